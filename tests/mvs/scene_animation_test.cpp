// Animations of snapshots: easings, interpolations, and the scene at a time.

#include <gtest/gtest.h>

#include <cmath>

#include "app/mvs/animation.h"
#include "tests/mvs/small_scene.h"

namespace nacre::app::mvs {
namespace {

// Right-hand sides: the formulas at easings.net, at a quarter of the time.
TEST(SceneAnimations, EasingsAreTheUsualOnes) {
    const auto at = [](const char* name, double t) { return easedByName(name, t).value(); };
    EXPECT_EQ(at("linear", 0.25), 0.25);
    EXPECT_NEAR(at("quad-in", 0.25), 0.0625, 1e-12);
    EXPECT_NEAR(at("quad-out", 0.25), 0.4375, 1e-12);
    EXPECT_NEAR(at("quad-in-out", 0.25), 0.125, 1e-12);
    EXPECT_NEAR(at("cubic-in", 0.25), 0.015625, 1e-12);
    EXPECT_NEAR(at("cubic-in-out", 0.75), 0.9375, 1e-12);
    EXPECT_NEAR(at("sin-in-out", 0.25), (1 - std::cos(std::acos(-1.0) / 4)) / 2, 1e-12);
    EXPECT_NEAR(at("circle-in", 0.25), 1 - std::sqrt(1 - 0.0625), 1e-12);
    EXPECT_NEAR(at("exp-in", 0.25), std::pow(2, -7.5), 1e-12);
    EXPECT_NEAR(at("bounce-out", 0.25), 7.5625 * 0.0625, 1e-12);
    EXPECT_NEAR(at("bounce-out", 0.5), 7.5625 * std::pow(0.5 - 1.5 / 2.75, 2) + 0.75, 1e-12);
    EXPECT_NEAR(at("bounce-out", 0.8), 7.5625 * std::pow(0.8 - 2.25 / 2.75, 2) + 0.9375, 1e-12);
    EXPECT_NEAR(at("bounce-out", 0.95), 7.5625 * std::pow(0.95 - 2.625 / 2.75, 2) + 0.984375, 1e-12);
    for (const char* curve : {"bounce", "circle", "cubic", "exp", "quad", "sin"})
        for (const char* way : {"-in", "-out", "-in-out"}) {
            const std::string name = std::string(curve) + way;
            EXPECT_EQ(easedByName(name, 0), 0) << name;
            EXPECT_EQ(easedByName(name, 1), 1) << name;
            if (name.ends_with("-in-out")) {
                EXPECT_NEAR(at(name.c_str(), 0.3) + at(name.c_str(), 0.7), 1, 1e-12) << name;
            }
        }
    for (const char* none : {"", "cubic", "quad-up", "smooth"}) EXPECT_FALSE(easedByName(none, 0.5)) << none;
}

Snapshot withAnimation(const std::string& parts, const std::string& params = "{}", const std::string& node = "{}") {
    const std::string json = R"({"root": {"kind": "root", "children": [{"kind": "canvas", "ref": "paper", "params": )" +
                             node + R"(}, {"kind": "primitives", "ref": "group", "params": )" + node +
                             R"(}]}, "animation": {"kind": "animation", "params": )" + params + R"(, "children": [)" +
                             parts + "]}}";
    return parseScene(json, "a.mvsj").snapshots.at(0);
}

std::string part(const std::string& kind, const std::string& property, const std::string& more,
                 const std::string& ref = "group") {
    return R"({"kind": "interpolate", "params": {"kind": ")" + kind + R"(", "target_ref": ")" + ref +
           R"(", "property": )" + property + ", " + more + "}}";
}

/// A parameter of the group at a time.
Json at(const Snapshot& snapshot, double seconds, const char* name) {
    SceneWarnings warnings;
    const Snapshot moved = animatedAt(snapshot, seconds, warnings);
    EXPECT_TRUE(warnings.take().empty());
    const Json* value = moved.root.children.at(1).param(name);
    return value ? *value : Json();
}

TEST(SceneAnimations, NumbersGoFromTheirStartToTheirEnd) {
    const Snapshot snapshot =
        withAnimation(part("scalar", R"("opacity")", R"("start": 1, "end": 0, "start_ms": 1000, "duration_ms": 2000)"));
    EXPECT_EQ(animationSeconds(snapshot), 3);
    EXPECT_EQ(at(snapshot, 0, "opacity"), 1);
    EXPECT_EQ(at(snapshot, 1.5, "opacity"), 0.75);
    EXPECT_EQ(at(snapshot, 9, "opacity"), 0);
    const std::string end = R"("end": 9, "duration_ms": 1000, )";
    const auto half = [&](const std::string& more) {
        return at(withAnimation(part("scalar", R"("x")", end + more), "{}", R"({"x": 1})"), 0.5, "x");
    };
    EXPECT_EQ(half(R"("easing": "linear")"), 5);  // from the value of the node
    EXPECT_EQ(half(R"("easing": "quad-in")"), 3);
    EXPECT_EQ(half(R"("frequency": 3)"), 5);  // one and a half
    EXPECT_EQ(half(R"("frequency": 2)"), 9);
    EXPECT_NEAR(half(R"("frequency": 3, "alternate_direction": true, "start": 3)").get<double>(), 6, 1e-9);
    EXPECT_TRUE(half(R"("discrete": true, "start": 0)").is_number_integer());
    EXPECT_EQ(half(R"("discrete": true, "start": 0)"), 5);
}

TEST(SceneAnimations, PartsOfOnePropertyFollowEachOther) {
    const Snapshot snapshot =
        withAnimation(part("scalar", R"(["x", 1])", R"("end": 10, "start_ms": 2000, "duration_ms": 1000)") + "," +
                          part("scalar", R"(["x", 1])", R"("start": 2, "end": 4, "duration_ms": 1000)"),
                      "{}", R"({"x": [0, 1, 0]})");
    EXPECT_EQ(at(snapshot, 0.5, "x"), Json({0, 3, 0}));
    EXPECT_EQ(at(snapshot, 1.5, "x"), Json({0, 4, 0}));
    EXPECT_EQ(at(snapshot, 2.5, "x"), Json({0, 7, 0}));
    EXPECT_EQ(at(snapshot, 3, "x"), Json({0, 10, 0}));
}

TEST(SceneAnimations, VectorsColoursAndRotationsMix) {
    const std::string one = R"(, "duration_ms": 1000)";
    const auto half = [&](const std::string& kind, const std::string& more, const std::string& node = "{}") {
        return at(withAnimation(part(kind, R"("x")", more + one), "{}", node), 0.5, "x");
    };
    EXPECT_EQ(half("vec3", R"("start": [0,0,0,1,1,1], "end": [2,4,6,1,1,3])"), Json({1, 2, 3, 1, 1, 2}));
    const Json turned = half("vec3", R"("start": [2,0,0], "end": [0,4,0], "spherical": true)");
    EXPECT_NEAR(turned[0].get<double>(), 3 * std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(turned[1].get<double>(), 3 * std::sqrt(0.5), 1e-9);
    EXPECT_EQ(half("color", R"("start": "#000000", "end": "#204060")"), "#102030");
    EXPECT_EQ(
        half("color", R"("start": {"1": "#000000"}, "end": {"1": "#204060"})", R"({"x": {"1": "red", "2": "red"}})"),
        Json({{"1", "#102030"}, {"2", "red"}}));
    EXPECT_EQ(half("color", R"("palette": {"kind": "continuous", "colors": ["#000000", "#204060"]})"), "#102030");
    const Json quarter = half("rotation_matrix", R"("start": [1,0,0,0,1,0,0,0,1], "end": [-1,0,0,0,-1,0,0,0,1])");
    ASSERT_EQ(quarter.size(), 9u);
    EXPECT_NEAR(std::abs(quarter[1].get<double>()), 1, 1e-9);
    EXPECT_NEAR(quarter[0].get<double>(), 0, 1e-9);
    const Json whole = half("transform_matrix", R"("rotation_start": [1,0,0,0,1,0,0,0,1],
        "rotation_end": [0,1,0,-1,0,0,0,0,1], "translation_end": [4,0,0], "pivot": [0,0,2])");
    ASSERT_EQ(whole.size(), 16u);
    EXPECT_NEAR(whole[0].get<double>(), std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(whole[1].get<double>(), std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(whole[12].get<double>(), 2, 1e-9);
    EXPECT_NEAR(whole[14].get<double>(), -2, 1e-9);
}

TEST(SceneAnimations, MatricesBeginWhereTheEarlierOneBegan) {
    const Snapshot snapshot = withAnimation(
        part("transform_matrix", R"("x")",
             R"("translation_start": [1,0,0], "translation_end": [2,0,0], "duration_ms": 1000)") +
        "," +
        part("transform_matrix", R"("x")", R"("translation_end": [5,0,0], "start_ms": 1000, "duration_ms": 1000)"));
    EXPECT_NEAR(at(snapshot, 0.5, "x")[12].get<double>(), 1.5, 1e-9);
    EXPECT_NEAR(at(snapshot, 1.5, "x")[12].get<double>(), 3, 1e-9);
}

TEST(SceneAnimations, PalettesBeginWithTheirInterpolation) {
    const Snapshot snapshot = withAnimation(
        part("color", R"("x")", R"("palette": {"kind": "discrete", "colors": ["#111111", "#222222"]}, "start_ms": 500,
            "duration_ms": 1000)"),
        "{}", R"({"x": "red"})");
    EXPECT_EQ(at(snapshot, 0.4, "x"), "red");
    EXPECT_EQ(at(snapshot, 0.6, "x"), "#111111");
    EXPECT_EQ(at(snapshot, 1.4, "x"), "#222222");
}

// Mol* shows the values at the end of each frame's time, except for the first.
TEST(SceneAnimations, SlowFramesStandStill) {
    const Snapshot snapshot = withAnimation(part("scalar", R"("x")", R"("start": 0, "end": 10, "duration_ms": 1000)"),
                                            R"({"frame_time_ms": 400})");
    EXPECT_EQ(at(snapshot, 0.3, "x"), 0);
    EXPECT_EQ(at(snapshot, 0.4, "x"), 0);
    EXPECT_EQ(at(snapshot, 0.5, "x"), 8);
    EXPECT_EQ(at(snapshot, 0.8, "x"), 8);
    EXPECT_EQ(at(snapshot, 0.9, "x"), 10);
}

TEST(SceneAnimations, TheCanvasStaysUnlessItIsIncluded) {
    const std::string fade =
        part("color", R"("background_color")", R"("end": "#000000", "duration_ms": 1000)", "paper");
    const auto end = [&](const std::string& params) {
        SceneWarnings warnings;
        const Snapshot moved =
            animatedAt(withAnimation(fade, params, R"({"background_color": "#ffffff"})"), 1, warnings);
        return *moved.root.children.at(0).param("background_color");
    };
    EXPECT_EQ(end("{}"), "#ffffff");
    EXPECT_EQ(end(R"({"include_canvas": true})"), "#000000");
}

TEST(SceneAnimations, FaultsAreTold) {
    const std::string one = R"("start": 0, "end": 1, "duration_ms": 1000)";
    for (const std::string& fault :
         {part("scalar", R"("x")", one, "nobody"), part("spline", R"("x")", one), part("scalar", "[]", one),
          part("scalar", R"(["a", "b"])", one), part("scalar", R"(["custom", "b"])", one),
          part("scalar", R"("x")", R"("end": 1, "duration_ms": 1000)"),
          part("scalar", R"("x")", R"("start": [1,2], "end": [1], "duration_ms": 9)"),
          part("vec3", R"("x")", R"("start": [1], "end": [1], "duration_ms": 9)"),
          part("color", R"("x")", R"("start": "red", "end": "nothing", "duration_ms": 9)"),
          part("rotation_matrix", R"("x")", R"("start": [1], "end": [1], "duration_ms": 9)"),
          part("transform_matrix", R"("x")", R"("pivot": 3, "duration_ms": 9)"),
          part("scalar", R"("x")", one + R"(, "noise_magnitude": 1)")}) {
        SceneWarnings warnings;
        animatedAt(withAnimation(fault), 0.5, warnings);
        EXPECT_EQ(warnings.take().size(), 1u) << fault;
    }
    EXPECT_EQ(animationSeconds(withAnimation("")), 0);
    EXPECT_EQ(animationSeconds(withAnimation(part("scalar", R"("x")", R"("duration_ms": 1e300)"))), 3600);
}

TEST(SceneAnimations, ASceneIsBuiltAsItIsAtATime) {
    const std::string moved = R"({"kind": "transform", "ref": "way", "params": {"translation": [0,0,0]}},)";
    std::string json = scene(moved + component(R"("all")", balls()));
    json.pop_back();
    json += R"(, "animation": {"kind": "animation", "children": [)" +
            part("vec3", R"("translation")", R"("end": [0,0,8], "duration_ms": 2000)", "way") + "]}}";
    const SceneTree tree = parseScene(json, "a.mvsj");
    SceneSources sources;
    sources.fetch = [](const std::string&) { return kStructure; };
    const auto height = [&](std::optional<double> seconds) {
        return buildScene(tree, 0, "a.mvsj", sources, seconds).atoms.at(0).position.z;
    };
    EXPECT_EQ(height({}), 3);
    EXPECT_EQ(height(0.5), 5);
    EXPECT_EQ(height(2), 11);
}

TEST(SceneTransitions, AreReadFromTheirNode) {
    const Snapshot plain = parseScene(R"({"root": {"kind": "root"}})", "a").snapshots.at(0);
    EXPECT_FALSE(transitionTo(plain));
    const Snapshot given = parseScene(R"({"root": {"kind": "root", "children": [{"kind": "transition", "params":
        {"duration_ms": 1500, "easing": "sin-in"}}]}})",
                                      "a")
                               .snapshots.at(0);
    const auto transition = transitionTo(given);
    ASSERT_TRUE(transition);
    EXPECT_EQ(transition->seconds, 1.5);
    EXPECT_EQ(transition->easing, "sin-in");
    EXPECT_EQ(transition->trajectory, "linear");
    const auto warnings = built(scene(component(R"("all")", balls()), R"(,{"kind": "transition", "params":
        {"easing": "none", "trajectory": "zigzag"}})"))
                              .guide->warnings;
    EXPECT_EQ(warnings.size(), 2u);
}

}  // namespace
}  // namespace nacre::app::mvs
