// How frames are drawn: by every class of device, with every effect, for every part of a picture. And what a choice
// becomes where a list is too long.

#include "engine/frame/choose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "engine/error.h"
#include "engine/graph/capability_sets.h"
#include "tests/frame/choices.h"

namespace nacre::test {
namespace {

using graph::FrameCaps;

/// lavapipe's and SwiftShader's: compute shades.
FrameCaps software() {
    FrameCaps caps = graph::capabilitySet("desktop");
    caps.plan.name = "software";
    caps.kind = graph::DeviceKind::software;
    caps.plan.conservativeDepth = false;
    caps.tiles.shade = caps.tiles.drawsEdges = true;
    caps.tiles.lists = false;
    caps.tiles.lanes = 8;
    caps.blendsFloats = true;
    return caps;
}

/// A device of each kind; devices of the same kind choose the same.
std::map<std::string, std::vector<FrameCaps>> devicesByKind() {
    std::map<std::string, std::vector<FrameCaps>> kinds;
    for (const graph::CapabilitySet& set : graph::capabilitySets()) {
        FrameCaps caps = set;
        caps.blendsFloats = true;
        kinds[visibilityName(choosePath(caps).visibility)].push_back(caps);
    }
    kinds["software"] = {software()};
    return kinds;
}

/// Settings and scenes with one effect each.
struct Case {
    const char* effect;
    std::function<void(RenderSettings&, SceneFacts&)> set;
};
const Case kCases[] = {
    {"plain", [](auto&, auto&) {}},
    {"outlines", [](auto& s, auto&) { s.effects.contours.width = 2; }},
    {"outlines by groups", [](auto& s, auto&) { s.effects.contours.width = 2, s.effects.contours.weights = 3; }},
    {"halos", [](auto& s, auto&) { s.effects.halos.width = 4; }},
    {"shadow", [](auto& s, auto&) { s.effects.shadow.strength = 0.5; }},
    {"translucency", [](auto&, auto& f) { f.hasTranslucent = true; }},
    {"lens", [](auto& s, auto&) { s.effects.depthOfField.strength = 0.1; }},
    {"fine", [](auto& s, auto&) { s.fine = true; }},
    {"thin shapes", [](auto&, auto& f) { f.smallestPixels = 0.5; }},
    {"debug view", [](auto& s, auto&) { s.debug = DebugView::normals; }},
};

struct Drawn {
    const char* part;
    Part what;
    std::uint32_t supersample;
};
constexpr Drawn kParts[] = {
    {"edges", Part::whole, RenderSettings::kEdges},
    {"one sample", Part::whole, 1},
    {"3 x 3", Part::whole, 3},
    {"edge frame", Part::edges, RenderSettings::kEdges},
    {"block", Part::block, RenderSettings::kEdges},
    {"distances", Part::distances, 1},
    {"layers", Part::layers, 1},
    {"pick", Part::pick, 1},
    {"motion", Part::motion, 1},
    {"sample", Part::sample, RenderSettings::kEdges},
};

Ending chooseEnding(Part part) {
    return part == Part::motion ? Ending::window : part == Part::sample ? Ending::nextSample : Ending::readBack;
}

/// "deferred, 1 per pixel, picture"
std::string shortly(const FrameChoice& choice) {
    std::string text;
    for (const Decision& decision : describe(choice)) {
        if (decision.what == "path") text = decision.how;
        if (decision.what == "shading" && decision.how == "compute") text += " by compute";
        if (decision.what == "samples" || decision.what == "ending") text += ", " + decision.how;
    }
    return text;
}

FrameChoice makeChoice(const Drawn& drawn, const Case& one, const FrameCaps& caps) {
    RenderSettings settings;
    settings.view.width = settings.view.height = 640;
    settings.view.radius = 20;
    settings.supersample = drawn.supersample;
    SceneFacts facts;
    facts.spheres = 1000;
    one.set(settings, facts);
    return choose({settings, drawn.what, chooseEnding(drawn.what)}, facts, caps);
}

/// Of each part the choices, and the cases that take them.
std::string formatTable(const FrameCaps& caps) {
    std::string table;
    for (const Drawn& drawn : kParts) {
        std::vector<std::pair<std::string, std::string>> rows;  // choice, cases
        for (const Case& one : kCases) {
            const std::string choice = shortly(makeChoice(drawn, one, caps));
            const auto same = std::ranges::find(rows, choice, &std::pair<std::string, std::string>::first);
            if (same == rows.end())
                rows.emplace_back(choice, one.effect);
            else
                same->second += std::string(", ") + one.effect;
        }
        for (const auto& [choice, cases] : rows)
            table += std::string(drawn.part) + ": " + choice + (rows.size() > 1 ? ": " + cases : "") + "\n";
    }
    return table;
}

TEST(Choose, IsStatedForEveryKindOfDeviceEffectAndPart) {
    EXPECT_EQ(devicesByKind().size(), statedChoices().size());
    for (const auto& [kind, devices] : devicesByKind())
        for (const FrameCaps& caps : devices) {
            // Frames in motion alone differ among devices of a kind.
            const auto stated = statedChoices().find(kind);
            EXPECT_EQ(withoutMotion(formatTable(caps)), stated == statedChoices().end() ? "" : stated->second)
                << kind << ", " << caps.plan.name;
        }
}

TEST(Choose, HasTheEffectsOfThePart) {
    using Kind = Effect::Kind;
    const FrameCaps caps = graph::capabilitySet("adreno");
    const std::map<std::string, std::vector<Effect>> effects{{"outlines by groups", {{Kind::outlines, 0}}},
                                                             {"halos", {{Kind::halos, 0}}},
                                                             {"shadow", {{Kind::shadow, 1024}}},
                                                             {"translucency", {{Kind::translucency, 2}}},
                                                             {"lens", {{Kind::lens, 0}}}};
    for (const Drawn& drawn : kParts)
        for (const Case& one : kCases) {
            const FrameChoice choice = makeChoice(drawn, one, caps);
            std::vector<Effect> wanted;
            if (const auto found = effects.find(one.effect); found != effects.end()) wanted = found->second;
            const bool lens = !wanted.empty() && wanted[0].kind == Kind::lens;
            const bool shadow = !wanted.empty() && wanted[0].kind == Kind::shadow;
            const bool colors = drawn.what != Part::distances && drawn.what != Part::pick;
            const bool picture = colors && drawn.what != Part::layers;
            if (!picture && !(shadow && colors)) wanted.clear();
            if (lens && drawn.what != Part::whole) wanted.clear();
            EXPECT_EQ(std::vector<Effect>(choice.effects.begin(), choice.effects.end()), wanted)
                << drawn.part << ", " << one.effect;
        }
}

FrameRequest makeRequest(const RenderSettings& settings) { return {settings, Part::whole, Ending::readBack}; }

TEST(Choose, OfASceneWithLongListsIsInTheValue) {
    const FrameCaps caps = software();
    RenderSettings settings;
    settings.view.width = settings.view.height = 640;
    SceneFacts facts;
    const FrameChoice edges = choose(makeRequest(settings), facts, caps);
    EXPECT_EQ(edges.within(6000), edges);
    EXPECT_EQ(edges.within(6001).refinement, Refinement::blocks);
    EXPECT_TRUE(edges.within(6001).givesWay());
    settings.supersample = 1;
    const FrameChoice single = choose(makeRequest(settings), facts, caps);
    EXPECT_EQ(single.within(28000), single);
    EXPECT_EQ(single.within(28001).path, Visibility::fragdepth);
    EXPECT_FALSE(single.within(28001).shadedByCompute());
    EXPECT_FALSE(single.within(28001).givesWay());
    settings.effects.halos.width = 3;  // which walk through lists twice
    const FrameChoice halos = choose(makeRequest(settings), facts, caps);
    EXPECT_EQ(halos.within(14000), halos);
    EXPECT_EQ(halos.within(14001).path, Visibility::deferred);
    settings.effects.halos.width = 0;
    facts.hasTranslucent = true;
    const FrameChoice layered = choose(makeRequest(settings), facts, caps);
    EXPECT_TRUE(layered.has(Effect::Kind::tileTranslucency));
    EXPECT_EQ(layered.within(1, 28001).path, Visibility::tiles);
    EXPECT_TRUE(layered.within(1, 28001).has(Effect::Kind::translucency));
    // Paths without lists have nothing that could be too long.
    const FrameChoice encoded = choose(makeRequest(settings), facts, graph::capabilitySet("adreno"));
    EXPECT_EQ(encoded.within(1'000'000, 1'000'000), encoded);
}

TEST(Choose, HasTheHostFindWhatIsInFrontWhereThatCostsLess) {
    const FrameCaps caps = software();
    RenderSettings settings;
    settings.view.width = settings.view.height = 640;
    settings.supersample = 1;
    SceneFacts facts;
    facts.boxed = true;
    facts.radiusPixels = 2;
    facts.spheres = 99'999;
    const auto host = [&] { return choose(makeRequest(settings), facts, caps).host; };
    EXPECT_EQ(host(), HostWork::none);
    facts.spheres = 100'000;
    EXPECT_EQ(host(), HostWork::frontSpheres);
    const auto but = [&](auto change) {
        RenderSettings other = settings;
        SceneFacts scene = facts;
        change(other, scene);
        return choose(makeRequest(other), scene, caps).host;
    };
    // Only what FrontSpheres supports.
    EXPECT_EQ(but([](auto& s, auto&) { s.view.projection = Projection::perspective; }), HostWork::none);
    EXPECT_EQ(but([](auto& s, auto&) { s.effects.contours.width = 1; }), HostWork::none);
    EXPECT_EQ(but([](auto& s, auto&) { s.effects.halos.width = 1; }), HostWork::none);
    EXPECT_EQ(but([](auto& s, auto&) { s.effects.clip.near = 3; }), HostWork::none);
    EXPECT_EQ(but([](auto& s, auto&) { s.effects.clip.far = 3; }), HostWork::none);
    EXPECT_EQ(but([](auto&, auto& f) { f.triangles = 1; }), HostWork::none);
    EXPECT_EQ(but([](auto&, auto& f) { f.boxed = false; }), HostWork::none);
    EXPECT_EQ(but([](auto&, auto& f) { f.radiusPixels = 3; }), HostWork::none);
    settings.supersample = RenderSettings::kEdges;
    facts.radiusPixels = 3;
    EXPECT_EQ(host(), HostWork::none);
    facts.spheres = settings.tuning.hideFrom;
    EXPECT_EQ(host(), HostWork::hiddenSpheres);
    settings.tuning.cull = false;
    EXPECT_EQ(host(), HostWork::none);
    // Where depth is tested late, a processor finds hidden spheres in less time than it shades them.
    settings = {};
    FrameCaps late = caps;
    late.visibility = Visibility::fragdepth;
    EXPECT_EQ(choose(makeRequest(settings), facts, late).host, HostWork::hiddenSpheres);
    late.visibility = Visibility::encoded;
    EXPECT_EQ(choose(makeRequest(settings), facts, late).host, HostWork::none);
}

TEST(Choose, DrawsAllSamplesOfManySmallSpheres) {
    const FrameCaps caps = software();
    RenderSettings settings;
    settings.view.width = settings.view.height = 640;
    settings.supersample = RenderSettings::kEdges;
    SceneFacts facts;
    facts.boxed = true;
    facts.radiusPixels = 2.5;
    facts.spheres = 100'000;
    const auto but = [&](auto change) {
        FrameRequest request = makeRequest(settings);
        SceneFacts scene = facts;
        change(request, scene);
        return choose(request, scene, caps).refinement;
    };
    EXPECT_EQ(but([](auto&, auto&) {}), Refinement::everywhere);
    EXPECT_EQ(but([](auto&, auto& f) { f.radiusPixels = 2.6; }), Refinement::none);
    EXPECT_EQ(but([](auto&, auto& f) { f.spheres = 99'999; }), Refinement::none);
    EXPECT_EQ(but([](auto&, auto& f) { f.leveled = true; }), Refinement::none);
    EXPECT_EQ(but([](auto&, auto& f) { f.triangles = 1; }), Refinement::none);
    EXPECT_NE(but([](auto& r, auto&) { r.quarterTurns = 1; }), Refinement::everywhere);
    // A block's pixels are samples, so spheres are four times as large.
    FrameRequest block = makeRequest(settings);
    block.part = Part::block;
    facts.radiusPixels = 10;
    EXPECT_EQ(choose(block, facts, caps).host, HostWork::frontSpheres);
    EXPECT_EQ(choose(block, facts, caps).shading, Shading::picture);
    facts.hasCylinders = true;
    EXPECT_EQ(choose(block, facts, caps).shading, Shading::compute);
    // Where the device lists primitives, the host finds none.
    FrameCaps device = caps;
    device.tiles.lists = true;
    facts.radiusPixels = 1;
    EXPECT_EQ(choose(makeRequest(settings), facts, device).refinement, Refinement::none);
}

TEST(Choose, KnowsWhereShapesAreThinFromTheHostsLists) {
    const FrameCaps caps = software();
    RenderSettings settings;
    settings.view.width = settings.view.height = 640;
    settings.supersample = RenderSettings::kEdges;
    SceneFacts facts;
    facts.hasTranslucent = true;  // no samples at edges
    facts.smallestPixels = 0.5;
    const auto refinement = [&] { return choose(makeRequest(settings), facts, caps).refinement; };
    EXPECT_EQ(refinement(), Refinement::blocks);
    facts.spheres = settings.tuning.hideFrom;  // the lists lack hidden ones
    EXPECT_EQ(refinement(), Refinement::everywhere);
    facts.spheres = 0;
    settings.effects.contours.width = 1;
    EXPECT_EQ(refinement(), Refinement::everywhere);
}

TEST(Choose, ExplainsEveryDecision) {
    for (const auto& [kind, devices] : devicesByKind())
        for (const Drawn& drawn : kParts)
            for (const Case& one : kCases) {
                RenderSettings settings;
                settings.supersample = drawn.supersample;
                SceneFacts facts;
                one.set(settings, facts);
                const FrameRequest request{settings, drawn.what, chooseEnding(drawn.what)};
                const std::vector<Decision> decisions = explain(request, facts, devices[0]);
                ASSERT_GE(decisions.size(), 8u);
                for (const Decision& d : decisions) {
                    EXPECT_FALSE(d.how.empty()) << d.what;
                    EXPECT_GT(d.why.size(), 8u) << d.what << " of " << drawn.part << " with " << one.effect;
                }
            }
}

TEST(Choose, ThatDidNotHoldSaysWhy) {
    RenderSettings settings;
    settings.supersample = 1;
    const FrameCaps caps = software();
    const FrameRequest request = makeRequest(settings);
    const FrameChoice drawn = choose(request, {}, caps).within(30'000);
    const std::vector<Decision> decisions = explain(request, {}, caps, drawn);
    EXPECT_EQ(decisions[0].how, "fragdepth");
    EXPECT_EQ(decisions[0].why, "a tile's list is too long");
    EXPECT_EQ(decisions[2].why, "asked for");
}

TEST(Choose, DrawsTranslucentPrimitivesOfAllKindsByTiles) {
    SceneFacts scene;
    scene.hasTranslucent = true;
    FrameCaps caps = software();
    RenderSettings settings;
    settings.supersample = 1;
    const FrameChoice meshes = choose(makeRequest(settings), scene, caps);
    EXPECT_EQ(meshes.effects.size(Effect::Kind::tileTranslucency), kTranslucentLayers);
    scene.hasTranslucentAtoms = true;
    const FrameChoice atoms = choose(makeRequest(settings), scene, caps);
    EXPECT_EQ(atoms.path, meshes.path);
    EXPECT_EQ(atoms.effects.size(Effect::Kind::tileTranslucency), kTranslucentLayers);
    caps.tiles.lanes = 4;
    const FrameChoice narrow = choose(makeRequest(settings), scene, caps);
    EXPECT_EQ(narrow.path, meshes.path);
    EXPECT_EQ(narrow.effects.size(Effect::Kind::translucency), kTranslucentLayers);
}

TEST(Choose, AddsUpTheRestInFewBitsWhereItMayStayOnATile) {
    SceneFacts scene;
    RenderSettings settings;
    settings.supersample = 1;
    FrameCaps desktop = graph::capabilitySet("desktop"), tiler = graph::capabilitySet("mali");
    EXPECT_FALSE(choose(makeRequest(settings), scene, software()).fineSums);
    scene.hasTranslucent = true;
    EXPECT_TRUE(choose(makeRequest(settings), scene, software()).fineSums);
    EXPECT_FALSE(choose(makeRequest(settings), scene, desktop).fineSums);
    desktop.blendsFloats = tiler.blendsFloats = true;
    EXPECT_TRUE(choose(makeRequest(settings), scene, desktop).fineSums);
    EXPECT_FALSE(choose(makeRequest(settings), scene, tiler).fineSums);
}

TEST(Choose, PutsAVolumeBetweenLayersOfTriangles) {
    SceneFacts scene;
    scene.hasVolume = true;
    const FrameCaps caps = software();
    RenderSettings settings;
    settings.supersample = 1;
    FrameChoice choice = choose(makeRequest(settings), scene, caps);
    EXPECT_TRUE(choice.has(Effect::Kind::volume));
    EXPECT_EQ(choice.shading, Shading::fragments);  // compute leaves no image to blend over
    EXPECT_EQ(choice.layers(), 0u);
    scene.hasTranslucent = true;
    choice = choose(makeRequest(settings), scene, caps);
    EXPECT_TRUE(choice.has(Effect::Kind::translucency));
    EXPECT_FALSE(choice.has(Effect::Kind::tileTranslucency));  // leaves no depth
    EXPECT_FALSE(choose({settings, Part::pick, Ending::readBack}, scene, caps).has(Effect::Kind::volume));
    settings.supersample = RenderSettings::kEdges;
    EXPECT_EQ(choose(makeRequest(settings), scene, caps).refinement, Refinement::blocks);
    settings.debug = DebugView::normals;
    EXPECT_FALSE(choose(makeRequest(settings), scene, caps).has(Effect::Kind::volume));
}

TEST(Choose, RefusesWhatTheDeviceCannotDraw) {
    FrameCaps caps = graph::capabilitySet("apple-moltenvk");
    RenderSettings settings;
    settings.supersample = 1;
    caps.multisampling = Multisampling::four;
    EXPECT_EQ(choose(makeRequest(settings), {}, caps).attachmentSamples(), 4u);
    settings.effects.contours.width = 1;
    EXPECT_THROW(choose(makeRequest(settings), {}, caps), Error);
    settings = {};
    settings.fine = true;
    SceneFacts translucent;
    translucent.hasTranslucent = true;
    EXPECT_THROW(choose(makeRequest(settings), translucent, caps), Error);
}

/// A GPU on which compute makes the lists: it shades where the device draws by tiles, and the host does nothing.
TEST(Choose, ListsByDeviceWhereTheDeviceDrawsByTiles) {
    FrameCaps caps = graph::capabilitySet("desktop");
    caps.tiles.shade = caps.tiles.drawsEdges = true;
    caps.tiles.lanes = 32;
    RenderSettings s;
    s.supersample = 1;
    SceneFacts facts;
    facts.spheres = 1'000'000;
    facts.boxed = true;
    const FrameChoice usual = choose(makeRequest(s), facts, caps);
    EXPECT_EQ(usual.path, Visibility::fragdepth);
    EXPECT_EQ(usual.shading, Shading::fragments);
    EXPECT_EQ(chooseOcclusionMaps(caps), OcclusionMaps::fragdepth);
    caps.tested.visibility = Visibility::tiles;
    const FrameChoice tested = choose(makeRequest(s), facts, caps);
    EXPECT_EQ(tested.path, Visibility::tiles);
    EXPECT_EQ(tested.geometry, Geometry::deviceLists);
    EXPECT_EQ(tested.shading, Shading::compute);
    EXPECT_EQ(tested.host, HostWork::none);
    EXPECT_TRUE(tested.drawnByTiles());
    EXPECT_EQ(chooseOcclusionMaps(caps), OcclusionMaps::tiles);
    facts.hasTranslucent = true;
    const FrameChoice layered = choose(makeRequest(s), facts, caps);
    EXPECT_TRUE(layered.has(Effect::Kind::translucency));
    EXPECT_FALSE(layered.has(Effect::Kind::tileTranslucency));
}

}  // namespace
}  // namespace nacre::test
