#include "app/panel/icons.h"

#include <cmath>
#include <initializer_list>

namespace nacre::app {
namespace {

constexpr float kPi = 3.14159265f;

/// Draws on a square from -1 to 1, y down.
class Pen {
public:
    Pen(ImDrawList& list, ImVec2 middle, float size, ImU32 color)
        : list_(list), middle_(middle), half_(size / 2), color_(color), width_(std::fmax(size / 12, 1.0f)) {}

    void line(std::initializer_list<ImVec2> points, bool closed = false) const {
        for (const ImVec2& p : points) list_.PathLineTo(at(p));
        list_.PathStroke(color_, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width_);
    }
    void fill(std::initializer_list<ImVec2> points) const {
        for (const ImVec2& p : points) list_.PathLineTo(at(p));
        list_.PathFillConvex(color_);
    }
    void arc(ImVec2 centre, float radius, float from, float to) const {
        list_.PathArcTo(at(centre), radius * half_, from, to, 20);
        list_.PathStroke(color_, ImDrawFlags_None, width_);
    }
    void ring(ImVec2 centre, float radius) const { list_.AddCircle(at(centre), radius * half_, color_, 20, width_); }
    void disc(ImVec2 centre, float radius) const { list_.AddCircleFilled(at(centre), radius * half_, color_, 20); }

private:
    ImVec2 at(ImVec2 p) const { return {middle_.x + p.x * half_, middle_.y + p.y * half_}; }

    ImDrawList& list_;
    ImVec2 middle_;
    float half_;
    ImU32 color_;
    float width_;
};

void drawEye(const Pen& pen) {
    pen.line(
        {{-0.9f, 0}, {-0.5f, -0.4f}, {0, -0.55f}, {0.5f, -0.4f}, {0.9f, 0}, {0.5f, 0.4f}, {0, 0.55f}, {-0.5f, 0.4f}},
        true);
    pen.disc({0, 0}, 0.24f);
}

/// An arrow that goes back; `s` -1: forth.
void drawTurn(const Pen& pen, float s) {
    pen.line({{-0.35f * s, -0.85f}, {-0.8f * s, -0.4f}, {-0.35f * s, 0.05f}});
    pen.line({{-0.8f * s, -0.4f},
              {0.25f * s, -0.4f},
              {0.65f * s, -0.2f},
              {0.8f * s, 0.2f},
              {0.65f * s, 0.6f},
              {0.25f * s, 0.78f},
              {-0.3f * s, 0.78f}});
}

void drawFit(const Pen& pen) {
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
            pen.line({{0.35f * x, 0.8f * y}, {0.8f * x, 0.8f * y}, {0.8f * x, 0.35f * y}});
    pen.disc({0, 0}, 0.25f);
}

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 middle, float size, ImU32 color) {
    const Pen pen(list, middle, size, color);
    switch (icon) {
        case Icon::none:
            return;
        case Icon::open:
            return pen.line(
                {{-0.85f, 0.65f}, {-0.85f, -0.6f}, {-0.25f, -0.6f}, {-0.05f, -0.35f}, {0.85f, -0.35f}, {0.85f, 0.65f}},
                true);
        case Icon::save:
            pen.line({{0, -0.85f}, {0, 0.3f}});
            pen.line({{-0.45f, -0.15f}, {0, 0.3f}, {0.45f, -0.15f}});
            return pen.line({{-0.8f, 0.35f}, {-0.8f, 0.8f}, {0.8f, 0.8f}, {0.8f, 0.35f}});
        case Icon::undo:
            return drawTurn(pen, 1);
        case Icon::redo:
            return drawTurn(pen, -1);
        case Icon::fit:
            return drawFit(pen);
        case Icon::spin:
            pen.arc({0, 0}, 0.75f, -0.35f * kPi, 1.35f * kPi);
            return pen.fill({{0.05f, -0.95f}, {0.65f, -0.75f}, {0.2f, -0.3f}});
        case Icon::help:
            pen.arc({0, -0.35f}, 0.4f, -kPi, 0.4f * kPi);
            pen.line({{0.13f, 0.03f}, {0, 0.15f}, {0, 0.35f}});
            return pen.disc({0, 0.72f}, 0.12f);
        case Icon::close:
            pen.line({{-0.6f, -0.6f}, {0.6f, 0.6f}});
            return pen.line({{-0.6f, 0.6f}, {0.6f, -0.6f}});
        case Icon::fold:
            return pen.line({{0.3f, -0.65f}, {-0.35f, 0}, {0.3f, 0.65f}});
        case Icon::label:
            for (const float y : {-0.6f, 0.0f, 0.6f}) pen.line({{-0.8f, y}, {y > 0.3f ? 0.2f : 0.8f, y}});
            return;
        case Icon::eye:
            return drawEye(pen);
        case Icon::eyeOff:
            drawEye(pen);
            return pen.line({{-0.75f, 0.75f}, {0.75f, -0.75f}});
        case Icon::play:
            return pen.fill({{-0.5f, -0.7f}, {0.75f, 0}, {-0.5f, 0.7f}});
        case Icon::pause:
            pen.fill({{-0.6f, -0.7f}, {-0.2f, -0.7f}, {-0.2f, 0.7f}, {-0.6f, 0.7f}});
            return pen.fill({{0.2f, -0.7f}, {0.6f, -0.7f}, {0.6f, 0.7f}, {0.2f, 0.7f}});
        case Icon::up:
            return pen.line({{-0.6f, 0.3f}, {0, -0.35f}, {0.6f, 0.3f}});
        case Icon::down:
            return pen.line({{-0.6f, -0.3f}, {0, 0.35f}, {0.6f, -0.3f}});
        case Icon::previous:
            pen.fill({{0.6f, -0.7f}, {-0.4f, 0}, {0.6f, 0.7f}});
            return pen.line({{-0.6f, -0.7f}, {-0.6f, 0.7f}});
        case Icon::next:
            pen.fill({{-0.6f, -0.7f}, {0.4f, 0}, {-0.6f, 0.7f}});
            return pen.line({{0.6f, -0.7f}, {0.6f, 0.7f}});
        case Icon::record:
            pen.ring({0, 0}, 0.8f);
            return pen.disc({0, 0}, 0.42f);
        case Icon::copy:
            pen.line({{-0.3f, -0.8f}, {0.75f, -0.8f}, {0.75f, 0.35f}, {-0.3f, 0.35f}}, true);
            return pen.line({{-0.3f, -0.35f}, {-0.75f, -0.35f}, {-0.75f, 0.8f}, {0.3f, 0.8f}, {0.3f, 0.35f}});
        case Icon::look:
            pen.ring({-0.25f, 0.2f}, 0.55f);
            return pen.ring({0.4f, -0.35f}, 0.4f);
        case Icon::parts:
            for (const float y : {-0.6f, 0.0f, 0.6f}) {
                pen.disc({-0.7f, y}, 0.16f);
                pen.line({{-0.3f, y}, {0.85f, y}});
            }
            return;
        case Icon::select:
            return pen.line({{-0.5f, -0.8f}, {0.65f, 0.25f}, {0.1f, 0.3f}, {0.4f, 0.85f}, {-0.1f, 0.4f}, {-0.5f, 0.7f}},
                            true);
        case Icon::more:
            for (const float x : {-0.65f, 0.0f, 0.65f}) pen.disc({x, 0}, 0.18f);
            return;
    }
}

}  // namespace nacre::app
