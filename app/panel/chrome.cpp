// The panel's frame: name, tools and tabs around its pages.

#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "app/panel/panel_state.h"
#include "app/picture/options.h"

namespace nacre::app {
namespace {

constexpr float kLowPoints = 400;      // of height: below, tools are icons only, or scroll
constexpr float kVeryLowPoints = 250;  // and below this, tools and tabs scroll with the page
constexpr float kTools = 8, kToolPoints = 44, kGap = 4, kRowGap = 2;

/// A page with its tab.
struct Page {
    const char* label;
    void (*draw)(PanelFrame&);
    Icon icon;
};

const Page kPages[] = {
    {"Look", drawLookPage, Icon{[](const Pen& pen) {
         pen.ring({-0.25f, 0.2f}, 0.55f);
         pen.ring({0.4f, -0.35f}, 0.4f);
     }}},
    {"Parts", drawPartsPage, Icon{[](const Pen& pen) {
         for (const float y : {-0.6f, 0.0f, 0.6f}) {
             pen.disc({-0.7f, y}, 0.16f);
             pen.line({{-0.3f, y}, {0.85f, y}});
         }
     }}},
    {"Select", drawSelectPage, Icon{[](const Pen& pen) {
         pen.line({{-0.5f, -0.8f}, {0.65f, 0.25f}, {0.1f, 0.3f}, {0.4f, 0.85f}, {-0.1f, 0.4f}, {-0.5f, 0.7f}}, true);
     }}},
    {"Labels", drawLabelsPage, Icon{[](const Pen& pen) {
         for (const float y : {-0.6f, 0.0f, 0.6f}) pen.line({{-0.8f, y}, {y > 0.3f ? 0.2f : 0.8f, y}});
     }}},
    {"More", drawMorePage, Icon{[](const Pen& pen) { Icon::more.draw(pen); }}},
};

/// Buttons of one size in a number of columns.
struct Grid {
    std::size_t columns;
    ImVec2 size;
    std::size_t placed = 0;

    Grid(const Widgets& ui, std::size_t inLine, float gap = kGap) : columns(inLine) {
        const float gaps = ui.px(gap) * static_cast<float>(columns - 1);
        const float room = ImGui::GetContentRegionAvail().x;
        size = ImVec2(std::floor((room - gaps) / static_cast<float>(columns)),
                      ui.px(ui.forFingers() ? kFingerPoints : kToolPoints));
    }
    void next() {
        if (placed++ % columns != 0) ImGui::SameLine();
    }
};

void drawHeader(PanelFrame& f) {
    const Document* document = f.viewer.document();
    const float side = f.ui.rowHeight();
    const float room = ImGui::GetContentRegionAvail().x - side - f.ui.px(4);
    const float x = ImGui::GetCursorPosX();
    std::string name = document                             ? shortName(document->view.input.path)
                       : f.viewer.reading().loader().busy() ? "Reading ..."
                                                            : "Nacre";
    if (document)
        for (const FurtherInput& further : document->view.input.further) name += " + " + shortName(further.path);
    f.ui.name(name, room);
    ImGui::SameLine(x + room + f.ui.px(4));
    if (f.ui.sign(f.s.sheet ? Icon::down : Icon::fold, "Fold the panel")) {
        f.s.shown = PanelState::Shown::folded;
        f.s.keyboard = false;
        f.s.restless = 2;
    }
    if (!f.s.foreign.missing().empty()) f.ui.caption(f.s.foreign.missing());
    if (!document) return;
    const std::size_t atoms = document->drawing.scene().drawnAtoms, maps = document->view.maps.files.size();
    std::string text = std::to_string(atoms) + (atoms == 1 ? " atom" : " atoms");
    if (atoms == 0 && maps > 0) text = maps == 1 ? "Density map" : std::to_string(maps) + " density maps";
    // Ignores the few sticks next to ribbons.
    if (2 * document->drawing.scene().drawnBonds > atoms)
        text += ", " + std::to_string(document->drawing.scene().drawnBonds) + " bonds";
    if (f.viewer.frames().occlusion() < 1 && !f.viewer.playback().playing())
        text += ", shading " + std::to_string(static_cast<int>(100 * f.viewer.frames().occlusion())) + " %";
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - f.ui.px(6));
    f.ui.caption(text);
}

/// Whether a low panel has room for all tools in one row, as icons only.
bool toolsFitRow(const PanelFrame& f) {
    const float target = f.ui.forFingers() ? kFingerPoints : kToolPoints;
    const float room = f.s.panel.width() - 2 * ImGui::GetStyle().WindowPadding.x;
    return f.s.panel.height() < f.ui.px(kLowPoints) && room >= f.ui.px(kTools * target + (kTools - 1) * kRowGap);
}

/// @param row  all tools in one row, as icons only
void drawTools(PanelFrame& f, bool row) {
    using C = ViewerCommand;
    struct Tool {
        Icon icon;
        const char* label;
        C command;
        bool on = false, enabled = true;
    };
    const bool there = f.viewer.document() != nullptr;
    const Tool tools[] = {{Icon::open, "Open", C::openFile},
                          {Icon::save, "Save", C::saveAs, false, there},
                          {Icon::undo, "Undo", C::undo, false, f.viewer.canUndo()},
                          {Icon::redo, "Redo", C::redo, false, f.viewer.canRedo()},
                          {Icon::fit, "Zoom to all", C::fit, false, there},
                          {Icon::spin, "Spin", C::autoRotate, f.viewer.motion().autoRotation(), there},
                          {Icon::copy, "Copy", C::copyPicture, false, there},
                          {Icon::help, "Help", C::help}};
    const float room = ImGui::GetContentRegionAvail().x;
    Grid grid(f.ui, row || room >= f.ui.px(8 * 72) ? 8 : room >= f.ui.px(4 * 68) ? 4 : 2, row ? kRowGap : kGap);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(f.ui.px(row ? kRowGap : kGap), f.ui.px(4)));
    for (const Tool& tool : tools) {
        if (tool.command == C::copyPicture && !f.host.copyPicture) continue;
        grid.next();
        if (f.ui.tool(tool.icon, tool.label, grid.size, tool.on, tool.enabled, "button", row)) f.host.run(tool.command);
    }
    ImGui::PopStyleVar();
}

void drawTabs(PanelFrame& f) {
    ImGui::Separator();
    constexpr std::size_t kTabs = std::size(kPages);
    Grid grid(f.ui, ImGui::GetContentRegionAvail().x >= f.ui.px(48 * kTabs) ? kTabs : (kTabs + 1) / 2);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(f.ui.px(4), f.ui.px(7)));
    for (const Page& page : kPages) {
        grid.next();
        if (!f.ui.tool(page.icon, page.label, grid.size, f.s.page == page.label, true, "tab")) continue;
        f.s.page = page.label;
        f.s.restless = 2;
    }
    ImGui::PopStyleVar();
}

}  // namespace

std::vector<std::string_view> Panel::pages() {
    std::vector<std::string_view> labels;
    for (const Page& page : kPages) labels.emplace_back(page.label);
    return labels;
}

std::string shortName(const std::string& input) {
    return input.starts_with("sample:") ? input.substr(7) : std::filesystem::path(input).filename().string();
}

void drawMenuButton(PanelFrame& f) {
    ImGui::SetNextWindowPos(ImVec2(f.s.window.left + f.ui.px(10), f.s.window.top + f.ui.px(10)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(f.ui.px(2), f.ui.px(2)));
    beginWindow(f, "Menu", ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_AlwaysAutoResize);
    if (f.ui.button(Icon::none, "Menu")) f.s.toggle();
    ImGui::End();
    ImGui::PopStyleVar();
}

void drawPanel(PanelFrame& f) {
    PanelState& s = f.s;
    ImGui::SetNextWindowPos(ImVec2(s.panel.left, s.panel.top));
    ImGui::SetNextWindowSize(ImVec2(s.panel.width(), s.panel.height()));
    if (s.sheet) ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    if (s.keyboard && !ImGui::IsWindowFocused(ImGuiFocusedFlags_AnyWindow)) ImGui::SetNextWindowFocus();
    const bool row = toolsFitRow(f), lacksRow = s.panel.height() < f.ui.px(kLowPoints) && !row;
    const bool low = lacksRow || s.panel.height() < f.ui.px(kVeryLowPoints);
    beginWindow(f, "Nacre", low ? 0 : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    drawHeader(f);
    // Tabs are needed more often than tools, which scroll away; on a phone only tools open files.
    const bool tabsFirst = low && !f.ui.forFingers();
    if (!tabsFirst) drawTools(f, row);
    drawTabs(f);
    if (tabsFirst) drawTools(f, row);
    if (!low) {
        ImGui::BeginChild("Page", ImVec2(0, 0), false,
                          ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_AlwaysVerticalScrollbar);
        followFinger(f);
    }
    beginLook(f);
    for (const Page& page : kPages)
        if (s.page == page.label) page.draw(f);
    if (!low) ImGui::EndChild();
    ImGui::End();
    if (s.sheet) ImGui::PopStyleVar();
    takeLook(f);
}

void beginLook(PanelFrame& f) { f.look = f.before = f.viewer.view(); }

void takeLook(PanelFrame& f) {
    PanelState& s = f.s;
    if (difference(f.look, f.before) != 0) {
        f.viewer.setLook(f.look, f.now, s.editing);
        s.editing = ImGui::IsAnyItemActive();
    }
    if (s.wanted) f.viewer.show(*std::exchange(s.wanted, std::nullopt), f.now);
    if (s.aim) f.viewer.camera().aim(*std::exchange(s.aim, std::nullopt), f.now);
}

}  // namespace nacre::app
