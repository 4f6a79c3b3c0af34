#include "app/viewer/mouse.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace nacre::app {

using Kind = Gesture::Kind;

std::vector<Gesture> MouseGestures::button(MouseButton button, bool down, glm::dvec2 at, Modifiers with, double now) {
    if (down) {
        if (held_) return {};  // one button leads
        const Drag drag = button != MouseButton::left || with.shift ? Drag::pan
                          : with.control                            ? Drag::roll
                                                                    : Drag::rotate;
        held_ = Held{button, drag, at, at, false};
        return {{Kind::touched, at}};
    }
    if (!held_ || held_->button != button) return {};
    const Held held = *held_;
    held_.reset();
    if (held.moved) return {{Kind::released, at}};
    if (button != MouseButton::left || held.drag != Drag::rotate) return {};
    const bool twice = last_ && now - last_->when <= kDoubleClickSeconds && glm::distance(last_->at, at) <= 2 * kSlop;
    last_.reset();
    if (!twice) last_ = Click{at, now};
    return {{twice ? Kind::doubleTap : Kind::tap, held.start}};
}

std::vector<Gesture> MouseGestures::move(glm::dvec2 at, glm::dvec2 middle) {
    if (!held_) return {};
    if (!held_->moved && glm::distance(at, held_->start) <= kSlop) return {};
    const glm::dvec2 before = held_->at, by = at - before;
    held_->at = at;
    held_->moved = true;
    switch (held_->drag) {
        case Drag::rotate:
            return {{Kind::rotate, at, by}};
        case Drag::pan:
            return {{Kind::transform, at, by}};
        case Drag::roll: {
            const glm::dvec2 from = before - middle, to = at - middle;
            Gesture gesture{Kind::transform, middle};
            gesture.turn = std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
            return {gesture};
        }
    }
    return {};
}

std::vector<Gesture> MouseGestures::wheel(double steps, glm::dvec2 at) const {
    Gesture gesture{Kind::transform, at};
    gesture.scale = std::pow(kZoomPerStep, steps);
    return {gesture};
}

}  // namespace nacre::app
