// Colours, as fields that are clicked.

#include "app/panel/widgets.h"
#include "app/panel/words.h"

namespace nacre::app {

std::optional<ImU32> Widgets::swatches(std::optional<ImU32> chosen, std::size_t perLine) {
    std::optional<ImU32> taken;
    std::size_t placed = 0;
    for (const NamedColor& color : nacre::app::swatches()) {
        if (placed++ % perLine != 0) ImGui::SameLine(0, px(4));
        const bool is = chosen && (*chosen | IM_COL32_A_MASK) == color.packed();
        if (swatch(color.name, color.packed(), is)) taken = color.packed();
    }
    return taken;
}

std::optional<ImU32> Widgets::pickColor(const char* name, std::optional<ImU32> chosen) {
    std::optional<ImU32> taken = swatches(chosen, 6);
    ImVec4 picked = ImGui::ColorConvertU32ToFloat4(chosen.value_or(IM_COL32(86, 180, 233, 255)));
    ImGui::SetNextItemWidth(px(200));
    if (ImGui::ColorPicker3("##picker", &picked.x,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoLabel))
        taken = ImGui::ColorConvertFloat4ToU32(ImVec4(picked.x, picked.y, picked.z, 1));
    note("colour", name);
    return taken;
}

void Widgets::showManyColors(ImVec2 corner, float side) const {
    if (side <= 0) side = rowHeight();
    const float in = px(7), cell = (side - 2 * in) / 2;
    for (std::size_t i = 0; i < 4; ++i) {
        const NamedColor& color = app::swatches()[i == 2 ? 4 : i == 3 ? 5 : i];
        const ImVec2 low(corner.x + in + static_cast<float>(i % 2) * cell,
                         corner.y + in + static_cast<float>(i / 2) * cell);
        ImGui::GetWindowDrawList()->AddRectFilled(low, ImVec2(low.x + cell, low.y + cell), color.packed());
    }
}

bool Widgets::chooseColor(const char* name, std::array<float, 3>& color, float side, bool many) {
    const ImU32 packed = ImGui::ColorConvertFloat4ToU32(ImVec4(color[0], color[1], color[2], 1));
    ImGui::PushID(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (swatch(name, many ? ImGui::GetColorU32(theme_->field) : packed, false, side)) ImGui::OpenPopup("Colour");
    if (many) showManyColors(at, side);
    bool taken = false;
    if (ImGui::BeginPopup("Colour")) {
        if (const auto other = pickColor((name + std::string(", any")).c_str(), packed)) {
            // As a saved view reads it.
            for (std::size_t i = 0; i < 3; ++i) color[i] = static_cast<float>(*other >> 8 * i & 255) / 255.0f;
            taken = true;
        }
        ImGui::EndPopup();
    }
    ImGui::PopID();
    return taken;
}

}  // namespace nacre::app
