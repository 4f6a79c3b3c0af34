#pragma once
// What pointer, keys and fingers tell the panel. A finger's press is told to Dear ImGui when it leaves again, for
// before that it may turn out to scroll.

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
    /// A letter with Ctrl, for a field that is being typed in. @returns whether such a field knows it
    bool shortcut(char32_t letter);
    /// What was typed into the field of a name, where the system's keyboard is asked for it.
    void typed(const std::string& name, const std::string& text);
    /// Whether the pointer or the keys are the panel's, not the molecule's.
    bool ownsPointer() const;
    bool ownsKeys() const;
    /// Frames have shown what came of the clicks and keys so far. @param focus  and of where the next key goes
    bool answered(bool focus) const { return frames_ >= (focus && focusMoves_ ? 2 : 1); }
    /// A finger, in points. @returns whether it is the panel's; who got the beginning gets the rest
    bool touch(const TouchEvent& event);
    /// Forgets the finger, as after a pause.
    void forgetTouch() { finger_.reset(), down_[0] = false; }

    // For the panel, about each frame
    void beginFrame(float seconds);
    void endFrame();

private:
    struct Finger {
        std::int64_t id;
        glm::dvec2 start, at;  // points
        bool scrolls;
        bool holds;  ///< what it touched follows it, as a mouse that is held
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
    std::optional<SpecialKey> again_;  // goes down once more in the next frame
    int frames_ = 2;                   // drawn since the last click or key
    bool focusMoves_ = false;          // by that
    float dragged_ = 0, gliding_ = 0;  // pixels a second: of the finger, and that the list goes on with
};

}  // namespace nacre::app
