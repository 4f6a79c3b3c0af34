#pragma once
// A viewer and the renderer that it draws with, for every shell: the renderer comes and goes, is made anew when its
// device is lost, and what the driver compiled is kept for the next run. For one thread.

#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/viewer/screen.h"
#include "app/viewer/viewer.h"

namespace nacre::app {

/// What a shell lends to its session.
struct SessionHost {
    /// For each renderer: the window, and what the user asked for; not the pipeline cache. @throws Error
    std::function<DeviceOptions()> device;
    std::function<std::vector<std::byte>()> loadPipelines;                  ///< of an earlier run; may be empty
    std::function<void(const std::vector<std::byte>&)> keepPipelines = {};  ///< called once, after warm-up
    std::function<void(Renderer&)> prepare = {};                            ///< each renderer, before it draws
    std::function<void(const std::string&)> lost = {};                      ///< told what is known of a loss
    /// The window may go before anyone is told: a frame that fails lets go of it, and another window is waited for.
    bool windowMayGo = false;
};

class Session {
public:
    /// Without a renderer: open() makes it.
    Session(SessionHost host, Sources sources, const PictureDescription& first, const ViewerOptions& options,
            std::function<void()> wake);
    /// Waits for a renderer that is being made.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    Viewer& viewer() { return viewer_; }
    const Viewer& viewer() const { return viewer_; }
    /// Null while there is none.
    Renderer* renderer() { return renderer_.get(); }
    const Renderer* renderer() const { return renderer_.get(); }

    /// For developers, in lines: the device, its path, and what its driver makes of the frame.
    std::string statistics() const;

    /// For those who have no such device: all that this one tells of itself and of its frames, as JSON.
    /// @param system  what it runs: "Android 16, Example Phone"
    std::string report(const std::string& system) const;

    /// Makes a renderer, which shows what the viewer has. The one before is gone first: it has the window.
    /// @throws Error if there is no suitable device
    void open(double now);
    /// The same on a thread of its own: the first start on a device takes seconds. Nothing is drawn until takeOpened();
    /// `wake` is called when that has something to take.
    void openAside();
    bool opening() const { return opening_.valid(); }
    /// Takes what openAside() made, if it is there. @returns whether it was. @throws as open()
    bool takeOpened(double now);
    void awaitOpened() const { opening_.wait(); }
    /// Gives up the renderer and all that it holds on the device.
    void close();

    /// Draws, if there is something to draw. A device that is lost is replaced; but if devices are lost again and
    /// again, more than kMostLosses with less than kForgottenAfter seconds from each to the next, something is wrong.
    /// @param overlay called before a frame is drawn; may be empty
    /// @returns when to call again, if nothing happens before; never: infinity. @throws Error
    double step(double now, const std::function<const Overlay*()>& overlay = {});

    static constexpr int kMostLosses = 3;
    static constexpr double kForgottenAfter = 60;

private:
    /// The renderer of the moment, as the viewer sees it.
    class OwnScreen : public Screen {
    public:
        explicit OwnScreen(Session& session) : session_(session) {}
        void setScene(const Representation& scene) override;
        void moveScene(const Representation& scene) override;
        void expectScene(Representation like, const RenderSettings& settings, const WindowFrame& frame) override;
        double advanceOcclusion(const RenderSettings& settings, const OcclusionPace& pace) override;
        void awaitFrame() override;
        double frameMilliseconds() const override;
        FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame) override;
        PixelSize windowSize() const override;
        std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach) override;
        std::string deviceLoss() const override;

    private:
        Session& session_;
        int failures_ = 0;             // to present, one after the other
        double hostMilliseconds_ = 0;  // of the last frame
    };

    DeviceOptions deviceOptions() const;
    void opened(std::unique_ptr<Renderer> renderer, double now);
    void replace(double now);
    void keepPipelines();

    SessionHost host_;
    std::function<void()> wake_;
    std::uint64_t occlusionBytes_;  // that the shell wants at the most
    std::thread opener_;
    std::future<std::unique_ptr<Renderer>> opening_;
    std::unique_ptr<Renderer> renderer_;
    OwnScreen screen_{*this};
    Viewer viewer_;
    bool pipelinesKept_ = false;
    int losses_ = 0;        // of late
    double lostAt_ = -1e9;  // the last of them
};

/// Of the occlusion's maps, where a device tells how much memory the program may use.
/// @param wanted  at the most  @param budget  0: it does not tell
std::uint64_t occlusionBytes(std::uint64_t wanted, std::uint64_t budget);

}  // namespace nacre::app
