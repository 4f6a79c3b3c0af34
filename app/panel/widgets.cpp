#include "app/panel/widgets.h"

#include <imgui_internal.h>  // Dear ImGui's own Tab only visits fields

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace nacre::app {
/// Ends typing in a field.
void Widgets::focusLast() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    if (g.LastItemData.ID == 0) return;
    ImGui::ClearActiveID();  // a field that was typed into
    ImGui::SetFocusID(g.LastItemData.ID, g.CurrentWindow);
#if IMGUI_VERSION_NUM < 19140
    g.NavDisableHighlight = false;
    g.NavDisableMouseHover = true;
#else
    g.NavCursorVisible = true;
    g.NavHighlightItemUnderNav = true;
#endif
    ImGui::ScrollToItem();
}

std::string shortened(const std::string& text, float width, Cut cut) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    std::vector<std::size_t> starts;  // byte offsets of characters
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) starts.push_back(i);
    for (std::size_t kept = starts.size(); kept-- > 1;) {
        const std::size_t tail = cut == Cut::end ? 0 : kept / 2, head = kept - tail;
        const std::size_t end = cut == Cut::end ? text.find_last_not_of(' ', starts[head] - 1) + 1 : starts[head];
        std::string tried = text.substr(0, end) + "…";
        if (tail > 0) tried += text.substr(starts[starts.size() - tail]);
        if (ImGui::CalcTextSize(tried.c_str()).x <= width) return tried;
    }
    return "…";
}

void Widgets::note(const char* role, const std::string& name, const std::string& value, bool enabled) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 clipLow = list.GetClipRectMin(), clipHigh = list.GetClipRectMax();
    Control c;
    c.role = role;
    c.name = name;
    c.value = value;
    c.left = low.x, c.top = low.y, c.right = high.x, c.bottom = high.y;
    c.seenLeft = std::max(low.x, clipLow.x), c.seenTop = std::max(low.y, clipLow.y);
    c.seenRight = std::min(high.x, clipHigh.x), c.seenBottom = std::min(high.y, clipHigh.y);
    c.enabled = enabled;
    c.focused = ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
    c.window = window;
    controls.push_back(std::move(c));
    if (!focusNext || focusNext->first + 1 != controls.size()) return;
    if (focusNext->second == name) focusLast();
    focusNext.reset();
}

void Widgets::ringFocus() const {
    if (!ImGui::IsItemFocused() || !ImGui::GetIO().NavVisible) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(ImVec2(low.x - px(3), low.y), ImVec2(high.x + px(3), high.y),
                                        ImGui::GetColorU32(theme_->mark), px(6), 0, px(2));
}

float Widgets::buttonWidth(const char* label) const {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

Widgets::Pressed Widgets::press(const char* id, const char* name, ImVec2 size, Face face, bool enabled) {
    const int colors = face == Face::field ? 0 : face == Face::clear ? 1 : 2;
    const ImVec4& accent = theme_->accent;
    if (colors > 0) ImGui::PushStyleColor(ImGuiCol_Button, colors > 1 ? accent : ImVec4(0, 0, 0, 0));
    if (colors > 1) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, accent);
    ImGui::PushID(name);
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(id, size);
    ImGui::EndDisabled();
    ImGui::PopID();
    ImGui::PopStyleColor(colors);
    ImVec4 ink = colors > 1 ? theme_->onAccent : theme_->text;
    if (!enabled) ink.w = 0.5f;
    return {pressed, ImGui::GetItemRectMin(), ImGui::GetColorU32(ink)};
}

void Widgets::write(ImVec2 at, ImU32 color, const std::string& text) const {
    ImGui::GetWindowDrawList()->AddText(ImVec2(std::round(at.x), std::round(at.y)), color, text.c_str());
}

bool Widgets::button(Icon icon, const char* label, float width, bool primary, bool enabled) {
    const float height = rowHeight(), sign = icon == Icon::none ? 0 : px(15) + px(8);
    const ImVec2 text = ImGui::CalcTextSize(label, nullptr, true);
    float wide = text.x + sign + 2 * ImGui::GetStyle().FramePadding.x;
    if (width < 0) wide = ImGui::GetContentRegionAvail().x;
    if (width > 0) wide = width;
    const auto [pressed, low, ink] =
        press("##button", label, ImVec2(wide, height), primary ? Face::accent : Face::field, enabled);
    const std::string whole = visualText(label);
    const std::string shown = shortened(whole, wide - 2 * px(4) - sign);
    const float x = low.x + (wide - ImGui::CalcTextSize(shown.c_str()).x - sign) / 2;
    const ImVec2 middle(x + px(7.5f), low.y + height / 2);
    if (icon != Icon::none) drawIcon(*ImGui::GetWindowDrawList(), icon, middle, px(15), ink);
    write(ImVec2(x + sign, low.y + (height - text.y) / 2), ink, shown);
    note("button", label, "", enabled);
    controls.back().cut = shown != whole;
    return pressed;
}

bool Widgets::word(const char* label, bool more, Icon icon) {
    constexpr float kColumnPoints = 112;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    if (more) ImGui::SameLine();
    // From the left edge: includes what is already on this line.
    const float left = ImGui::GetCursorPosX() - ImGui::GetCursorStartPos().x,
                room = left + ImGui::GetContentRegionAvail().x;
    const float columns = std::max(std::floor((room + gap) / (px(kColumnPoints) + gap)), 1.0f);
    const float cell = std::floor((room + gap) / columns);
    const float wanted = buttonWidth(label) + (icon == Icon::none ? 0 : px(23));
    const float width = std::min(std::ceil((wanted + gap) / cell), columns) * cell - gap;
    if (more && left + width > room + 0.5f) ImGui::NewLine();
    return button(icon, label, width);
}

std::optional<std::size_t> Widgets::answers(std::span<const Answer> buttons) {
    const float gap = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
    std::vector<float> widths;
    float all = -gap;
    for (const Answer& answer : buttons) {
        widths.push_back(std::max(buttonWidth(answer.label) + (answer.icon == Icon::none ? 0 : px(23)), px(80)));
        all += widths.back() + gap;
    }
    const bool stacked = all > room;
    if (!stacked) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::floor(room - all));
    std::optional<std::size_t> pressed;
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        if (i > 0 && !stacked) ImGui::SameLine();
        const auto& [label, icon, enabled] = buttons[i];
        if (button(icon, label, stacked ? -1 : widths[i], i + 1 == buttons.size(), enabled)) pressed = i;
    }
    return pressed;
}

bool Widgets::row(Icon icon, const std::string& label, float width, bool faint, const std::string& text, bool chosen) {
    const float height = rowHeight(), side = icon == Icon::none ? 0 : px(15), gap = px(6);
    const float wide = width < 0 ? ImGui::GetContentRegionAvail().x : width;
    const auto [pressed, low, ink] =
        press("##row", label.c_str(), ImVec2(wide, height), chosen ? Face::field : Face::clear);
    const ImU32 color = faint ? ImGui::GetColorU32(theme_->faint) : ink;
    drawIcon(*ImGui::GetWindowDrawList(), icon, ImVec2(low.x + px(2) + side / 2, low.y + height / 2), side, color);
    const std::string whole = visualText(text.empty() ? label : text);
    const std::string shown = shortened(whole, wide - side - gap - px(4), Cut::end);
    write(ImVec2(low.x + px(2) + side + gap, low.y + (height - ImGui::GetFontSize()) / 2), color, shown);
    note("button", label);
    if (shown != whole || !text.empty()) explain(label);
    return pressed;
}

bool Widgets::tool(Icon icon, const char* label, ImVec2 size, bool on, bool enabled, const char* role, bool alone) {
    const auto [pressed, low, ink] = press("##tool", label, size, on ? Face::accent : Face::clear, enabled);
    ImFont* font = findFont(TextSize::caption);
    const float side = px(17), gap = px(4);
    const float top = low.y + (size.y - side - (alone ? 0 : gap + font->FontSize)) / 2;
    drawIcon(*ImGui::GetWindowDrawList(), icon, ImVec2(low.x + size.x / 2, top + side / 2), side, ink);
    note(role, label, on ? "on" : "", enabled);
    if (alone) return explain(label), pressed;
    ImGui::PushFont(font);
    const std::string shown = shortened(label, size.x);
    write(ImVec2(low.x + (size.x - ImGui::CalcTextSize(shown.c_str()).x) / 2, top + side + gap), ink, shown);
    ImGui::PopFont();
    controls.back().cut = shown != label;
    return pressed;
}

bool Widgets::sign(Icon icon, const char* name, bool enabled) {
    const float side = rowHeight();
    const auto [pressed, low, ink] = press("##sign", name, ImVec2(side, side), Face::clear, enabled);
    drawIcon(*ImGui::GetWindowDrawList(), icon, ImVec2(low.x + side / 2, low.y + side / 2), px(15), ink);
    note("button", name, "", enabled);
    explain(name);
    return pressed;
}

void Widgets::explain(const std::string& text) const {
    if (!fingers_ && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
}

bool Widgets::unfold(const char* label) {
    const bool open = ImGui::CollapsingHeader(label);
    note("heading", label, open ? "open" : "closed");
    return open;
}

/// A switch, with its text to the right.
bool Widgets::toggle(const char* label, bool& on) {
    const float track = px(30), thick = px(17), room = ImGui::GetContentRegionAvail().x - track - px(8);
    const ImVec2 text = ImGui::CalcTextSize(label, nullptr, true, std::max(room, 1.0f));
    const float height = std::max(rowHeight(), text.y + px(6));
    ImGui::PushID(label);
    const bool pressed =
        ImGui::InvisibleButton("##toggle", ImVec2(track + px(8) + text.x, height), ImGuiButtonFlags_None);
    const bool hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    if (pressed) on = !on;
    const ImVec2 low = ImGui::GetItemRectMin();
    const float y = low.y + height / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 back = ImGui::GetColorU32(on ? theme_->accent : hovered && !fingers_ ? theme_->hovered : theme_->field);
    list.AddRectFilled(ImVec2(low.x, y - thick / 2), ImVec2(low.x + track, y + thick / 2), back, thick / 2);
    list.AddRect(ImVec2(low.x, y - thick / 2), ImVec2(low.x + track, y + thick / 2), ImGui::GetColorU32(theme_->faint),
                 thick / 2, 0, px(1));
    const float knob = thick / 2 - px(3);
    list.AddCircleFilled(ImVec2(on ? low.x + track - thick / 2 : low.x + thick / 2, y), knob,
                         ImGui::GetColorU32(on ? theme_->onAccent : theme_->faint), 20);
    list.AddText(nullptr, 0, ImVec2(low.x + track + px(8), std::round(y - text.y / 2)),
                 ImGui::GetColorU32(theme_->text), label, nullptr, std::max(room, 1.0f));
    ringFocus();
    note("switch", std::string(label), on ? "on" : "off");
    controls.back().lines = text.y / ImGui::GetFontSize();
    return pressed;
}

bool Widgets::choose(const char* name, std::span<const char* const> choices, std::string& current, float width) {
    bool taken = false;
    ImGui::PushID(name);
    const auto offer = [&](const char* choice, const ImVec2& size) {
        const bool pressed = ImGui::Selectable(choice, current == choice, 0, size);
        note("choice", choice, current == choice ? "on" : "off");
        if (!pressed) return;
        taken = current != choice;
        current = choice;
        unfolded_.clear();
    };
    if (!fingers_) {
        ImGui::SetNextItemWidth(width);
        const float room =
            (width < 0 ? ImGui::GetContentRegionAvail().x : width) - rowHeight() - ImGui::GetStyle().FramePadding.x;
        const std::string shown = shortened(current, room);
        const bool open = ImGui::BeginCombo("##choices", shown.c_str(), ImGuiComboFlags_HeightLarge);
        if (!open) {
            note("list", name, current);
            controls.back().cut = shown != current;
        } else {
            for (const char* choice : choices) offer(choice, ImVec2(0, 0));
            ImGui::EndCombo();
        }
        ImGui::PopID();
        return taken;
    }
    const bool open = unfolded_ == name;
    if (width > 0) width = std::min(width, ImGui::GetContentRegionAvail().x);
    if (button(open ? Icon::up : Icon::down, current.c_str(), width)) unfolded_ = open ? "" : name;
    controls.back().role = "list";
    controls.back().name = name;
    controls.back().value = current;
    if (open) {
        ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0, 0.5f));
        ImGui::Indent();
        for (const char* choice : choices) offer(choice, ImVec2(0, px(kFingerPoints)));
        ImGui::Unindent();
        ImGui::PopStyleVar();
    }
    ImGui::PopID();
    return taken;
}

bool Widgets::field(const char* name, const char* hint, std::string& text, float width, int flags) {
    if (fingers_ && askText) return askedField(name, hint, text, width);
    char buffer[kMostTyped + 1];
    std::snprintf(buffer, sizeof buffer, "%s", text.c_str());
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(width);
    const bool done = ImGui::InputTextWithHint("##field", hint, buffer, sizeof buffer, flags);
    edited_ = ImGui::IsItemEdited();
    ImGui::PopID();
    text = buffer;
    note("field", name, text);
    return done;
}

/// A field for the system's own keyboard: opens it when pressed, and shows the typed text.
bool Widgets::askedField(const char* name, const char* hint, std::string& text, float width) {
    edited_ = typed && typed->first == name;
    if (edited_) text = std::exchange(typed, std::nullopt)->second.substr(0, kMostTyped);
    const float wide = width < 0 ? ImGui::GetContentRegionAvail().x : width, pad = px(10);
    const auto [pressed, low, ink] = press("##field", name, ImVec2(wide, rowHeight()));
    if (pressed) askText(name, text);
    write(ImVec2(low.x + pad, low.y + (rowHeight() - ImGui::GetFontSize()) / 2),
          text.empty() ? ImGui::GetColorU32(theme_->faint) : ink,
          shortened(visualText(text.empty() ? hint : text), wide - 2 * pad));
    note("field", name, text);
    return edited_;
}

bool Widgets::swatch(const char* name, ImU32 color, bool chosen, float side) {
    if (side <= 0) side = rowHeight();
    ImGui::PushID(name);
    const bool pressed = ImGui::InvisibleButton("##swatch", ImVec2(side, side), ImGuiButtonFlags_None);
    ImGui::PopID();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float in = px(chosen ? 4 : 3);
    list.AddRectFilled(ImVec2(low.x + in, low.y + in), ImVec2(high.x - in, high.y - in), color | 0xff000000, px(4));
    list.AddRect(ImVec2(low.x + in, low.y + in), ImVec2(high.x - in, high.y - in), ImGui::GetColorU32(theme_->faint),
                 px(4), 0, px(1));
    if (chosen)
        list.AddRect(ImVec2(low.x + px(1), low.y + px(1)), ImVec2(high.x - px(1), high.y - px(1)),
                     ImGui::GetColorU32(theme_->mark), px(6), 0, px(2));
    ringFocus();
    note("colour", name, chosen ? "on" : "off");
    explain(name);
    return pressed;
}

void Widgets::text(const std::string& text, TextSize size, const ImVec4& color, float right) {
    ImGui::PushFont(findFont(size));
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(right);
    ImGui::TextUnformatted(visualText(text).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    note("text", text);
    controls.back().lines = (controls.back().bottom - controls.back().top) / ImGui::GetFontSize();
    ImGui::PopFont();
}

void Widgets::heading(const char* words) {
    ImGui::Dummy(ImVec2(0, px(3)));
    text(words, TextSize::body, theme_->faint);
}

void Widgets::progress(double share, const std::string& words) {
    ImGui::ProgressBar(static_cast<float>(share), ImVec2(-1, px(8)), "");
    caption(words);
}

void Widgets::openFolder(const char* path) {
    if (fingers_) return;
    std::error_code none;
    const std::filesystem::path whole = std::filesystem::absolute(path, none).lexically_normal();
    if (none || !whole.has_parent_path()) return;
    ImGui::PushFont(findFont(TextSize::caption));
    const std::string shown = shortened("In " + whole.parent_path().string(), ImGui::GetContentRegionAvail().x);
    ImGui::PopFont();
    caption(shown);
}

void Widgets::name(const std::string& text, float width) {
    if (width <= 0) width = ImGui::GetContentRegionAvail().x;
    const std::string whole = visualText(text), shown = shortened(whole, width);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shown.c_str());
    note("text", text);
    if (shown != whole) explain(whole);
}

void Widgets::wrapLine(float width) {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

}  // namespace nacre::app
