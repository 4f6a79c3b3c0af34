// Words in the picture: labels, measurements, title, scale and legend. All of them are saved with it.

#include <cstdio>
#include <string>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

/// What a measurement is of and says; while its atoms are not drawn, what it is of as it was written.
std::string rowText(const Measure& measure, const PlacedWords& placed) {
    for (const PlacedMeasure& at : placed.measures)
        if (at.of == measure.text) return at.text + ", " + at.atoms;
    return "Atoms " + measure.text;
}

}  // namespace

void Panel::drawLabelsPage(SavedView& look, Viewer& viewer) {
    Widgets& ui = state_->ui;
    ui.caption("All of this is in saved pictures and views.");
    ui.heading("Title");
    if (!state_->typingTitle) std::snprintf(state_->title, sizeof state_->title, "%s", look.words.title.c_str());
    ui.field("Title", "None", state_->title, sizeof state_->title);
    state_->typingTitle = ImGui::IsItemActive();
    if (ui.edited()) {
        try {
            look.words.title = parseTitle(state_->title);
            ruleError_.clear();
        } catch (const std::exception& error) {
            ruleError_ = error.what();
        }
    }
    if (!ruleError_.empty()) ui.warning(ruleError_);
    ui.toggle("Legend of the colours", look.words.legend);
    ui.heading("Scale bar");
    constexpr const char* kBars[] = {"None", "In ångström", "In nanometres"};
    std::string bar = kBars[static_cast<std::size_t>(look.words.scaleBar)];
    if (ui.choose("Scale bar", kBars, bar))
        for (std::size_t i = 0; i < std::size(kBars); ++i)
            if (bar == kBars[i]) look.words.scaleBar = static_cast<ScaleBar>(i);
    ui.heading("Measurements");
    const std::size_t picked = viewer.picks().size();
    if (picked < 2) {
        ui.caption(forFingers() ? "Tap two atoms for a distance, three for an angle, four for a torsion."
                                : "Click two atoms for a distance, three for an angle, four for a torsion.");
    } else {
        ui.paragraph(viewer.annotations().measurement);
        if (ui.button(Icon::none, "Keep it in the picture")) host_.run(ViewerCommand::keepMeasurement);
    }
    const float side = ui.rowHeight();
    const auto row = [&](int id, const std::string& text) {
        ImGui::PushID(id);
        const float x = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
        ui.name(text, room - side - ui.px(8));
        ImGui::SameLine(x + room - side);
        const bool gone = ui.sign(Icon::close, "Remove");
        ImGui::PopID();
        return gone;
    };
    std::vector<Measure>& measures = look.words.measures;
    for (std::size_t i = 0; i < measures.size(); ++i)
        if (row(static_cast<int>(i), rowText(measures[i], viewer.words()))) {
            measures.erase(measures.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    std::vector<Label>& labels = look.words.labels;
    if (!labels.empty()) {
        ui.heading("Labels");
        bool hidden = !look.words.seenOnly;
        if (ui.toggle("Those behind atoms, too", hidden)) look.words.seenOnly = !hidden;
    }
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (row(1000 + static_cast<int>(i), labels[i].selection.text)) {
            labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    if (labels.empty()) {
        ui.heading("Labels");
        ui.caption("Choose atoms under \"Select\", then \"Label\".");
    }
}

}  // namespace nacre::app
