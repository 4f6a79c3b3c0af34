// Fixed foveation: maps of fragment densities, the frames that are drawn by them, and the reasons why a frame is not.

#include "engine/frame/foveation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/graph/capability_sets.h"
#include "engine/graph/plan.h"
#include "tests/frame/shapes.h"

namespace nacre {
namespace {

constexpr graph::Extent kHeadset{1680, 1760};

/// An eye of a headset: 45 to 55 degrees to each side.
View headsetEye(bool right) {
    View view;
    view.width = kHeadset.width, view.height = kHeadset.height;
    view.projection = Projection::perspective;
    view.eyeDistance = 500;
    view.pixelsPerAngstrom = 700.0 / view.eyeDistance;
    view.pan = {(right ? -140 : 140) / view.pixelsPerAngstrom, 60 / view.pixelsPerAngstrom};
    return view;
}

std::array<EyeAxis, 2> axes() { return {findAxis(headsetEye(false)), findAxis(headsetEye(true))}; }

/// From the eye to a point of its picture, as View says where that is.
glm::dvec3 directionTo(const View& view, double x, double y) {
    const double perPixel = 1 / view.pixelsPerAngstrom;
    return glm::normalize(glm::dvec3((x - view.width / 2.0) * perPixel - view.pan.x,
                                     (view.height / 2.0 - y) * perPixel - view.pan.y, -view.eyeDistance));
}

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / 3.141592653589793;
}

TEST(Foveation, NoFragmentIsWiderThanWhatAnEyeTellsApart) {
    constexpr std::uint32_t kTexel = 32;
    const graph::ImageDesc map = densityMapFor(kHeadset, 2, kTexel);
    EXPECT_EQ(map.extent, (graph::Extent{53, 55}));
    EXPECT_EQ(map.layers, 2u);
    const std::vector<std::uint8_t> bytes = fragmentDensities(axes(), kTexel);
    ASSERT_EQ(bytes.size(), 2u * 2 * 53 * 55);
    double fragments = 0;
    for (std::uint32_t eye = 0; eye < 2; ++eye) {
        const View view = headsetEye(eye == 1);
        for (std::uint32_t y = 0; y < 55; ++y)
            for (std::uint32_t x = 0; x < 53; ++x) {
                const std::size_t at = 2 * (std::size_t{eye} * 53 * 55 + y * 53 + x);
                ASSERT_EQ(bytes[at], bytes[at + 1]);
                // By "Fragment Area Conversion": a driver takes no larger area than the reciprocal.
                const double side = std::floor(255.0 / bytes[at]);
                fragments += 1 / (side * side);
                for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
                    const glm::dvec2 p = (glm::dvec2(x, y) + corner) * double{kTexel};
                    const glm::dvec3 seen = directionTo(view, p.x, p.y);
                    const double beyond = std::max(0.0, degreesBetween(seen, {0, 0, -1}) - 15);
                    const double wide = std::max(degreesBetween(seen, directionTo(view, p.x + side, p.y)),
                                                 degreesBetween(seen, directionTo(view, p.x, p.y + side)));
                    const double told = side > 1 ? 1.0 / 48 + 1.32 / 60 * beyond : wide;
                    ASSERT_LE(wide, 1.01 * told) << x << ' ' << y;
                }
            }
    }
    EXPECT_NEAR(fragments / (2 * 53 * 55), 0.156, 0.005);  // docs/platforms.md
    // Where the eyes look, each pixel has its fragment: 15 degrees are 188 of 700 pixels per tangent.
    for (const EyeAxis& eye : axes())
        for (const double away : {0.0, 180.0}) {
            const auto column = static_cast<std::size_t>((eye.place.x + away) / kTexel);
            const auto row = static_cast<std::size_t>(eye.place.y / kTexel);
            EXPECT_EQ(fragmentDensities({&eye, 1}, kTexel)[2 * (row * 53 + column)], 255);
        }
}

TEST(Foveation, AMovingHeadKeepsItsMap) {
    View nearer = headsetEye(false);
    nearer.pan *= 0.5;
    nearer.eyeDistance *= 0.5, nearer.pixelsPerAngstrom *= 2;
    EXPECT_TRUE(alike(findAxis(nearer), findAxis(headsetEye(false))));
    EXPECT_FALSE(alike(findAxis(headsetEye(true)), findAxis(headsetEye(false))));
}

FrameShape foveated(Visibility path) {
    FrameShape shape = test::makeShape(path, kHeadset);
    shape.choice.views = 2;
    shape.choice.foveated = true;
    shape.density = densityMapFor(kHeadset, 2, 32);
    return shape;
}

TEST(Foveation, AMapIsLoadedAndNothingElseChanges) {
    const graph::PlanCaps& caps = graph::capabilitySet("turnip").plan;
    for (const Visibility path : {Visibility::encoded, Visibility::fragdepth, Visibility::deferred}) {
        SCOPED_TRACE(visibilityName(path));
        FrameShape shape = foveated(path);
        const Frame frame = test::makeFrame(shape);
        const graph::Plan plan = graph::compile(frame.graph, caps);
        ASSERT_EQ(plan.steps.size(), 1u);
        const graph::RenderPassPlan& pass = plan.steps[0].renderPass;
        ASSERT_GE(pass.density, 0);
        const graph::Attachment& map = pass.attachments[static_cast<std::size_t>(pass.density)];
        EXPECT_EQ(map.image, frame.density->index);
        EXPECT_EQ(map.format, VK_FORMAT_R8G8_UNORM);
        // VUID-VkRenderPassFragmentDensityMapCreateInfoEXT-fragmentDensityMapAttachment-02548 to 02551
        EXPECT_EQ(map.load, graph::Load::load);
        EXPECT_EQ(map.store, graph::Store::dontCare);
        EXPECT_EQ(map.initialLayout, VK_IMAGE_LAYOUT_FRAGMENT_DENSITY_MAP_OPTIMAL_EXT);
        EXPECT_EQ(map.finalLayout, VK_IMAGE_LAYOUT_FRAGMENT_DENSITY_MAP_OPTIMAL_EXT);
        const auto at = static_cast<std::uint32_t>(pass.density);
        for (const graph::Subpass& s : pass.subpasses) {
            for (const auto* list : {&s.colors, &s.inputs, &s.preserve})
                EXPECT_EQ(std::count(list->begin(), list->end(), at), 0);
            EXPECT_NE(s.depth, pass.density);
        }
        EXPECT_TRUE(plan.steps[0].before.empty());
        EXPECT_TRUE(plan.after.empty());
        shape.choice.foveated = false;
        const Frame even = test::makeFrame(shape);
        const graph::Plan plain = graph::compile(even.graph, caps);
        const graph::RenderPassPlan& evenPass = plain.steps[0].renderPass;
        EXPECT_EQ(evenPass.density, -1);
        EXPECT_EQ(pass.tileBytesPerPixel, evenPass.tileBytesPerPixel);
        EXPECT_EQ(pass.dependencies, evenPass.dependencies);
        EXPECT_EQ(plan.total.stored, plain.total.stored);
        EXPECT_EQ(plan.total.loaded, plain.total.loaded + 2 * 2 * 53 * 55);
        EXPECT_NE(describe(frame.graph, plan).find("fragment density  RG8  load  -  53x55, 2 layers, of fragments\n"),
                  std::string::npos)
            << describe(frame.graph, plan);
    }
}

class Maps : public testing::Test {
protected:
    graph::Graph g{"test"};
    graph::ImageDesc desc{VK_FORMAT_R8G8B8A8_UNORM, {64, 64}}, map{VK_FORMAT_R8G8_UNORM, {2, 2}};
    graph::Image color = g.image("colour", desc);
    graph::PlanCaps caps = graph::capabilitySet("turnip").plan;

    std::string refusal() {
        g.output(color);
        try {
            graph::compile(g, caps);
        } catch (const graph::GraphError& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(Maps, TheHostReadsThemBeforeTheGraphExecutes) {
    graph::Image made = g.image("map", map);
    g.graphics("make").color(made, graph::Clear{1.0f});
    g.graphics("draw").density(made).color(color, graph::Clear{0.0f});
    EXPECT_NE(refusal().find("a density map is imported, with contents"), std::string::npos) << refusal();
}

TEST_F(Maps, HaveTheSizeThatTheDeviceAsksFor) {
    map.extent = {3, 2};
    const graph::Image wide = g.importImage("map", map, kDensityState);
    g.graphics("draw").density(wide).color(color, graph::Clear{0.0f});
    EXPECT_NE(refusal().find("a map of 3x2 for 64x64"), std::string::npos) << refusal();
}

TEST_F(Maps, AreRefusedWhereADeviceTakesNone) {
    caps = graph::capabilitySet("mali").plan;
    const graph::Image imported = g.importImage("map", map, kDensityState);
    g.graphics("draw").density(imported).color(color, graph::Clear{0.0f});
    EXPECT_NE(refusal().find("'mali' takes no density maps"), std::string::npos) << refusal();
}

TEST_F(Maps, BelongToAWholeRenderPass) {
    const graph::Image imported = g.importImage("map", map, kDensityState);
    g.graphics("draw").density(imported).color(color, graph::Clear{0.0f});
    g.graphics("go on").density(imported).color(color);
    g.graphics("every pixel").color(color);
    g.graphics("by the map").density(imported).color(color);
    g.output(color);
    const graph::Plan plan = graph::compile(g, caps);
    ASSERT_EQ(plan.steps.size(), 3u);
    EXPECT_GE(plan.steps[0].renderPass.density, 0);
    EXPECT_EQ(plan.steps[1].renderPass.density, -1);
    EXPECT_GE(plan.steps[2].renderPass.density, 0);
}

/// What is said of the foveation of a headset's frame.
Decision chooseFoveation(const graph::FrameCaps& caps, const RenderSettings& settings = {},
                         const SceneFacts& scene = {}, bool headset = true) {
    for (const Decision& decision :
         explain({settings, Part::motion, Ending::window, 0, false, true, headset}, scene, caps))
        if (decision.what == "foveation") return decision;
    return {};
}

TEST(Foveation, IsChosenForHeadsetsAloneElseTheReason) {
    graph::FrameCaps caps = graph::capabilitySet("turnip");
    RenderSettings plain{.view = headsetEye(false)};
    plain.view.other = View::OtherEye{-1, 1};
    EXPECT_EQ(chooseFoveation(caps, plain).how, "by a fragment density map");
    EXPECT_EQ(chooseFoveation(caps, plain, {}, false).how, "");
    // Paths that read an attachment say what Vulkan leaves to the driver.
    EXPECT_NE(chooseFoveation(caps, plain).why.find("each reads the depth or number of one of them"),
              std::string::npos);
    caps.visibility = Visibility::fragdepth;
    EXPECT_EQ(chooseFoveation(caps, plain).why, "fragments of several pixels where no eye looks");
    caps.visibility = Visibility::automatic;
    const auto refused = [&](auto change, const char* why) {
        graph::FrameCaps device = caps;
        RenderSettings settings = plain;
        SceneFacts scene;
        change(device, settings, scene);
        const Decision said = chooseFoveation(device, settings, scene);
        EXPECT_EQ(said.how, "a fragment per pixel") << why;
        EXPECT_NE(said.why.find(why), std::string::npos) << said.why;
    };
    refused([](auto& d, auto&, auto&) { d.plan.densityTexel = 0; }, "unknown whether the driver");
    refused([](auto&, auto& s, auto&) { s.effects.halos.width = 2; }, "outlines and halos");
    refused([](auto&, auto& s, auto&) { s.debug = DebugView::normals; }, "debug");
    refused([](auto&, auto&, auto& f) { f.hasTranslucent = true; }, "translucent");
    refused(
        [](auto& d, auto&, auto&) {
            d.visibility = Visibility::fragdepth;
            d.multisampling = Multisampling::four;
        },
        "samples");
    refused([](auto& d, auto&, auto&) { d.visibility = Visibility::tiles; }, "compute");
    // The choice is that of the frame.
    EXPECT_TRUE(choose({plain, Part::motion, Ending::window, 0, false, true, true}, {}, caps).foveated);
}

}  // namespace
}  // namespace nacre
