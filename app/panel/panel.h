#pragma once
// What a shell shows over the picture: panel, help, marks and labels. Dear ImGui lays it out; what comes of it is the
// engine's plain Overlay. Knows no window system. For a mouse everything is small and the panel stands open; for
// fingers every widget is 48 points high, a button opens the panel, and a drag in it scrolls.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/viewer.h"

struct ImGuiContext;

namespace nacre::app {

enum class PanelHand { mouse, fingers };

/// Parts of the window's edges that content keeps clear of (status bar, camera), in pixels.
struct Insets {
    float left = 0, top = 0, right = 0, bottom = 0;
};

class Panel {
public:
    /// @param run called with the commands that the user clicks
    Panel(double pixelsPerPoint, std::function<void(ViewerCommand)> run, PanelHand hand = PanelHand::mouse);
    ~Panel();
    Panel(const Panel&) = delete;

    /// Glyphs of the font, for the engine.
    OverlayGlyphs glyphs() const;
    void setInsets(const Insets& insets) { insets_ = insets, restless_ = 2; }

    // Events, in pixels of the window
    void pointer(glm::dvec2 at);
    void button(MouseButton button, bool down);
    void wheel(double steps);
    void character(char32_t c);
    void key(SpecialKey key, bool down);
    /// Whether the pointer or the keys are the panel's, not the molecule's.
    bool ownsPointer() const;
    bool ownsKeys() const;
    /// A finger, in points. @returns whether it is the panel's; who got the beginning gets the rest
    bool touch(const TouchEvent& event);
    /// Forgets the finger, as after a pause.
    void forgetTouch() { finger_.reset(); }

    void togglePanel() { open_ = !open_, restless_ = 2; }  // Dear ImGui needs a frame to measure
    void toggleHelp() { help_ = !help_, restless_ = 2; }
    bool helpOpen() const { return help_; }
    bool panelOpen() const { return open_; }
    void closeHelp() { help_ = false; }

    /// Whether something in the panel still reacts to what the user did.
    bool restless() const { return restless_ > 0; }
    /// Lays everything out. @returns good until the next call
    const Overlay* draw(Viewer& viewer, PixelSize size, double now);

private:
    class Turn;
    struct Rectangle {
        float left, top, right, bottom;
    };
    struct Finger {
        std::int64_t id;
        glm::dvec2 start, at;  // points
        bool scrolls;
    };
    float scale() const { return static_cast<float>(pixelsPerPoint_); }
    bool forFingers() const { return hand_ == PanelHand::fingers; }
    bool occupies(glm::dvec2 pixel) const;
    void beginWindow(const char* name, int moreFlags);
    void drawMenuButton();
    void drawPanel(Viewer& viewer, double now);
    void drawLook(SavedView& look);
    void drawShown(SavedView& look);
    void drawEffects(SavedView& look, double radius);
    void drawPresets(SavedView& look);
    bool choose(const char* label, std::span<const char* const> choices, std::string& current);
    void drawRules(SavedView& look, const Molecule* molecule);
    void drawRuleButtons(SavedView& look, const std::string& selection);
    void drawHelp();
    void drawWords(const Viewer& viewer);
    void drawQuestion(Viewer& viewer, double now);
    void drawAnnotations(const Annotations& annotations);
    void drawStatus(const std::string& text, float bottom, bool strong);
    void followFinger();
    void remember();
    void collect();

    ImGuiContext* context_ = nullptr;
    std::function<void(ViewerCommand)> run_;
    PanelHand hand_;
    double pixelsPerPoint_, last_ = 0;
    Insets insets_;
    bool open_, help_ = false, licences_ = false;
    int restless_ = 2;
    bool down_[3] = {false, false, false}, pressed_[3] = {false, false, false};
    std::optional<Finger> finger_;
    float scroll_ = 0;               // pixels that the finger dragged since the last frame
    std::string unfolded_;           // the one list that is open, for fingers
    std::string picked_ = "ligand";  // the selection that is chosen, for fingers
    std::vector<Rectangle> occupied_;
    char selection_[512] = "";
    std::string ruleError_;
    std::optional<Aim> aim_;  // that a button asked for in this frame
    Overlay overlay_;
};

}  // namespace nacre::app
