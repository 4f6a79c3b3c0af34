#pragma once
// What the apps of phones share: viewer, panel and renderer of one window, from touches to the pixels that are shared.
// Plain C++, so that it is tested where there is no phone. For one thread.

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

/// What the system lends to a session. An empty function is not offered to the user.
struct PhoneHost {
    std::function<double()> clock;  ///< seconds, as the times of touches are counted
    SurfaceSource surface;
    /// A file's bytes, where a path alone does not open it. Called on the loader's thread. @throws Error
    std::function<std::string(const std::string& path)> readFile = {};
    /// Something is ready: call step(). Called on any thread.
    std::function<void()> wake;
    std::function<void(const std::string&)> log = {};
    std::string cache;  ///< folder of downloads, bakes, pipelines, self-tests; empty: none is kept
    std::function<void()> pickDocument = {};                                              ///< shows the system's picker
    std::function<void(const PictureBytes&, const std::string& name)> sharePicture = {};  ///< with another app
    std::function<void(const std::string& text, const std::string& name)> shareText = {};
    std::function<void(const std::string& text)> copyText = {};  ///< to the clipboard
    /// Shows the keyboard for a field of the panel; PhoneSession::typed() hears of it.
    std::function<void(const std::string& name, const std::string& text)> askText = {};
    std::string system;      ///< "Android 16, Example Phone", for the report
    bool downloads = false;  ///< setHttpFetch() was called
    bool shakes = false;     ///< a shake takes the last step back
    bool dark = true;        ///< what the system asks for
    bool validate = false;   ///< Khronos validation layer
    /// As Android has it: the window may go before anyone is told, and the device works for apps that are not seen.
    bool windowMayGo = false;
};

class PhoneSession {
public:
    /// Not seen, and without a device, until setSeen().
    PhoneSession(PhoneHost host, const PictureDescription& first, double pixelsPerPoint = 1);
    PhoneSession(const PhoneSession&) = delete;

    Viewer& viewer() { return session_.viewer(); }
    const Viewer& viewer() const { return session_.viewer(); }
    const Renderer* renderer() const { return session_.renderer(); }

    // The window
    void resize(PixelSize pixels, double pixelsPerPoint);
    /// How much larger than usual the user wants to read, by the system's settings: words and widgets of the panel are.
    void setTextScale(double scale);
    /// What the system covers of it, pixels.
    void setInsets(const Insets& insets);
    /// Nothing is drawn while it is not seen. @throws Error if there is no suitable device; where the window may go,
    /// the device is made on a thread of its own, and step() throws that
    void setSeen(bool seen);
    bool seen() const { return seen_; }
    /// The window goes, or is another one from now on.
    void releaseWindow();
    /// Gives up what can be made again; while the window is not seen, that is the device and all that it holds.
    void lowMemory();

    // What the user does; the panel has it, or else the picture. Places in points.
    void touch(const TouchEvent& event, double when);
    /// One button of a mouse, as a finger that is not down between its phases.
    /// @param button  at the beginning; who got that has the rest
    void mouse(MouseButton button, const TouchEvent& event, Modifiers with, double when);
    /// Where a mouse or a pen points to and touches nothing; nothing: it left.
    void hover(std::optional<glm::dvec2> at);
    void wheel(double steps, glm::dvec2 at) { viewer().wheel(steps, at, host_.clock()); }
    void run(ViewerCommand command);
    /// Closes what lies over the picture. @returns whether something did
    bool back();
    bool wantsBack() const { return panel_->helpOpen() || panel_->panelOpen(); }
    /// The fingers that were down are not heard of again.
    void forgetTouch() { panel_->input().forgetTouch(); }
    /// As PanelInput::typed().
    void typed(const std::string& name, const std::string& text);
    void open(const std::string& path) { viewer().reading().open(path, host_.clock()); }
    /// What could not be done, until it is read.
    void fail(const std::string& text);

    // For those who do not see the window
    /// The picture first, then the panel's controls. Pixels.
    std::vector<Control> spoken() const;
    /// Presses a control that is seen.
    void press(const std::string& role, const std::string& name);
    /// Moves a slider that is seen by a tenth of its way.
    void adjust(const std::string& name, bool up);

    /// Draws, if there is something to draw. @returns when to call again, if nothing happens before; never: infinity.
    /// @throws Error
    double step();

    /// The picture as it is seen, for a file. Only with a device and a document. @throws Error
    /// @param samples  a side of a pixel, or RenderSettings::kEdges
    PictureBytes picture(std::uint32_t samples = RenderSettings::kEdges);
    /// "1bna", for the names of files that are shared.
    std::string shareName() const;
    /// What restores this session, as `nacre render --view` takes it.
    std::string state() const { return savedViewJson(viewer().view()); }

protected:
    double now() const { return host_.clock(); }
    double scale() const { return scale_; }
    /// Waits for a device that is being made.
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
    int windows_ = 0, openedFor_ = 0;  // that went, in all and when a device began to be made
};

/// The view of state(); nothing if it is none.
std::optional<PictureDescription> viewOfState(const std::string& json);

/// What a screen reader says of the picture besides title(): what went wrong, the last pick, its measurement, the
/// message.
std::string spokenValue(const Annotations& annotations);

}  // namespace nacre::app
