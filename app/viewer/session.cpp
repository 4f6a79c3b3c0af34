#include "app/viewer/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/files/device_report.h"
#include "app/files/json_text.h"
#include "engine/devices.h"
#include "engine/error.h"
#include "engine/scene/build/representation.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

constexpr std::uint64_t kFramesOfWarmUp = 3;  // live, refined, kept

}  // namespace

/// The current renderer as the viewer's screen.
class Session::OwnScreen : public Screen {
public:
    explicit OwnScreen(Session& session) : session_(session) {}

    void setScene(Representation scene) override {
        if (Renderer* r = session_.renderer()) r->setScene(std::move(scene));
    }
    void moveScene(Representation scene) override {
        if (Renderer* r = session_.renderer()) r->moveScene(std::move(scene));
    }
    void expectScene(Representation like, const RenderSettings& settings, const WindowFrame& frame) override {
        if (Renderer* r = session_.renderer()) r->expectScene(std::move(like), settings, frame);
    }
    double advanceOcclusion(const RenderSettings& settings, const OcclusionPace& pace) override {
        Renderer* r = session_.renderer();
        return r ? r->advanceOcclusion(settings, pace) : 0;
    }
    void awaitFrame() override {
        if (Renderer* r = session_.renderer()) r->awaitFrame();
    }
    /// Time of the host or the device, whichever is slower: lists of triangles may cost the host more than pixels cost
    /// the device.
    double frameMilliseconds() const override {
        const Renderer* r = session_.renderer();
        const double device = r ? r->stats().windowMilliseconds : 0;
        return device > 0 ? std::max(device, hostMilliseconds_) : 0;
    }
    FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame) override;
    PixelSize windowSize() const override {
        const Renderer* r = session_.renderer();
        return r ? r->windowSize() : PixelSize{1, 1};
    }
    std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach) override {
        Renderer* r = session_.renderer();
        return r ? r->atomAt(settings, x, y, reach) : 0;
    }
    SeenAtoms atoms(const RenderSettings& settings) override {
        Renderer* r = session_.renderer();
        if (!r) return {};
        const auto begin = std::chrono::steady_clock::now();
        SeenAtoms seen{r->atoms(settings)};
        seen.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        return seen;
    }
    std::string deviceLoss() const override {
        const Renderer* r = session_.renderer();
        return r ? r->deviceLoss() : std::string();
    }

private:
    Session& session_;
    int failures_ = 0;             // consecutive failures to present
    double hostMilliseconds_ = 0;  // of the last frame
};

FrameOutcome Session::OwnScreen::present(const RenderSettings& settings, const WindowFrame& frame) {
    Renderer* renderer = session_.renderer();
    if (!renderer) return FrameOutcome::hidden;
    if (session_.host_.present) return session_.host_.present(*renderer, settings);
    try {
        // Time spent waiting does not count for the host; and the window may have another size by now.
        const PixelSize window = renderer->windowSize();
        if (window.width == settings.view.width && window.height == settings.view.height) renderer->awaitFrame();
        const auto begin = std::chrono::steady_clock::now();
        const FrameOutcome outcome = renderer->present(settings, frame);
        hostMilliseconds_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        failures_ = 0;
        return outcome;
    } catch (const Error& error) {
        constexpr int kMostFailures = 3;
        if (!session_.host_.windowMayGo || !renderer->deviceLoss().empty() || ++failures_ > kMostFailures) throw;
        if (session_.host_.lost) session_.host_.lost(error.what());
        renderer->releaseWindow();
        return FrameOutcome::hidden;
    }
}

// --- the session

Session::Session(SessionHost host, Sources sources, const PictureDescription& first, const ViewerOptions& options,
                 std::function<void()> wake)
    : host_(std::move(host)),
      wake_(wake),
      occlusionBytes_(options.occlusionBytes),
      screen_(std::make_unique<OwnScreen>(*this)),
      viewer_(*screen_, std::move(sources), first, options, std::move(wake)) {}

Session::~Session() {
    if (opener_.joinable()) opener_.join();
}

DeviceOptions Session::deviceOptions() {
    options_ = host_.device();
    DeviceOptions device = options_;
    device.pipelineCache = host_.loadPipelines();
    return device;
}

void Session::open(double now) {
    close();
    opened(std::make_unique<Renderer>(deviceOptions()), now);
}

void Session::openAside() {
    if (opening()) return;
    close();
    std::promise<std::unique_ptr<Renderer>> made;
    opening_ = made.get_future();
    opener_ = startThread([this, made = std::move(made)]() mutable {
        try {
            made.set_value(std::make_unique<Renderer>(deviceOptions()));
        } catch (...) {
            made.set_exception(std::current_exception());
        }
        wake_();
    });
}

bool Session::takeOpened(double now) {
    if (!opening() || opening_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    opener_.join();
    opened(opening_.get(), now);
    return true;
}

void Session::opened(std::unique_ptr<Renderer> renderer, double now) {
    renderer_ = std::move(renderer);
    framesBefore_ = 0;
    viewer_.frames().setOcclusionBytes(occlusionBytes(occlusionBytes_, renderer_->stats().device.budgetBytes));
    renderer_->setScene({});
    if (host_.prepare) host_.prepare(*renderer_);
    viewer_.frames().replaced(now);
}

void Session::close() { renderer_.reset(); }

double Session::step(double now, const std::function<const Overlay*()>& overlay) {
    const double wake = viewer_.update(now, overlay);
    if (viewer_.frames().lost()) {
        replace(now);
        return now;
    }
    keepPipelines();
    return testWhileIdle(now, wake);
}

std::string Session::statistics() const {
    if (!renderer_) return {};
    const FrameStats& stats = renderer_->stats();
    std::string text =
        stats.device.name + "\n" + stats.device.visibility + ", " + std::to_string(stats.windowFrames) + " frames";
    text += ", display " + std::to_string(std::lround(1 / viewer_.schedule().displayInterval())) + " Hz";
    if (const std::string driver = describe(renderer_->driverFeedback()); !driver.empty()) text += "\n" + driver;
    return text;
}

std::string Session::report(const std::string& system) const {
    nlohmann::ordered_json report{{"system", system}};
    const MotionFrames& motions = viewer_.schedule().motionFrames();
    if (renderer_) {
        const FrameStats& stats = renderer_->stats();
        report["device"] = deviceJson(stats.device);
        report["driver_feedback"] = describe(renderer_->driverFeedback());
        report["memory_traffic"] = trafficJson(queryTraffic(stats.device, options_));
        report["frames"] = {{"shown", stats.windowFrames},
                            {"device_milliseconds", stats.windowMilliseconds},
                            {"of_motions", motions.frames},
                            {"reduced", motions.reduced},
                            {"smallest_scale", motions.smallestScale},
                            {"pace", paceName(stats.windowPace.state)},
                            {"display_milliseconds", stats.windowPace.displayMilliseconds}};
    }
    report["window"] = {{"width", viewer_.frames().size().width},
                        {"height", viewer_.frames().size().height},
                        {"display_hertz", 1 / viewer_.schedule().displayInterval()}};
    return jsonText(report);
}

/// The occlusion maps get a part of the available memory.
std::uint64_t occlusionBytes(std::uint64_t wanted, std::uint64_t budget) {
    constexpr std::uint64_t kPart = 8, kLeast = 4u << 20;
    return budget == 0 ? wanted : std::min(wanted, std::max(budget / kPart, kLeast));
}

void Session::replace(double now) {
    const std::string loss = renderer_->deviceLoss();
    if (now - lostAt_ > kForgottenAfter) losses_ = 0;
    lostAt_ = now;
    if (++losses_ > kMostLosses)
        throw Error("drawing was given up", std::to_string(losses_) + " times within minutes", loss);
    if (host_.lost) host_.lost(loss);
    open(now);
}

void Session::setIdleTests(bool on) {
    idleTests_ = on;
    if (!on) idleTest_.stop();
}

/// Frames and a test at the same time would slow each other down, and falsify the test's times.
/// @returns when to call step() again
double Session::testWhileIdle(double now, double wake) {
    constexpr double kIdleSeconds = 1;
    if (!renderer_) return wake;
    if (idleTest_.foundNone()) open(now);  // refuses the device, and says why
    const std::uint64_t frames = renderer_->stats().windowFrames;
    if (std::exchange(framesBefore_, frames) != frames) {
        frameAt_ = now;
        idleTest_.stop();
    }
    const bool idle = idleTests_ && std::isinf(wake) && frames >= kFramesOfWarmUp && !renderer_->captures();
    if (!idle) return wake;
    const DeviceInfo& device = renderer_->stats().device;
    if (!idleTest_.wanted(options_, device)) return wake;
    if (now < frameAt_ + kIdleSeconds) return frameAt_ + kIdleSeconds;
    idleTest_.begin(options_, device);
    return wake;
}

/// The pipelines of the first refined picture suffice for all later ones.
void Session::keepPipelines() {
    if (pipelinesKept_ || !renderer_ || renderer_->stats().windowFrames < kFramesOfWarmUp) return;
    pipelinesKept_ = true;
    // RenderDoc hides the driver's data, and the earlier data is better.
    if (host_.keepPipelines && !renderer_->captures()) host_.keepPipelines(renderer_->pipelineCache());
}

}  // namespace nacre::app
