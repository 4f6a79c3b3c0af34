// Marks on picked atoms, and the lines of text below.

#include "app/panel/panel.h"
#include "app/panel/panel_style.h"

namespace nacre::app {

void Panel::drawAnnotations(const Annotations& a) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();  // beneath panel and help
    const auto place = [&](const glm::dvec2& p) {
        return ImVec2(static_cast<float>(p.x) * scale(), static_cast<float>(p.y) * scale());
    };
    for (std::size_t i = 1; i < a.atoms.size(); ++i) {
        list.AddLine(place(a.atoms[i - 1]), place(a.atoms[i]), kMarkEdge, 5 * scale());
        list.AddLine(place(a.atoms[i - 1]), place(a.atoms[i]), kMark, 2 * scale());
    }
    for (const glm::dvec2& atom : a.atoms) {
        list.AddCircle(place(atom), 8 * scale(), kMarkEdge, 24, 5 * scale());
        list.AddCircle(place(atom), 8 * scale(), kMark, 24, 2 * scale());
    }
    float bottom = ImGui::GetIO().DisplaySize.y - insets_.bottom - 14 * scale();
    const float line = ImGui::GetTextLineHeight() + 20 * scale();
    for (const auto& [text, strong] :
         {std::pair(a.message, false), std::pair(a.measurement, true), std::pair(a.atom, false)}) {
        if (text.empty()) continue;
        drawStatus(text, bottom, strong);
        bottom -= line;
    }
}

/// One line in a dark box, low in the middle of the window.
void Panel::drawStatus(const std::string& text, float bottom, bool strong) {
    const float room = ImGui::GetIO().DisplaySize.x - insets_.left - insets_.right;
    const float widest = room - 48 * scale();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest);
    const float left = insets_.left + (room - size.x) / 2;
    const ImVec2 pad(12 * scale(), 7 * scale());
    // A panel for fingers leaves no room beside it: it covers the text.
    ImDrawList& list = forFingers() ? *ImGui::GetBackgroundDrawList() : *ImGui::GetForegroundDrawList();
    list.AddRectFilled(ImVec2(left - pad.x, bottom - size.y - 2 * pad.y), ImVec2(left + size.x + pad.x, bottom),
                       ImGui::GetColorU32(kGround), 7 * scale());
    list.AddText(nullptr, 0, ImVec2(left, bottom - size.y - pad.y), ImGui::GetColorU32(strong ? kWarning : kText),
                 text.c_str(), nullptr, widest);
}

}  // namespace nacre::app
