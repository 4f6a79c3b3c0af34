// Help: explains the picture, and lists mouse, touch and keys. Title and search stay in place while the list scrolls.

#include <algorithm>
#include <vector>

#include "app/files/notices.h"
#include "app/panel/panel_state.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

constexpr float kHelpPoints = 620, kLowestListPoints = 120;

struct HelpLine {
    std::string keys, what;
};

std::vector<HelpLine> pointerLines(const PanelFrame& f) {
    const bool fingers = f.ui.forFingers();
    std::vector<HelpLine> lines;
    for (const PointerBinding& b : pointerBindings())
        if (const char* hand = fingers ? b.touch : b.mouse) lines.push_back({hand, b.what});
    if (!fingers) lines.push_back({"double click a slider", "Type its number"});
    if (f.host.shakes) lines.push_back({"shake", "Undo"});
    return lines;
}

/// Keys of one command share a line.
std::vector<HelpLine> keyLines(const PanelFrame& f) {
    std::vector<HelpLine> lines{{"Tab, Shift Tab", "Move between controls; Enter presses, Esc leaves"}};
    const std::span<const Binding> all = keyBindings();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].command == ViewerCommand::captureFrame && !f.host.captures) continue;
        std::string keys = all[i].keys;
        while (i + 1 < all.size() && all[i + 1].command == all[i].command) keys += std::string(", ") + all[++i].keys;
        lines.push_back({keys, all[i].what});
    }
    return lines;
}

/// The lines that match the search, under their heading.
void drawLines(PanelFrame& f, const char* heading, std::vector<HelpLine> lines, float keys) {
    const std::string sought = lowerCase(f.s.helpSearch);
    std::erase_if(lines, [&](const HelpLine& line) {
        return lowerCase(line.keys + " " + line.what).find(sought) == std::string::npos;
    });
    if (lines.empty()) return;
    f.ui.heading(heading);
    const bool narrow = ImGui::GetContentRegionAvail().x < keys + f.ui.px(150);  // the text is below the keys
    for (const HelpLine& line : lines) {
        const float x = ImGui::GetCursorPosX();
        ImGui::PushStyleColor(ImGuiCol_Text, f.ui.theme().faint);
        ImGui::TextUnformatted(line.keys.c_str());
        ImGui::PopStyleColor();
        f.ui.note("text", line.keys);
        narrow ? ImGui::Indent(f.ui.px(12)) : ImGui::SameLine(x + keys);
        f.ui.paragraph(line.what);
        if (narrow) ImGui::Unindent(f.ui.px(12));
    }
}

void drawList(PanelFrame& f) {
    const std::vector<HelpLine> hand = pointerLines(f);
    const std::vector<HelpLine> keys = f.ui.forFingers() ? std::vector<HelpLine>() : keyLines(f);
    float width = 0;
    for (const auto* lines : {&hand, &keys})
        for (const HelpLine& line : *lines) width = std::max(width, ImGui::CalcTextSize(line.keys.c_str()).x);
    width += f.ui.px(20);
    if (f.s.helpSearch.empty() && f.viewer.document()) {
        f.ui.heading("What am I seeing?");
        f.ui.paragraph(f.viewer.explanation());
    }
    drawLines(f, f.ui.forFingers() ? "Fingers" : "Mouse and trackpad", hand, width);
    drawLines(f, "Keys", keys, width);
    if (!f.s.helpSearch.empty()) return;
    ImGui::Spacing();
    if (f.ui.button(f.s.licences ? Icon::up : Icon::down, "Licences")) f.s.licences = !f.s.licences;
    if (f.s.licences) f.ui.paragraph(notices());
}

}  // namespace

void drawHelp(PanelFrame& f) {
    if (beginCard(f, "Help", "Help", kHelpPoints)) f.s.help = false;
    focusField(f);
    if (f.ui.typable()) f.ui.field("Search the help", "a key, or what it does", f.s.helpSearch);
    // Height of its contents in the last frame, limited by the window.
    float& content = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("##content"), 0);
    const float most = f.s.window.height() - ImGui::GetCursorPosY() - f.ui.px(40);
    const float height = std::clamp(content, f.ui.px(kLowestListPoints), std::max(most, f.ui.px(kLowestListPoints)));
    ImGui::BeginChild("List", ImVec2(0, height), false, ImGuiWindowFlags_NavFlattened);
    followFinger(f);
    drawList(f);
    const float end = ImGui::GetCursorPosY();
    ImGui::EndChild();
    if (end != content) f.s.restless = std::max(f.s.restless, 2);
    content = end;
    endGrown(f);
}

}  // namespace nacre::app
