#pragma once
// A window of the desktop's window system, by GLFW.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "app/viewer/events.h"
#include "engine/device_options.h"
#include "engine/results.h"

struct GLFWwindow;

namespace nacre::app {

/// Callbacks of a window. Positions are in pixels from the top left.
struct WindowEvents {
    std::function<void()> resized;
    std::function<void(bool)> iconified;
    std::function<void()> damaged;  ///< the window's picture must be presented again
    std::function<void(glm::dvec2)> pointer;
    std::function<void(MouseButton, bool, Modifiers)> button;
    std::function<void(double, Modifiers)> wheel;
    std::function<void(SpecialKey, bool down, bool repeated, Modifiers)> special;
    std::function<void(char32_t)> character;
    std::function<void()> closing;           ///< the user closes the window, which stays until close()
    std::function<void(KeyEvent)> shortcut;  ///< a letter with Ctrl
    std::function<void(const std::vector<std::string>&)> dropped;  ///< paths, one or more
};

class Window {
public:
    /// @throws Error if there is no display
    Window(PixelSize size, WindowEvents events);
    ~Window();
    Window(const Window&) = delete;

    SurfaceSource surface() const;
    PixelSize size() const;         ///< pixels
    double pixelsPerPoint() const;  ///< of the window's display
    double refreshRate() const;     ///< of that display, per second
    /// The window is hidden at first.
    void show();
    void hide();
    /// Covers the monitor that shows it, or restores its size and position.
    void toggleFullScreen();
    bool isFullScreen() const;
    void setTitle(const std::string& title);
    std::string clipboard() const;
    void setClipboard(const std::string& text);
    bool closing() const;
    void close();

    /// Handles pending events, or waits for some. Does not wait if the window is to close: the key that closed it may
    /// have been the last event.
    /// @param seconds maximum wait; infinity: no limit
    void handleEvents(double seconds);
    /// Ends a wait. Thread-safe.
    static void wake();

private:
    void connect();

    GLFWwindow* window_ = nullptr;
    WindowEvents events_;
    std::string title_;
    std::array<int, 4> restored_{};  // position and size before full screen
};

}  // namespace nacre::app
