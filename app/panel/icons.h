#pragma once
// Icons of buttons, drawn as lines.

#include <imgui.h>

#include <initializer_list>

namespace nacre::app {

/// Draws on a square from -1 to 1, y down.
class Pen {
public:
    Pen(ImDrawList& list, ImVec2 middle, float size, ImU32 color);

    void line(std::initializer_list<ImVec2> points, bool closed = false) const;
    void fill(std::initializer_list<ImVec2> points) const;
    void arc(ImVec2 centre, float radius, float from, float to) const;
    void ring(ImVec2 centre, float radius) const;
    void disc(ImVec2 centre, float radius) const;

private:
    ImVec2 at(ImVec2 p) const { return {middle_.x + p.x * half_, middle_.y + p.y * half_}; }

    ImDrawList& list_;
    ImVec2 middle_;
    float half_;
    ImU32 color_;
    float width_;
};

struct Icon {
    void (*draw)(const Pen&) = nullptr;
    friend bool operator==(const Icon&, const Icon&) = default;

    static const Icon none, open, save, undo, redo, fit, spin, help, close, fold, eye, eyeOff, play, pause, up, down,
        copy, previous, next, record, more;
};

/// @param middle, size  of its square, pixels
void drawIcon(ImDrawList& list, Icon icon, ImVec2 middle, float size, ImU32 color);

}  // namespace nacre::app
