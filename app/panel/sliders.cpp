// Sliders: text, a track with a knob, and the number.

#include <imgui.h>
#include <imgui_internal.h>  // whether the user types into a slider

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panel/widgets.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

/// Position of a number between two others, 0 to 1. @param byRatio  all are above 0
float toShare(float value, float low, float high, bool byRatio) {
    const float share = byRatio ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return std::clamp(share, 0.0f, 1.0f);
}

}  // namespace

/// "Fog %.2f" is split into "Fog" and "0.50"; "%g per second" is one text.
struct Widgets::SliderText {
    std::string words, number;

    SliderText(const std::string& format, double value) {
        const std::size_t at = std::min(format.find('%'), format.size());
        words = format.substr(0, at);
        number = formatted(format.c_str() + at, value);
        if (at == 0) words = std::exchange(number, {});
        words.resize(words.find_last_not_of(": ") + 1);
    }
};

/// Draws over Dear ImGui's last slider, whose own knob is invisible: a track with a knob at half height. @param below
/// its text is above it, within the slider
void Widgets::drawTrack(float share, bool below) const {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (ImGui::TempInputIsActive(ImGui::GetItemID())) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = ImGui::GetStyle().FramePadding.x, room = high.x - low.x - 2 * pad;
    const float radius = px(fingers_ ? 8.0f : 6.0f), thick = px(4);
    const float y = below ? high.y - px(2) - radius : (low.y + high.y) / 2, x = low.x + pad + share * room;
    const ImU32 mark = ImGui::GetColorU32(theme_->mark);
    list.AddRectFilled(ImVec2(low.x + pad, y - thick / 2), ImVec2(high.x - pad, y + thick / 2),
                       ImGui::GetColorU32(theme_->line), thick / 2);
    list.AddRectFilled(ImVec2(low.x + pad, y - thick / 2), ImVec2(x, y + thick / 2), mark, thick / 2);
    list.AddCircleFilled(ImVec2(x, y), radius, mark, 24);
}

/// Draws the text within the last slider, above the track. @returns whether it was truncated
bool Widgets::drawSliderText(const SliderText& text) const {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (ImGui::TempInputIsActive(ImGui::GetItemID())) return false;
    const float pad = ImGui::GetStyle().FramePadding.x, room = high.x - low.x - 2 * pad;
    const float numberWidth = ImGui::CalcTextSize(text.number.c_str()).x;
    const std::string shown = shortened(text.words, room - (text.number.empty() ? 0 : numberWidth + px(8)));
    const float track = px(2) + 2 * px(fingers_ ? 8.0f : 6.0f);
    const float top = low.y + std::max(high.y - low.y - track - ImGui::GetFontSize() + px(3), px(1)) / 2;
    const ImU32 ink = ImGui::GetColorU32(theme_->text);
    write(ImVec2(low.x + pad, top), ink, shown);
    write(ImVec2(high.x - pad - numberWidth, top), ink, text.number);
    return shown != text.words;
}

/// @param slide  draws Dear ImGui's slider @param told  format of the value for screen readers
template <typename Number, typename Slide>
bool Widgets::slider(const char* name, const Number& value, Number low, Number high, const SliderText* text,
                     bool byRatio, const char* told, Slide&& slide) {
    ImGui::PushID(name);
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##slider"));
    const ImVec4 unseen(0, 0, 0, 0);
    for (const int which : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) ImGui::PushStyleColor(which, unseen);
    ImGui::PushStyleColor(ImGuiCol_Text, typing ? theme_->text : unseen);
    // A double click also starts typing, in addition to Ctrl and click.
    ImGuiIO& io = ImGui::GetIO();
    const bool control = io.KeyCtrl;
    io.KeyCtrl = control || io.MouseDoubleClicked[0];
    const bool moved = slide(ImGuiSliderFlags_AlwaysClamp | (byRatio ? ImGuiSliderFlags_Logarithmic : 0));
    io.KeyCtrl = control;
    ImGui::PopStyleColor(3);
    ImGui::PopID();
    const float share = toShare(static_cast<float>(value), static_cast<float>(low), static_cast<float>(high), byRatio);
    drawTrack(share, text && !text->words.empty());
    const bool cut = text && drawSliderText(*text);
    note("slider", name, formatted(told, static_cast<double>(value)));
    controls.back().cut = cut;
    controls.back().inset = ImGui::GetStyle().FramePadding.x;
    if (!byRatio) controls.back().share = share;
    return moved;
}

/// Text, track and number in one row; in two if the text is long.
bool Widgets::slide(const char* name, float& value, float low, float high, const char* format, bool byRatio) {
    constexpr float kLabelShare = 0.42f, kNumberPoints = 48;
    const float least = px(fingers_ ? 2.75f * kFingerPoints : 72);  // of the track
    const SliderText text(format, static_cast<double>(value));
    const float x = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x, gap = px(6);
    const float words = ImGui::CalcTextSize(text.words.c_str()).x;
    const float number = std::max(ImGui::CalcTextSize(text.number.c_str()).x, px(kNumberPoints));
    float label = std::max(kLabelShare * room, words + gap);
    const bool above = room - label - number - gap < least;
    ImGui::AlignTextToFramePadding();
    if (above) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(text.words.c_str());
        ImGui::PopTextWrapPos();
        label = 0;
    } else {
        ImGui::TextUnformatted(text.words.c_str());
        ImGui::SameLine(x + label);
    }
    ImGui::SetNextItemWidth(room - label - number - gap);
    for (const int which : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
        ImGui::PushStyleColor(which, ImVec4(0, 0, 0, 0));
    const bool moved = slider(name, value, low, high, nullptr, byRatio, "%.2f", [&](int flags) {
        return ImGui::SliderFloat("##slider", &value, low, high, format, flags);
    });
    ImGui::PopStyleColor(3);
    const ImVec2 corner = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
    write(ImVec2(end.x + gap + number - ImGui::CalcTextSize(text.number.c_str()).x,
                 (corner.y + end.y - ImGui::GetFontSize()) / 2),
          ImGui::GetColorU32(theme_->text), text.number);
    return moved;
}

bool Widgets::slideWhole(const char* name, int& value, int low, int high, const char* format) {
    const SliderText text(format, value);
    return slider(name, value, low, std::max(high, low + 1), &text, false, "%.0f",
                  [&](int flags) { return ImGui::SliderInt("##slider", &value, low, high, format, flags); });
}

bool Widgets::slideRate(const char* name, float& value, float low, float high, const char* format) {
    const SliderText text(format, static_cast<double>(value));
    return slider(name, value, low, high, &text, true, format,
                  [&](int flags) { return ImGui::SliderFloat("##slider", &value, low, high, format, flags); });
}

}  // namespace nacre::app
