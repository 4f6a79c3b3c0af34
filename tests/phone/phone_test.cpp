// Everything that the renderer does, on the least phone and on the least iPhone (tests/phone_layer), under validation:
// a message is a limit, a format or a feature that they lack.

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "engine/devices.h"
#include "engine/error.h"
#include "engine/gpu/execute.h"
#include "engine/gpu/pipeline.h"
#include "engine/gpu/resources.h"
#include "engine/scene/build/representation.h"
#include "tests/phone_layer/floor.h"
#include "tests/renderer/scenes.h"
#include "tests/support/error_text.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {
namespace {

bool onMoltenVk() { return std::string_view(std::getenv("NACRE_PHONE")) == "moltenvk"; }
bool onMali() { return std::string_view(std::getenv("NACRE_PHONE")) == "mali"; }

constexpr Visibility kPaths[] = {Visibility::encoded, Visibility::fragdepth, Visibility::deferred, Visibility::tiles};

TEST(Phone, IsTakenForWhatItSaysItIs) {
    ValidatedRenderer renderer(Visibility::automatic, ValidatedRenderer::fresh);
    const DeviceInfo& device = renderer->stats().device;
    EXPECT_EQ(device.name, onMoltenVk()                                               ? "the least iPhone"
                           : std::string_view(std::getenv("NACRE_PHONE")) == "adreno" ? "Adreno (TM) 660"
                                                                                      : "the least phone");
    EXPECT_EQ(device.type, "integrated");
    EXPECT_EQ(device.apiVersion, "1.1.106");
    EXPECT_EQ(device.visibility, onMoltenVk() ? "fragdepth" : onMali() ? "raster-order" : "encoded");
    EXPECT_EQ(device.encodedFormat, onMoltenVk() ? "R32F" : onMali() ? "R32F in raster order" : "RGBA16F");
    EXPECT_EQ(device.rasterOrder, onMali());
    EXPECT_TRUE(device.lazyMemory);
    EXPECT_TRUE(device.timestamps);
    EXPECT_FALSE(device.localRead);
    EXPECT_EQ(renderer->maxSize(), 4096u);
}

TEST(PhoneProfile, IsSeenByTheProgram) {
    const phone::Profile* profile = phone::profile();
    if (!profile) GTEST_SKIP() << "no profile";
    ValidatedRenderer renderer(Visibility::automatic, ValidatedRenderer::fresh);
    const DeviceInfo& device = renderer->stats().device;
    const auto limit =
        std::ranges::find_if(device.limits, [](const auto& l) { return l.first == "max_image_dimension_2d"; });
    ASSERT_NE(limit, device.limits.end());
    std::uint32_t asked = 4096;
    for (const phone::Profile* p = profile; p; p = p->base)
        for (const phone::ProfileLimit& l : p->limits)
            if (l.limit == &VkPhysicalDeviceLimits::maxImageDimension2D) asked = std::max(asked, l.least);
    EXPECT_EQ(limit->second, asked);
    EXPECT_EQ(renderer->maxSize(), asked);
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    renderer->setScene(r);
    const Picture first = renderer->render(settings(r, 64, Projection::orthographic));
    EXPECT_GT(std::ranges::count_if(first.rgba, [](float v) { return v > 0; }), 1000);
}

TEST(Phone, WhatIsTooMuchForItIsTold) {
    // Without this, silence in the other tests would prove nothing.
    Renderer renderer(DeviceOptions{.validate = true});
    const Representation r = scene("sample:glucose", Style::spacefill);
    renderer.setScene(r);
    EXPECT_THROW(renderer.render(settings(r, 4097, Projection::orthographic)), Error);
    if (!onMali()) {
        EXPECT_THROW(Renderer(DeviceOptions{true, "", Visibility::rasterOrder}), Error);
    }
    if (!onMoltenVk() && !onMali()) {
        EXPECT_THROW(Renderer(DeviceOptions{true, "", Visibility::encoded, EncodedDepth::r32f}), Error);
    }
    EXPECT_TRUE(renderer.validationMessages().empty());
}

// And an image that asks for none: compression of a fixed rate loses detail (VK_EXT_image_compression_control).
TEST(Phone, IsTakenForItsFixedRates) {
    const auto formats = [] { return Renderer(DeviceOptions{}).stats().device.formats; };
    const auto compressed = [](const std::vector<std::string>& list) {
        return std::ranges::count_if(
            list, [](const std::string& f) { return f.ends_with(", compressed to 2, 5 bits per channel on demand"); });
    };
    EXPECT_EQ(compressed(formats()), 0);
    setenv("NACRE_PHONE_RATES", "1", 1);
    const std::vector<std::string> told = formats();
    unsetenv("NACRE_PHONE_RATES");
    EXPECT_EQ(compressed(told), 2);
    EXPECT_NE(told.front().find("R8"), std::string::npos) << told.front();
    EXPECT_TRUE(told.front().ends_with("on demand")) << told.front();
}

TEST(Phone, AMeshThatItsShadersCannotReadIsRefused) {
    Renderer renderer(DeviceOptions{.validate = true});
    const Representation small = scene("sample:glucose", Style::spacefill);
    const RenderSettings s = settings(small, 32, Projection::orthographic);
    renderer.setScene(small);
    const std::vector<float> before = renderer.render(s).rgba;
    Representation large = small;
    large.triangles.push_back({0, 1, 2, 1});
    large.meshLooks.push_back({0xffffffffu, 1});
    large.meshVertices.resize((std::size_t{1} << 27) / sizeof(MeshVertex));
    expectThrows([&] { renderer.setScene(std::move(large)); }, "take 129 MB, and its shaders read 128 MB");
    EXPECT_TRUE(renderer.render(s).rgba == before);  // the scene before stays
    EXPECT_TRUE(renderer.validationMessages().empty());
}

TEST(Phone, TheValidationLayerKnowsItsLimits) {
    // And without this.
    const gpu::Device device(DeviceOptions{.validate = true});
    gpu::makeLayout(device, {"more than 128 bytes", {}, vk::ShaderStageFlagBits::eVertex, 132});
    ASSERT_EQ(device.validationMessages().size(), 1u);
    EXPECT_NE(device.validationMessages()[0].find("VUID-VkPushConstantRange-size-00298"), std::string::npos);
}

TEST(Phone, TheValidationLayerSeesThePhoneAndNotItsDriver) {
    // And without this: lavapipe has eight sets, and no portability subset.
    const gpu::Device device(DeviceOptions{.validate = true});
    const vk::raii::DescriptorSetLayout empty(*device, vk::DescriptorSetLayoutCreateInfo());
    const std::vector<vk::DescriptorSetLayout> five(5, *empty);
    const vk::raii::PipelineLayout layout(*device, vk::PipelineLayoutCreateInfo({}, five));
    ASSERT_EQ(device.validationMessages().size(), 1u);
    EXPECT_NE(device.validationMessages()[0].find("setLayoutCount-00286"), std::string::npos);
    if (!onMoltenVk()) return;
    // What the subset leaves out is off, whatever the device has, since nobody asks for it.
    vk::SamplerCreateInfo sampler;
    sampler.mipLodBias = 0.5f;
    const vk::raii::Sampler biased(*device, sampler);
    ASSERT_EQ(device.validationMessages().size(), 2u);
    EXPECT_NE(device.validationMessages()[1].find("samplerMipLodBias-04467"), std::string::npos);
}

TEST(Phone, DrawsEveryPathAndStyleAlike) {
    for (const Style style : {Style::spacefill, Style::ballAndStick})
        for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
            const Representation r = scene("sample:glucose", style);
            std::vector<std::uint32_t> ids;
            for (const Visibility path : kPaths) {
                ValidatedRenderer renderer(path, r);
                RenderSettings s = settings(r, 96, projection);
                s.occlusion.directions = 4;
                s.supersample = 2;
                renderer->render(s);
                const LayerPicture layers = renderer->layers(s);
                if (ids.empty()) ids = layers.id;
                EXPECT_TRUE(std::any_of(ids.begin(), ids.end(), [](std::uint32_t id) { return id > 0; }));
                EXPECT_EQ(layers.id, ids);
                EXPECT_EQ(renderer->atomAt(s, 48.5, 48.5, 0), ids[48 * 96 + 48]);
                // Nothing leaves the tile and comes back, on the path that the phone takes.
                if (path != Visibility::tiles && (!onMoltenVk() || path == Visibility::fragdepth)) {
                    EXPECT_EQ(renderer->stats().loadedBytes, 0u);
                }
                s.tuning.merge = false;
                renderer->render(s);
            }
        }
}

// What the host reads it caches, and must invalidate; the layer shows it nothing else, and aborts where no barrier made
// what the device wrote available to it.
TEST(Phone, TheHostReadsFromMemoryThatItCaches) {
    const gpu::Device device(DeviceOptions{.validate = true});
    constexpr auto kUsage = vk::BufferUsageFlagBits::eTransferDst;
    const gpu::Buffer read = gpu::makeBuffer(device, 256, kUsage, gpu::Access::readback, "read by the host");
    const gpu::Buffer written = gpu::makeBuffer(device, 256, kUsage, gpu::Access::upload, "written by the host");
    EXPECT_FALSE(read.coherent);
    EXPECT_TRUE(written.coherent);
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        commands.fillBuffer(*read.handle, 0, 256, 0x01010101);
        const vk::BufferMemoryBarrier barrier(vk::AccessFlagBits::eTransferWrite, vk::AccessFlagBits::eHostRead,
                                              VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *read.handle, 0,
                                              VK_WHOLE_SIZE);
        commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eHost, {}, {},
                                 barrier, {});
    });
    EXPECT_EQ(read.mapped[0], std::byte{0});  // without this the other tests would prove nothing
    read.invalidate();
    EXPECT_EQ(read.mapped[255], std::byte{1});
    EXPECT_TRUE(device.validationMessages().empty());
}

/// A phone whose tile is too small for anything, for as long as this lives.
struct SmallTile {
    SmallTile() { setenv("NACRE_PHONE_TILE", "small", 1); }
    ~SmallTile() { unsetenv("NACRE_PHONE_TILE"); }
};

DriverFeedback readFeedback(Visibility path) {
    ValidatedRenderer renderer(path, ValidatedRenderer::fresh);
    const Representation r = scene("sample:glucose", Style::spacefill);
    renderer->setScene(r);
    renderer->render(settings(r, 64, Projection::orthographic));
    return renderer->driverFeedback();
}

// The driver says what became of the plan: how many subpasses it merged, and what it had to give the tile's images.
TEST(Phone, TheDriverTellsWhatLeftTheTile) {
    const DriverFeedback large = readFeedback(onMoltenVk() ? Visibility::fragdepth : Visibility::encoded);
    ASSERT_FALSE(large.transients.empty());
    for (const TransientImage& image : large.transients) {
        EXPECT_GE(image.bytes, 64u * 64 * 4) << image.name;
        EXPECT_EQ(image.committedBytes, 0u) << image.name;
    }
    if (onMoltenVk()) {
        EXPECT_TRUE(large.merges.empty());  // it tells nothing of merging
        return;
    }
    ASSERT_EQ(large.merges.size(), 1u);
    EXPECT_EQ(large.merges[0].name, "opaque prepass + depth encoding + impostor colour");
    EXPECT_EQ(large.merges[0].planned, 3u);
    EXPECT_EQ(large.merges[0].carried, 1u);
    EXPECT_EQ(large.merges[0].why, "");
    EXPECT_NE(describe(large).find("3 subpasses as 1\n"), std::string::npos) << describe(large);
    EXPECT_NE(describe(large).find(": 0.0 of "), std::string::npos) << describe(large);

    const SmallTile tile;
    const DriverFeedback small = readFeedback(Visibility::encoded);
    ASSERT_EQ(small.merges.size(), 1u);
    EXPECT_EQ(small.merges[0].carried, 3u);
    EXPECT_NE(small.merges[0].why.find("the tile is full"), std::string::npos) << small.merges[0].why;
    ASSERT_EQ(small.transients.size(), large.transients.size());
    for (const TransientImage& image : small.transients) EXPECT_EQ(image.committedBytes, image.bytes) << image.name;
}

// Times are the device's own, or nobody tells any: a queue without a clock is asked for none, and bakes all the same.
TEST(Phone, TellsTimesWhereItsQueueHasAClock) {
    for (const bool clock : {true, false}) {
        if (!clock) setenv("NACRE_PHONE_NO_CLOCK", "1", 1);
        ValidatedRenderer renderer(Visibility::automatic, ValidatedRenderer::fresh);
        const Representation r = scene("sample:glucose", Style::spacefill);
        renderer->setScene(r);
        RenderSettings s = settings(r, 48, Projection::orthographic);
        s.supersample = 1;
        s.occlusion.directions = 20;
        s.tuning.timePasses = true;
        renderer->render(s);
        EXPECT_EQ(renderer->stats().device.timestamps, clock);
        EXPECT_EQ(renderer->stats().passTimes.empty(), !clock);
        EXPECT_EQ(renderer->stats().occlusion.done, 20);
    }
    unsetenv("NACRE_PHONE_NO_CLOCK");
}

/// Programs that start while this lives go without the validation layer here, which is older than local reads: under it
/// nobody asks for them. What the phone draws and loses is told.
class Unvalidated {
public:
    Unvalidated() {
        setenv("VK_INSTANCE_LAYERS", "VK_LAYER_NACRE_phone", 1);
        setenv("NACRE_PHONE_DRAWS", file_.c_str(), 1);
    }
    ~Unvalidated() {
        setenv("VK_INSTANCE_LAYERS", layers_.c_str(), 1);
        unsetenv("NACRE_PHONE_DRAWS");
    }
    /// How often an attachment was lost with its encoder.
    int losses() const {
        std::ifstream lines(file_);
        int count = 0;
        for (std::string line; std::getline(lines, line);) count += line == "noise";
        return count;
    }

private:
    const std::string layers_ = std::getenv("VK_INSTANCE_LAYERS");
    const TemporaryFolder folder_;
    const std::string file_ = folder_ / "draws";
};

TEST(Phone, LosesNothingWithAnEncoder) {
    for (const Style style : {Style::spacefill, Style::ballAndStick})
        for (const Visibility path : kPaths) {
            const Representation r = scene("sample:glucose", style);
            const RenderSettings s = settings(r, 96, Projection::orthographic);
            ValidatedRenderer validated(path, r);
            const std::vector<float> expected = validated->render(s).rgba;
            const Unvalidated phone;
            Renderer renderer(DeviceOptions{.visibility = path});
            renderer.setScene(r);
            EXPECT_TRUE(renderer.render(s).rgba == expected) << visibilityName(path);
            EXPECT_EQ(phone.losses(), 0) << visibilityName(path);
        }
}

TEST(Phone, AnEncoderOfMoltenVkTakesWhatIsTransientWithIt) {
    // Without this, the test before it would prove nothing.
    const Unvalidated phone;
    const gpu::Device device{DeviceOptions()};
    EXPECT_EQ(gpu::hasExtension(device.physical(), VK_KHR_DYNAMIC_RENDERING_LOCAL_READ_EXTENSION_NAME), onMoltenVk());
    EXPECT_FALSE(device.caps().plan.storeNone);  // MoltenVK has it, and stores
    graph::Graph g("two subpasses");
    auto depth = g.image("depth", {VK_FORMAT_D32_SFLOAT, {16, 16}});
    auto first = g.image("first", {VK_FORMAT_R8G8B8A8_UNORM, {16, 16}});
    auto second = g.image("second", {VK_FORMAT_R8G8B8A8_UNORM, {16, 16}});
    g.graphics("first").depth(depth, graph::Clear{1.0f}).color(first, graph::Clear{0.0f});
    g.graphics("second").depthTest(depth).input(first).color(second, graph::Clear{0.0f});
    g.output(second);
    graph::PlanCaps caps = device.caps().plan;
    caps.tileSubpasses = true;
    const graph::Plan plan = graph::compile(g, caps);
    ASSERT_EQ(plan.steps.size(), 1u);
    gpu::Executor executor(device);
    executor.run(g, plan, {});
    EXPECT_EQ(phone.losses(), onMoltenVk() ? 1 : 0);
}

// Tools that record frames are told where one ends that nobody presents. The validation layer here is older than the
// extension, and would hand nothing of it on.
TEST(Phone, WhatEndsAFrameSaysSo) {
    const TemporaryFolder folder;
    const std::string layers = std::getenv("VK_INSTANCE_LAYERS"), frames = folder / "frames";
    setenv("VK_INSTANCE_LAYERS", "VK_LAYER_NACRE_phone", 1);
    setenv("NACRE_PHONE_FRAMES", frames.c_str(), 1);
    for (const bool validated : {false, true}) {
        if (validated) setenv("VK_INSTANCE_LAYERS", layers.c_str(), 1);
        Renderer renderer(DeviceOptions{validated, ""});
        const Representation r = scene("sample:glucose", Style::spacefill);
        renderer.setScene(r);
        RenderSettings s = settings(r, 32, Projection::orthographic);
        s.supersample = 1;
        s.occlusion.directions = 0;
        renderer.render(s);
        renderer.layers(s);
        s.occlusion.directions = 1;
        renderer.render(s);
    }
    unsetenv("NACRE_PHONE_FRAMES");
    std::ifstream told(frames);
    std::vector<std::string> ends;
    int goesOn = 0;
    for (std::string line; std::getline(told, line);)
        if (line.ends_with(" ends"))
            ends.push_back(line);
        else
            ++goesOn;
    if (onMoltenVk()) {  // it has no such extension
        EXPECT_TRUE(ends.empty());
        return;
    }
    EXPECT_EQ(ends, (std::vector<std::string>{"0 ends", "1 ends", "2 ends"}));
    EXPECT_GT(goesOn, 0);  // of the first, what it needs; of the last, its bake
}

TEST(Phone, BakesByEveryKindOfDepthMap) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const OcclusionMaps maps :
         {OcclusionMaps::automatic, OcclusionMaps::encoded, OcclusionMaps::fragdepth, OcclusionMaps::tiles})
        for (const int directions : {1, 20}) {
            ValidatedRenderer renderer(Visibility::automatic, r);
            RenderSettings s = settings(r, 64, Projection::orthographic);
            s.occlusion.directions = directions;
            s.occlusion.maps = maps;
            renderer->render(s);
            EXPECT_EQ(renderer->stats().occlusion.done, directions);
        }
}

// The layer aborts where a phone would lose its device.
TEST(Phone, DrawsNoMoreInstancesAtOnceThanPhonesTake) {
    Representation r = scene("sample:dna", Style::ballAndStick);
    const Representation once = r;
    r.spheres.insert(r.spheres.end(), once.spheres.begin(), once.spheres.end());
    r.sphereLooks.insert(r.sphereLooks.end(), once.sphereLooks.begin(), once.sphereLooks.end());
    ASSERT_GT(r.spheres.size(), 512u);
    ASSERT_GT(r.cylinders.size(), 512u);
    for (const Visibility path : kPaths) {
        ValidatedRenderer renderer(path, r);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        s.occlusion.directions = 1;
        s.occlusion.maps = path == Visibility::encoded ? OcclusionMaps::encoded : OcclusionMaps::fragdepth;
        s.tuning.impostor = path == Visibility::deferred ? ImpostorShape::octagon : ImpostorShape::pyramid;
        s.tuning.plates = PlateShape::octagon;
        renderer->render(s);
    }
}

TEST(Phone, DrawsBothEyesAtOnce) {
    setenv("NACRE_MULTIVIEW", "1", 1);  // the layer's driver is lavapipe
    { EXPECT_EQ(gpu::Device(DeviceOptions{.validate = true}).caps().plan.maxViews, 6u); }
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const Visibility path : kPaths) {
        ValidatedRenderer renderer(path, r, ValidatedRenderer::fresh);
        RenderSettings s = settings(r, 64, Projection::perspective);
        s.occlusion.directions = 2;
        s.supersample = 1;
        const View left = fromAside(s.view, -1, s.view.eyeDistance), right = fromAside(s.view, 1, s.view.eyeDistance);
        s.view = paired(left, right);
        const std::array<Picture, 2> both = renderer->renderEyes(s);
        const std::vector<Decision> decisions = renderer->decisions();
        // Each eye has its own lists of tiles.
        EXPECT_EQ(std::ranges::any_of(decisions, [](const Decision& d) { return d.how == "both eyes in one frame"; }),
                  path != Visibility::tiles)
            << visibilityName(path);
        for (std::size_t i = 0; i < 2; ++i) {
            s.view = i == 0 ? left : right;
            EXPECT_EQ(both[i].rgba, renderer->render(s).rgba) << visibilityName(path) << ", eye " << i;
        }
    }
    unsetenv("NACRE_MULTIVIEW");
}

TEST(Phone, ShowsEveryDebugViewAndRungOfEncodedDepth) {
    const Representation r = scene("sample:glucose", Style::spacefill);
    for (const EncodedDepth rung :
         {EncodedDepth::rgba16f, EncodedDepth::rg16f, EncodedDepth::a2b10g10r10, EncodedDepth::rgba8}) {
        Renderer renderer(DeviceOptions{true, "", Visibility::encoded, rung});
        renderer.setScene(r);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        s.occlusion.directions = 2;
        const std::size_t views = rung == EncodedDepth::rgba16f ? debugViewNames().size() : 1;
        for (std::size_t view = 0; view < views; ++view) {
            s.debug = static_cast<DebugView>(view);
            renderer.render(s);
        }
        for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
    }
}

TEST(Phone, DrawsEveryKindOfPlateAndOutline) {
    Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const Visibility path : kPaths) {
        ValidatedRenderer renderer(path, r);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        for (const PlateShape plates : {PlateShape::none, PlateShape::octagon, PlateShape::dome3})
            for (const ImpostorShape impostor :
                 {ImpostorShape::square, ImpostorShape::octagon, ImpostorShape::pyramid}) {
                s.tuning.plates = plates;
                s.tuning.impostor = impostor;
                EXPECT_GT(renderer->render(s).rgba.size(), 0u);
            }
    }
}

}  // namespace
}  // namespace nacre::test
