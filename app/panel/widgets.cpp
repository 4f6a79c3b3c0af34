#include "app/panel/widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/panel/focus.h"

namespace nacre::app {

std::string shortened(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    std::vector<std::size_t> starts;  // of characters
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) starts.push_back(i);
    for (std::size_t kept = starts.size(); kept > 1; --kept) {
        const std::size_t head = (kept + 1) / 2, tail = kept / 2;
        std::string tried = text.substr(0, starts[std::min(head, starts.size() - 1)]) + "…" +
                            text.substr(starts[starts.size() - std::max<std::size_t>(tail, 1)]);
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
    if (focusNext->second == name) focusLastItem();
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

bool Widgets::button(Icon icon, const char* label, float width, bool primary, bool enabled) {
    const float height = rowHeight(), gap = px(8), side = icon == Icon::none ? 0 : px(15);
    const ImVec2 text = ImGui::CalcTextSize(label, nullptr, true);
    const float room = text.x + (icon == Icon::none ? 0 : side + gap);
    float wide = room + 2 * ImGui::GetStyle().FramePadding.x;
    if (width < 0) wide = ImGui::GetContentRegionAvail().x;
    if (width > 0) wide = width;
    if (primary) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme_->accent);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme_->accent);
    }
    ImGui::PushID(label);
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button("##button", ImVec2(wide, height));
    ImGui::EndDisabled();
    ImGui::PopID();
    if (primary) ImGui::PopStyleColor(2);
    const ImVec2 low = ImGui::GetItemRectMin();
    const float inner = wide - 2 * px(4);
    const std::string whole = visualText(label);
    const std::string shown = shortened(whole, inner - (icon == Icon::none ? 0 : side + gap));
    const float shownWidth = ImGui::CalcTextSize(shown.c_str()).x;
    float x = low.x + (wide - shownWidth - (icon == Icon::none ? 0 : side + gap)) / 2;
    ImVec4 ink = primary ? theme_->onAccent : theme_->text;
    if (!enabled) ink.w = 0.5f;
    const ImU32 color = ImGui::GetColorU32(ink);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (icon != Icon::none) {
        drawIcon(list, icon, ImVec2(x + side / 2, low.y + height / 2), side, color);
        x += side + gap;
    }
    list.AddText(ImVec2(std::round(x), std::round(low.y + (height - text.y) / 2)), color, shown.c_str());
    note("button", label, "", enabled);
    controls.back().cut = shown != whole;
    return pressed;
}

bool Widgets::row(Icon icon, const std::string& label, float width, bool faint) {
    const float height = rowHeight(), side = px(15), gap = px(6);
    const float wide = width < 0 ? ImGui::GetContentRegionAvail().x : width;
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::PushID(label.c_str());
    const bool pressed = ImGui::Button("##row", ImVec2(wide, height));
    ImGui::PopID();
    ImGui::PopStyleColor();
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImU32 color = ImGui::GetColorU32(faint ? theme_->faint : theme_->text);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawIcon(list, icon, ImVec2(low.x + px(2) + side / 2, low.y + height / 2), side, color);
    const std::string whole = visualText(label), shown = shortened(whole, wide - side - gap - px(4));
    list.AddText(
        ImVec2(std::round(low.x + px(2) + side + gap), std::round(low.y + (height - ImGui::GetFontSize()) / 2)), color,
        shown.c_str());
    note("button", label);
    if (!fingers_ && shown != whole && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", whole.c_str());
    return pressed;
}

bool Widgets::tool(Icon icon, const char* label, ImVec2 size, bool on, bool enabled, const char* role) {
    ImGui::PushID(label);
    ImGui::PushStyleColor(ImGuiCol_Button, on ? theme_->accent : ImVec4(0, 0, 0, 0));
    if (on) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme_->accent);
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button("##tool", size);
    ImGui::EndDisabled();
    ImGui::PopStyleColor(on ? 2 : 1);
    ImGui::PopID();
    const ImVec2 low = ImGui::GetItemRectMin();
    ImVec4 ink = on ? theme_->onAccent : theme_->text;
    if (!enabled) ink.w = 0.5f;
    const ImU32 color = ImGui::GetColorU32(ink);
    ImFont* font = fontOf(TextSize::caption);
    const float side = px(17), gap = px(4), text = font->FontSize;
    const float top = low.y + (size.y - side - gap - text) / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawIcon(list, icon, ImVec2(low.x + size.x / 2, top + side / 2), side, color);
    ImGui::PushFont(font);
    const std::string shown = shortened(label, size.x);
    const float width = ImGui::CalcTextSize(shown.c_str()).x;
    list.AddText(ImVec2(std::round(low.x + (size.x - width) / 2), std::round(top + side + gap)), color, shown.c_str());
    ImGui::PopFont();
    note(role, label, on ? "on" : "", enabled);
    controls.back().cut = shown != label;
    return pressed;
}

bool Widgets::sign(Icon icon, const char* name, bool enabled) {
    const float side = rowHeight();
    ImGui::PushID(name);
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button("##sign", ImVec2(side, side));
    ImGui::EndDisabled();
    ImGui::PopStyleColor();
    ImGui::PopID();
    const ImVec2 low = ImGui::GetItemRectMin();
    ImVec4 ink = theme_->text;
    if (!enabled) ink.w = 0.5f;
    drawIcon(*ImGui::GetWindowDrawList(), icon, ImVec2(low.x + side / 2, low.y + side / 2), px(15),
             ImGui::GetColorU32(ink));
    note("button", name, "", enabled);
    if (!fingers_ && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", name);
    return pressed;
}

bool Widgets::unfold(const char* label) {
    const bool open = ImGui::CollapsingHeader(label);
    note("heading", label, open ? "open" : "closed");
    return open;
}

/// A switch that slides, with its words to the right.
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

bool Widgets::radio(const char* label, bool on) {
    const bool pressed = ImGui::RadioButton(label, on);
    note("choice", label, on ? "on" : "off");
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

bool Widgets::field(const char* name, const char* hint, char* buffer, std::size_t size, float width, int flags) {
    if (fingers_ && askText) return askedField(name, hint, buffer, size, width);
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(width);
    const bool done = ImGui::InputTextWithHint("##field", hint, buffer, size, flags);
    edited_ = ImGui::IsItemEdited();
    ImGui::PopID();
    note("field", name, buffer);
    return done;
}

/// What the system's own keyboard is for: a field that is pressed, and shows what was typed there.
bool Widgets::askedField(const char* name, const char* hint, char* buffer, std::size_t size, float width) {
    edited_ = typed && typed->first == name;
    if (edited_) std::snprintf(buffer, size, "%s", typed->second.c_str());
    if (edited_) typed.reset();
    const float wide = width < 0 ? ImGui::GetContentRegionAvail().x : width, pad = px(10);
    ImGui::PushID(name);
    if (ImGui::Button("##field", ImVec2(wide, rowHeight()))) askText(name, buffer);
    ImGui::PopID();
    const ImVec2 low = ImGui::GetItemRectMin();
    const bool empty = buffer[0] == '\0';
    ImGui::GetWindowDrawList()->AddText(
        ImVec2(low.x + pad, std::round(low.y + (rowHeight() - ImGui::GetFontSize()) / 2)),
        ImGui::GetColorU32(empty ? theme_->faint : theme_->text),
        shortened(visualText(empty ? hint : buffer), wide - 2 * pad).c_str());
    note("field", name, buffer);
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
    if (!fingers_ && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", name);
    return pressed;
}

/// Of the text that was noted last, in the font that it is in.
void Widgets::countLines() {
    controls.back().lines = (controls.back().bottom - controls.back().top) / ImGui::GetFontSize();
}

void Widgets::heading(const char* text) {
    ImGui::Dummy(ImVec2(0, px(3)));
    ImGui::PushStyleColor(ImGuiCol_Text, theme_->faint);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    note("text", text);
    countLines();
}

void Widgets::title(const std::string& text, float right) {
    ImGui::PushFont(fontOf(TextSize::heading));
    ImGui::PushTextWrapPos(right);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    note("text", text);
    countLines();
    ImGui::PopFont();
}

void Widgets::progress(double share, const std::string& text) {
    ImGui::ProgressBar(static_cast<float>(share), ImVec2(-1, px(8)), "");
    caption(text);
}

void Widgets::caption(const std::string& text) {
    ImGui::PushFont(fontOf(TextSize::caption));
    ImGui::PushStyleColor(ImGuiCol_Text, theme_->faint);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    note("text", text);
    countLines();
    ImGui::PopFont();
}

void Widgets::paragraph(const std::string& text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(visualText(text).c_str());
    ImGui::PopTextWrapPos();
    note("text", text);
    countLines();
}

void Widgets::folderOf(const char* path) {
    if (fingers_) return;
    std::error_code none;
    const std::filesystem::path whole = std::filesystem::absolute(path, none).lexically_normal();
    if (none || !whole.has_parent_path()) return;
    ImGui::PushFont(fontOf(TextSize::caption));
    const std::string shown =
        shortened(visualText("In " + whole.parent_path().string()), ImGui::GetContentRegionAvail().x);
    ImGui::PopFont();
    caption(shown);
}

void Widgets::warning(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme_->warning);
    paragraph(text);
    ImGui::PopStyleColor();
}

void Widgets::name(const std::string& text, float width) {
    if (width <= 0) width = ImGui::GetContentRegionAvail().x;
    const std::string whole = visualText(text), shown = shortened(whole, width);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shown.c_str());
    note("text", text);
    if (!fingers_ && shown != whole && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", whole.c_str());
}

void Widgets::wrapLine(float width) {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

}  // namespace nacre::app
