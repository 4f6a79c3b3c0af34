// The bar under the picture of a molecule that moves: play, step, scrub; how fast, in what order, and how frames are
// laid.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kBarPoints = 620, kBarMargin = 10;
constexpr float kNarrowPoints = 460;     // under it the text has a line of its own
constexpr float kTextPointsOfBar = 190;  // of the text beside the slider
constexpr int kMostSmoothing = 25;       // that the slider offers

constexpr std::array kOrders = {"Loop", "Back and forth", "Once"};
constexpr std::array kFits = {"Frames as they are", "Lay backbones together", "Lay all atoms together"};
constexpr std::array kFitSelections = {"", "backbone", "all"};

/// "Frame 12 of 200, 24 ps"
std::string placeText(const Viewer& viewer) {
    const Playback& playback = viewer.playback();
    std::string text = (viewer.hasTrajectory() ? "Frame " : "Model ") + std::to_string(playback.frame() + 1) + " of " +
                       std::to_string(playback.frames());
    if (const auto time = viewer.frameTime()) {
        std::array<char, 40> number{};
        const bool nanoseconds = std::abs(*time) >= 1000;
        std::snprintf(number.data(), number.size(), ", %.5g %s", nanoseconds ? *time / 1000 : *time,
                      nanoseconds ? "ns" : "ps");
        text += number.data();
    }
    return text;
}

}  // namespace

void Panel::drawPlayBar(Viewer& viewer, double now) {
    const float before = bar_;
    bar_ = 0;
    playBar_ = {};
    if (viewer.document() && viewer.playback().frames() > 1) {
        const Rectangle room = freeRoom();
        const float margin = kBarMargin * scale();
        const float width = std::min(kBarPoints * scale(), room.right - room.left - 2 * margin);
        ImGui::SetNextWindowPos(ImVec2(std::round((room.left + room.right) / 2), room.bottom - margin),
                                ImGuiCond_Always, ImVec2(0.5f, 1));
        ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, room.bottom - room.top - 2 * margin));
        beginWindow("Play", ImGuiWindowFlags_AlwaysAutoResize);
        drawPlayRow(viewer, now);
        if (state_->playOptions) drawPlayOptions(viewer, now);
        bar_ = ImGui::GetWindowHeight() + 2 * margin;
        playBar_ = occupied_.back();
        endGrown();
    }
    if (bar_ != before) restless_ = std::max(restless_, 2);
}

void Panel::drawPlayRow(Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    const Playback& playback = viewer.playback();
    const bool narrow = ImGui::GetContentRegionAvail().x < ui.px(kNarrowPoints);
    if (narrow) ui.name(placeText(viewer));
    const char* const what = viewer.hasTrajectory() ? "frame" : "model";
    const auto named = [&](const char* text) { return std::string(text) + " " + what; };
    if (ui.sign(Icon::previous, named("Previous").c_str())) host_.run(ViewerCommand::previousModel);
    ImGui::SameLine();
    if (ui.sign(playback.playing() ? Icon::pause : Icon::play, playback.playing() ? "Pause" : "Play"))
        host_.run(ViewerCommand::playModels);
    ImGui::SameLine();
    if (ui.sign(Icon::next, named("Next").c_str())) host_.run(ViewerCommand::nextModel);
    ImGui::SameLine();
    const float gap = ImGui::GetStyle().ItemSpacing.x, end = ui.rowHeight() + gap;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - end - (narrow ? 0 : ui.px(kTextPointsOfBar) + gap));
    int number = static_cast<int>(playback.frame() + 1);
    if (ui.slideWhole("Frame", number, 1, static_cast<int>(playback.frames()), ""))
        viewer.showFrame(static_cast<std::size_t>(number - 1), now);
    ImGui::SameLine();
    if (!narrow) {
        const float x = ImGui::GetCursorPosX();
        ui.name(placeText(viewer), ui.px(kTextPointsOfBar));
        ImGui::SameLine(x + ui.px(kTextPointsOfBar) + gap);
    }
    if (ui.sign(Icon::more, "How it is played")) state_->playOptions = !state_->playOptions, restless_ = 2;
}

void Panel::drawPlayOptions(Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    const Playback& playback = viewer.playback();
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    const bool narrow = half < ui.px(210);
    const auto place = [&](bool second) {
        if (second && !narrow) ImGui::SameLine();
        ImGui::SetNextItemWidth(narrow ? -1 : half);
    };
    place(false);
    auto rate = static_cast<float>(playback.rate());
    if (ui.slideRate("Speed", rate, Playback::kSlowest, Playback::kFastest, "%.3g a second"))
        viewer.setRate(rate < 3 ? std::round(2 * rate) / 2 : std::round(rate));
    std::string order = kOrders[static_cast<std::size_t>(playback.order())];
    if (!narrow) ImGui::SameLine();
    if (ui.choose("Order", kOrders, order, narrow ? -1 : half))
        viewer.setOrder(static_cast<PlayOrder>(std::find(kOrders.begin(), kOrders.end(), order) - kOrders.begin()));
    if (!viewer.canLay()) return;
    TrajectoryOptions laid = viewer.view().trajectory;
    bool changed = false;
    place(false);
    int smooth = static_cast<int>(laid.smooth / 2);
    const std::string mean = laid.smooth > 1 ? "Mean of " + std::to_string(laid.smooth) : "Not smoothed";
    if (ui.slideWhole("Smoothing", smooth, 0, kMostSmoothing / 2, mean.c_str())) {
        laid.smooth = 2 * smooth + 1;
        changed = true;
    }
    const std::string now_ = laid.fit ? laid.fit->text : "";
    const auto known = std::find(kFitSelections.begin(), kFitSelections.end(), now_);
    const std::string selected = viewer.selection().any() ? viewer.selection().text : "";
    std::vector<const char*> choices(kFits.begin(), kFits.end());
    if (!selected.empty()) choices.push_back("Lay the selection together");
    std::string fit =
        known == kFitSelections.end() ? "By " + now_ : kFits[static_cast<std::size_t>(known - kFitSelections.begin())];
    if (!narrow) ImGui::SameLine();
    if (ui.choose("Fit", choices, fit, narrow ? -1 : half)) {
        const auto taken = std::find(kFits.begin(), kFits.end(), fit);
        const std::string text =
            taken == kFits.end() ? selected : kFitSelections[static_cast<std::size_t>(taken - kFits.begin())];
        laid.fit = text.empty() ? std::nullopt : std::optional(parseSelection(text));
        changed = true;
    }
    if (viewer.hasTrajectory()) changed = ui.toggle("Whole molecules", laid.whole) || changed;
    if (changed) viewer.setMotion(laid, now);
    if (laid.fit) {
        std::array<char, 60> text{};
        std::snprintf(text.data(), text.size(), "%.2f Å from the first (RMSD)", viewer.frameRmsd());
        ui.caption(text.data());
    }
}

}  // namespace nacre::app
