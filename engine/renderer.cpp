// The frame, in reading order: the passes of the screen, the layers, the occlusion they read.

#include "engine/renderer.h"

#include <algorithm>
#include <bit>
#include <chrono>

#include "engine/error.h"
#include "engine/gpu/instance.h"
#include "engine/passes/fragment_counter.h"
#include "engine/passes/geometry.h"
#include "engine/passes/occlusion.h"
#include "engine/passes/read_back.h"
#include "engine/passes/view_constants.h"
#include "engine/picture.h"

namespace nacre {
namespace {

using graph::Clear;
using graph::Graph;
using passes::Nearest;
using passes::Writes;
using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

DeviceInfo infoOf(const gpu::Caps& caps) {
    DeviceInfo info;
    info.name = caps.deviceName;
    info.driver = caps.driverName;
    info.type = caps.type;
    info.apiVersion = std::to_string(VK_API_VERSION_MAJOR(caps.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_MINOR(caps.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_PATCH(caps.apiVersion));
    info.visibility = gpu::visibilityName(caps.visibility);
    info.why = caps.visibilityReason;
    info.encodedFormat = graph::formatName(caps.encoded.format);
    info.lazyMemory = caps.plan.transient;
    return info;
}

Nearest nearestOf(Visibility visibility) {
    switch (visibility) {
        case Visibility::fragdepth:
            return Nearest::fragdepth;
        case Visibility::deferred:
            return Nearest::deferred;
        case Visibility::rasterOrder:
            return Nearest::rasterOrder;
        default:
            return Nearest::encoded;
    }
}

}  // namespace

struct Renderer::Impl {
    gpu::Device device;
    Nearest nearest;
    passes::Geometry geometry;
    graph::Executor executor;
    gpu::Image white;
    Representation representation;
    OcclusionLayout layout;
    passes::SceneBuffers scene;
    std::unique_ptr<passes::OcclusionBake> bake;
    double meanRadius = 0;  // of the spheres, Å
    int bakedDirections = 0;
    std::uint64_t bakeBudget = 0;
    FrameStats stats;
    std::string planText;

    explicit Impl(const DeviceOptions& options)
        : device(options),
          nearest(nearestOf(device.caps().visibility)),
          geometry(device),
          executor(device),
          white(passes::makeWhiteTexture(device, executor)) {
        stats.device = infoOf(device.caps());
    }

    /// One target of the frame, how it is written, and where the host finds it afterwards.
    struct Target {
        const char* pass;
        const char* image;
        VkFormat format;
        Writes writes;
        gpu::Buffer pixels;
    };

    void draw(const RenderSettings& settings, const View& view, std::vector<Target>& targets, bool readBack = true);
    void prepareOcclusion(const RenderSettings& settings);
    layout::ViewConstants constants(const RenderSettings& settings, const View& view) const;
};

layout::ViewConstants Renderer::Impl::constants(const RenderSettings& settings, const View& view) const {
    layout::ViewConstants c =
        passes::viewConstants(view, device.caps().snapPixels, view.width / 2.0, view.height / 2.0);
    const bool occlusion = settings.occlusionDirections > 0;
    if (occlusion) c.atlas = glm::vec4(1.0 / layout.width, 1.0 / layout.height, layout.sphereEdge, layout.around);
    const auto spheres = static_cast<std::uint32_t>(representation.spheres.size());
    c.shading = glm::vec4(settings.lighting ? 1 : 0, occlusion ? 1 : 0, layout.along, std::bit_cast<float>(spheres));
    return c;
}

/// The screen frame: opaque prepass, the pass that finds what is nearest (none with `fragdepth`), and one pass for
/// every target.
void Renderer::Impl::draw(const RenderSettings& settings, const View& view, std::vector<Target>& targets,
                          bool readBack) {
    const graph::Extent extent{view.width, view.height};
    passes::FragmentCounter counter(device, settings.countFragments);
    const auto drawn = [&](Writes writes) {
        passes::Draw d{writes, nearest, view.projection == Projection::perspective, constants(settings, view)};
        d.plates = settings.plates;
        d.impostor = settings.impostor;
        d.radiusPixels = meanRadius * view.pixelsPerAngstrom;
        counter.attach(d);
        return d;
    };
    const auto geometryPass = [&](Writes writes) {
        return [this, d = drawn(writes)](graph::PassContext& c) { geometry.draw(c, scene, d); };
    };
    Graph g("screen");
    graph::Imports imports;
    const auto depth = g.image("depth", {VK_FORMAT_D32_SFLOAT, extent});
    const gpu::Image& atlasImage = settings.occlusionDirections > 0 ? bake->atlas() : white;
    const auto atlas = g.importImage("occlusion atlas", atlasImage.desc, passes::kTextureState);
    imports.bind(atlas, atlasImage);

    g.graphics("opaque prepass").depth(depth, Clear{1.0f}).record(geometryPass(Writes::plates));
    graph::Image found = depth;
    if (nearest == Nearest::encoded) {
        found = g.image("encoded depth", {device.caps().encoded.format, extent});
        const Clear farthest{device.caps().encoded.farthest};
        g.graphics("depth encoding").depthTest(depth).color(found, farthest).record(geometryPass(Writes::encoded));
    } else if (nearest == Nearest::deferred) {
        found = g.image("primitive number", {VK_FORMAT_R32_UINT, extent});
        g.graphics("nearest primitive").depth(depth).color(found, Clear{0.0f}).record(geometryPass(Writes::number));
    }
    // One target keeps the nearest depth itself; several (the layers) share one that is found before them.
    const bool ordered = nearest == Nearest::rasterOrder;
    const bool shared = ordered && targets.size() > 1;
    if (ordered) found = g.image("nearest depth", {VK_FORMAT_R32_SFLOAT, extent});
    if (shared)
        g.graphics("depth encoding")
            .depthTest(depth)
            .ordered(found, Clear{1.0f})
            .record([this, found, atlas, d = drawn(Writes::encoded)](graph::PassContext& c) {
                geometry.draw(c, scene, d, {c.view(atlas), c.view(found)});
            });
    for (Target& target : targets) {
        const graph::ImageDesc desc{target.format, extent};
        const auto image = g.image(target.image, desc);
        auto pass = g.graphics(target.pass);
        if (nearest == Nearest::fragdepth || (nearest == Nearest::encoded && geometry.settles()))
            pass.depth(depth);
        else if (nearest != Nearest::deferred)
            pass.depthTest(depth);
        if (nearest == Nearest::encoded || nearest == Nearest::deferred) pass.input(found);
        pass.samples(atlas).color(image, Clear{0.0f});
        if (ordered && !shared) pass.ordered(found, Clear{1.0f});
        if (shared) pass.samples(found);
        pass.record([this, found, atlas, shared, d = drawn(target.writes)](graph::PassContext& c) {
            geometry.draw(c, scene, d, {c.view(atlas), c.view(found), shared});
        });
        if (!readBack) {
            g.output(image);
            continue;
        }
        const std::uint64_t bytes = std::uint64_t{extent.width} * extent.height * graph::bytesPerTexel(target.format);
        target.pixels = gpu::makeBuffer(device, bytes, vk::BufferUsageFlagBits::eTransferDst, gpu::Access::readback,
                                        std::string(target.image) + " pixels");
        const auto buffer = g.importBuffer(std::string(target.image) + " pixels", bytes);
        imports.bind(buffer, target.pixels);
        passes::readBack(g, image, desc, buffer);
    }

    graph::PlanCaps caps = device.caps().plan;
    caps.merge = caps.merge && settings.merge;
    const graph::Plan plan = graph::compile(g, caps);
    planText = graph::describe(g, plan);
    const auto start = Clock::now();
    device.submitAndWait([&](const vk::raii::CommandBuffer& c) {
        executor.record(c, g, plan, imports);
        counter.finish(c);
    });
    stats.frameMilliseconds = millisecondsSince(start);
    executor.reset();
    if (settings.countFragments) stats.passes = counter.counts();
    stats.tileBytesPerPixel = 0;
    for (const graph::Step& step : plan.steps)
        stats.tileBytesPerPixel = std::max(stats.tileBytesPerPixel, step.renderPass.tileBytesPerPixel);
    stats.loadedBytes = plan.total.loaded;
    stats.storedBytes = plan.total.stored;
    stats.deviceBytes = device.peakAllocatedBytes();
}

void Renderer::Impl::prepareOcclusion(const RenderSettings& settings) {
    const int directions = settings.occlusionDirections;
    if (directions == 0 || (bake && bakedDirections == directions && bakeBudget == settings.occlusionBytes)) return;
    const auto start = Clock::now();
    bake.reset();
    layout = occlusionLayout(representation.spheres.size(), representation.cylinders.size(), settings.occlusionBytes,
                             device.caps().maxImageSize);
    assignPatches(layout, representation);
    scene = passes::makeSceneBuffers(device, representation);
    const Nearest maps = nearest == Nearest::encoded ? Nearest::encoded : Nearest::fragdepth;
    bake = std::make_unique<passes::OcclusionBake>(device, geometry, maps, scene, representation, layout, directions);
    while (bake->step(executor))
        if (settings.onBakeProgress) settings.onBakeProgress(static_cast<double>(bake->directionsDone()) / directions);
    bake->finish(executor);
    executor.forget("occlusion");
    bakedDirections = directions;
    bakeBudget = settings.occlusionBytes;
    stats.bakeMilliseconds = millisecondsSince(start);
    stats.occlusionDirections = directions;
    stats.patchTexels = layout.sphereEdge;
}

Renderer::Renderer(const DeviceOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

void Renderer::setScene(Representation representation) {
    impl_->bake.reset();
    impl_->representation = std::move(representation);
    impl_->scene = passes::makeSceneBuffers(impl_->device, impl_->representation);
    double sum = 0;
    for (const Sphere& s : impl_->representation.spheres) sum += s.radius;
    impl_->meanRadius = sum / static_cast<double>(std::max<std::size_t>(impl_->representation.spheres.size(), 1));
    impl_->stats.spheres = impl_->representation.spheres.size();
    impl_->stats.cylinders = impl_->representation.cylinders.size();
}

Picture Renderer::render(const RenderSettings& settings) {
    const std::uint32_t n = std::max(settings.supersample, 1u);
    View view = settings.view;
    view.width *= n;
    view.height *= n;
    view.pixelsPerAngstrom *= n;
    if (std::max(view.width, view.height) > maxSize())
        throw Error("picture too large", std::to_string(view.width) + "x" + std::to_string(view.height),
                    "this device draws at most " + std::to_string(maxSize()) + " pixels a side, supersampling counted");
    impl_->prepareOcclusion(settings);
    std::vector<Impl::Target> targets;
    targets.push_back({"impostor colour", "colour", VK_FORMAT_R8G8B8A8_SRGB, Writes::color, {}});
    impl_->draw(settings, view, targets);
    Picture picture = resolvePicture(reinterpret_cast<const std::uint32_t*>(targets[0].pixels.mapped), view.width,
                                     view.height, n, settings.background, impl_->stats.coveredPixels);
    return picture;
}

LayerPicture Renderer::layers(const RenderSettings& settings) {
    impl_->prepareOcclusion(settings);
    std::vector<Impl::Target> targets;
    targets.push_back({"impostor colour", "colour", VK_FORMAT_R32G32B32A32_SFLOAT, Writes::color, {}});
    targets.push_back({"surface layer", "surface", VK_FORMAT_R32G32B32A32_SFLOAT, Writes::surface, {}});
    targets.push_back({"identity layer", "identity", VK_FORMAT_R32G32_UINT, Writes::identity, {}});
    impl_->draw(settings, settings.view, targets);
    return assembleLayers(settings.view.width, settings.view.height,
                          reinterpret_cast<const float*>(targets[0].pixels.mapped),
                          reinterpret_cast<const float*>(targets[1].pixels.mapped),
                          reinterpret_cast<const std::uint32_t*>(targets[2].pixels.mapped), settings.background,
                          impl_->stats.coveredPixels);
}

double Renderer::drawFrame(const RenderSettings& settings) {
    impl_->prepareOcclusion(settings);
    const auto start = Clock::now();
    std::vector<Impl::Target> targets;
    targets.push_back({"impostor colour", "colour", VK_FORMAT_R8G8B8A8_SRGB, Writes::color, {}});
    impl_->draw(settings, settings.view, targets, false);
    return millisecondsSince(start);
}

const FrameStats& Renderer::stats() const { return impl_->stats; }
const std::string& Renderer::planText() const { return impl_->planText; }
const std::vector<std::string>& Renderer::validationMessages() const { return impl_->device.validationMessages(); }
std::uint32_t Renderer::maxSize() const { return impl_->device.caps().maxImageSize; }

std::vector<DeviceInfo> listDevices() {
    const vk::raii::Context context;
    gpu::InstanceExtensions found;
    const vk::raii::Instance instance = gpu::makeInstance(context, false, found);
    std::vector<DeviceInfo> devices;
    for (const auto& physical : vk::raii::PhysicalDevices(instance)) devices.push_back(infoOf(gpu::capsOf(physical)));
    return devices;
}

}  // namespace nacre
