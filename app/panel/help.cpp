// What mouse, fingers and keys do.

#include <algorithm>

#include "app/files/notices.h"
#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr float kHelpPoints = 620;

}  // namespace

void Panel::drawHelp() {
    Widgets& ui = state_->ui;
    if (beginCard("Help", "Help", kHelpPoints)) help_ = false;
    float keys = 0;
    for (const PointerBinding& b : pointerBindings())
        if (const char* hand = forFingers() ? b.touch : b.mouse) keys = std::max(keys, ImGui::CalcTextSize(hand).x);
    if (!forFingers())
        for (const Binding& b : keyBindings()) keys = std::max(keys, ImGui::CalcTextSize(b.keys).x);
    keys += ui.px(20);
    const bool narrow = ImGui::GetContentRegionAvail().x < keys + ui.px(150);  // what keys do stands below them
    const auto line = [&](const char* left, const char* right) {
        const float x = ImGui::GetCursorPosX();
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme().faint);
        ImGui::TextUnformatted(left);
        ImGui::PopStyleColor();
        ui.note("text", left);
        narrow ? ImGui::Indent(ui.px(12)) : ImGui::SameLine(x + keys);
        ui.paragraph(right);
        if (narrow) ImGui::Unindent(ui.px(12));
    };
    ui.heading(forFingers() ? "Fingers" : "Mouse and trackpad");
    for (const PointerBinding& b : pointerBindings())
        if (const char* hand = forFingers() ? b.touch : b.mouse) line(hand, b.what);
    if (!forFingers()) line("double click a slider", "Type its number");
    if (host_.shakes) line("shake", "Undo");
    if (!forFingers()) {
        ui.heading("Keys");
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
    if (ui.button(licences_ ? Icon::up : Icon::down, "Licences")) licences_ = !licences_;
    if (licences_) ui.paragraph(notices());
    endCard();
}

}  // namespace nacre::app
