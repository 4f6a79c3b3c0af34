// Windows of the panel: their layout, cards over everything else, and their uses: progress, errors and questions.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "app/panel/panel_state.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

constexpr int kWindow = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;
constexpr float kTightPoints = 320;  // width; below, a card takes all of it
constexpr float kErrorPoints = 220;  // height reserved for the error with its advice

/// Dims everything below a card; a click there closes the card.
void drawScrim(PanelFrame& f, const char* below) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0, 0, 0, 0.45f));
    ImGui::Begin(below, nullptr, kWindow | ImGuiWindowFlags_NoNav);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) f.s.closeTop();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

/// Advice on an error that does not include it; may be empty.
std::string adviceFor(const std::string& error) {
    const auto says = [&](std::initializer_list<const char*> words) {
        return std::any_of(words.begin(), words.end(),
                           [&](const char* word) { return error.find(word) != std::string::npos; });
    };
    if (says({"check your connection", "did you mean", "open one first", "open its structure first"})) return {};
    if (says({"resolve", "timed out", "timeout", "network", "certificate"}))
        return "Check that this computer is online, then try again.";
    if (says({"no such file", "No such file", "does not exist"}))
        return "Check the name, or whether the file was moved or renamed.";
    if (says({"not found", "404", "no such entry"}))
        return "Check the identifier: a PDB ID has four characters, such as 1BNA.";
    if (says({"ermission"})) return "Ask the owner of the file or folder, or choose another one.";
    if (says({"memory"})) return "Close other programs, or show less of the molecule.";
    if (says({"cannot read molecule"}))
        return "The file may be damaged, or not a structure file: PDB, mmCIF, BinaryCIF, SDF, MOL2, XYZ and others are "
               "read.";
    return {};
}

}  // namespace

void followFinger(PanelFrame& f) {
    float& scroll = f.s.scroll;
    if (!f.ui.forFingers() || scroll == 0 || ImGui::GetScrollMaxY() <= 0) return;
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + std::exchange(scroll, 0), 0.0f, ImGui::GetScrollMaxY()));
}

void beginWindow(PanelFrame& f, const char* name, int moreFlags) {
    ImGui::Begin(name, nullptr, kWindow | moreFlags);
    f.ui.window = name;
    if (ImGui::IsWindowAppearing()) f.s.restless = std::max(f.s.restless, 3);  // measured before it is shown
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    f.s.occupied.push_back({at.x, at.y, at.x + size.x, at.y + size.y});
    followFinger(f);
}

void beginGrown(PanelFrame& f, const char* name, ImVec2 at, ImVec2 pivot, float width, float height) {
    ImGui::SetNextWindowPos(ImVec2(std::round(at.x), std::round(at.y)), ImGuiCond_Always, pivot);
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, height));
    beginWindow(f, name, ImGuiWindowFlags_AlwaysAutoResize);
}

void endGrown(PanelFrame& f) {
    const float end = ImGui::GetCursorPosY();
    float& before = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("##end"), 0);
    if (std::abs(end - before) > 0.5f) f.s.restless = std::max(f.s.restless, 2);
    before = end;
    if (f.s.opening > 0 && f.ui.window == f.s.topCard()) ImGui::SetScrollY(0);  // the focus may be below
    ImGui::End();
}

bool beginCard(PanelFrame& f, const char* name, const char* title, float points, bool closable) {
    const Rectangle& window = f.s.window;
    const float edge = window.width() < f.ui.px(kTightPoints) ? 0 : f.ui.px(8);
    if (closable) drawScrim(f, (std::string("Below ") + name).c_str());
    beginGrown(f, name, window.middle(), ImVec2(0.5f, 0.5f), std::min(f.ui.px(points), window.width() - 2 * edge),
               window.height() - 2 * edge);
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
    const float x = ImGui::GetCursorPosX(), y = ImGui::GetCursorPosY();
    const float right = ImGui::GetContentRegionAvail().x - f.ui.rowHeight();
    f.ui.title(title, closable ? x + right : 0);
    const float below = ImGui::GetCursorPosY();
    if (!closable) return false;
    ImGui::SetCursorPos(ImVec2(x + right, y));
    const bool closed = f.ui.sign(Icon::close, "Close");
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), below));
    return closed;
}

void focusField(PanelFrame& f) {
    if (f.s.opening > 1 && !f.ui.forFingers() && f.ui.window == f.s.topCard()) ImGui::SetKeyboardFocusHere();
}

void focusButton(PanelFrame& f) {
    if (f.s.opening > 1 && !f.ui.forFingers() && f.ui.window == f.s.topCard()) f.ui.focusLast();
}

void beginProgress(PanelFrame& f, const char* name) {
    const Rectangle room = f.s.freeRoom();
    beginGrown(f, name, ImVec2(room.middle().x, room.top + f.ui.px(16)), ImVec2(0.5f, 0),
               std::min(f.ui.px(380), room.width() - f.ui.px(16)), room.height());
}

/// The file being read, with a cancel button.
void drawReading(PanelFrame& f) {
    if (!f.viewer.reading().another()) return;
    const Loader& loader = f.viewer.reading().loader();
    beginProgress(f, "Reading");
    f.ui.name("Reading " + shortName(loader.view().input.path));
    if (const double share = loader.progress(); share >= 0)
        f.ui.progress(share, std::to_string(std::lround(100 * share)) + " % downloaded");
    if (f.ui.button(Icon::close, "Cancel")) f.viewer.reading().cancel(f.now);
    endGrown(f);
    f.s.restless = std::max(f.s.restless, 1);  // progress continues
}

void tellFailure(PanelFrame& f) {
    Messages& messages = f.viewer.messages();
    const bool reading = f.viewer.reading().failed();
    // Splits "cannot read molecule: a.pdb: it is empty": what, then where and why.
    std::string what = messages.failure();
    const std::size_t colon = what.find(": ");
    const std::string why = colon == std::string::npos ? "" : what.substr(colon + 2);
    what = upperCase(what.substr(0, 1)) + what.substr(1, colon == std::string::npos ? colon : colon - 1);
    f.ui.warning(what);
    if (!why.empty()) f.ui.paragraph(why);
    if (const std::string advice = adviceFor(messages.failure()); !advice.empty()) f.ui.caption(advice);
    const bool again = reading && f.ui.button(Icon::none, "Try again");
    if (f.ui.word("Close", reading)) messages.dismissFailure();
    if (again) f.viewer.reading().again();
}

/// As above, in a separate card, until it is dismissed.
void drawFailure(PanelFrame& f) {
    Rectangle room = f.s.freeRoom();
    if (room.height() < f.ui.px(kErrorPoints)) room = f.s.window;
    beginGrown(f, "Error", ImVec2(room.middle().x, room.bottom - f.ui.px(16)), ImVec2(0.5f, 1),
               std::min(f.ui.px(460), room.width() - f.ui.px(16)), room.height() - f.ui.px(32));
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
    tellFailure(f);
    if (f.ui.word("Open another", true, Icon::open)) {
        f.viewer.messages().dismissFailure();
        f.s.start = true;
        f.s.restless = 2;
    }
    endGrown(f);
}

/// In the middle of the window, over everything else.
void drawQuestion(PanelFrame& f) {
    const Rectangle& window = f.s.window;
    ImGui::SetNextWindowFocus();
    beginGrown(f, "Question", window.middle(), ImVec2(0.5f, 0.5f),
               std::min(f.ui.px(340), std::max(window.width() - f.ui.px(24), 1.0f)), window.height());
    const Question question = *f.viewer.reading().question();
    const std::string yes = question.yes();
    f.ui.title((yes + "?").c_str(), 0);
    f.ui.paragraph(question.what());
    ImGui::Spacing();
    const Answer answers[] = {{"Cancel"}, {yes.c_str()}};
    const auto pressed = f.ui.answers(answers);
    focusButton(f);
    endGrown(f);
    if (!pressed) return;
    f.viewer.reading().answer(*pressed == 1, f.now);
    f.s.restless = 2;
}

/// The emphasised button loses nothing, and has the focus.
void drawQuit(PanelFrame& f) {
    constexpr float kQuitPoints = 400;
    const bool records = f.host.recording && f.host.recording().running;
    const bool saves = !records && f.viewer.hasUnsavedWork() && f.host.saveAndQuit;
    const char* stay = records ? "Keep recording" : "Cancel";
    const char* quit = records ? "Keep finished frames and quit" : "Quit";
    const bool closed = beginCard(f, "Quit", "Quit Nacre?", kQuitPoints);
    f.ui.paragraph(f.s.unsaved);
    ImGui::Spacing();
    std::vector<Answer> answers{{quit}, {stay}};
    if (saves) answers.push_back({"Save view and quit", Icon::save});
    const auto pressed = f.ui.answers(answers);
    focusButton(f);
    endGrown(f);
    if (!pressed && !closed) return;
    f.s.quitting = false;
    f.s.restless = 2;
    if (pressed == 0u) f.host.quit();
    if (pressed == 2u) f.host.saveAndQuit();
}

void drawDropped(PanelFrame& f) {
    constexpr float kDroppedPoints = 400;
    const std::vector<std::string> paths = f.s.dropped;
    const std::string title =
        "Open " + (paths.size() == 1 ? shortName(paths.front()) : std::to_string(paths.size()) + " files");
    const bool closed = beginCard(f, "Dropped", title.c_str(), kDroppedPoints);
    f.ui.paragraph("Replace the current scene, or add to it?");
    ImGui::Spacing();
    static const Answer kAnswers[] = {{"Cancel"}, {"Add"}, {"Replace", Icon::open}};
    const auto pressed = f.ui.answers(kAnswers);
    focusButton(f);
    endGrown(f);
    if (!pressed && !closed) return;
    f.s.dropped.clear();
    f.s.restless = 2;
    if (pressed.value_or(0) > 0) f.host.open(paths, *pressed == 1);
}

}  // namespace nacre::app
