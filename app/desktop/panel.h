#pragma once
// What the desktop shows over the picture: panel, help, marks and labels. Dear ImGui lays it out; what comes of it is
// the engine's plain Overlay.

#include <functional>
#include <vector>

#include "app/viewer/viewer.h"

struct ImGuiContext;

namespace nacre::app {

class Panel {
public:
    /// @param run called with the commands that the user clicks
    Panel(double pixelsPerPoint, std::function<void(ViewerCommand)> run);
    ~Panel();
    Panel(const Panel&) = delete;

    /// Glyphs of the font, for the engine.
    OverlayGlyphs glyphs() const;

    // Events, in pixels of the window
    void pointer(glm::dvec2 at);
    void button(MouseButton button, bool down);
    void wheel(double steps);
    void character(char32_t c);
    void key(SpecialKey key, bool down);
    /// Whether the pointer or the keys are the panel's, not the molecule's.
    bool ownsPointer() const;
    bool ownsKeys() const;

    void togglePanel() { open_ = !open_, restless_ = 2; }  // Dear ImGui needs a frame to measure
    void toggleHelp() { help_ = !help_, restless_ = 2; }
    bool helpOpen() const { return help_; }
    void closeHelp() { help_ = false; }

    /// Whether something in the panel still reacts to what the user did.
    bool restless() const { return restless_ > 0; }
    /// Lays everything out. @returns good until the next call
    const Overlay* draw(Viewer& viewer, PixelSize size, double now);

private:
    struct Rectangle {
        float left, top, right, bottom;
    };
    void drawPanel(Viewer& viewer, double now);
    void drawLook(SavedView& look);
    void drawRules(SavedView& look);
    void drawHelp();
    void drawAnnotations(const Annotations& annotations);
    void drawStatus(const std::string& text, float bottom, bool strong);
    void remember();
    void collect();

    ImGuiContext* context_;
    std::function<void(ViewerCommand)> run_;
    double pixelsPerPoint_, last_ = 0;
    bool open_ = true, help_ = false;
    int restless_ = 2;
    bool down_[3] = {false, false, false}, pressed_[3] = {false, false, false};
    std::vector<Rectangle> occupied_;
    char selection_[512] = "";
    std::string ruleError_;
    Overlay overlay_;
};

}  // namespace nacre::app
