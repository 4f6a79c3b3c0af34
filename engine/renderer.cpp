// The frame, in reading order: the passes of the screen, the layers, the occlusion they read.

#include "engine/renderer.h"

#include <algorithm>
#include <cmath>

#include "engine/error.h"
#include "engine/frame/debug_frame.h"
#include "engine/frame/picture.h"
#include "engine/frame/screen_frame.h"
#include "engine/frame/window_frames.h"
#include "engine/gpu/context.h"
#include "engine/gpu/instance.h"
#include "engine/milliseconds.h"
#include "engine/occlusion/scene_occlusion.h"
#include "engine/passes/debug_pass.h"
#include "engine/passes/fragment_counter.h"
#include "engine/passes/geometry.h"
#include "engine/passes/read_back.h"
#include "engine/passes/view_constants.h"

namespace nacre {
namespace {

using passes::Nearest;
using passes::Writes;

DeviceInfo infoOf(const gpu::Caps& caps) {
    DeviceInfo info;
    info.name = caps.deviceName;
    info.driver = caps.driverName;
    info.type = caps.type;
    info.apiVersion = std::to_string(VK_API_VERSION_MAJOR(caps.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_MINOR(caps.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_PATCH(caps.apiVersion));
    info.visibility = visibilityName(caps.visibility);
    info.why = caps.visibilityReason;
    info.encodedFormat = graph::formatName(caps.encoded.format);
    info.lazyMemory = caps.plan.transient;
    return info;
}

constexpr ScreenTarget kLayerTargets[] = {{"colour", VK_FORMAT_R32G32B32A32_SFLOAT, Writes::color},
                                          {"surface", VK_FORMAT_R32G32B32A32_SFLOAT, Writes::surface},
                                          {"identity", VK_FORMAT_R32G32_UINT, Writes::identity}};

constexpr ScreenTarget kPickTargets[] = {{"identity", VK_FORMAT_R32G32_UINT, Writes::identity}};

/// Of the image that holds a view: the view's own, or turned.
graph::Extent imageExtent(const View& view) {
    return view.quarterTurns % 2 ? graph::Extent{view.height, view.width} : graph::Extent{view.width, view.height};
}

}  // namespace

struct Renderer::Impl {
    gpu::Device device;
    Nearest nearest;
    passes::Geometry geometry;
    passes::DebugPass debugPass;
    gpu::Executor executor;
    gpu::Image white;
    Representation representation;
    passes::SceneBuffers scene;
    double meanRadius = 0;  // of the spheres, Å
    FrameStats stats;
    SceneOcclusion occlusion{device, executor, geometry, nearest, representation, scene, stats};
    graph::PlanCache plans;
    graph::Graph lastGraph{"none"};  // of planText()
    graph::Plan lastPlan;
    std::string planText;
    std::unique_ptr<WindowFrames> window;
    std::string loss;  // of the device; empty: it is there

    ~Impl() { device.settle(); }

    /// What went wrong, in words. A loss is remembered.
    Error told(const vk::SystemError& failure) {
        Error error = device.errorOf(failure);
        if (failure.code() == vk::make_error_code(vk::Result::eErrorDeviceLost)) loss = error.what();
        return error;
    }
    template <typename Call>
    auto guarded(Call&& call) {
        try {
            return call();
        } catch (const vk::SystemError& failure) {
            throw told(failure);
        }
    }

    explicit Impl(const DeviceOptions& options)
        : device(options),
          nearest(nearestOf(device.caps().visibility)),
          geometry(device),
          debugPass(device),
          executor(device) {
        stats.device = infoOf(device.caps());
        guarded([&] {
            white = passes::makeWhiteTexture(device, executor);
            if (options.surface.create) window = std::make_unique<WindowFrames>(device, executor, options.surface);
        });
    }

    /// Declares the screen frame (screen_frame.cpp) with its recorders.
    ScreenFrame declare(const RenderSettings& settings, const View& view, std::span<const ScreenTarget> targets,
                        const char* name, gpu::Imports& imports, passes::FragmentCounter* counter = nullptr);
    /// Gives the recorders of the passes that only a debug view has.
    DebugRecord recordDebug(const RenderSettings& settings, const View& view);
    /// Draws one frame. @returns the pixels of every target, for the host; none unless `readBack`
    std::vector<gpu::Buffer> draw(const RenderSettings& settings, const View& view,
                                  std::span<const ScreenTarget> targets, bool readBack = true,
                                  const char* name = "screen");
    layout::ViewConstants constants(const RenderSettings& settings, const View& view) const;
};

layout::ViewConstants Renderer::Impl::constants(const RenderSettings& settings, const View& view) const {
    const graph::Extent image = imageExtent(view);
    layout::ViewConstants c =
        passes::viewConstants(view, device.caps().snapPixels, image.width / 2.0, image.height / 2.0);
    const bool occluded = settings.occlusion.directions > 0 && occlusion.bake();
    const OcclusionLayout layout = occluded ? occlusion.bake()->layout() : OcclusionLayout{};
    if (occluded) c.atlasTexel = glm::vec2(1.0 / layout.width, 1.0 / layout.height);
    c.sphereEdge = static_cast<float>(layout.sphereEdge);
    c.around = static_cast<float>(layout.around);
    c.along = static_cast<float>(layout.along);
    c.lighting = settings.lighting ? 1 : 0;
    c.occlusion = occluded ? 1 : 0;
    c.spheres = static_cast<std::uint32_t>(representation.spheres.size());
    c.primitives = static_cast<std::uint32_t>(c.spheres + representation.cylinders.size());
    c.wholeImage = 1;
    return c;
}

ScreenFrame Renderer::Impl::declare(const RenderSettings& settings, const View& view,
                                    std::span<const ScreenTarget> targets, const char* name, gpu::Imports& imports,
                                    passes::FragmentCounter* counter) {
    const gpu::Image& atlas = settings.occlusion.directions > 0 && occlusion.bake() ? occlusion.bake()->atlas() : white;
    // Held by the recorders, as long as the graph is there.
    const auto copies = std::make_shared<const passes::PlacedCopies>(passes::placeCopies(representation, view));
    const auto copyRows = std::make_shared<gpu::Buffer>();
    stats.spheres = copies->sphereCount();
    stats.cylinders = copies->cylinderCount();
    // Layers and picks take several targets or another one.
    const bool debug = settings.debug != DebugView::none && targets.size() == 1 && targets[0].writes == Writes::color;
    const Nearest path = debug ? debugNearest(settings.debug, nearest) : nearest;
    if (path == Nearest::deferred)
        *copyRows = gpu::makeBuffer(device, std::span(copies->rows), vk::BufferUsageFlagBits::eStorageBuffer, "copies");
    const auto record = [&](Writes writes, const ScreenInputs& inputs) {
        passes::Draw d{writes, path, view.projection == Projection::perspective, constants(settings, view)};
        d.quarterTurns = view.quarterTurns;
        d.copies = copies.get();
        d.copyRows = copyRows.get();
        d.plates = settings.tuning.plates;
        d.impostor = settings.tuning.impostor;
        d.radiusPixels = meanRadius * view.pixelsPerAngstrom;
        if (counter) counter->attach(d);
        return [this, d, inputs, copies, copyRows](gpu::PassContext& c) {
            geometry.draw(c, scene, d, {c.view(inputs.atlas), c.view(inputs.nearest), inputs.nearestIsTexture});
        };
    };
    const ScreenFrameOptions options{imageExtent(view), path, device.caps().encoded, atlas.desc, targets, name};
    ScreenFrame frame =
        debug ? debugFrame(settings.debug, options, record, recordDebug(settings, view)) : screenFrame(options, record);
    imports.bind(frame.atlas, atlas);
    return frame;
}

DebugRecord Renderer::Impl::recordDebug(const RenderSettings& settings, const View& view) {
    return [&](const DebugInputs& inputs) {
        const passes::DebugPass::Draw d{settings.debug,    inputs.tileMean,
                                        kDebugTile,        view.projection == Projection::perspective,
                                        view.quarterTurns, constants(settings, view)};
        return [this, d, inputs](gpu::PassContext& c) {
            debugPass.draw(c, d, c.view(inputs.source), inputs.hasUnder ? c.view(inputs.under) : vk::ImageView());
        };
    };
}

/// The screen frame, and the copies of its targets to the host.
std::vector<gpu::Buffer> Renderer::Impl::draw(const RenderSettings& settings, const View& view,
                                              std::span<const ScreenTarget> targets, bool readBack, const char* name) {
    const graph::Extent extent = imageExtent(view);
    passes::FragmentCounter counter(device, settings.tuning.countFragments);
    gpu::Imports imports;
    ScreenFrame frame = declare(settings, view, targets, name, imports, &counter);
    graph::Graph& g = frame.graph;
    std::vector<gpu::Buffer> pixels;
    pixels.reserve(targets.size());
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (!readBack) {
            g.output(frame.targets[i]);
            continue;
        }
        const std::string what = std::string(targets[i].image) + " pixels";
        const std::uint64_t bytes =
            std::uint64_t{extent.width} * extent.height * graph::bytesPerTexel(targets[i].format);
        pixels.push_back(
            gpu::makeBuffer(device, bytes, vk::BufferUsageFlagBits::eTransferDst, gpu::Access::readback, what));
        const auto buffer = g.importBuffer(what, bytes);
        imports.bind(buffer, pixels.back());
        passes::readBack(g, frame.targets[i], {targets[i].format, extent}, buffer);
    }

    graph::PlanCaps caps = device.caps().plan;
    caps.merge = caps.merge && settings.tuning.merge;
    caps.transient = caps.transient && settings.tuning.transient;
    caps.storeAll = caps.storeAll || !settings.tuning.transient;
    const graph::Plan& plan = plans.planOf(g, caps);
    if (lastPlan != plan) {
        lastGraph = g.declarations();
        lastPlan = plan;
        planText.clear();
    }
    const auto start = Clock::now();
    device.submitAndWait([&](const vk::raii::CommandBuffer& c) {
        executor.record(c, g, plan, imports);
        counter.finish(c);
    });
    stats.frameMilliseconds = millisecondsSince(start);
    executor.reset();
    if (settings.tuning.countFragments) stats.passes = counter.counts();
    stats.tileBytesPerPixel = 0;
    for (const graph::Step& step : plan.steps)
        stats.tileBytesPerPixel = std::max(stats.tileBytesPerPixel, step.renderPass.tileBytesPerPixel);
    stats.loadedBytes = plan.total.loaded;
    stats.storedBytes = plan.total.stored;
    stats.deviceBytes = device.peakAllocatedBytes();
    stats.deviceBytesHeld = device.allocatedBytes();
    return pixels;
}

Renderer::Renderer(const DeviceOptions& options) {
    try {
        impl_ = std::make_unique<Impl>(options);
    } catch (const vk::SystemError& failure) {  // before there was a device that could tell more
        throw Error("cannot start Vulkan", "", gpu::inOneLine(failure.what()));
    }
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

void Renderer::setScene(Representation representation) {
    Impl& impl = *impl_;
    impl.guarded([&] {
        impl.device->waitIdle();  // frames for the window may still read the streams
        passes::SceneBuffers scene = passes::makeSceneBuffers(impl.device, representation);
        impl.occlusion.drop();
        impl.scene = std::move(scene);
    });
    impl.representation = std::move(representation);
    double sum = 0;
    for (const Sphere& s : impl.representation.spheres) sum += s.radius;
    impl.meanRadius = sum / static_cast<double>(std::max<std::size_t>(impl.representation.spheres.size(), 1));
    impl.stats.copies = std::max<std::uint64_t>(impl.representation.copies.transforms.size(), 1);
}

Picture Renderer::render(const RenderSettings& settings) {
    const std::uint32_t n = std::max(settings.supersample, 1u);
    const View view = scaled(settings.view, n);
    if (std::max(view.width, view.height) > maxSize())
        throw Error("picture too large", std::to_string(view.width) + "x" + std::to_string(view.height),
                    "this device draws at most " + std::to_string(maxSize()) + " pixels a side, supersampling counted");
    const auto pixels = impl_->guarded([&] {
        impl_->occlusion.finish(settings);
        return impl_->draw(settings, view, kScreenTargets);
    });
    const graph::Extent image = imageExtent(view);
    return resolvePicture(reinterpret_cast<const std::uint32_t*>(pixels[0].mapped), image.width, image.height, n,
                          settings.background, impl_->stats.coveredPixels);
}

LayerPicture Renderer::layers(const RenderSettings& settings) {
    const auto pixels = impl_->guarded([&] {
        impl_->occlusion.finish(settings);
        return impl_->draw(settings, settings.view, kLayerTargets);
    });
    return assembleLayers(settings.view.width, settings.view.height, reinterpret_cast<const float*>(pixels[0].mapped),
                          reinterpret_cast<const float*>(pixels[1].mapped),
                          reinterpret_cast<const std::uint32_t*>(pixels[2].mapped), settings.background,
                          impl_->stats.coveredPixels);
}

double Renderer::drawFrame(const RenderSettings& settings) {
    return impl_->guarded([&] {
        impl_->occlusion.begin(settings);
        const auto start = Clock::now();
        impl_->draw(settings, settings.view, kScreenTargets, false);
        return millisecondsSince(start);
    });
}

double Renderer::advanceOcclusion(const RenderSettings& settings, double milliseconds) {
    if (settings.occlusion.directions == 0) return 1;
    try {
        impl_->guarded([&] {
            impl_->occlusion.begin(settings);
            impl_->occlusion.advance(milliseconds);
        });
    } catch (const Error&) {
        if (impl_->loss.empty()) throw;
        return 0;  // present() tells
    }
    if (!impl_->occlusion.bake()) return 1;
    return static_cast<double>(impl_->occlusion.bake()->directionsDone()) / impl_->occlusion.bake()->directions();
}

std::vector<bool> Renderer::seenSpheres() const {
    return impl_->occlusion.bake() ? impl_->occlusion.bake()->seenSpheres() : std::vector<bool>{};
}

FrameOutcome Renderer::present(const RenderSettings& settings, const WindowFrame& frame) {
    Impl& impl = *impl_;
    const auto declare = [&](const View& view, std::span<const ScreenTarget> targets, const char* name,
                             gpu::Imports& imports) { return impl.declare(settings, view, targets, name, imports); };
    if (!impl.loss.empty()) return FrameOutcome::lost;
    try {
        return impl.guarded([&] {
            const FrameOutcome outcome = impl.window->present(settings.view, settings.background, frame, declare);
            if (outcome == FrameOutcome::shown) ++impl.stats.windowFrames;
            return outcome;
        });
    } catch (const Error&) {
        if (impl.loss.empty()) throw;
        return FrameOutcome::lost;
    }
}

PixelSize Renderer::windowSize() const { return {impl_->window->size().width, impl_->window->size().height}; }
void Renderer::releaseWindow() {
    impl_->guarded([&] { impl_->window->release(); });
}
void Renderer::setOverlayGlyphs(const OverlayGlyphs& glyphs) {
    impl_->guarded([&] { impl_->window->setGlyphs(glyphs); });
}

std::uint32_t Renderer::atomAt(const RenderSettings& settings, double x, double y, double reach) {
    // A picture of its own, as large as the reach, about the place. The middle pixel is the one that holds (x, y).
    const auto side = static_cast<std::uint32_t>(2 * std::ceil(std::clamp(reach, 0.0, 100.0)) + 1);
    RenderSettings small = settings;
    small.occlusion.directions = 0;
    small.tuning.countFragments = false;
    small.view.pan = -planePointAt(settings.view, std::floor(x) + 0.5, std::floor(y) + 0.5);
    small.view.width = small.view.height = side;
    const auto pixels = impl_->guarded([&] { return impl_->draw(small, small.view, kPickTargets, true, "pick"); });
    const auto* identity = reinterpret_cast<const std::uint32_t*>(pixels[0].mapped);
    std::uint32_t atom = 0;
    double nearest = reach * reach + 0.5;
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const double right = i - (side - 1) / 2.0, down = j - (side - 1) / 2.0;
            const double distance = right * right + down * down;
            const std::uint32_t here = identity[2 * (std::size_t{j} * side + i)];
            if (here == 0 || distance >= nearest) continue;
            nearest = distance;
            atom = here;
        }
    return atom;
}

bool Renderer::captures() const { return impl_->device.capture().loaded(); }
bool Renderer::startedByRenderDoc() const { return impl_->device.capture().launched(); }
void Renderer::beginCapture(const std::string& stem) { impl_->device.capture().begin(*impl_->device.instance(), stem); }
std::string Renderer::endCapture() { return impl_->device.capture().end(); }

std::vector<std::byte> Renderer::pipelineCache() const {
    const auto data = impl_->guarded([&] { return impl_->device.pipelineCache().getData(); });
    const auto bytes = std::as_bytes(std::span(data));
    return {bytes.begin(), bytes.end()};
}

const std::string& Renderer::deviceLoss() const { return impl_->loss; }
const FrameStats& Renderer::stats() const { return impl_->stats; }
const std::string& Renderer::planText() const {
    if (impl_->planText.empty()) impl_->planText = graph::describe(impl_->lastGraph, impl_->lastPlan);
    return impl_->planText;
}
const std::vector<std::string>& Renderer::validationMessages() const { return impl_->device.validationMessages(); }
std::uint32_t Renderer::maxSize() const { return impl_->device.caps().maxImageSize; }

bool capturesBuilt() { return gpu::CaptureHook::built(); }

std::vector<DeviceInfo> listDevices() {
    try {
        const vk::raii::Context context = gpu::makeContext();
        gpu::InstanceExtensions found;
        const vk::raii::Instance instance = gpu::makeInstance(context, false, found);
        std::vector<DeviceInfo> devices;
        for (const auto& physical : vk::raii::PhysicalDevices(instance))
            devices.push_back(infoOf(gpu::capsOf(physical)));
        return devices;
    } catch (const vk::SystemError& failure) {
        throw Error("cannot list devices", "", gpu::inOneLine(failure.what()));
    }
}

}  // namespace nacre
