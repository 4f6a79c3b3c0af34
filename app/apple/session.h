#pragma once
// What the iOS app does apart from UIKit: the session of one scene of the app, from its surface to the pixels that are
// shared. Plain C++, so that it is tested where there is no iPhone. For the main thread.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/panel/panel.h"
#include "app/viewer/session.h"

namespace nacre::app {

/// What UIKit lends to a session.
struct MoleculeHost {
    SurfaceSource surface;
    /// A file's bytes. Called on the loader's thread. @throws Error
    std::function<std::string(const std::string& path)> readFile;
    /// Something is ready: call step() on the main thread. Called on any thread.
    std::function<void()> wake;
    std::function<std::vector<std::byte>()> loadPipelines;             ///< of an earlier run; may be empty
    std::function<void(const std::vector<std::byte>&)> keepPipelines;  ///< called once, after warm-up
    std::string occlusionCache;                                        ///< folder; empty: bakes are not kept
    std::function<void()> pickDocument = {};                           ///< shows the system's picker
    std::function<void(ViewerCommand)> share = {};                     ///< the picture or the view, with another app
    /// Shows the keyboard for a field of the panel; MoleculeSession::typed() hears of it.
    std::function<void(const std::string& name, const std::string& text)> askText = {};
    bool downloads = false;  ///< setHttpFetch() was called
    bool dark = true;        ///< what the system asks for
    bool validate = false;   ///< Khronos validation layer
};

/// 8 bits a channel, sRGB, straight alpha, row 0 on top.
struct PictureBytes {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

class MoleculeSession {
public:
    /// @throws Error if there is no suitable device
    MoleculeSession(MoleculeHost host, const SavedView& first);

    Viewer& viewer() { return session_.viewer(); }
    const Viewer& viewer() const { return session_.viewer(); }

    void resize(PixelSize pixels, double pixelsPerPoint, double now);
    /// What the system covers of the window, pixels.
    void setInsets(const Insets& insets);
    // What the user does; the panel has it, or else the picture. Places in points.
    void touch(const TouchEvent& event, double now);
    /// One button of a mouse, as a finger that is not down between its phases.
    void mouse(MouseButton button, const TouchEvent& event, Modifiers with, double now);
    void run(ViewerCommand command, double now);
    /// As Panel::typed().
    void typed(const std::string& name, const std::string& text);
    /// What stands in the window, for who cannot see it: the picture first, then the panel's controls. Pixels.
    std::vector<Control> spoken() const;
    /// Presses a control that is seen.
    void press(const std::string& role, const std::string& name, double now);
    /// Moves a slider a tenth of its way.
    void adjust(const std::string& name, bool up, double now);
    /// The device works for apps that are seen alone: nothing is submitted from now on.
    void enterBackground();
    /// @throws Error if the device cannot be had again
    void enterForeground(double now);
    /// Gives up what can be made again; in the background that is the device and all that it holds.
    void lowMemory();
    bool holdsDevice() const { return renderer() != nullptr; }

    /// Draws, if there is something to draw.
    /// @returns when to call again, if nothing happens before; never: infinity. @throws Error
    double step(double now);

    /// The picture as it is seen, for a file. Only in the foreground, with a document. @throws Error
    /// @param samples a side of a pixel
    PictureBytes picture(std::uint32_t samples = ViewerOptions{}.mostSamples);
    /// What restores this session, as `nacre render --view` takes it.
    std::string state() const { return savedViewJson(viewer().view()); }
    /// "1bna", for the names of files that are shared.
    std::string shareName() const;
    const Renderer* renderer() const { return session_.renderer(); }

private:
    SessionHost sessionHost();
    void makePanel(double pixelsPerPoint);
    void tap(glm::dvec2 pixel, double now);

    MoleculeHost host_;
    std::unique_ptr<Panel> panel_;
    Session session_;
    double scale_ = 1;
    bool foreground_ = true, panelDrag_ = false;
};

/// What a screen reader says of the picture besides title(): what went wrong, the last pick, its measurement, the
/// message.
std::string spokenValue(const Annotations& annotations);

}  // namespace nacre::app
