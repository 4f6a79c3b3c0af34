// The play bar for a moving molecule: play, step, scrub; speed, order, and fitting of frames.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/panel/panel_state.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

constexpr float kBarPoints = 620, kBarMargin = 10;
constexpr float kNarrowPoints = 460;     // below this width, the text has its own line
constexpr float kTextPointsOfBar = 190;  // of the text next to the slider
constexpr int kMostSmoothing = 25;       // maximum of the slider

constexpr std::array kOrders = {"Loop", "Back and forth", "Once"};
constexpr std::array kFits = {"Not superposed", "Superpose backbones", "Superpose all atoms"};
constexpr std::array kFitSelections = {"", "backbone", "all"};

/// "Frame 12 of 200, 24 ps"
std::string placeText(const PanelFrame& f) {
    const Playback& playback = f.viewer.playback();
    const PlayClock& clock = playback.clock();
    if (!playback.hasTrajectory() && f.look.input.model == kAllModels)
        return "All " + std::to_string(clock.frames()) + " models";
    std::string text = playback.hasTrajectory() ? "Frame " : "Model ";
    if (const double place = playback.place(); place != std::floor(place)) {
        const auto before = static_cast<int>(place) + 1;
        text = "Between models " + std::to_string(before) + " and " + std::to_string(before + 1);
    } else {
        const std::size_t count = playback.morphs() ? playback.models() : clock.frames();
        text += std::to_string(static_cast<int>(place) + 1) + " of " + std::to_string(count);
    }
    if (const auto time = playback.frameTime()) {
        const bool nanoseconds = std::abs(*time) >= 1000;
        text += nanoseconds ? formatted(", %.5g ns", *time / 1000) : formatted(", %.5g ps", *time);
    }
    return text;
}

void drawPlayRow(PanelFrame& f) {
    Playback& playback = f.viewer.playback();
    const PlayClock& clock = playback.clock();
    const bool narrow = ImGui::GetContentRegionAvail().x < f.ui.px(kNarrowPoints);
    if (narrow) f.ui.name(placeText(f));
    const char* const what = playback.hasTrajectory() ? "frame" : "model";
    const auto named = [&](const char* text) { return std::string(text) + " " + what; };
    if (f.ui.sign(Icon::previous, named("Previous").c_str())) f.host.run(ViewerCommand::previousModel);
    ImGui::SameLine();
    if (f.ui.sign(playback.playing() ? Icon::pause : Icon::play, playback.playing() ? "Pause" : "Play"))
        f.host.run(ViewerCommand::playModels);
    ImGui::SameLine();
    if (f.ui.sign(Icon::next, named("Next").c_str())) f.host.run(ViewerCommand::nextModel);
    ImGui::SameLine();
    const float gap = ImGui::GetStyle().ItemSpacing.x, end = f.ui.rowHeight() + gap;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - end - (narrow ? 0 : f.ui.px(kTextPointsOfBar) + gap));
    int number = static_cast<int>(clock.frame() + 1);
    if (f.ui.slideWhole("Frame", number, 1, static_cast<int>(clock.frames()), ""))
        playback.show(static_cast<std::size_t>(number - 1), f.now);
    ImGui::SameLine();
    if (!narrow) {
        const float x = ImGui::GetCursorPosX();
        f.ui.name(placeText(f), f.ui.px(kTextPointsOfBar));
        ImGui::SameLine(x + f.ui.px(kTextPointsOfBar) + gap);
    }
    if (f.ui.sign(Icon::more, "Playback options")) f.s.playOptions = !f.s.playOptions, f.s.restless = 2;
}

void drawPlayOptions(PanelFrame& f) {
    Playback& playback = f.viewer.playback();
    const PlayClock& clock = playback.clock();
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    const bool narrow = half < f.ui.px(210);
    ImGui::SetNextItemWidth(narrow ? -1 : half);
    auto rate = static_cast<float>(clock.rate());
    if (f.ui.slideRate("Speed", rate, PlayClock::kSlowest, PlayClock::kFastest, "%.3g per second"))
        playback.setRate(rate < 3 ? std::round(2 * rate) / 2 : std::round(rate));
    PlayOrder order = clock.order();
    if (!narrow) ImGui::SameLine();
    if (f.ui.choose("Order", kOrders, order, narrow ? -1 : half)) playback.setOrder(order);
    if (!playback.canLay()) return;
    bool morphs = playback.morphs();
    if (playback.canMorph() && f.ui.toggle("Morph between models", morphs)) playback.setMorph(morphs, f.now);
    const PictureDescription& view = f.viewer.view();
    TrajectoryOptions laid = view.input.trajectory;
    bool changed = false;
    ImGui::SetNextItemWidth(narrow ? -1 : half);
    int smooth = static_cast<int>(laid.smooth / 2);
    const std::string mean = laid.smooth > 1 ? "Average of " + std::to_string(laid.smooth) : "Not smoothed";
    if (f.ui.slideWhole("Smoothing", smooth, 0, kMostSmoothing / 2, mean.c_str())) {
        laid.smooth = 2 * smooth + 1;
        changed = true;
    }
    const std::string given = laid.fit ? laid.fit->text : "";
    const auto known = std::find(kFitSelections.begin(), kFitSelections.end(), given);
    const SelectedAtoms& selection = f.viewer.picking().selection();
    const std::string selected = selection.any() ? selection.text : "";
    std::vector<const char*> choices(kFits.begin(), kFits.end());
    if (!selected.empty()) choices.push_back("Superpose the selection");
    std::string fit =
        known == kFitSelections.end() ? "By " + given : kFits[static_cast<std::size_t>(known - kFitSelections.begin())];
    if (!narrow) ImGui::SameLine();
    if (f.ui.choose("Fit", choices, fit, narrow ? -1 : half)) {
        const auto taken = std::find(kFits.begin(), kFits.end(), fit);
        const std::string text =
            taken == kFits.end() ? selected : kFitSelections[static_cast<std::size_t>(taken - kFits.begin())];
        laid.fit = text.empty() ? std::nullopt : std::optional(parseSelection(text));
        changed = true;
    }
    if (playback.hasTrajectory()) changed = f.ui.toggle("Whole molecules", laid.whole) || changed;
    if (changed) playback.setMotion(laid, f.now);
    if (laid.fit) f.ui.caption(formatted("%.2f Å from the first (RMSD)", playback.frameRmsd()));
}

}  // namespace

void drawPlayBar(PanelFrame& f) {
    const float before = std::exchange(f.s.bar, 0);
    f.s.playBar = {};
    if (f.viewer.document() && f.viewer.playback().clock().frames() > 1) {
        const Rectangle room = f.s.freeRoom();
        const float margin = f.ui.px(kBarMargin);
        beginGrown(f, "Play", ImVec2(room.middle().x, room.bottom - margin), ImVec2(0.5f, 1),
                   std::min(f.ui.px(kBarPoints), room.width() - 2 * margin), room.height() - 2 * margin);
        drawPlayRow(f);
        if (f.s.playOptions) drawPlayOptions(f);
        f.s.bar = ImGui::GetWindowHeight() + 2 * margin;
        f.s.playBar = f.s.occupied.back();
        endGrown(f);
    }
    if (f.s.bar != before) f.s.restless = std::max(f.s.restless, 2);
}

}  // namespace nacre::app
