#pragma once
// A viewer with its renderer, for every shell: replaces the renderer when its device is lost, and keeps compiled
// pipelines for the next run. For one thread.

#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/viewer/idle_test.h"
#include "app/viewer/screen.h"
#include "app/viewer/viewer.h"

namespace nacre::app {

/// Functions of the shell for its session.
struct SessionHost {
    /// For each renderer: the window and the user's options, without pipeline cache. @throws Error
    std::function<DeviceOptions()> device;
    std::function<std::vector<std::byte>()> loadPipelines;                  ///< from an earlier run; may be empty
    std::function<void(const std::vector<std::byte>&)> keepPipelines = {};  ///< called once, after warm-up
    std::function<void(Renderer&)> prepare = {};                            ///< each renderer, before it draws
    std::function<void(const std::string&)> lost = {};                      ///< receives what is known of a loss
    /// Draws a frame, instead of the renderer's window.
    std::function<FrameOutcome(Renderer&, const RenderSettings&)> present = {};
    /// The window may vanish without notice. A frame that fails then releases it and waits for another window.
    bool windowMayGo = false;
};

class Session {
public:
    /// Without a renderer until open().
    Session(SessionHost host, Sources sources, const PictureDescription& first, const ViewerOptions& options,
            std::function<void()> wake);
    /// Waits for a renderer being created.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    Viewer& viewer() { return viewer_; }
    const Viewer& viewer() const { return viewer_; }
    /// Null without a renderer.
    Renderer* renderer() { return renderer_.get(); }
    const Renderer* renderer() const { return renderer_.get(); }

    /// Lines for developers: the device, its path, and how its driver handles the frame.
    std::string statistics() const;

    /// Everything about the device and its frames as JSON, for remote diagnosis.
    /// @param system  "Android 16, Example Phone"
    std::string report(const std::string& system) const;

    /// Creates a renderer that shows the viewer's document. First closes the previous one, which owns the window.
    /// @throws Error if there is no suitable device
    void open(double now);
    /// As above on another thread: the first start on a device takes seconds. Nothing is drawn until takeOpened();
    /// calls `wake` when the result is ready.
    void openAside();
    bool opening() const { return opening_.valid(); }
    /// Takes the result of openAside(), if ready. @returns whether it was. @throws as open()
    bool takeOpened(double now);
    void awaitOpened() const { opening_.wait(); }
    /// Drops the renderer and everything on the device.
    void close();

    /// Whether to test the device's paths while the picture rests. Initially on.
    void setIdleTests(bool on);
    /// Whether a test is running.
    bool testing() const { return idleTest_.running(); }

    /// Draws, if there is something to draw. Replaces a lost device, but throws after more than kMostLosses with less
    /// than kForgottenAfter seconds between them.
    /// @param overlay called before a frame is drawn; may be empty
    /// @returns when to call again without further events; never: infinity. @throws Error
    double step(double now, const std::function<const Overlay*()>& overlay = {});

    static constexpr int kMostLosses = 3;
    static constexpr double kForgottenAfter = 60;

private:
    class OwnScreen;

    DeviceOptions deviceOptions();
    void opened(std::unique_ptr<Renderer> renderer, double now);
    void replace(double now);
    void keepPipelines();
    double testWhileIdle(double now, double wake);

    SessionHost host_;
    std::function<void()> wake_;
    std::uint64_t occlusionBytes_;  // maximum set by the shell
    std::thread opener_;
    std::future<std::unique_ptr<Renderer>> opening_;
    std::unique_ptr<Renderer> renderer_;
    DeviceOptions options_;  // of the renderer, without its pipelines
    std::unique_ptr<OwnScreen> screen_;
    Viewer viewer_;
    bool pipelinesKept_ = false, idleTests_ = true;
    std::uint64_t framesBefore_ = 0;  // number of frames shown when step() was last called
    double frameAt_ = 0;              // time of the last frame
    IdleTest idleTest_;
    int losses_ = 0;        // recent ones
    double lostAt_ = -1e9;  // time of the last one
};

/// Memory for occlusion maps, given the device's memory budget.
/// @param wanted  maximum  @param budget  0: unknown
std::uint64_t occlusionBytes(std::uint64_t wanted, std::uint64_t budget);

}  // namespace nacre::app
