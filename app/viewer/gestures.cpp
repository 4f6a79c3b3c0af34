#include "app/viewer/gestures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

namespace nacre::app {

using Kind = Gesture::Kind;

std::vector<Gesture> TouchGestures::handle(const TouchEvent& event, double now) {
    std::vector<Gesture> out = tick(now);
    switch (event.phase) {
        case TouchPhase::began:
            if (fingers_.empty()) wandered_ = dragging_ = pressed_ = three_ = false;
            fingers_[event.finger] = {event.at, event.at, now};
            if (fingers_.size() > 1) wandered_ = true;
            three_ |= fingers_.size() > 2;
            pinching_ = false;
            for (auto& [name, finger] : fingers_) finger.start = finger.at;
            out.push_back({Kind::touched, event.at});
            break;
        case TouchPhase::moved:
            move(event, out);
            break;
        case TouchPhase::ended:
            lift(event, now, out);
            break;
        case TouchPhase::cancelled:
            clear();
            break;
    }
    return out;
}

void TouchGestures::move(const TouchEvent& event, std::vector<Gesture>& out) {
    const auto it = fingers_.find(event.finger);
    if (it == fingers_.end()) return;
    Finger& finger = it->second;
    const glm::dvec2 before = finger.at;
    if (fingers_.size() == 1) {
        if (three_) return;
        if (!wandered_ && glm::distance(event.at, finger.start) <= kSlop) return;
        finger.at = event.at;
        // Drops the distance before a drag was recognised: the picture must not jump.
        if (wandered_) {
            out.push_back({Kind::rotate, event.at, event.at - before});
            dragging_ = true;
        }
        wandered_ = true;
        return;
    }
    finger.at = event.at;
    if (three_) return;
    // Fingers that come down one after the other move nothing until their number is known.
    if (!pinching_ && glm::distance(event.at, finger.start) <= kSlop) return;
    pinching_ = true;
    const auto second = std::next(fingers_.begin());
    const glm::dvec2 other = it == second ? fingers_.begin()->second.at : second->second.at;
    const glm::dvec2 from = before - other, to = event.at - other;
    const double lengthFrom = glm::length(from), lengthTo = glm::length(to);
    Gesture gesture{Kind::transform, (event.at + other) / 2.0, (event.at - before) / 2.0};
    if (lengthFrom > 1 && lengthTo > 1) {
        gesture.scale = lengthTo / lengthFrom;
        gesture.turn = std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
    }
    out.push_back(gesture);
    dragging_ = true;
}

void TouchGestures::lift(const TouchEvent& event, double now, std::vector<Gesture>& out) {
    const auto it = fingers_.find(event.finger);
    if (it == fingers_.end()) return;
    const Finger finger = it->second;
    if (three_) swipe(out);
    fingers_.erase(it);
    if (!fingers_.empty()) return;
    if (dragging_) out.push_back({Kind::released, event.at});
    if (wandered_ || pressed_ || now - finger.since > kTapSeconds) return;
    const bool twice =
        last_ && now - last_->when <= kDoubleTapSeconds && glm::distance(last_->at, finger.start) <= kDoubleTapReach;
    out.push_back({twice ? Kind::doubleTap : Kind::tap, finger.start});
    last_.reset();
    if (!twice) last_ = Tap{finger.start, now};
}

/// Recognises a swipe of three fingers when the first is lifted.
void TouchGestures::swipe(std::vector<Gesture>& out) {
    if (fingers_.size() < 3) return;
    double least = 1e9, most = -1e9, across = 0;
    for (const auto& [name, finger] : fingers_) {
        const glm::dvec2 went = finger.at - finger.start;
        least = std::min(least, went.x);
        most = std::max(most, went.x);
        across = std::max(across, std::abs(went.y));
    }
    if (most < -kSwipe && across < -most) out.push_back({Kind::undo, fingers_.begin()->second.at});
    if (least > kSwipe && across < least) out.push_back({Kind::redo, fingers_.begin()->second.at});
}

std::vector<Gesture> TouchGestures::tick(double now) {
    const std::optional<double> due = wake();
    if (!due || now < *due) return {};
    pressed_ = true;
    return {{Kind::longPress, fingers_.begin()->second.start}};
}

std::optional<double> TouchGestures::wake() const {
    if (fingers_.size() != 1 || wandered_ || pressed_) return std::nullopt;
    return fingers_.begin()->second.since + kLongPressSeconds;
}

void TouchGestures::clear() {
    fingers_.clear();
    wandered_ = dragging_ = pressed_ = three_ = pinching_ = false;
}

using Kind = Gesture::Kind;

std::vector<Gesture> MouseGestures::button(MouseButton button, bool down, glm::dvec2 at, Modifiers with, double now) {
    if (down) {
        if (held_) return {};  // only one button counts
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
    if (button == MouseButton::right) return {{Kind::menu, held.start}};
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
    Gesture gesture{.kind = Kind::transform, .at = at, .scale = std::pow(kZoomPerStep, steps)};
    return {gesture};
}

}  // namespace nacre::app
