// Numbers that are slid: words stand at the left, the number at the right, and below them a track with a knob.

#include <imgui.h>
#include <imgui_internal.h>  // whether somebody types into a slider

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/panel/widgets.h"

namespace nacre::app {
namespace {

/// Where a number stands between two others, 0 to 1. @param byRatio  all are above 0
float shareOf(float value, float low, float high, bool byRatio) {
    const float share = byRatio ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return std::clamp(share, 0.0f, 1.0f);
}

/// A format's words, and what comes of the rest: "Fog %.2f" is "Fog" and "0.50", "%g a second" is one.
struct Said {
    std::string words, number;
};
template <typename Number>
Said said(const std::string& format, Number number) {
    const std::size_t at = format.find('%');
    if (at == std::string::npos) return {format, ""};
    char text[64];
    std::snprintf(text, sizeof text, format.c_str() + at, number);
    if (at == 0) return {text, ""};
    return {format.substr(0, format.find_last_not_of(' ', at - 1) + 1), text};
}

}  // namespace

/// Over the slider that Dear ImGui drew last, whose own words and knob are not seen.
bool Widgets::drawSlider(float share, const std::string& words, const std::string& number) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (ImGui::TempInputIsActive(ImGui::GetItemID())) return false;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = ImGui::GetStyle().FramePadding.x, room = high.x - low.x - 2 * pad, gap = px(8);
    const ImU32 ink = ImGui::GetColorU32(theme_->text), mark = ImGui::GetColorU32(theme_->mark);
    // A track alone goes through the middle.
    const bool told = !words.empty() || !number.empty();
    const float radius = px(fingers_ ? 8.0f : 5.0f), thick = px(3);
    const float y = told ? high.y - px(2) - radius : (low.y + high.y) / 2;
    const float numberWidth = ImGui::CalcTextSize(number.c_str()).x;
    const std::string shown = shortened(words, room - (number.empty() ? 0 : numberWidth + gap));
    const float textTop = std::round(low.y + std::max(y - radius - low.y - ImGui::GetFontSize() + px(3), px(1)) / 2);
    list.AddText(ImVec2(std::round(low.x + pad), textTop), ink, shown.c_str());
    list.AddText(ImVec2(std::round(high.x - pad - numberWidth), textTop), ink, number.c_str());
    const float x = low.x + pad + share * room;
    list.AddRectFilled(ImVec2(low.x + pad, y - thick / 2), ImVec2(high.x - pad, y + thick / 2),
                       ImGui::GetColorU32(theme_->line), thick / 2);
    list.AddRectFilled(ImVec2(low.x + pad, y - thick / 2), ImVec2(x, y + thick / 2), mark, thick / 2);
    list.AddCircleFilled(ImVec2(x, y), radius, mark, 24);
    return shown != words;
}

template <typename Slide>
bool Widgets::slider(const char* name, Slide&& slide) {
    ImGui::PushID(name);
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##slider"));
    const ImVec4 unseen(0, 0, 0, 0);
    for (const int which : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) ImGui::PushStyleColor(which, unseen);
    ImGui::PushStyleColor(ImGuiCol_Text, typing ? theme_->text : unseen);
    // A double click types a number, too, not Ctrl and a click alone.
    ImGuiIO& io = ImGui::GetIO();
    const bool control = io.KeyCtrl;
    io.KeyCtrl = control || io.MouseDoubleClicked[0];
    const bool moved = slide();
    io.KeyCtrl = control;
    ImGui::PopStyleColor(3);
    ImGui::PopID();
    return moved;
}

bool Widgets::slide(const char* name, float& value, float low, float high, const char* format, int flags) {
    ImGui::SetNextItemWidth(-1);
    const bool byRatio = (flags & ImGuiSliderFlags_Logarithmic) != 0;
    const bool moved = slider(name, [&] {
        return ImGui::SliderFloat("##slider", &value, low, high, format, flags | ImGuiSliderFlags_AlwaysClamp);
    });
    const float share = shareOf(value, low, high, byRatio);
    const Said text = said(format, static_cast<double>(value));
    const bool cut = drawSlider(share, text.words, text.number);
    char told[64];
    std::snprintf(told, sizeof told, "%.2f", static_cast<double>(value));
    note("slider", name, told);
    controls.back().cut = cut;
    controls.back().inset = ImGui::GetStyle().FramePadding.x;
    if (!byRatio) controls.back().share = share;
    return moved;
}

bool Widgets::slideWhole(const char* name, int& value, int low, int high, const char* format) {
    const bool moved = slider(
        name, [&] { return ImGui::SliderInt("##slider", &value, low, high, format, ImGuiSliderFlags_AlwaysClamp); });
    const float share =
        shareOf(static_cast<float>(value), static_cast<float>(low), static_cast<float>(std::max(high, low + 1)), false);
    const Said text = said(format, value);
    const bool cut = drawSlider(share, text.words, text.number);
    note("slider", name, std::to_string(value));
    controls.back().cut = cut;
    controls.back().inset = ImGui::GetStyle().FramePadding.x;
    controls.back().share = share;
    return moved;
}

bool Widgets::slideRate(const char* name, float& value, float low, float high, const char* format) {
    const bool moved = slider(name, [&] {
        return ImGui::SliderFloat("##slider", &value, low, high, format,
                                  ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    });
    const Said text = said(format, static_cast<double>(value));
    const bool cut = drawSlider(shareOf(value, low, high, true), text.words, text.number);
    char told[64];
    std::snprintf(told, sizeof told, format, static_cast<double>(value));
    note("slider", name, told);
    controls.back().cut = cut;
    return moved;
}

}  // namespace nacre::app
