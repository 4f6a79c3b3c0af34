// The panel's frame: name, tools and tabs about its pages, and the cards that lie over everything.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/panel/panel_state.h"
#include "app/viewer/advice.h"

namespace nacre::app {
namespace {

constexpr int kWindow = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;
constexpr float kTightPoints = 320;  // of width: under it a card has all of it
constexpr float kErrorPoints = 220;  // of height that what went wrong takes, with what to do
constexpr float kLowPoints = 400;    // of height: under it tools and tabs scroll with the page

std::string shortName(const std::string& input) {
    return input.starts_with("sample:") ? input.substr(7) : std::filesystem::path(input).filename().string();
}

}  // namespace

void Panel::beginWindow(const char* name, int moreFlags) {
    ImGui::Begin(name, nullptr, kWindow | moreFlags);
    state_->ui.window = name;
    if (ImGui::IsWindowAppearing()) restless_ = std::max(restless_, 3);  // it is measured before it is shown
    remember();
    if (forFingers()) followFinger();
}

/// What the panel leaves of the window.
Panel::Rectangle Panel::freeRoom() const {
    if (sheet_) return {window_.left, window_.top, window_.right, panel_.top - bar_};
    return {std::max(panel_.right, window_.left), window_.top, window_.right, window_.bottom - bar_};
}

void Panel::drawMenuButton() {
    ImGui::SetNextWindowPos(ImVec2(window_.left + 10 * scale(), window_.top + 10 * scale()));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(2 * scale(), 2 * scale()));
    beginWindow("Menu", ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_AlwaysAutoResize);
    if (state_->ui.button(Icon::none, "Menu")) togglePanel();
    ImGui::End();
    ImGui::PopStyleVar();
}

void Panel::drawPanel(Viewer& viewer, double now) {
    ImGui::SetNextWindowPos(ImVec2(panel_.left, panel_.top));
    ImGui::SetNextWindowSize(ImVec2(panel_.right - panel_.left, panel_.bottom - panel_.top));
    if (sheet_) ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    if (keyboard_ && !ImGui::IsWindowFocused(ImGuiFocusedFlags_AnyWindow)) ImGui::SetNextWindowFocus();
    const bool low = panel_.bottom - panel_.top < kLowPoints * scale();
    beginWindow("Nacre", low ? 0 : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    drawHeader(viewer);
    drawTools(viewer);
    drawTabs();
    if (!low) {
        ImGui::BeginChild("Page", ImVec2(0, 0), false, ImGuiWindowFlags_NavFlattened);
        if (forFingers()) followFinger();
    }
    SavedView look = viewer.view();
    const std::string before = savedViewJson(look);
    switch (page_) {
        case Page::look:
            drawLookPage(look, viewer);
            break;
        case Page::parts:
            drawPartsPage(look, viewer);
            break;
        case Page::select:
            drawSelectPage(look, viewer);
            break;
        case Page::labels:
            drawLabelsPage(look, viewer);
            break;
        case Page::more:
            drawMorePage(viewer, now);
            break;
    }
    if (!low) ImGui::EndChild();
    ImGui::End();
    if (sheet_) ImGui::PopStyleVar();
    if (savedViewJson(look) != before) {
        viewer.setLook(look, now, editing_);
        editing_ = ImGui::IsAnyItemActive();
    }
    if (wanted_) viewer.show(*std::exchange(wanted_, std::nullopt), now);
    if (aim_) viewer.aim(*std::exchange(aim_, std::nullopt), now);
}

void Panel::drawHeader(const Viewer& viewer) {
    Widgets& ui = state_->ui;
    const Document* document = viewer.document();
    const float side = ui.rowHeight();
    const float room = ImGui::GetContentRegionAvail().x - side - ui.px(4);
    const float x = ImGui::GetCursorPosX();
    std::string name = document ? shortName(document->view.input) : viewer.loading() ? "Reading ..." : "Nacre";
    if (document)
        for (const FurtherInput& further : document->view.further) name += " + " + shortName(further.path);
    ui.name(name, room);
    ImGui::SameLine(x + room + ui.px(4));
    if (ui.sign(sheet_ ? Icon::down : Icon::fold, "Fold the panel")) {
        shown_ = Shown::folded;
        keyboard_ = false;
        restless_ = 2;
    }
    if (!document) return;
    std::string text = std::to_string(document->scene.drawnAtoms) + " atoms";
    // Of the few sticks beside ribbons it says nothing.
    if (2 * document->scene.drawnBonds > document->scene.drawnAtoms)
        text += ", " + std::to_string(document->scene.drawnBonds) + " bonds";
    if (viewer.occlusion() < 1 && !viewer.playing())
        text += ", shading " + std::to_string(static_cast<int>(100 * viewer.occlusion())) + " %";
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ui.px(6));
    ui.caption(text);
}

void Panel::drawTools(const Viewer& viewer) {
    Widgets& ui = state_->ui;
    struct Tool {
        Icon icon;
        const char* label;
        ViewerCommand command;
        bool on = false, enabled = true;
    };
    const bool there = viewer.document() != nullptr;
    const Tool tools[] = {{Icon::open, "Open", ViewerCommand::openFile},
                          {Icon::save, "Save", ViewerCommand::saveAs, false, there},
                          {Icon::undo, "Undo", ViewerCommand::undo, false, viewer.canUndo()},
                          {Icon::redo, "Redo", ViewerCommand::redo, false, viewer.canRedo()},
                          {Icon::fit, "Zoom to all", ViewerCommand::fit, false, there},
                          {Icon::spin, "Spin", ViewerCommand::autoRotate, viewer.autoRotating(), there},
                          {Icon::copy, "Copy", ViewerCommand::copyPicture, false, there},
                          {Icon::help, "Help", ViewerCommand::help}};
    const float room = ImGui::GetContentRegionAvail().x;
    const std::size_t columns = room >= ui.px(8 * 72) ? 8 : room >= ui.px(4 * 68) ? 4 : 2;
    const float gap = ui.px(4),
                width = std::floor((room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    const ImVec2 size(width, ui.px(forFingers() ? kFingerPoints : 42));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    std::size_t placed = 0;
    for (const Tool& tool : tools) {
        if (tool.command == ViewerCommand::copyPicture && !host_.copyPicture) continue;
        if (placed++ % columns != 0) ImGui::SameLine();
        if (ui.tool(tool.icon, tool.label, size, tool.on, tool.enabled)) host_.run(tool.command);
    }
    ImGui::PopStyleVar();
}

void Panel::drawTabs() {
    Widgets& ui = state_->ui;
    constexpr struct {
        Icon icon;
        const char* label;
        Page page;
    } kTabs[] = {{Icon::look, "Look", Page::look},
                 {Icon::parts, "Parts", Page::parts},
                 {Icon::select, "Select", Page::select},
                 {Icon::label, "Labels", Page::labels},
                 {Icon::more, "More", Page::more}};
    ImGui::Separator();
    const float gap = ui.px(4);
    const float room = ImGui::GetContentRegionAvail().x;
    const std::size_t columns = room >= ui.px(5 * 48) ? 5 : 3;
    const float width = std::floor((room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, ui.px(7)));
    for (std::size_t placed = 0; const auto& tab : kTabs) {
        if (placed++ % columns != 0) ImGui::SameLine();
        if (ui.tool(tab.icon, tab.label, ImVec2(width, ui.px(forFingers() ? kFingerPoints : 42)), page_ == tab.page,
                    true, "tab"))
            showPage(tab.page);
    }
    ImGui::PopStyleVar();
}

// --- cards

/// What lies below a card is dimmed, and a click there closes the card.
void Panel::drawScrim(const char* below) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0, 0, 0, 0.45f));
    ImGui::Begin(below, nullptr, kWindow | ImGuiWindowFlags_NoNav);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) closeTop();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

/// A window in the middle, over everything else, with a name and a sign that closes it.
/// @returns whether it was closed
bool Panel::beginCard(const char* name, const char* title, float points, bool closable) {
    Widgets& ui = state_->ui;
    const float room = window_.right - window_.left, edge = room < ui.px(kTightPoints) ? 0 : ui.px(8);
    const float width = std::min(ui.px(points), room - 2 * edge);
    const float height = window_.bottom - window_.top - 2 * edge;
    if (closable) drawScrim((std::string("Below ") + name).c_str());
    ImGui::SetNextWindowPos(
        ImVec2(std::round((window_.left + window_.right) / 2), std::round((window_.top + window_.bottom) / 2)),
        ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, height));
    beginWindow(name, ImGuiWindowFlags_AlwaysAutoResize);
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
    const float x = ImGui::GetCursorPosX(), y = ImGui::GetCursorPosY();
    const float right = ImGui::GetContentRegionAvail().x - ui.rowHeight();
    ui.title(title, closable ? x + right : 0);
    const float below = ImGui::GetCursorPosY();
    if (!closable) return false;
    ImGui::SetCursorPos(ImVec2(x + right, y));
    const bool closed = ui.sign(Icon::close, "Close");
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), below));
    return closed;
}

void Panel::endCard() { endGrown(); }

/// Ends a window that is as high as what stands in it, which shows a frame late: that frame is asked for.
void Panel::endGrown() {
    const float end = ImGui::GetCursorPosY();
    float& before = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("##end"), 0);
    if (std::abs(end - before) > 0.5f) restless_ = std::max(restless_, 2);
    before = end;
    ImGui::End();
}

/// At the top of what the panel leaves free: something that goes on, and can be stopped.
void Panel::beginProgress(const char* name) {
    const Widgets& ui = state_->ui;
    const Rectangle room = freeRoom();
    const float width = std::min(ui.px(380), room.right - room.left - ui.px(16));
    ImGui::SetNextWindowPos(ImVec2(std::round((room.left + room.right) / 2), room.top + ui.px(16)), ImGuiCond_Always,
                            ImVec2(0.5f, 0));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, room.bottom - room.top));
    beginWindow(name, ImGuiWindowFlags_AlwaysAutoResize);
}

/// What is being read, with a way to stop it.
void Panel::drawReading(Viewer& viewer, double now) {
    const bool another = !viewer.document() || viewer.loadingName() != viewer.document()->view.input;
    if (!viewer.loading() || !another) return;
    Widgets& ui = state_->ui;
    beginProgress("Reading");
    ui.name("Reading " + shortName(viewer.loadingName()));
    const double share = viewer.loadingProgress();
    if (share >= 0) {
        char text[32];
        std::snprintf(text, sizeof text, "%.0f %% downloaded", 100 * share);
        ui.progress(share, text);
    }
    if (ui.button(Icon::close, "Cancel")) viewer.cancelLoading(now);
    endGrown();
    restless_ = std::max(restless_, 1);  // it goes on
}

/// What went wrong, and what to do.
void Panel::tellFailure(Viewer& viewer) {
    Widgets& ui = state_->ui;
    ui.warning("This did not work");
    ui.paragraph(viewer.failure());
    ui.caption(adviceFor(viewer.failure()));
    if (ui.button(Icon::none, "Close")) viewer.dismissFailure();
}

/// The same in a card of its own, until it is read.
void Panel::drawFailure(Viewer& viewer) {
    Widgets& ui = state_->ui;
    Rectangle room = freeRoom();
    if (room.bottom - room.top < ui.px(kErrorPoints)) room = window_;
    const float width = std::min(ui.px(460), room.right - room.left - ui.px(16));
    ImGui::SetNextWindowPos(ImVec2(std::round((room.left + room.right) / 2), room.bottom - ui.px(16)), ImGuiCond_Always,
                            ImVec2(0.5f, 1));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, room.bottom - room.top - ui.px(32)));
    beginWindow("Error", ImGuiWindowFlags_AlwaysAutoResize);
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
    tellFailure(viewer);
    ui.wrapLine(ui.buttonWidth("Open another") + ui.px(23));
    if (ui.button(Icon::open, "Open another")) {
        viewer.dismissFailure();
        showStart();
    }
    endGrown();
}

/// In the middle of the window, over everything else.
void Panel::drawQuestion(Viewer& viewer, double now) {
    Widgets& ui = state_->ui;
    const float width = std::min(ui.px(340), std::max(window_.right - window_.left - ui.px(24), 1.0f));
    ImGui::SetNextWindowPos(
        ImVec2(std::round((window_.left + window_.right) / 2), std::round((window_.top + window_.bottom) / 2)),
        ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, window_.bottom - window_.top));
    ImGui::SetNextWindowFocus();
    beginWindow("Question", ImGuiWindowFlags_AlwaysAutoResize);
    ui.paragraph(viewer.question()->what());
    ImGui::Spacing();
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    std::optional<bool> answer;
    if (ui.button(Icon::none, viewer.question()->yes().c_str(), half, true)) answer = true;
    ImGui::SameLine();
    if (ui.button(Icon::none, "Cancel", half)) answer = false;
    endGrown();
    if (!answer) return;
    viewer.answer(*answer, now);
    restless_ = 2;
}

}  // namespace nacre::app
