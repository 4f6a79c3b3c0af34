#pragma once
// Viewer, panel and renderer of one activity. Everything here belongs to the render thread.

#include <android/native_window.h>
#include <android/rect.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/panel/panel.h"
#include "app/viewer/session.h"

namespace nacre::app {

/// Where an activity keeps things; all in its internal data folder.
struct SessionFiles {
    std::string view;       ///< the last view, JSON
    std::string pipelines;  ///< what the driver compiled
    std::string occlusion;  ///< folder of finished bakes
    std::string devices;    ///< folder of what devices draw right
    std::string cache;      ///< folder of what was downloaded, among others
};

/// What the main thread may ask at any time.
struct SharedState {
    std::atomic<bool> wantsBack{false};  ///< the back key is ours, to close the panel or the help
    std::mutex mutex;
    std::optional<SavedView> view;  ///< under the mutex: as it was after the last step
    std::atomic<bool> read{false};  ///< a screen reader wants to know what is there
    std::string lines;              ///< under the mutex: controlLines() of what it is told of
};

/// What the platform does for a session. Empty: it does not.
struct PlatformCalls {
    std::function<void()> pickDocument;
    std::function<void(const Picture&, const std::string& name)> share;
    std::function<void()> controlsChanged;
    /// Shows the keyboard for a field of the panel; AndroidSession::typed() hears of it.
    std::function<void(const std::string& name, const std::string& text)> askText;
    std::function<void(const std::string& text, const std::string& name)> shareText;
};

class AndroidSession {
public:
    /// @param first what to show; without input: nothing yet
    /// @param wake  makes the thread call step(); from any thread
    AndroidSession(SessionFiles files, const SavedView& first, double pixelsPerPoint, SharedState& shared,
                   std::function<void()> wake, PlatformCalls platform = {});

    // The window
    void windowCreated(ANativeWindow* window);
    /// It has another size, or lost what was in it.
    void windowChanged();
    void windowDestroyed();
    void contentChanged(const ARect& content);
    void densityChanged(double pixelsPerPoint);
    /// The display that the window is on shows so many pictures a second.
    void displayRefreshes(double rate);

    // The activity
    void started();
    void paused();
    void stopped();
    void lowMemory();

    // What the user does
    void touch(const TouchEvent& event, double when);
    void wheel(double steps, glm::dvec2 at);
    void key(const KeyEvent& event);
    void back();
    /// Presses a control that is seen, as a screen reader asks for it.
    void press(const std::string& role, const std::string& name);
    /// Moves a slider that is seen, likewise, by a tenth of its way.
    void adjust(const std::string& name, bool up);
    /// As Panel::typed().
    void typed(const std::string& name, const std::string& text);
    void open(const std::string& path);
    void say(const std::string& text);
    /// What could not be done, until it is read.
    void fail(const std::string& text);

    /// As Viewer::awaitFrame.
    void awaitFrame();
    /// Draws, if there is something to draw. @returns when to call again, if nothing happens before. @throws Error
    double step();

    /// Lets go of window and device for good.
    void giveUp();

private:
    Viewer& viewer() { return session_.viewer(); }
    SessionHost host();
    void makePanel(double pixelsPerPoint);
    void settle();
    void run(ViewerCommand command);
    PixelSize size() const;
    void share();
    void shareView();
    std::string shareName(const char* extension);
    void tellControls();

    SessionFiles files_;
    SharedState& shared_;
    PlatformCalls platform_;
    ANativeWindow* window_ = nullptr;
    Session session_;
    std::unique_ptr<Panel> panel_;
    ARect content_{};
    double scale_ = 1;
    bool started_ = false;
};

}  // namespace nacre::app
