// The page of everything else: motion, the window itself, tools for developers.

#include <iterator>

#include "app/panel/panel_state.h"
#include "engine/debug_view.h"

namespace nacre::app {
namespace {

void drawForDevelopers(PanelFrame& f) {
    f.ui.heading("Debug views");
    const auto names = debugViewNames();
    const std::vector<const char*> choices(names.begin(), names.end());
    DebugView debug = f.viewer.frames().debugView();
    if (f.ui.choose("Debug view", choices, debug)) f.viewer.frames().setDebugView(debug, f.now);
    if (f.host.captures && f.ui.button(Icon::none, "Capture a frame (F12)", -1))
        f.host.run(ViewerCommand::captureFrame);
    if (f.host.copyReport && f.ui.button(Icon::none, "Copy report", -1)) f.host.copyReport();
    if (f.host.statistics) f.ui.caption(f.host.statistics());
}

}  // namespace

void drawMorePage(PanelFrame& f) {
    f.ui.heading("Motion");
    bool spinning = f.viewer.motion().autoRotation(), rocking = f.viewer.motion().rocking();
    if (f.ui.toggle("Spin", spinning)) f.host.run(ViewerCommand::autoRotate);
    if (f.ui.toggle("Rock", rocking)) f.host.run(ViewerCommand::rock);
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (f.ui.button(Icon::none, "Align axes", half)) f.host.run(ViewerCommand::orient);
    ImGui::SameLine();
    if (f.ui.button(Icon::none, "Reset view", half)) f.host.run(ViewerCommand::reset);
    f.ui.heading("View");
    if (f.ui.button(Icon::save, "Save this view", -1)) f.host.run(ViewerCommand::saveView);
    if (f.host.savesScenes && f.ui.button(Icon::save, "Save as MolViewSpec", -1)) f.host.run(ViewerCommand::saveScene);
    if (f.host.record) {
        if (f.ui.button(Icon::eye, "Add keyframe", -1)) f.host.run(ViewerCommand::keepView);
        if (f.ui.button(Icon::record, "Record movie", -1)) f.host.run(ViewerCommand::record);
    }
    f.ui.heading("Panel");
    constexpr const char* kBrightness[] = {"Theme: system", "Theme: dark", "Theme: light"};
    if (f.ui.choose("Brightness", kBrightness, f.s.brightness)) f.s.setBrightness(f.s.brightness);
    if (f.ui.toggle("Dark background in the dark theme", f.s.darkCanvas)) f.s.canvasDue = true;
    constexpr int kPercents[] = {100, 125, 150, 200};
    constexpr const char* kSizes[] = {"Text: 100 %", "Text: 125 %", "Text: 150 %", "Text: 200 %"};
    std::size_t size = 0;
    while (size + 1 < std::size(kPercents) && kPercents[size] < f.s.textPercent) ++size;
    if (f.host.scalesText && f.ui.choose("Text size", kSizes, size)) f.s.textPercent = kPercents[size];
    ImGui::Spacing();
    if (f.ui.button(f.s.developers ? Icon::up : Icon::down, "For developers", -1)) f.s.developers = !f.s.developers;
    if (f.s.developers) drawForDevelopers(f);
}

}  // namespace nacre::app
