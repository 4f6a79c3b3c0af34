// How vertex outputs fit the limit of a render pass: what each class of device chooses for scenes of each size, and
// that no render pass of any plan goes beyond the limit.

#include <gtest/gtest.h>

#include <random>

#include "engine/frame/geometry.h"
#include "engine/graph/capability_sets.h"

namespace nacre::test {
namespace {

constexpr std::uint64_t kMali = 150'000'000;

RenderSettings phoneSettings() {
    RenderSettings settings;
    settings.view.width = 1170, settings.view.height = 2532;
    settings.view.radius = 200;
    settings.supersample = 1;
    return settings;
}

std::string describeFit(const RenderSettings& settings, const SceneFacts& facts, const graph::FrameCaps& caps) {
    for (const Decision& d : explain({settings, Part::motion, Ending::window}, facts, caps))
        if (d.what == "vertex outputs") return d.how + ": " + d.why;
    return "as they are";
}

struct Scene {
    std::uint64_t spheres = 0, triangles = 0;
    double radius = 2;
};

std::string describeFit(const char* set, Visibility path, const Scene& scene) {
    graph::FrameCaps caps = graph::capabilitySet(set);
    caps.visibility = path;
    SceneFacts facts;
    facts.spheres = scene.spheres, facts.triangles = scene.triangles, facts.radiusPixels = scene.radius;
    return describeFit(phoneSettings(), facts, caps);
}

TEST(VertexLimitOfClasses, IsKeptByMaliWithTheFewestRenderPasses) {
    using V = Visibility;
    const Scene small{700'000}, surface{0, 2'388'000}, capsid{1'030'000}, huge{4'000'000}, close{800'000, 0, 12};
    EXPECT_EQ(describeFit("mali", V::automatic, small), "as they are");
    EXPECT_EQ(describeFit("mali", V::automatic, surface),
              "1 render pass without plates: they would be 258 MB, and a render pass gets at most 150 MB");
    EXPECT_EQ(describeFit("mali", V::encoded, surface),
              "2 render passes without plates: they would be 401 MB, and a render pass gets at most 150 MB");
    EXPECT_EQ(describeFit("mali", V::automatic, capsid),
              "1 render pass without plates: they would be 198 MB, and a render pass gets at most 150 MB");
    EXPECT_EQ(describeFit("mali-old", V::encoded, capsid),
              "2 render passes without plates: they would be 330 MB, and a render pass gets at most 150 MB");
    EXPECT_EQ(describeFit("mali", V::rasterOrder, huge),
              "4 render passes without plates: they would be 768 MB, and a render pass gets at most 150 MB");
    EXPECT_EQ(describeFit("mali", V::fragdepth, huge),
              "4 render passes without plates: they would be 768 MB, and a render pass gets at most 150 MB");
    // Octagons as plates are more than squares.
    EXPECT_EQ(describeFit("mali", V::automatic, {780'000, 0, 12}),
              "1 render pass of squares: they would be 200 MB, and a render pass gets at most 150 MB");
    EXPECT_EQ(describeFit("mali", V::automatic, close).find("1 render pass without plates"), 0u);
}

TEST(VertexLimitOfClasses, IsNoneElsewhere) {
    std::size_t limited = 0;
    for (const graph::CapabilitySet& set : graph::capabilitySets()) {
        const bool mali = set.plan.name == "mali" || set.plan.name == "mali-old";
        EXPECT_EQ(set.plan.geometry.mostVertexBytes, mali ? kMali : 0) << set.plan.name;
        EXPECT_EQ(describeFit(set.plan.name.c_str(), choosePath(set).visibility, {4'000'000}) != "as they are", mali);
        limited += mali;
    }
    EXPECT_EQ(limited, 2u);
}

/// Scenes whose vertex outputs would take several render passes are drawn by compute, which has none; on every device
/// with the limit, unless another path is asked for or the device's self-test found that compute draws wrongly.
TEST(VertexLimitOfClasses, LeavesWhatTakesSeveralRenderPassesToCompute) {
    using V = Visibility;
    struct Row {
        const char* set;
        Scene scene;
        V path;
    };
    const Scene small{700'000}, surface{0, 2'388'000}, capsid{1'030'000}, huge{4'000'000};
    const Row rows[] = {
        {"mali", small, V::rasterOrder}, {"mali", surface, V::rasterOrder},   {"mali", capsid, V::rasterOrder},
        {"mali", huge, V::tiles},        {"mali-old", {400'000}, V::encoded}, {"mali-old", small, V::tiles},
        {"mali-old", surface, V::tiles}, {"mali-old", huge, V::tiles},        {"mali-late", huge, V::rasterOrder},
        {"powervr", huge, V::encoded},   {"adreno", huge, V::encoded},        {"apple-moltenvk", huge, V::fragdepth},
        {"desktop", huge, V::fragdepth}};
    for (const auto& [set, scene, path] : rows) {
        SCOPED_TRACE(std::string(set) + ", " + std::to_string(scene.spheres + scene.triangles));
        SceneFacts facts;
        facts.spheres = scene.spheres, facts.triangles = scene.triangles, facts.radiusPixels = scene.radius;
        RenderSettings settings = phoneSettings();
        graph::FrameCaps caps = graph::capabilitySet(set);
        const auto drawn = [&](Part part = Part::motion) {
            return choose({settings, part, part == Part::motion ? Ending::window : Ending::readBack}, facts, caps);
        };
        for (const Part part : {Part::motion, Part::whole, Part::pick}) {
            const FrameChoice choice = drawn(part);
            if (part != Part::pick) {
                EXPECT_EQ(choice.path, path);
            }
            if (choice.path != V::tiles) continue;
            EXPECT_EQ(choice.geometry, Geometry::deviceLists);
            EXPECT_EQ(choice.shading, Shading::image);
            EXPECT_EQ(choice.vertices, VertexOutputs());
            EXPECT_TRUE(choice.readsCopyRows());
            // Where lists may be too long: the usual path, in several render passes.
            const FrameChoice other = choice.within(choice.overflow.longestList + 1);
            EXPECT_EQ(other.path, choosePath(caps).visibility);
            EXPECT_EQ(other.shading, Shading::fragments);
            EXPECT_NE(other.vertices, VertexOutputs());
        }
        if (path != V::tiles) continue;
        caps.tested = {V::encoded, "the fastest here"};
        EXPECT_EQ(drawn().path, V::tiles);
        caps.tested.tilesFail = true;
        EXPECT_EQ(drawn().path, V::encoded);
        caps.tested = {};
        caps.visibility = V::encoded;
        EXPECT_EQ(drawn().path, V::encoded);
        caps.visibility = V::automatic;
        settings.effects.halos.width = 2;
        EXPECT_EQ(drawn().path, V::deferred);
        settings.effects.halos.width = 0;
        if (scene.spheres < huge.spheres) continue;
        // Frames in motion with several samples per pixel have one by compute, unless several are asked for.
        caps.plan.rasterOrder = graph::RasterOrder::none;
        caps.tested = {V::fragdepth, "the fastest here"};
        EXPECT_EQ(drawn().path, V::tiles);
        EXPECT_EQ(drawn().samples, Samples());
        caps.multisampling = Multisampling::four;
        EXPECT_EQ(drawn().path, V::fragdepth);
        EXPECT_EQ(drawn().samples.count, 4u);
    }
}

/// The largest render pass of a frame's plan, bytes of vertex outputs.
std::uint64_t findLargest(const FrameRequest& request, const SceneFacts& facts, const graph::FrameCaps& caps) {
    FrameShape shape;
    shape.choice = choose(request, facts, caps);
    shape.choice.ending = Ending::left;
    shape.extent = {64, 64};
    shape.targets = screenTargets(shape.choice);
    Frame frame = declareFrame(shape);
    for (const graph::Image target : frame.targets) frame.graph.output(target);
    const graph::Plan plan = graph::compile(frame.graph, caps.plan);
    SceneCounts counts;
    static_cast<passes::PrimitiveCounts&>(counts) = facts;
    counts.light = facts.light;
    const VertexOutputs& vertices = shape.choice.vertices;
    const std::vector<PassGeometry> passes =
        describeGeometry(frame.graph, counts, caps.plan.geometry, vertices.plates, vertices.impostor);
    std::uint64_t largest = 0, drawn = 0;
    for (const std::uint64_t bytes : countVertexBytes(plan, passes)) largest = std::max(largest, bytes), drawn += bytes;
    // Nothing is left out, and nothing drawn twice.
    FrameShape whole = shape;
    whole.choice.vertices = {};
    whole.choice.vertices.plates = vertices.plates;
    whole.choice.vertices.impostor = vertices.impostor;
    const Frame once = declareFrame(whole);
    EXPECT_EQ(drawn,
              sumGeometry(describeGeometry(once.graph, counts, caps.plan.geometry, vertices.plates, vertices.impostor))
                  .varyingBytes);
    return largest;
}

TEST(VertexLimitOfPlans, IsNeverExceeded) {
    std::mt19937 random(7);
    const auto some = [&](std::uint64_t most) { return random() % 3 == 0 ? 0 : random() % most; };
    std::size_t split = 0;
    for (int i = 0; i < 3000; ++i) {
        SceneFacts facts;
        facts.spheres = some(3'000'000), facts.cylinders = some(2'000'000), facts.triangles = some(4'000'000);
        facts.radiusPixels = 1 + static_cast<double>(random() % 30);
        if (random() % 4 == 0) facts.hasTranslucent = true, facts.layers.triangles = some(4'000'000);
        RenderSettings settings = phoneSettings();
        if (random() % 4 == 0) {
            settings.effects.shadow.strength = 0.5;
            facts.light = {some(4'000'000), some(2'000'000), some(4'000'000), 3};
        }
        if (random() % 4 == 0) settings.effects.halos.width = 2;
        if (random() % 4 == 0) settings.view.projection = Projection::perspective, facts.flat = true;
        constexpr Part kPartsOfFrames[] = {Part::whole, Part::layers, Part::solid, Part::pick, Part::motion};
        constexpr Visibility kPaths[] = {Visibility::automatic, Visibility::encoded, Visibility::fragdepth,
                                         Visibility::deferred, Visibility::rasterOrder};
        graph::FrameCaps caps = graph::capabilitySet(random() % 3 == 0 ? "mali-old" : "mali");
        caps.plan.rasterOrder = graph::RasterOrder::promised;
        caps.blendsFloats = true;
        caps.visibility = kPaths[random() % 5];
        const Part part = kPartsOfFrames[random() % 5];
        const FrameRequest request{settings, part, part == Part::motion ? Ending::window : Ending::readBack};
        EXPECT_LE(findLargest(request, facts, caps), kMali)
            << i << ": " << visibilityName(caps.visibility) << ", part " << static_cast<int>(part) << ", "
            << facts.spheres << " spheres, " << facts.cylinders << " cylinders, " << facts.triangles << " triangles";
        const VertexOutputs& v = choose(request, facts, caps).vertices;
        split += v.shading.count > 1 || v.nearest.count > 1 || v.plating.count > 1;
    }
    EXPECT_GT(split, 500u);
}

TEST(VertexLimitOfPlans, OfADrawIsEvenlyShared) {
    const std::array<std::uint64_t, 3> all{100, 10, 37};
    graph::Share share{.bytes = {128, 368, 60}};
    for (const std::uint32_t count : {1u, 2u, 3u, 7u, 50u}) {
        share.count = count;
        std::array<std::uint64_t, 3> next{};
        const std::uint64_t total = 100 * 128 + 10 * 368 + 37 * 60;
        for (share.index = 0; share.index < count; ++share.index) {
            std::uint64_t bytes = 0;
            for (std::size_t kind = 0; kind < 3; ++kind) {
                const auto [first, end] = share.range(kind, all);
                EXPECT_EQ(first, next[kind]);
                next[kind] = end;
                bytes += (end - first) * share.bytes[kind];
            }
            EXPECT_LE(bytes, total / count + 368);
        }
        EXPECT_EQ(next, all);
    }
}

}  // namespace
}  // namespace nacre::test
