// What mouse, fingers and keys do.

#include <algorithm>

#include "app/files/notices.h"
#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kHelpPoints = 620;

}  // namespace

void drawHelp(PanelFrame& f) {
    if (beginCard(f, "Help", "Help", kHelpPoints)) f.s.help = false;
    float keys = 0;
    for (const PointerBinding& b : pointerBindings())
        if (const char* hand = f.ui.forFingers() ? b.touch : b.mouse)
            keys = std::max(keys, ImGui::CalcTextSize(hand).x);
    if (!f.ui.forFingers())
        for (const Binding& b : keyBindings()) keys = std::max(keys, ImGui::CalcTextSize(b.keys).x);
    keys += f.ui.px(20);
    const bool narrow = ImGui::GetContentRegionAvail().x < keys + f.ui.px(150);  // what keys do stands below them
    const auto line = [&](const char* left, const char* right) {
        const float x = ImGui::GetCursorPosX();
        ImGui::PushStyleColor(ImGuiCol_Text, f.ui.theme().faint);
        ImGui::TextUnformatted(left);
        ImGui::PopStyleColor();
        f.ui.note("text", left);
        narrow ? ImGui::Indent(f.ui.px(12)) : ImGui::SameLine(x + keys);
        f.ui.paragraph(right);
        if (narrow) ImGui::Unindent(f.ui.px(12));
    };
    f.ui.heading(f.ui.forFingers() ? "Fingers" : "Mouse and trackpad");
    for (const PointerBinding& b : pointerBindings())
        if (const char* hand = f.ui.forFingers() ? b.touch : b.mouse) line(hand, b.what);
    if (!f.ui.forFingers()) line("double click a slider", "Type its number");
    if (f.host.shakes) line("shake", "Undo");
    if (!f.ui.forFingers()) {
        f.ui.heading("Keys");
        line("Tab", "Go about in the panel; Enter presses, Esc leaves");
        // Several keys of one command stand in one line.
        const std::span<const Binding> all = keyBindings();
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!all[i].listed) continue;
            std::string names = all[i].keys;
            while (i + 1 < all.size() && all[i + 1].command == all[i].command)
                names += std::string(", ") + all[++i].keys;
            line(names.c_str(), all[i].what);
        }
    }
    ImGui::Spacing();
    if (f.ui.button(f.s.licences ? Icon::up : Icon::down, "Licences")) f.s.licences = !f.s.licences;
    if (f.s.licences) f.ui.paragraph(notices());
    endGrown(f);
}

}  // namespace nacre::app
