// Sliders: text at the left, the number at the right, and below them a track with a knob.

#include <imgui.h>
#include <imgui_internal.h>  // whether somebody types into a slider

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/panel/widgets.h"

namespace nacre::app {
namespace {

/// Position of a number between two others, 0 to 1. @param byRatio  all are above 0
float shareOf(float value, float low, float high, bool byRatio) {
    const float share = byRatio ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return std::clamp(share, 0.0f, 1.0f);
}

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

/// Over the slider that Dear ImGui drew last, whose own words and knob are not seen.
/// @returns whether its words had no room
bool Widgets::drawSlider(float share, const std::string& format, double value) const {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (ImGui::TempInputIsActive(ImGui::GetItemID())) return false;
    // Splits a format into text and value: "Fog %.2f" is "Fog" and "0.50"; "%g per second" is one.
    const std::size_t at = std::min(format.find('%'), format.size());
    std::string words = format.substr(0, at), number = formatted(format.c_str() + at, value);
    if (at == 0) words = std::exchange(number, {});
    words.resize(words.find_last_not_of(' ') + 1);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = ImGui::GetStyle().FramePadding.x, room = high.x - low.x - 2 * pad, gap = px(8);
    const ImU32 ink = ImGui::GetColorU32(theme_->text), mark = ImGui::GetColorU32(theme_->mark);
    // A track alone goes through the middle.
    const bool told = !words.empty() || !number.empty();
    const float radius = px(fingers_ ? 8.0f : 5.0f), thick = px(3);
    const float y = told ? high.y - px(2) - radius : (low.y + high.y) / 2;
    const float numberWidth = ImGui::CalcTextSize(number.c_str()).x;
    const std::string shown = shortened(words, room - (number.empty() ? 0 : numberWidth + gap));
    const float textTop = low.y + std::max(y - radius - low.y - ImGui::GetFontSize() + px(3), px(1)) / 2;
    write(ImVec2(low.x + pad, textTop), ink, shown);
    write(ImVec2(high.x - pad - numberWidth, textTop), ink, number);
    const float x = low.x + pad + share * room;
    list.AddRectFilled(ImVec2(low.x + pad, y - thick / 2), ImVec2(high.x - pad, y + thick / 2),
                       ImGui::GetColorU32(theme_->line), thick / 2);
    list.AddRectFilled(ImVec2(low.x + pad, y - thick / 2), ImVec2(x, y + thick / 2), mark, thick / 2);
    list.AddCircleFilled(ImVec2(x, y), radius, mark, 24);
    return shown != words;
}

/// @param slide  draws Dear ImGui's slider @param told  format of the value for screen readers
template <typename Number, typename Slide>
bool Widgets::slider(const char* name, const Number& value, Number low, Number high, const char* format, bool byRatio,
                     const char* told, Slide&& slide) {
    ImGui::PushID(name);
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##slider"));
    const ImVec4 unseen(0, 0, 0, 0);
    for (const int which : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) ImGui::PushStyleColor(which, unseen);
    ImGui::PushStyleColor(ImGuiCol_Text, typing ? theme_->text : unseen);
    // A double click also starts typing, not only Ctrl and click.
    ImGuiIO& io = ImGui::GetIO();
    const bool control = io.KeyCtrl;
    io.KeyCtrl = control || io.MouseDoubleClicked[0];
    const bool moved = slide(ImGuiSliderFlags_AlwaysClamp | (byRatio ? ImGuiSliderFlags_Logarithmic : 0));
    io.KeyCtrl = control;
    ImGui::PopStyleColor(3);
    ImGui::PopID();
    const float share = shareOf(static_cast<float>(value), static_cast<float>(low), static_cast<float>(high), byRatio);
    const bool cut = drawSlider(share, format, static_cast<double>(value));
    note("slider", name, formatted(told, static_cast<double>(value)));
    controls.back().cut = cut;
    controls.back().inset = ImGui::GetStyle().FramePadding.x;
    if (!byRatio) controls.back().share = share;
    return moved;
}

bool Widgets::slide(const char* name, float& value, float low, float high, const char* format, bool byRatio) {
    ImGui::SetNextItemWidth(-1);
    return slider(name, value, low, high, format, byRatio, "%.2f",
                  [&](int flags) { return ImGui::SliderFloat("##slider", &value, low, high, format, flags); });
}

bool Widgets::slideWhole(const char* name, int& value, int low, int high, const char* format) {
    return slider(name, value, low, std::max(high, low + 1), format, false, "%.0f",
                  [&](int flags) { return ImGui::SliderInt("##slider", &value, low, high, format, flags); });
}

bool Widgets::slideRate(const char* name, float& value, float low, float high, const char* format) {
    return slider(name, value, low, high, format, true, format,
                  [&](int flags) { return ImGui::SliderFloat("##slider", &value, low, high, format, flags); });
}

}  // namespace nacre::app
