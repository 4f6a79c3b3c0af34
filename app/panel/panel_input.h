#pragma once
// Pointer, keys and touches for the panel. Dear ImGui gets a finger's press when it is lifted: before, it may turn into
// scrolling.

#include <deque>
#include <glm/vec2.hpp>
#include <optional>
#include <set>
#include <string>

#include "app/viewer/events.h"

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
    /// Whether the pointer or the keys belong to the panel, not the molecule.
    bool ownsPointer() const;
    bool ownsKeys() const;
    /// Whether frames show the effect of all clicks and keys. @param focus  also of the keyboard focus
    bool answered(bool focus) const { return frames_ >= (focus && focusMoves_ ? 2 : 1); }
    /// A finger, in points. @returns whether it belongs to the panel; that stays until it is lifted
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
    bool focusMoves_ = false;          // by that click or key
    float dragged_ = 0, gliding_ = 0;  // pixels per second: of the finger, and of the scrolling list
};

}  // namespace nacre::app
