#include "app/xr/xr_session.h"

#include <chrono>
#include <thread>

#include "app/download/molecule_sources.h"
#include "app/files/cache_folder.h"
#include "app/files/messages.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr PixelSize kPicture{1000, 1000};  // size of the picture that the viewer assumes

PictureDescription firstView(PictureDescription first) {
    first.aim = {};  // the viewer receives the aim separately
    first.stereo = {};
    first.input.path = lasting(first.input.path);
    for (FurtherInput& further : first.input.further) further.path = lasting(further.path);
    return first;
}

ViewerOptions viewerOptions(const PictureDescription& first) {
    ViewerOptions options;
    options.occlusionBytes = first.occlusion.bytes();
    options.occlusionCache = cacheFolder(first.input.cache, "occlusion");
    options.tuning = first.tuning;
    return options;
}

}  // namespace

double HeadsetSession::now() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

HeadsetSession::HeadsetSession(const PictureDescription& first)
    : first_(first), session_(host(), windowSources(first.input), firstView(first), viewerOptions(first), [] {}) {
    placement_.center = {0, 0, -kMetresAhead};
    session_.setIdleTests(false);
    open();
    viewer().frames().resize(kPicture, 1, now());
    viewer().camera().aim(first.aim, now());
    viewer().reading().throwEarlyFailure();
}

HeadsetSession::~HeadsetSession() { headset_.end(); }

SessionHost HeadsetSession::host() {
    SessionHost host;
    host.device = [this] {
        DeviceOptions device = first_.device;
        device.headset = headset_.source();
        return device;
    };
    host.loadPipelines = [] { return std::vector<std::byte>(); };
    host.prepare = [this](Renderer&) { headset_.begin(); };
    host.lost = [this](const std::string& why) {
        sayWarning(why);
        headset_.end();
    };
    host.present = [this](Renderer& renderer, const RenderSettings& settings) { return present(renderer, settings); };
    return host;
}

/// Opens a headset session with a new device.
void HeadsetSession::open() {
    headset_.end();
    session_.open(now());
}

void HeadsetSession::loop(const std::function<bool()>& asked) {
    for (bool leaving = false; step();)
        if (!leaving && asked && asked()) headset_.leave(), leaving = true;
    headset_.end();
    if (const std::vector<std::string> messages = renderer()->validationMessages(); !messages.empty())
        throw Error("Vulkan validation", renderer()->stats().device.name,
                    std::to_string(messages.size()) + " messages, the first: " + messages.front());
}

bool HeadsetSession::step() {
    try {
        headset_.handleEvents();
        if (headset_.over()) return false;
        if (!headset_.lost()) {
            if (headset_.running())
                drawFrame();
            else
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            return true;
        }
    } catch (const XrFailure& failure) {
        if (failure.result != XR_ERROR_SESSION_LOST) throw;
    }
    if (++losses_ > kMostLosses)
        throw Error("cannot show in a headset", "OpenXR", "the session was lost " + std::to_string(losses_) + " times");
    sayWarning("the headset's session was lost: another begins");
    grip_.reset();
    open();
    return true;
}

void HeadsetSession::drawFrame() {
    const Headset::Frame frame = headset_.beginFrame();
    shown_.reset();
    eyes_.reset();
    if (frame.shows) eyes_ = headset_.eyes(frame);
    if (eyes_) {
        follow(headset_.hand(frame), *eyes_);
        viewer().schedule().pictureChanged(now());  // the head moves
    }
    session_.step(now());
    tell();
    if (!headset_.running()) return;  // the device was lost, and with it the session
    headset_.endFrame(frame, shown_);
    if (shown_) losses_ = 0;
}

void HeadsetSession::follow(const std::optional<Hand>& hand, const std::array<EyePose, 2>& eyes) {
    if (headset_.menu()) {
        placement_.center = {0, 0, -kMetresAhead};
        viewer().run(ViewerCommand::reset, now());
    }
    if (!hand || !hand->holds) {
        grip_.reset();
        return;
    }
    if (!grip_) {
        viewer().gesture({Gesture::Kind::touched}, now());  // undo returns to this state
        const Camera& camera = viewer().view().camera;
        grip_.emplace(hand->pose, (eyes[0].position + eyes[1].position) / 2.0, camera.orientation, camera.zoom);
    }
    viewer().camera().hold(grip_->orientation(hand->pose), grip_->zoom(hand->pose), now());
}

FrameOutcome HeadsetSession::present(Renderer& renderer, const RenderSettings& settings) {
    if (!eyes_) return FrameOutcome::shown;  // nothing until the head is tracked again
    const View& seen = settings.view;
    placement_.rotation = seen.rotation;
    placement_.radius = seen.radius;
    placement_.metresPerAngstrom = kMetresAcross * seen.pixelsPerAngstrom / kPicture.width;
    const EyeViews drawn = makeViews(keepInFront(placement_, *eyes_), *eyes_, headset_.width(), headset_.height());
    RenderSettings both = settings;
    both.view = drawn.views[0];
    both.effects.depthOfField.strength = 0;  // the user's eyes focus themselves
    const HeadsetImage image = headset_.take();
    FrameOutcome outcome{};
    try {
        outcome = renderer.presentEyes(both, drawn.views, image);
    } catch (...) {
        headset_.give();
        throw;
    }
    headset_.give();
    if (outcome == FrameOutcome::shown) shown_ = drawn.eyes;
    return outcome;
}

/// Prints new messages of the viewer, which the headset does not show.
void HeadsetSession::tell() {
    const std::string& message = viewer().messages().message();
    if (message != told_ && !message.empty()) sayNote(message);
    told_ = message;
}

}  // namespace nacre::app
