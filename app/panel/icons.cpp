#include "app/panel/icons.h"

#include <cmath>

namespace nacre::app {
namespace {

constexpr float kPi = 3.14159265f;

void drawEye(const Pen& pen) {
    pen.line(
        {{-0.9f, 0}, {-0.5f, -0.4f}, {0, -0.55f}, {0.5f, -0.4f}, {0.9f, 0}, {0.5f, 0.4f}, {0, 0.55f}, {-0.5f, 0.4f}},
        true);
    pen.disc({0, 0}, 0.24f);
}

/// An arrow back; with `s` -1, forward.
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

Pen::Pen(ImDrawList& list, ImVec2 middle, float size, ImU32 color)
    : list_(list), middle_(middle), half_(size / 2), color_(color), width_(std::fmax(size / 12, 1.0f)) {}

void Pen::line(std::initializer_list<ImVec2> points, bool closed) const {
    for (const ImVec2& p : points) list_.PathLineTo(at(p));
    list_.PathStroke(color_, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width_);
}

void Pen::fill(std::initializer_list<ImVec2> points) const {
    for (const ImVec2& p : points) list_.PathLineTo(at(p));
    list_.PathFillConvex(color_);
}

void Pen::arc(ImVec2 centre, float radius, float from, float to) const {
    list_.PathArcTo(at(centre), radius * half_, from, to, 20);
    list_.PathStroke(color_, ImDrawFlags_None, width_);
}

void Pen::ring(ImVec2 centre, float radius) const { list_.AddCircle(at(centre), radius * half_, color_, 20, width_); }
void Pen::disc(ImVec2 centre, float radius) const { list_.AddCircleFilled(at(centre), radius * half_, color_, 20); }

const Icon Icon::none{};
const Icon Icon::open{[](const Pen& pen) {
    pen.line({{-0.85f, 0.65f}, {-0.85f, -0.6f}, {-0.25f, -0.6f}, {-0.05f, -0.35f}, {0.85f, -0.35f}, {0.85f, 0.65f}},
             true);
}};
const Icon Icon::save{[](const Pen& pen) {
    pen.line({{0, -0.85f}, {0, 0.3f}});
    pen.line({{-0.45f, -0.15f}, {0, 0.3f}, {0.45f, -0.15f}});
    pen.line({{-0.8f, 0.35f}, {-0.8f, 0.8f}, {0.8f, 0.8f}, {0.8f, 0.35f}});
}};
const Icon Icon::undo{[](const Pen& pen) { drawTurn(pen, 1); }};
const Icon Icon::redo{[](const Pen& pen) { drawTurn(pen, -1); }};
const Icon Icon::fit{[](const Pen& pen) { drawFit(pen); }};
const Icon Icon::spin{[](const Pen& pen) {
    pen.arc({0, 0}, 0.75f, -0.35f * kPi, 1.35f * kPi);
    pen.fill({{0.05f, -0.95f}, {0.65f, -0.75f}, {0.2f, -0.3f}});
}};
const Icon Icon::help{[](const Pen& pen) {
    pen.arc({0, -0.35f}, 0.4f, -kPi, 0.4f * kPi);
    pen.line({{0.13f, 0.03f}, {0, 0.15f}, {0, 0.35f}});
    pen.disc({0, 0.72f}, 0.12f);
}};
const Icon Icon::close{[](const Pen& pen) {
    pen.line({{-0.6f, -0.6f}, {0.6f, 0.6f}});
    pen.line({{-0.6f, 0.6f}, {0.6f, -0.6f}});
}};
const Icon Icon::fold{[](const Pen& pen) { pen.line({{0.3f, -0.65f}, {-0.35f, 0}, {0.3f, 0.65f}}); }};
const Icon Icon::eye{[](const Pen& pen) { drawEye(pen); }};
const Icon Icon::eyeOff{[](const Pen& pen) {
    drawEye(pen);
    pen.line({{-0.75f, 0.75f}, {0.75f, -0.75f}});
}};
const Icon Icon::play{[](const Pen& pen) { pen.fill({{-0.5f, -0.7f}, {0.75f, 0}, {-0.5f, 0.7f}}); }};
const Icon Icon::pause{[](const Pen& pen) {
    pen.fill({{-0.6f, -0.7f}, {-0.2f, -0.7f}, {-0.2f, 0.7f}, {-0.6f, 0.7f}});
    pen.fill({{0.2f, -0.7f}, {0.6f, -0.7f}, {0.6f, 0.7f}, {0.2f, 0.7f}});
}};
const Icon Icon::up{[](const Pen& pen) { pen.line({{-0.6f, 0.3f}, {0, -0.35f}, {0.6f, 0.3f}}); }};
const Icon Icon::down{[](const Pen& pen) { pen.line({{-0.6f, -0.3f}, {0, 0.35f}, {0.6f, -0.3f}}); }};
const Icon Icon::copy{[](const Pen& pen) {
    pen.line({{-0.3f, -0.8f}, {0.75f, -0.8f}, {0.75f, 0.35f}, {-0.3f, 0.35f}}, true);
    pen.line({{-0.3f, -0.35f}, {-0.75f, -0.35f}, {-0.75f, 0.8f}, {0.3f, 0.8f}, {0.3f, 0.35f}});
}};
const Icon Icon::previous{[](const Pen& pen) {
    pen.fill({{0.6f, -0.7f}, {-0.4f, 0}, {0.6f, 0.7f}});
    pen.line({{-0.6f, -0.7f}, {-0.6f, 0.7f}});
}};
const Icon Icon::next{[](const Pen& pen) {
    pen.fill({{-0.6f, -0.7f}, {0.4f, 0}, {-0.6f, 0.7f}});
    pen.line({{0.6f, -0.7f}, {0.6f, 0.7f}});
}};
const Icon Icon::record{[](const Pen& pen) {
    pen.ring({0, 0}, 0.8f);
    pen.disc({0, 0}, 0.42f);
}};
const Icon Icon::more{[](const Pen& pen) {
    for (const float x : {-0.65f, 0.0f, 0.65f}) pen.disc({x, 0}, 0.18f);
}};

void drawIcon(ImDrawList& list, Icon icon, ImVec2 middle, float size, ImU32 color) {
    if (icon.draw) icon.draw(Pen(list, middle, size, color));
}

}  // namespace nacre::app
