// Motion, the window itself, and what developers look at.

#include "app/files/notices.h"
#include "app/panel/panel_state.h"

namespace nacre::app {

void Panel::drawMorePage(Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    ui.heading("Motion");
    bool spinning = viewer.autoRotating(), rocking = viewer.rocking();
    if (ui.toggle("Spin", spinning)) host_.run(ViewerCommand::autoRotate);
    if (ui.toggle("Swing to and fro", rocking)) host_.run(ViewerCommand::rock);
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (ui.button(Icon::none, "Lay flat", half)) host_.run(ViewerCommand::orient);
    ImGui::SameLine();
    if (ui.button(Icon::none, "First view", half)) host_.run(ViewerCommand::reset);
    ui.heading("View");
    if (ui.button(Icon::save, "Save this view", -1)) host_.run(ViewerCommand::saveView);
    if (host_.record) {
        if (ui.button(Icon::eye, "Keep this view for a film", -1)) host_.run(ViewerCommand::keepView);
        if (ui.button(Icon::record, "Record a film", -1)) host_.run(ViewerCommand::record);
    }
    ui.heading("Panel");
    constexpr const char* kBrightness[] = {"As the system", "Dark", "Light"};
    std::string chosen = kBrightness[static_cast<std::size_t>(brightness_)];
    if (ui.choose("Brightness", kBrightness, chosen))
        for (std::size_t i = 0; i < std::size(kBrightness); ++i)
            if (chosen == kBrightness[i]) setBrightness(static_cast<Brightness>(i));
    ImGui::Spacing();
    if (ui.button(developers_ ? Icon::up : Icon::down, "For developers", -1)) developers_ = !developers_;
    if (developers_) drawForDevelopers(viewer, now);
}

void Panel::drawForDevelopers(Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    ui.heading("What the frame works with");
    const auto names = debugViewNames();
    std::vector<const char*> choices(names.begin(), names.end());
    std::string chosen = choices[static_cast<std::size_t>(viewer.debugView())];
    if (ui.choose("Debug view", choices, chosen))
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (chosen == choices[i]) viewer.setDebugView(static_cast<DebugView>(i), now);
    if (host_.captures && ui.button(Icon::none, "Capture a frame (F12)", -1)) host_.run(ViewerCommand::captureFrame);
    if (host_.copyReport && ui.button(Icon::none, "Copy report", -1)) host_.copyReport();
    if (host_.statistics) ui.caption(host_.statistics());
}

}  // namespace nacre::app
