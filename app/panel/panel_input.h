#pragma once
// Pointer, keys and touches for the panel. Dear ImGui receives a finger's press when it is lifted: until then, it may
// turn into scrolling.

#include <cstdint>
#include <deque>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/viewer/commands.h"
#include "engine/results.h"

struct ImGuiContext;

namespace nacre::app {

struct PanelState;

class PanelInput {
public:
    PanelInput(ImGuiContext* context, PanelState& state);

    // Pixels of the window
    void pointer(glm::dvec2 at);
    void button(MouseButton button, bool down);
    void wheel(double steps);
    void character(char32_t c);
    void key(SpecialKey key, bool down, Modifiers with = {});
    /// A letter with Ctrl, for the active text field. @returns whether the field handles it
    bool shortcut(char32_t letter);
    /// Text typed on the system's keyboard for the field of this name.
    void typed(const std::string& name, const std::string& text);
    /// A key for whatever has the keyboard focus: an open dialog, a field, a control; else the picture.
    /// @returns its command for the shell to run, if the picture has the focus
    std::optional<ViewerCommand> press(SpecialKey key, bool down, Modifiers with = {});
    /// As above for a character, and for a letter with Ctrl.
    std::optional<ViewerCommand> type(char32_t c);
    std::optional<ViewerCommand> press(const KeyEvent& shortcut);
    /// Whether the pointer or the keys belong to the panel, not the molecule.
    bool ownsPointer() const;
    bool ownsKeys() const;
    /// Whether frames have shown the effect of all clicks and keys. @param focus  including the keyboard focus
    bool answered(bool focus) const;
    /// A finger, in points. @returns whether it belongs to the panel; fixed until it is lifted
    bool touch(const TouchEvent& event);
    /// Drops the finger, for example after a pause.
    void forgetTouch() { finger_.reset(), down_[0] = false; }

    // For the panel, around each frame
    void beginFrame(float seconds);
    void endFrame();

private:
    struct Finger {
        std::int64_t id;
        glm::dvec2 start, at;  // points
        bool scrolls;
        bool holds;  ///< the widget follows it, like a held mouse button
    };
    bool escapes() const;
    void await(bool focusMoves);
    void hold(SpecialKey key, bool down);
    void pressButtons();
    void glide(float seconds);

    ImGuiContext* context_;
    PanelState& s_;
    bool down_[3] = {false, false, false}, pressed_[3] = {false, false, false};
    std::optional<Finger> finger_;
    std::deque<glm::dvec2> taps_;    // pixels: not yet pressed
    std::optional<glm::dvec2> tap_;  // pressed in the last frame
    std::set<SpecialKey> held_;
    std::optional<SpecialKey> again_;  // pressed again in the next frame
    int frames_ = 2;                   // drawn since the last click or key
    bool focusMoves_ = false;          // the last click or key moves it
    float dragged_ = 0, gliding_ = 0;  // pixels per second: of the finger, and of the scrolling list
};

/// Mouse and key events in order. The panel shows the effect of a click or key a frame or two later. Later events wait
/// until then, and none is lost, however short the press or slow the frames.
class InputQueue {
public:
    enum class Kind { pointer, key };

    /// Handles an event at once, or after the waiting ones.
    void add(const PanelInput& panel, Kind kind, std::function<void()> handle) {
        events_.push_back({kind, std::move(handle)});
        go(panel);
    }
    /// Handles events that need not wait any longer; call it after each frame.
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

struct RecordingWish {
    enum class Motion { spin, rock, models, views, morph };
    Motion motion = Motion::spin;
    double seconds = 6, framesPerSecond = 30;
    PixelSize size;
    bool loop = false;  ///< for keyframes: the last leads back to the first
    bool transparent = false;
    std::string path;
};

struct RecordingState {
    bool running = false, stopping = false;
    double share = 0;                     ///< of the frames, 0..1
    std::uint64_t frame = 0, frames = 0;  ///< finished, and total; 0: unknown
    double left = -1;                     ///< remaining seconds, estimated; negative: unknown
    std::string path;
    std::string message;  ///< result of the last recording
    bool failed = false;
};

}  // namespace nacre::app
