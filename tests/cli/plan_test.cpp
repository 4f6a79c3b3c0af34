#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "app/cli/plan_command.h"
#include "engine/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace nacre::app {
namespace {

using Json = nlohmann::json;

PlanOptions phone(const std::string& caps) {
    PlanOptions options;
    options.caps = caps;
    options.picture.size = {1170, 2532};
    return options;
}
PlanOptions encodedOn(const std::string& caps) {
    PlanOptions options = phone(caps);
    options.picture.device.visibility = Visibility::encoded;
    return options;
}
Json toJson(const PlanOptions& options) { return Json::parse(planJson(planReport(options))); }

constexpr std::uint64_t kPixels = 1170ull * 2532;

TEST(Plan, TellsWhatSamplesInMotionCost) {
    EXPECT_EQ(toJson(phone("mali"))["motion"]["samples"], 1);
    const Json suggested = toJson(phone("apple-moltenvk"));
    EXPECT_EQ(suggested["motion"]["samples"], 4);
    ASSERT_EQ(suggested["costs"].size(), 1u);
    EXPECT_EQ(suggested["costs"][0], Json({{"option", "msaa 4"},
                                           {"visibility", "fragdepth"},
                                           {"passes", Json::array()},
                                           {"samples", 4},
                                           {"loaded", 0},
                                           {"stored", 0},
                                           {"tile_bytes_per_pixel", 12}}));
    PlanOptions asked = phone("apple-moltenvk");
    asked.picture.device.multisampling = Multisampling::four;
    const Json apple = toJson(asked);
    EXPECT_EQ(apple["samples"], 4);
    for (const Json& a : apple["render_passes"][0]["attachments"]) {
        EXPECT_EQ(a["store"], a["name"] == "colour" ? "store" : "dont_care");
        EXPECT_EQ(a["samples"], a["name"] == "colour" ? 1 : 4);
    }
    EXPECT_EQ(apple["memory_bytes"]["stored"], kPixels * 4);
    asked.picture.device.multisampling = Multisampling::off;
    EXPECT_EQ(toJson(asked)["motion"]["samples"], 1);
    EXPECT_TRUE(toJson(asked).at("costs").empty());
    asked.picture.device.multisampling = Multisampling::automatic;
    asked.picture.effects.contours.width = 2;
    EXPECT_EQ(toJson(asked)["motion"]["samples"], 1);
    asked.picture.device.multisampling = Multisampling::four;
    EXPECT_THROW(planReport(asked), Error);
    asked = phone("adreno");
    asked.picture.device.multisampling = Multisampling::four;
    EXPECT_THROW(planReport(asked), Error);
}

// Of a frame at rest, colour takes 4 bytes per pixel, the sum 8, the window 4.
TEST(Plan, FramesAtRestKeepTheColourAndTheSumOnTheTileWhereTheyFit) {
    struct Expected {
        const char* caps;
        int renderPasses, loaded, stored, tile;
    };
    // On one tile; colour stored and read again by what sums and shows it; and a render pass for each of the three.
    for (const Expected& e :
         {Expected{"mali", 1, 8, 12, 20}, Expected{"mali-late", 1, 8, 12, 20}, Expected{"adreno", 1, 8, 12, 24},
          Expected{"turnip", 1, 8, 12, 20}, Expected{"mali-old", 2, 12, 16, 12}, Expected{"powervr", 2, 12, 16, 12},
          Expected{"apple-moltenvk", 3, 20, 16, 8}, Expected{"adreno-no-subpass", 3, 20, 16, 8}}) {
        const Json rest = toJson(phone(e.caps))["rest"];
        EXPECT_EQ(rest["render_passes"], e.renderPasses) << e.caps;
        EXPECT_EQ(rest["memory_bytes"]["loaded"], kPixels * static_cast<unsigned>(e.loaded)) << e.caps;
        EXPECT_EQ(rest["memory_bytes"]["stored"], kPixels * static_cast<unsigned>(e.stored)) << e.caps;
        EXPECT_EQ(rest["tile_bytes_per_pixel"], e.tile) << e.caps;
        EXPECT_GE(rest["unmerged_memory_bytes"]["loaded"], rest["memory_bytes"]["loaded"]) << e.caps;
    }
    EXPECT_NE(planText(planReport(phone("mali"))).find("frames at rest: 1 render pass, 8 B loaded and 12 B stored"),
              std::string::npos);
    PlanOptions apart = phone("mali");
    apart.merge = false;
    EXPECT_EQ(toJson(apart)["rest"]["memory_bytes"], toJson(apart)["rest"]["unmerged_memory_bytes"]);
}

TEST(Plan, OfAHeadsetDrawsBothEyesInFull) {
    PlanOptions asked = phone("mali");
    ASSERT_EQ(planText(planReport(asked)).find("2 views"), std::string::npos);
    asked.headset = true;
    const std::string text = planText(planReport(asked));
    EXPECT_NE(text.find("stereo: both eyes in one frame"), std::string::npos) << text;
    EXPECT_NE(text.find("RGBA8 sRGB, 2 views"), std::string::npos) << text;
    EXPECT_EQ(toJson(asked)["size"], toJson(phone("mali"))["size"]);
}

TEST(Plan, OfMaliIsOneRenderPassWhoseTrafficIsTheColourAlone) {
    const Json json = toJson(encodedOn("mali"));
    ASSERT_EQ(json["render_passes"].size(), 1u);
    const Json& pass = json["render_passes"][0];
    ASSERT_EQ(pass["subpasses"].size(), 3u);
    EXPECT_EQ(pass["subpasses"][2]["name"], "impostor colour");
    EXPECT_EQ(pass["subpasses"][2]["reads"], Json({"depth", "encoded depth", "occlusion atlas"}));
    EXPECT_EQ(pass["subpasses"][2]["input_attachments"], Json({"encoded depth"}));
    EXPECT_EQ(pass["subpasses"][2]["writes"], Json({"colour"}));
    for (const Json& a : pass["attachments"]) {
        EXPECT_EQ(a["transient"], a["name"] != "colour");
        EXPECT_EQ(a["store"], a["name"] == "colour" ? "store" : "dont_care");
        EXPECT_EQ(a["load"], "clear");
    }
    EXPECT_EQ(json["memory_bytes"]["loaded"], 0);
    EXPECT_EQ(json["memory_bytes"]["stored"], kPixels * 4);
    EXPECT_EQ(json["memory_bytes"]["unmerged"], kPixels * 24);  // 12 each way
    EXPECT_EQ(json["memory_bytes"]["paper"], kPixels * 16);     // 6 loaded, 10 stored
    EXPECT_EQ(json["tile_bytes_per_pixel"], 8);
}

TEST(Plan, CountsTheGeometryOfASceneThatIsGiven) {
    PlanOptions options = encodedOn("mali");
    EXPECT_TRUE(toJson(options).at("geometry").is_null());
    options.picture.input.path = "sample:dna";
    const Json mali = toJson(options)["geometry"];
    const std::uint64_t spheres = mali["passes"][0]["triangles"].get<std::uint64_t>() / 18;  // domes of three octagons
    EXPECT_GT(spheres, 400u);
    EXPECT_EQ(mali["vertices"], spheres * (24 + 9 + 9));  // and indexed pyramids, twice
    EXPECT_EQ(mali["varying_bytes"], spheres * (24 * 16 + 9 * 32 + 9 * 32));
    EXPECT_EQ(mali["memory_bytes"]["stored"], mali["varying_bytes"]);
    EXPECT_NE(planText(planReport(options)).find("through memory: written once, read once"), std::string::npos);
    options.picture.camera.zoom = 0.1;  // squares, where corners cost more than fragments
    EXPECT_EQ(toJson(options)["geometry"]["vertices"], spheres * (4 + 4 + 4));
    options.picture.camera.zoom = 1000;  // nearly all is off the picture
    EXPECT_LT(toJson(options)["geometry"]["vertices"], spheres * (24 + 9 + 9));
    options.picture.camera.zoom = 0.1;
    options.caps = "adreno";
    const Json adreno = toJson(options)["geometry"];
    EXPECT_EQ(adreno["memory_bytes"]["stored"], 0);
    EXPECT_EQ(adreno["vertices"], spheres * (8 + 4 + 4));  // octagons as plates, squares as impostors
}

TEST(Plan, TellsHowVertexOutputsFitMalisMemory) {
    NACRE_NEEDS_DATA();
    PlanOptions options = encodedOn("mali");
    options.picture.input.path = test::dataFile("1aon-groel.pdb.gz");
    options.picture.look.style = Style::cartoon;
    const PlanReport report = planReport(options);
    const std::string text = planText(report);
    EXPECT_NE(
        text.find("\nvertex outputs: 2 render passes without plates (they would be 241 MB, and a render pass gets "
                  "at most 150 MB)\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("\n  the limit adds 23,699,520 B loaded, 23,699,520 B stored\n"), std::string::npos) << text;
    const Json json = Json::parse(planJson(report));
    ASSERT_EQ(json["render_passes"].size(), 2u);
    EXPECT_EQ(json["render_passes"][1]["name"], "impostor colour");
    EXPECT_EQ(json["render_passes"][1]["shares"], 1);
    EXPECT_EQ(json["vertex_bytes"]["most"], 150'000'000);
    std::uint64_t sum = 0;
    for (const std::uint64_t bytes : json["vertex_bytes"]["render_passes"]) sum += bytes;
    EXPECT_EQ(sum, json["geometry"]["varying_bytes"]);
    EXPECT_EQ(json["memory_bytes"]["loaded"], kPixels * 8);  // depth and encoded depth
    EXPECT_EQ(json["memory_bytes"]["stored"], kPixels * 12);
    options.caps = "mali-late";
    const Json late = toJson(options);
    EXPECT_EQ(late["render_passes"].size(), 1u);
    EXPECT_TRUE(late["vertex_bytes"]["most"].is_null());
}

TEST(Plan, LinesAndHalosStayOnTheTileWhateverThePath) {
    for (const char* caps : {"mali", "adreno", "powervr"}) {
        PlanOptions options = phone(caps);
        options.picture.effects.halos.width = 5;
        options.picture.effects.contours = {1, 1.5, 3};
        const Json json = toJson(options);
        ASSERT_EQ(json["render_passes"].size(), 1u) << caps;
        EXPECT_EQ(json["render_passes"][0]["subpasses"][1]["writes"], Json({"lines and halos"}));
        EXPECT_EQ(json["memory_bytes"]["loaded"], 0) << caps;
        EXPECT_EQ(json["memory_bytes"]["stored"], kPixels * 4) << caps;
        EXPECT_EQ(json["tile_bytes_per_pixel"], 16) << caps;
    }
}

TEST(Plan, TellsWhatEachOptionOfTheLookCosts) {
    PlanOptions options = encodedOn("mali");
    EXPECT_TRUE(toJson(options).at("costs").empty());
    Effects& effects = options.picture.effects;
    effects.contours = {1, 1.5, 3};
    effects.halos.width = 5;
    effects.fog.range = Fog::Range::automatic;
    effects.shadow.strength = 0.5;
    effects.clip.near = 0;
    const Json costs = toJson(options)["costs"];
    std::map<std::string, Json> of;
    for (const Json& cost : costs) of[cost["option"]] = cost;
    ASSERT_EQ(of.size(), 6u);
    for (const char* free : {"contours", "fog", "clip"}) {
        EXPECT_EQ(of[free]["passes"], Json::array());
        for (const char* key : {"loaded", "stored", "tile_bytes_per_pixel"}) EXPECT_EQ(of[free][key], 0) << free;
    }
    constexpr int kMap = 1024 * 1024 * 4;
    EXPECT_EQ(of["shadow"]["passes"], Json({"shadow map"}));
    EXPECT_EQ(of["shadow"]["loaded"], kMap);
    EXPECT_EQ(of["shadow"]["stored"], kMap);
    for (const char* rims : {"halos", "contour-weights 3"}) {
        EXPECT_EQ(of[rims]["passes"], Json({"nearest primitive", "lines and halos"}));
        EXPECT_EQ(of[rims]["loaded"], 0);
        EXPECT_EQ(of[rims]["stored"], 0);
        EXPECT_EQ(of[rims]["tile_bytes_per_pixel"], 8);
    }
    EXPECT_NE(planText(planReport(options)).find("--fog                none: a few instructions"), std::string::npos);
    options.picture.lighting = false;  // then nothing is shadowed
    EXPECT_EQ(toJson(options)["costs"].size(), 5u);
}

TEST(Plan, TellsThatDepthOfFieldIsAnotherFrame) {
    PlanOptions options = encodedOn("mali");
    const Json before = toJson(options);
    options.picture.effects.depthOfField.strength = 0.05;
    const Json json = toJson(options);
    EXPECT_EQ(json["memory_bytes"], before["memory_bytes"]);  // the first frame is what it was
    ASSERT_EQ(json["costs"].size(), 1u);
    const Json& cost = json["costs"][0];
    EXPECT_EQ(cost["option"], "depth-of-field");
    EXPECT_EQ(cost["passes"], Json({"opaque prepass", "depth encoding", "surface layer", "circles", "largest circles",
                                    "reach of circles", "large circles", "depth of field"}));
    const int pixels = json["size"][0].get<int>() * json["size"][1].get<int>();
    // Colour and distance come from memory, circles three times, and what the large ones show.
    EXPECT_GT(cost["loaded"], pixels * (4 + 4 + 3 * 8 + 4));
    EXPECT_LT(cost["loaded"], pixels * (4 + 4 + 3 * 8 + 4 + 1));
    EXPECT_GT(cost["stored"], pixels * (4 + 8 + 4 + 4));  // distance, circles, what the large ones show, the result
    EXPECT_LT(cost["stored"], pixels * (4 + 8 + 4 + 4 + 1));
}

TEST(Plan, TranslucentLayersLeaveTheTileAndTheOpaqueFrameStaysOnIt) {
    PlanOptions options = encodedOn("mali");
    options.picture.input.path = "sample:glucose";
    options.picture.look.style = Style::surface;
    const Json opaque = toJson(options);
    options.picture.look.surfaceOpacity = 0.5;
    const Json json = toJson(options);
    ASSERT_EQ(json["render_passes"].size(), 3u);
    for (std::size_t i : {0, 1}) EXPECT_EQ(json["render_passes"][i]["subpasses"].size(), 1u);
    const Json& last = json["render_passes"][2];
    std::string names;
    for (const Json& subpass : last["subpasses"]) names += subpass["name"].get<std::string>() + ", ";
    EXPECT_EQ(names,
              "opaque prepass, depth encoding, impostor colour, opaque depth, translucent rest, "
              "translucent colour of the rest + translucent colour 2 + translucent colour 1, ");
    EXPECT_EQ(last["subpasses"][3]["input_attachments"], Json({"encoded depth"}));
    // Numbers and depths of both layers go out and come back once each. Sums over the rest stay.
    EXPECT_EQ(json["memory_bytes"]["loaded"], kPixels * 16);
    EXPECT_EQ(json["memory_bytes"]["stored"], kPixels * (4 + 16));
    EXPECT_EQ(json["tile_bytes_per_pixel"].get<int>(), opaque["tile_bytes_per_pixel"].get<int>() + 8 + 2);
    // The same is told as what the option costs.
    EXPECT_TRUE(opaque.at("costs").empty());
    ASSERT_EQ(json["costs"].size(), 1u);
    EXPECT_EQ(json["costs"][0]["option"], "surface-opacity");
    EXPECT_EQ(json["costs"][0]["loaded"], kPixels * 16);
    EXPECT_EQ(json["costs"][0]["stored"], kPixels * 16);
    const auto countTriangles = [](const Json& plan, const std::string& name) {
        for (const Json& pass : plan["geometry"]["passes"])
            if (pass["name"] == name) return pass["triangles"].get<std::uint64_t>();
        return std::uint64_t{0};
    };
    EXPECT_GT(countTriangles(json, "translucent layer 1"), 0u);
    EXPECT_EQ(countTriangles(json, "translucent layer 1"), countTriangles(opaque, "impostor colour"));
    EXPECT_EQ(countTriangles(json, "impostor colour"), 0u);
    EXPECT_EQ(countTriangles(json, "translucent colour 1"), 0u);
}

TEST(Plan, UnmergedPrintsThePlanThatMergedIsComparedWith) {
    PlanOptions options = encodedOn("mali");
    options.merge = false;
    const Json json = toJson(options);
    EXPECT_EQ(json["render_passes"].size(), 3u);
    EXPECT_EQ(json["memory_bytes"]["loaded"].get<std::uint64_t>() + json["memory_bytes"]["stored"].get<std::uint64_t>(),
              toJson(encodedOn("mali"))["memory_bytes"]["unmerged"]);
}

TEST(Plan, SaysOfEveryPassWhatProfilersAsk) {
    for (const Visibility path : {Visibility::encoded, Visibility::fragdepth, Visibility::deferred}) {
        PlanOptions options = encodedOn("mali");
        options.picture.device.visibility = path;
        const Json passes = toJson(options)["passes"];
        ASSERT_GE(passes.size(), 2u);
        for (const Json& pass : passes) {
            EXPECT_FALSE(pass["depth_test_why"].get<std::string>().empty());
            EXPECT_NE(pass["precision"].get<std::string>().find("fp32"), std::string::npos);
        }
        EXPECT_EQ(passes[0]["depth_test"], "early");
        EXPECT_EQ(passes[0]["binning_bytes"]["sphere"], 16);
        const Json& shading = passes.back();
        EXPECT_EQ(shading["depth_test"], path == Visibility::encoded     ? "early"
                                         : path == Visibility::fragdepth ? "conservative"
                                                                         : "none");
        EXPECT_EQ(shading["shading_bytes"]["sphere"], 24);
        EXPECT_EQ(shading["shading_bytes"]["cylinder"], 48);
        EXPECT_EQ(shading["binning_bytes"]["cylinder"], path == Visibility::deferred ? 0 : 32);
    }
}

TEST(Plan, TextNamesEveryPassAndImage) {
    for (const graph::CapabilitySet& set : graph::capabilitySets()) {
        const std::string text = planText(planReport(phone(set.plan.name)));
        for (const char* word : {"impostor colour", "colour", "depth", "total", "paper"})
            EXPECT_NE(text.find(word), std::string::npos) << set.plan.name << ": " << word;
        const bool plates = platesReject(choosePath(set).visibility, set.plan);
        EXPECT_EQ(text.find("opaque prepass") != std::string::npos, plates) << set.plan.name;
        EXPECT_EQ(text.find("  late  ") != std::string::npos, !plates) << set.plan.name;
        EXPECT_EQ(text.find("  \n"), std::string::npos);
    }
}

/// What tools/plan_dot makes of `nacre plan OPTIONS`.
std::string makeDot(const std::string& options) {
    const test::TemporaryFolder folder;
    const std::string drawn = folder / "plan.dot";
    const std::string command =
        "'" NACRE_PROGRAM "' plan " + options + " --json | '" NACRE_SOURCE_DIR "/tools/plan_dot' >'" + drawn + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << options;
    return test::readContents(drawn);
}

TEST(Plan, DotHasABoxForEveryRenderPassAndBalances) {
    const std::string merged = makeDot("--caps mali-old --size 1170x2532");
    const std::string dot = makeDot("--caps mali-old --size 1170x2532 --merge off");
    EXPECT_EQ(dot.rfind("digraph plan {", 0), 0u);
    EXPECT_NE(merged.find("cluster0"), std::string::npos);
    EXPECT_EQ(merged.find("cluster1"), std::string::npos);
    EXPECT_EQ(merged.find("load "), std::string::npos);
    for (const char* word : {"cluster0", "cluster1", "cluster2", "store 23.7 MB", "load 11.8 MB"})
        EXPECT_NE(dot.find(word), std::string::npos) << word;
    EXPECT_EQ(std::count(dot.begin(), dot.end(), '{'), std::count(dot.begin(), dot.end(), '}'));
    EXPECT_EQ(std::count(dot.begin(), dot.end(), '"') % 2, 0);
}

TEST(Plan, OfTilesTellsTheComputePassAndWhatItHandsOn) {
    PlanOptions options = phone("");
    options.picture.device.visibility = Visibility::tiles;
    const Json json = toJson(options);
    ASSERT_EQ(json["compute_passes"].size(), 1u);
    EXPECT_EQ(json["compute_passes"][0], (Json{{"name", "nearest primitive, shaded"},
                                               {"reads", {"occlusion atlas"}},
                                               {"writes", {"colours of tiles"}}}));
    EXPECT_EQ(json["render_passes"].size(), 0u);
    // Whole bins of 16 x 16 pixels.
    const std::uint64_t numbers =
        4 * ((options.picture.size.width + 15ull) / 16 * 16) * ((options.picture.size.height + 15ull) / 16 * 16);
    EXPECT_EQ(json["memory_bytes"]["buffers"][0],
              (Json{{"name", "colours of tiles"}, {"loaded", 0}, {"stored", numbers}}));
    EXPECT_EQ(json["memory_bytes"]["stored"], numbers);
    const std::string text = planText(planReport(options));
    for (const char* word : {"compute: nearest primitive, shaded", "visibility tiles"})
        EXPECT_NE(text.find(word), std::string::npos) << text;
    const std::string dot = makeDot("--visibility tiles --supersample auto");
    for (const char* line : {R"(label="primitive numbers\nloads 8.4 MB, stores 4.2 MB")",
                             R"("compute nearest primitive, shaded" -> "memory primitive numbers" [label="write")",
                             R"("memory occlusion atlas" -> "compute edge samples" [label="texture")"})
        EXPECT_NE(dot.find(line), std::string::npos) << dot;
}

TEST(Plan, OfAPictureTellsHowItsEdgesAreDrawn) {
    PlanOptions options = phone("");
    options.picture.device.visibility = Visibility::tiles;
    options.edges = true;
    const Json json = toJson(options);
    EXPECT_EQ(json["samples"], 1);
    ASSERT_EQ(json["compute_passes"].size(), 3u);
    EXPECT_EQ(json["compute_passes"][1], (Json{{"name", "edge pixels"},
                                               {"reads", {"primitive numbers", "colours of tiles"}},
                                               {"writes", {"edge pixels"}}}));
    EXPECT_EQ(json["compute_passes"][2], (Json{{"name", "edge samples"},
                                               {"reads", {"primitive numbers", "edge pixels", "occlusion atlas"}},
                                               {"writes", {"colours of tiles"}}}));
    EXPECT_EQ(json["render_passes"].size(), 0u);
    EXPECT_EQ(planText(planReport(options)).find("the mean of"), std::string::npos);
    options.picture.effects.halos.width = 6;
    const Json halos = toJson(options);
    EXPECT_EQ(halos["visibility"], "tiles");
    ASSERT_EQ(halos["compute_passes"].size(), 1u);
    EXPECT_EQ(halos["compute_passes"][0]["name"], "nearest primitive, lines and halos, shaded");
    EXPECT_EQ(halos["samples"], 16);
    EXPECT_EQ(halos["costs"][0]["visibility"], "tiles");
    EXPECT_EQ(toJson(options)["costs"][0]["samples"], 16);
    EXPECT_NE(planText(planReport(options)).find("pixels of a picture where colours change are the mean of 16 samples"),
              std::string::npos);
    options.picture.effects.halos.width = 0;
    options.picture.device.visibility = Visibility::encoded;
    EXPECT_EQ(toJson(options)["samples"], 16);
}

TEST(Plan, RefusesWhatTheDeviceCannotDo) {
    PlanOptions options = phone("mali-old");
    options.picture.device.encoded = EncodedDepth::r32f;
    EXPECT_THROW(planReport(options), Error);
    options.picture.device.encoded = EncodedDepth::rgba8;
    EXPECT_EQ(toJson(options)["tile_bytes_per_pixel"], 8);
    options = phone("powervr");
    options.picture.device.visibility = Visibility::rasterOrder;
    EXPECT_THROW(planReport(options), Error);  // the user's, not the graph's
}

}  // namespace
}  // namespace nacre::app
