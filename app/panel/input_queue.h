#pragma once
// Mouse and key events in order. The panel shows the effect of a click or key only a frame or two later: following
// events wait until then, and none is lost, however short the press or slow the frames.

#include <deque>
#include <functional>
#include <utility>

#include "app/panel/panel_input.h"

namespace nacre::app {

class InputQueue {
public:
    enum class Kind { pointer, key };

    /// Handles an event at once, or after those that wait.
    void add(const PanelInput& panel, Kind kind, std::function<void()> handle) {
        events_.push_back({kind, std::move(handle)});
        go(panel);
    }
    /// Handles events that need not wait any more; call it after each frame.
    void frameDrawn(const PanelInput& panel) { go(panel); }
    bool empty() const { return events_.empty(); }

private:
    struct Event {
        Kind kind;
        std::function<void()> handle;
    };
    void go(const PanelInput& panel) {
        while (!events_.empty() && panel.answered(events_.front().kind == Kind::key)) {
            const Event event = std::move(events_.front());
            events_.pop_front();
            event.handle();
        }
    }
    std::deque<Event> events_;
};

}  // namespace nacre::app
