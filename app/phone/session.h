#pragma once
// Shared by the phone apps: viewer, panel and renderer of one window, from touches to shared images. Plain C++, so that
// it can be tested without a phone. For one thread.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/panel/panel.h"
#include "app/viewer/session.h"

namespace nacre::app {

/// 8 bits per channel, sRGB, straight alpha, row 0 on top.
struct PictureBytes {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Functions of the system for a session. Empty ones are not offered to the user.
struct PhoneHost {
    std::function<double()> clock;  ///< seconds, on the time base of touches
    SurfaceSource surface;
    /// A file's bytes, if a path alone does not open it. Called on the loader's thread. @throws Error
    std::function<std::string(const std::string& path)> readFile = {};
    /// Something is ready: call step(). Called from any thread.
    std::function<void()> wake;
    std::function<void(const std::string&)> log = {};
    std::string cache;                        ///< folder of downloads, bakes, pipelines, self-tests; empty: no cache
    std::function<void()> pickDocument = {};  ///< shows the system's file picker
    std::function<void(const PictureBytes&, const std::string& name)> sharePicture = {};  ///< with another app
    std::function<void(const std::string& text, const std::string& name)> shareText = {};
    std::function<void(const std::string& text)> copyText = {};  ///< to the clipboard
    /// Shows the keyboard for a field of the panel; PhoneSession::typed() gets the result.
    std::function<void(const std::string& name, const std::string& text)> askText = {};
    std::string system;      ///< "Android 16, Example Phone", for the report
    bool downloads = false;  ///< setHttpFetch() was called
    bool shakes = false;     ///< shaking the device undoes
    bool dark = true;        ///< the system's theme
    bool validate = false;   ///< Khronos validation layer
    /// Android: the window may vanish without notice, and the device keeps working for invisible apps.
    bool windowMayGo = false;
};

class PhoneSession {
public:
    /// Invisible, and without a device, until setSeen().
    PhoneSession(PhoneHost host, const PictureDescription& first, double pixelsPerPoint = 1);
    PhoneSession(const PhoneSession&) = delete;

    Viewer& viewer() { return session_.viewer(); }
    const Viewer& viewer() const { return session_.viewer(); }
    const Renderer* renderer() const { return session_.renderer(); }

    // The window
    void resize(PixelSize pixels, double pixelsPerPoint);
    /// Text scale from the system's settings; applies to words and widgets of the panel.
    void setTextScale(double scale);
    /// Areas covered by the system, pixels.
    void setInsets(const Insets& insets);
    /// Nothing is drawn while invisible. @throws Error if there is no suitable device; if the window may vanish, the
    /// device is created on another thread, and step() throws that error
    void setSeen(bool seen);
    bool seen() const { return seen_; }
    /// On systems that stop the work of invisible apps: waits until submitted work is done and a test of the device has
    /// stopped, or the time is over. Call after setSeen(false). @returns whether everything has ended
    bool awaitSubmitted(double seconds);
    /// The window vanishes, or is replaced from now on.
    void releaseWindow();
    /// Frees memory that can be recreated; while the window is invisible, that is the device and everything on it.
    void lowMemory();

    // User input: for the panel, or else the picture. Positions in points.
    void touch(const TouchEvent& event, double when);
    /// One button of a mouse, like a finger that is up between its phases.
    /// @param button  when pressed; the receiver also gets the rest of the gesture
    void mouse(MouseButton button, const TouchEvent& event, Modifiers with, double when);
    /// Position of a hovering mouse or pen; empty: it left.
    void hover(std::optional<glm::dvec2> at);
    void wheel(double steps, glm::dvec2 at) { viewer().wheel(steps, at, host_.clock()); }
    void run(ViewerCommand command);
    /// Closes the topmost card over the picture. @returns whether there was one
    bool back();
    bool wantsBack() const { return panel_->helpOpen() || panel_->panelOpen(); }
    /// The pressed fingers will not be reported again.
    void forgetTouch() { panel_->input().forgetTouch(); }
    /// As PanelInput::typed().
    void typed(const std::string& name, const std::string& text);
    void open(const std::string& path) { viewer().open(path, host_.clock()); }
    /// Shows an error until it is dismissed.
    void fail(const std::string& text);

    // Accessibility
    // The picture first, then the panel's controls. Pixels.
    std::vector<Control> spoken() const;
    /// Presses a visible control.
    void press(const std::string& role, const std::string& name);
    /// Moves a visible slider by a tenth of its range.
    void adjust(const std::string& name, bool up);

    /// Draws, if there is something to draw. @returns when to call again without further events; never: infinity.
    /// @throws Error
    double step();
    /// Whether the device's paths are being tested, which takes seconds of an idle screen, once per driver.
    bool testing() const { return session_.testing(); }

    /// The current picture, for a file. Only with a device and a document. @throws Error
    /// @param samples  per pixel side, or RenderSettings::kEdges
    PictureBytes picture(std::uint32_t samples = RenderSettings::kEdges);
    /// "1bna", for the names of shared files.
    std::string shareName() const;
    /// Restores this session; in the format of `nacre render --view`.
    std::string state() const { return savedViewJson(viewer().restartView()); }

protected:
    double now() const { return host_.clock(); }
    double scale() const { return scale_; }
    /// Waits for a device being created.
    void awaitDevice();

private:
    void takeDevice();
    SessionHost sessionHost();
    void makePanel();
    void remakePanel();
    TouchEvent onPanel(const TouchEvent& event) const;
    void sharePicture();
    void shareView();
    void tap(glm::dvec2 pixel);

    PhoneHost host_;
    std::unique_ptr<Panel> panel_;
    Session session_;
    double scale_ = 1, textScale_ = 1;
    MouseButton held_ = MouseButton::left;
    Insets insets_;
    bool seen_ = false, panelDrag_ = false;
    int windows_ = 0, openedFor_ = 0;  // number of windows that vanished: so far, and when the device was requested
};

/// The view of state(); empty if it is invalid.
std::optional<PictureDescription> viewOfState(const std::string& json);

/// Screen reader text for the picture in addition to title(): the error, the last pick, its measurement, the message.
std::string spokenValue(const Annotations& annotations);

}  // namespace nacre::app
