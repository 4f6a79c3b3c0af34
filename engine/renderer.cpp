// The parts of a renderer, and its calls. A picture continues in frame/picture_frames.cpp: its frames are chosen
// (frame/choose.h), declared (frame/frame.h, frame/paths), planned (graph/) and recorded (gpu/). docs/frame.md walks
// through one.

#include "engine/renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/error.h"
#include "engine/frame/devices.h"
#include "engine/frame/headset_frames.h"
#include "engine/frame/picture_frames.h"
#include "engine/frame/window_frames.h"
#include "engine/gpu/device_info.h"
#include "engine/gpu/loss_guard.h"
#include "engine/milliseconds.h"
#include "engine/occlusion/scene_occlusion.h"
#include "engine/scene/build/representation.h"
#include "engine/self_test.h"
#include "engine/self_test/start_guard.h"

namespace nacre {

namespace {

occlusion::SceneToBake toBake(const std::shared_ptr<const Scene>& scene) {
    return {{scene, &scene->representation}, {scene, &scene->buffers}};
}

/// @throws Error unless the view has pixels and usable numbers
void checkView(const View& view) {
    if (view.width == 0 || view.height == 0) throw Error("cannot draw", "", "the view has no pixels");
    double sum = view.radius + view.eyeDistance + view.pixelsPerAngstrom + view.pan.x + view.pan.y;
    sum += view.shift.x + view.shift.y + view.shift.z;
    if (view.other) sum += view.other->shift + view.other->pan;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) sum += view.rotation[column][row];
    if (!std::isfinite(sum)) throw Error("cannot draw", "", "the view has a number that is not finite");
    if (view.pixelsPerAngstrom <= 0) throw Error("cannot draw", "", "the view has no pixels per ångström");
    if (view.radius < 0) throw Error("cannot draw", "", "the view's radius is negative");
    if (view.projection == Projection::perspective && view.eyeDistance <= 0)
        throw Error("cannot draw", "", "the eye is not in front of the scene");
}

void checkOcclusion(const OcclusionSettings& occlusion) {
    if (occlusion.directions < 0 || occlusion.directions > OcclusionSettings::kMostDirections)
        throw Error("cannot draw", "",
                    "occlusion has 0 to " + std::to_string(OcclusionSettings::kMostDirections) + " directions, not " +
                        std::to_string(occlusion.directions));
}

/// @throws Error unless a picture can have these settings
void checkSettings(const RenderSettings& settings) {
    checkView(settings.view);
    checkOcclusion(settings.occlusion);
    const auto& [light, contours, halos, fog, shadow, clip, lens] = settings.effects;
    double sum = light.ambient + light.direct + light.highlight + light.gloss + light.occlusion + contours.width +
                 contours.depth + halos.width + halos.depth + halos.strength + fog.start + fog.end + fog.strength +
                 shadow.strength + lens.strength + lens.focus.value_or(0) + settings.meshError + settings.levelError;
    for (const float part : settings.background) sum += part;
    if (!std::isfinite(sum) || std::isnan(clip.near) || std::isnan(clip.far))
        throw Error("cannot draw", "", "the settings have a number that is not finite");
}

/// @throws Error unless the view has two eyes
void checkEyes(const View& view) {
    if (!view.other) throw Error("cannot draw both eyes", "", "the view has no other eye (View::other)");
}

}  // namespace

struct SharedDevice {
    SharedDevice(const DeviceOptions& options, gpu::Caching caching) : device(options, caching) {}
    gpu::Device device;
    DeviceInfo info;  ///< with choices, and the result of a self-test
};

struct Renderer::Impl {
    StartGuard start;
    std::shared_ptr<SharedDevice> shared;
    gpu::Device& device{shared->device};
    gpu::LossGuard guarded{device};
    gpu::Executor executor{device};
    FrameStats stats;
    std::shared_ptr<Scene> own = std::make_shared<Scene>();  // its colours may change while nobody else reads it
    std::shared_ptr<const Scene> scene = own;
    occlusion::SceneOcclusion occlusion{device, executor};
    SceneFrames frames = guarded([&] { return SceneFrames(device, executor, scene); });
    PictureFrames pictures{device, executor, frames};
    std::unique_ptr<WindowFrames> window;
    std::unique_ptr<HeadsetFrames> headset;
    /// Inputs of the bake that started pictures read.
    std::pair<const Scene*, occlusion::SceneOcclusion::Wanted> startedWith{};

    explicit Impl(const DeviceOptions& options)
        : start(options.surface.create ? options.selfTests : std::string()),
          shared(std::make_shared<SharedDevice>(
              options, start.mode() == StartMode::usual ? gpu::Caching::usual : gpu::Caching::none)) {
        stats.device = gpu::describeDevice(device.caps(), device.physical());
        const std::string selfTest = testPath(options, stats.device);
        addChoices(stats.device, device.caps());
        stats.device.selfTest = selfTest;
        shared->info = stats.device;
        occlusion.setAutomaticMaps(chooseOcclusionMaps(device.caps()));
        if (options.surface.create) window = std::make_unique<WindowFrames>(device, executor, frames, options.surface);
        if (options.headset.device) headset = std::make_unique<HeadsetFrames>(device, executor, frames);
    }
    explicit Impl(std::shared_ptr<SharedDevice> other) : start(std::string()), shared(std::move(other)) {
        stats.device = shared->info;
        occlusion.setAutomaticMaps(chooseOcclusionMaps(device.caps()));
    }
    ~Impl() { settle(); }

    /// Waits for this renderer's own work.
    void settle() {
        if (window || headset) return device.settle();  // their frames may still read the scene
        try {
            pictures.settle();
        } catch (const std::exception&) {
            device.settle();
        }
    }

    /// Finds the fastest correct path, if a self-test decides. A window does not wait for a test: it draws by the path
    /// of the device's capabilities until somebody has tested (lacksSelfTest()).
    /// @returns the test's result as text @throws Error if no path is right
    std::string testPath(const DeviceOptions& options, const DeviceInfo& info) {
        const gpu::Caps& caps = device.caps();
        if (!wantsSelfTest(options, info) || device.capture().loaded()) return {};
        if (start.mode() == StartMode::plainPath) {
            device.choose(plainestPath("earlier starts by other paths ended the program"));
            return {};
        }
        std::optional<SelfTest> test = keptSelfTest(options.selfTests, caps.driverKey);
        if (!test) {
            if (options.surface.create) return {};
            if (options.onSelfTest) options.onSelfTest();
            test = testPaths(options, info);
        }
        const graph::TestedPath byCaps = nacre::choosePath(caps);
        const graph::TestedPath path = nacre::choosePath(*test, byCaps.visibility, byCaps.why);
        if (isAutomatic(path.visibility)) throw Error("unsuitable device", caps.deviceName, path.why);
        device.choose(path);
        return describe(*test);
    }

    /// @throws Error if there is no window
    WindowFrames& shownIn() const {
        if (!window) throw Error("cannot present", "", "the renderer has no window (DeviceOptions::surface)");
        return *window;
    }

    // Collects the parts' measurements for stats():
    void noteBake() { static_cast<BakeStats&>(stats) = occlusion.stats(); }
    /// @param counts  of the last frame
    void noteFrame(const SceneCounts& counts) {
        stats.spheres = counts.spheres + counts.layers.spheres;
        stats.cylinders = counts.cylinders + counts.layers.cylinders;
        stats.triangles = counts.triangles + counts.layers.triangles;
        stats.meshLevels = counts.meshLevels;
        stats.copyLevels = counts.copyLevels;
        stats.lists = counts.lists;
        stats.pipelines = executor.pipelines();
        stats.pipelinesPending = executor.makesPipelines();
    }

    void notePicture() {
        noteBake();
        static_cast<PictureStats&>(stats) = pictures.stats();
        noteFrame(pictures.counts());
    }

    /// Draws with complete occlusion, if the settings ask for occlusion.
    template <typename Draw>
    auto drawFinished(const RenderSettings& settings, const Draw& draw) {
        checkSettings(settings);
        return guarded([&] {
            pictures.settle();
            occlusion.finish(settings.occlusion, onlyViewDirection(settings));
            auto drawn = draw(occlusion.atlas());
            notePicture();
            return drawn;
        });
    }

    /// Waits for started pictures if their bake would change: they read it.
    void waitUnlessBaked(const OcclusionSettings& wanted) {
        std::pair now(static_cast<const Scene*>(scene.get()), occlusion::SceneOcclusion::wanted(wanted));
        if (wanted.once || now != startedWith) pictures.settle();
        startedWith = std::move(now);
    }

    /// Runs a call for started pictures, and cancels them if it fails.
    template <typename Call>
    auto dropOnError(const Call& call) {
        try {
            return guarded(call);
        } catch (...) {
            pictures.drop();
            throw;
        }
    }

    /// Runs a call, and returns `lost` instead of its result if the device is lost.
    template <typename Outcome, typename Call>
    Outcome unlessLost(Outcome lost, Call&& call) {
        if (guarded.lost()) return lost;
        try {
            return guarded(call);
        } catch (const Error&) {
            if (!guarded.lost()) throw;
            return lost;
        }
    }
};

Renderer::Renderer(const DeviceOptions& options) {
    try {
        impl_ = std::make_unique<Impl>(options);
    } catch (const vk::SystemError& failure) {  // before there was a device that could give details
        throw Error("cannot start Vulkan", "", gpu::inOneLine(failure.what()));
    }
}
Renderer::Renderer(std::shared_ptr<SharedDevice> device) {
    gpu::LossGuard(device->device)([&] { impl_ = std::make_unique<Impl>(device); });
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

std::shared_ptr<SharedDevice> Renderer::device() const { return impl_->shared; }

bool Renderer::setScene(Representation representation) {
    const bool colorsAlone = impl_->guarded([&] {
        impl_->settle();
        impl_->occlusion.stopBounce();
        const bool kept = !impl_->occlusion.readsScene() && recolor(*impl_->own, representation);
        if (!kept) {
            auto scene = std::make_shared<Scene>(makeScene(impl_->device, std::move(representation)));
            impl_->occlusion.setScene(toBake(scene));
            impl_->scene = impl_->own = std::move(scene);
        }
        if (kept && impl_->occlusion.recolored()) impl_->startedWith = {};
        impl_->frames.releaseScene();
        return kept;
    });
    impl_->stats.copies = std::max<std::uint64_t>(impl_->scene->representation.copies.transforms.size(), 1);
    return colorsAlone;
}

void Renderer::moveScene(Representation representation) {
    if (!isMoved(*impl_->scene, representation)) return void(setScene(std::move(representation)));
    impl_->guarded([&] {  // frames in flight keep the previous scene
        auto scene = std::make_shared<Scene>(makeMovedScene(impl_->device, std::move(representation), *impl_->scene));
        impl_->occlusion.moveScene(toBake(scene));
        impl_->scene = impl_->own = std::move(scene);
        impl_->frames.releaseScene();
    });
}

void Renderer::makePipelinesAhead() { impl_->executor.makePipelinesAhead(); }

Picture Renderer::render(const RenderSettings& settings) {
    return impl_->drawFinished(settings,
                               [&](const passes::Atlas& atlas) { return impl_->pictures.picture(settings, atlas); });
}

CodedPicture Renderer::renderCoded(const RenderSettings& settings, bool alpha) {
    return impl_->drawFinished(
        settings, [&](const passes::Atlas& atlas) { return impl_->pictures.coded(settings, atlas, alpha); });
}

void Renderer::startCoded(const RenderSettings& settings, bool alpha) {
    impl_->dropOnError([&] {
        checkSettings(settings);
        impl_->waitUnlessBaked(settings.occlusion);
        impl_->occlusion.finish(settings.occlusion, onlyViewDirection(settings));
        impl_->pictures.start(settings, impl_->occlusion.atlas(), alpha);
        impl_->notePicture();
    });
}

CodedPicture Renderer::finishCoded() {
    return impl_->dropOnError([&] { return impl_->pictures.finish(); });
}

std::size_t Renderer::started() const { return impl_->pictures.started(); }

Picture Renderer::renderPart(const RenderSettings& settings, const PictureRect& part) {
    return impl_->drawFinished(settings,
                               [&](const passes::Atlas& atlas) { return impl_->pictures.part(settings, atlas, part); });
}

std::array<Picture, 2> Renderer::renderEyes(const RenderSettings& settings) {
    checkEyes(settings.view);
    return impl_->drawFinished(settings,
                               [&](const passes::Atlas& atlas) { return impl_->pictures.eyes(settings, atlas); });
}

std::array<LayerPicture, 2> Renderer::layersOfEyes(const RenderSettings& settings) {
    checkEyes(settings.view);
    return impl_->drawFinished(
        settings, [&](const passes::Atlas& atlas) { return impl_->pictures.layersOfEyes(settings, atlas); });
}

LayerPicture Renderer::layers(const RenderSettings& settings) {
    return impl_->drawFinished(settings,
                               [&](const passes::Atlas& atlas) { return impl_->pictures.layers(settings, atlas); });
}

double Renderer::drawFrame(const RenderSettings& settings) {
    checkSettings(settings);
    return impl_->guarded([&] {
        impl_->occlusion.begin(settings.occlusion);
        const auto start = Clock::now();
        impl_->pictures.frame(settings, impl_->occlusion.atlas());
        const double milliseconds = millisecondsSince(start);
        impl_->notePicture();
        return milliseconds;
    });
}

double Renderer::advanceOcclusion(const RenderSettings& settings, double milliseconds) {
    checkOcclusion(settings.occlusion);
    if (settings.occlusion.directions == 0) return 1;
    return impl_->unlessLost(0.0, [&] {  // present() reports the loss
        impl_->occlusion.begin(settings.occlusion);
        impl_->occlusion.advance(milliseconds);
        impl_->noteBake();
        return impl_->occlusion.share();
    });
}

double Renderer::advanceOcclusion(const RenderSettings& settings, const OcclusionPace& pace) {
    checkOcclusion(settings.occlusion);
    if (settings.occlusion.directions == 0) return 1;
    return impl_->unlessLost(0.0, [&] {
        const double share = impl_->occlusion.advanceBeside(settings.occlusion, pace);
        impl_->noteBake();
        return share;
    });
}

void Renderer::awaitFrame() {
    try {
        impl_->unlessLost(false, [&] {
            impl_->shownIn().await();
            return true;
        });
    } catch (const Error&) {
        // present() reports the same error.
    }
}

FrameOutcome Renderer::present(const RenderSettings& settings, const WindowFrame& frame) {
    return impl_->unlessLost(FrameOutcome::lost, [&] {
        const FrameOutcome outcome = impl_->shownIn().present(settings, impl_->occlusion.atlas(), frame);
        constexpr std::uint64_t kFramesOfStart = 3;  // when the third is submitted, the first is done
        if (outcome == FrameOutcome::shown && ++impl_->stats.windowFrames == kFramesOfStart)
            impl_->start.done(impl_->stats.device.driverKey);
        impl_->noteFrame(impl_->shownIn().counts());
        impl_->stats.windowMilliseconds = impl_->shownIn().milliseconds();
        impl_->stats.windowPace = impl_->shownIn().pace();
        return outcome;
    });
}

FrameOutcome Renderer::presentEyes(const RenderSettings& settings, const std::array<View, 2>& eyes,
                                   const HeadsetImage& into) {
    if (!impl_->headset) throw Error("cannot present", "", "the renderer has no headset (DeviceOptions::headset)");
    for (const View& eye : eyes) {
        checkView(eye);
        if (eye.width != into.width || eye.height != into.height)
            throw Error("cannot present", "", "an eye's view has another size than the headset's image");
    }
    return impl_->unlessLost(FrameOutcome::lost, [&] {
        impl_->headset->present(settings, impl_->occlusion.atlas(), eyes, into);
        ++impl_->stats.windowFrames;
        impl_->noteFrame(impl_->headset->counts());
        impl_->stats.windowMilliseconds = impl_->headset->milliseconds();
        return FrameOutcome::shown;
    });
}

void Renderer::expectScene(Representation like, const RenderSettings& settings, const WindowFrame& frame) {
    const auto expect = [&] {
        auto scene = std::make_shared<const Scene>(makeScene(impl_->device, std::move(like)));
        std::swap(scene, impl_->scene);
        const auto back = [&] {
            std::swap(scene, impl_->scene);
            impl_->frames.releaseScene();
        };
        try {
            impl_->shownIn().prepareScene(settings, frame);
        } catch (...) {
            back();
            throw;
        }
        back();
        return true;
    };
    try {
        impl_->unlessLost(false, expect);
    } catch (const Error&) {
        // The scene itself reports the same error.
    }
}

BakedOcclusion Renderer::bakedOcclusion(const OcclusionSettings& settings) {
    checkOcclusion(settings);
    return impl_->guarded([&] {
        BakedOcclusion baked = impl_->occlusion.baked(settings);
        impl_->noteBake();
        return baked;
    });
}

std::uint32_t Renderer::atomAt(const RenderSettings& settings, double x, double y, double reach) {
    checkSettings(settings);
    return impl_->guarded([&] {
        const std::uint32_t atom = impl_->pictures.atomAt(settings, x, y, reach);
        impl_->notePicture();
        return atom;
    });
}

std::vector<std::uint32_t> Renderer::atoms(const RenderSettings& settings) {
    checkSettings(settings);
    return impl_->guarded([&] {
        std::vector<std::uint32_t> atoms = impl_->pictures.atoms(settings);
        impl_->notePicture();
        return atoms;
    });
}

std::vector<bool> Renderer::seenSpheres() const {
    const occlusion::Bake* bake = impl_->occlusion.bake();
    if (!bake) return {};
    const std::vector<bool>& ordered = bake->seenSpheres();
    std::vector<bool> seen(ordered.size());
    for (std::size_t i = 0; i < ordered.size(); ++i) seen[impl_->scene->order.spheres[i]] = ordered[i];
    return seen;
}

PixelSize Renderer::windowSize() const { return {impl_->shownIn().size().width, impl_->shownIn().size().height}; }
void Renderer::releaseWindow() {
    impl_->guarded([&] { impl_->shownIn().release(); });
}
void Renderer::setOverlayGlyphs(const OverlayGlyphs& glyphs) {
    impl_->guarded([&] { impl_->shownIn().setGlyphs(glyphs); });
}

bool Renderer::captures() const { return impl_->device.capture().loaded(); }
bool Renderer::startedByRenderDoc() const { return impl_->device.capture().launched(); }
void Renderer::beginCapture(const std::string& stem) { impl_->device.capture().begin(*impl_->device.instance(), stem); }
std::string Renderer::endCapture() { return impl_->device.capture().end(); }

std::vector<std::byte> Renderer::pipelineCache() const {
    const vk::raii::PipelineCache* cache = impl_->device.pipelineCache();
    if (!cache) return {};
    const auto data = impl_->guarded([&] { return cache->getData(); });
    const auto bytes = std::as_bytes(std::span(data));
    return {bytes.begin(), bytes.end()};
}

bool Renderer::awaitSubmitted(double seconds) const {
    return impl_->unlessLost(true, [&] { return impl_->device.awaitSubmitted(seconds); });
}

const std::string& Renderer::deviceLoss() const { return impl_->guarded.loss(); }
const FrameStats& Renderer::stats() const { return impl_->stats; }
DriverFeedback Renderer::driverFeedback() const {
    return impl_->guarded([&] { return impl_->executor.feedback(); });
}
const std::string& Renderer::planText() const { return impl_->pictures.planText(); }
std::vector<Decision> Renderer::decisions() const { return impl_->pictures.decisions(); }
std::vector<std::string> Renderer::validationMessages() const { return impl_->device.validationMessages(); }
std::uint32_t Renderer::maxSize() const { return impl_->device.caps().maxImageSize; }

}  // namespace nacre
