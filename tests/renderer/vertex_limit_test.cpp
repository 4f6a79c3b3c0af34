// A limit of vertex outputs per render pass cuts a frame into several, each with a share of the primitives. The picture
// is the same to the last byte on every path that rasterises.

#include <algorithm>

#include "engine/scene/color/colors.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

std::vector<Visibility> rasterPaths() {
    std::vector<Visibility> paths = devicePaths();
    std::erase(paths, Visibility::tiles);
    return paths;
}

std::size_t countRenderPasses(const std::string& plan) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = plan.find("render pass ", at)) != std::string::npos; ++at) ++count;
    return count;
}

/// How the last picture fits a limit, for people.
Decision findFit(const Renderer& renderer) {
    for (const Decision& decision : renderer.decisions())
        if (decision.what == "vertex outputs") return decision;
    return {};
}

/// Draws with and without a limit: a share of what the frame's passes hand on.
void expectTheSameInShares(ValidatedRenderer& renderer, RenderSettings s, const std::string& what, double share) {
    s.tuning.mostVertexBytes = 0;
    const Picture whole = renderer->render(s);
    EXPECT_EQ(findFit(*renderer.operator->()).how, "") << what;
    const std::size_t renderPasses = countRenderPasses(renderer->planText());
    std::uint64_t all = 0;
    for (const PassGeometry& pass : renderer->stats().geometry) all += pass.varyingBytes;
    const LayerPicture layers = renderer->layers(s);

    s.tuning.mostVertexBytes = static_cast<std::uint64_t>(static_cast<double>(all) * share);
    const Picture inShares = renderer->render(s);
    const Decision fit = findFit(*renderer.operator->());
    EXPECT_NE(fit.how, "") << what;
    EXPECT_NE(fit.why.find("a render pass gets at most"), std::string::npos) << fit.why;
    // A GPU's shapes have lighter ones, which may fit.
    const bool lighter = fit.how.find("without plates") != std::string::npos || fit.how.ends_with("of squares");
    const std::size_t least = renderPasses + (lighter && !isSoftwareDevice() ? 0 : 1);
    EXPECT_GE(countRenderPasses(renderer->planText()), least) << what << ": " << fit.how;
    std::uint64_t drawn = 0;
    for (const PassGeometry& pass : renderer->stats().geometry) {
        EXPECT_LE(pass.varyingBytes, s.tuning.mostVertexBytes) << what << ", " << pass.name;
        drawn += pass.varyingBytes;
    }
    EXPECT_LE(drawn, all) << what;
    EXPECT_TRUE(whole.rgba == inShares.rgba) << what << ": " << fit.how;

    const LayerPicture layersInShares = renderer->layers(s);
    EXPECT_TRUE(layers.id == layersInShares.id && layers.z == layersInShares.z) << what;
    EXPECT_TRUE(layers.normal == layersInShares.normal && layers.rgba == layersInShares.rgba) << what;
    EXPECT_GT(std::ranges::count_if(layers.id, [](std::uint32_t id) { return id > 0; }), 500) << what;
}

struct LimitCase {
    const char* name;
    Style style = Style::ballAndStick;
    void (*set)(Representation&, RenderSettings&) = [](auto&, auto&) {};
};
void PrintTo(const LimitCase& c, std::ostream* out) { *out << c.name; }

class VertexLimit : public SharedRenderers<LimitCase> {};

TEST_P(VertexLimit, ChangesNoPixelOnAnyPath) {
    const LimitCase& c = GetParam();
    Representation r = scene(c.style == Style::cartoon ? "sample:dna" : "sample:glucose", c.style);
    RenderSettings s = settings(r, 128, Projection::orthographic);
    c.set(r, s);
    for (const Visibility path : rasterPaths()) {
        ValidatedRenderer& renderer = sharedRenderer(path, r);
        for (const double share : {0.3, 0.13})
            expectTheSameInShares(renderer, s, std::string(visibilityName(path)) + " " + std::to_string(share), share);
    }
}

const LimitCase kLimitCases[] = {
    {"spheres", Style::spacefill},
    {"sticks"},
    {"triangles", Style::cartoon},
    {"perspective", Style::ballAndStick,
     [](Representation& r, RenderSettings& s) {
         const auto tuning = s.tuning;
         s = settings(r, 128, Projection::perspective);
         s.tuning = tuning;
     }},
    {"unmerged", Style::ballAndStick, [](auto&, RenderSettings& s) { s.tuning.merge = false; }},
    {"counted", Style::spacefill, [](auto&, RenderSettings& s) { s.tuning.countFragments = true; }},
    {"pyramids", Style::spacefill,
     [](auto&, RenderSettings& s) {
         s.tuning.plates = PlateShape::dome3;
         s.tuning.impostor = ImpostorShape::pyramid;
     }},
    {"halos", Style::ballAndStick,
     [](auto&, RenderSettings& s) {
         s.effects.halos.width = 4;
         s.effects.contours = {1, 1.5, 3};
     }},
    {"shadow", Style::ballAndStick,
     [](auto&, RenderSettings& s) {
         s.effects.shadow.strength = 0.7;
         s.effects.fog.range = Fog::Range::automatic;
     }},
    {"occlusion", Style::spacefill, [](auto&, RenderSettings& s) { s.occlusion.directions = 8; }},
    {"translucent", Style::ballAndStick,
     [](Representation& r, RenderSettings&) {
         for (const float size : {5.0f, 3.0f})
             appendMesh(
                 icosphere({0.2f, 0, 0}, size, 3, 0), glm::dvec3(0),
                 [](std::uint32_t atom) {
                     SphereLook look = testLook(atom);
                     look.color = withOpacity(look.color, 0.4);
                     return look;
                 },
                 r);
     }},
    {"samples", Style::spacefill, [](auto&, RenderSettings& s) { s.supersample = 2; }},
};
INSTANTIATE_TEST_SUITE_P(Scenes, VertexLimit, testing::ValuesIn(kLimitCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(VertexLimitOfCopies, CutsAnywhere) {
    Molecule m = molecule("sample:glucose");
    addCopies(m, {{9, 0, 0}, {0, 9, 0}});
    RepresentationOptions options{.style = Style::ballAndStick, .assembly = "1"};
    const Representation r = represent(m, drawnAtoms(m), options);
    PathRenderers renderers;
    for (const Visibility path : rasterPaths()) {
        renderers[path]->setScene(r);
        expectTheSameInShares(renderers[path], settings(r, 128, Projection::orthographic), visibilityName(path), 0.07);
    }
}

TEST(VertexLimitOfCoarseDepth, ChangesNoPixel) {
    const Representation r = scene("sample:dna", Style::spacefill);
    RenderSettings s = settings(r, 128, Projection::orthographic);
    Renderer renderer({true, "", Visibility::encoded, EncodedDepth::rgba8});
    renderer.setScene(r);
    const Picture whole = renderer.render(s);
    s.tuning.mostVertexBytes = 5000;
    EXPECT_TRUE(renderer.render(s).rgba == whole.rgba);
    EXPECT_GT(countRenderPasses(renderer.planText()), 10u);
    for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
}

TEST(VertexLimitOfSamples, IsLoadedAndStored) {
    const Representation r = scene("sample:dna", Style::spacefill);
    RenderSettings s = settings(r, 128, Projection::orthographic);
    DeviceOptions options{true, "", Visibility::fragdepth};
    options.multisampling = Multisampling::four;
    Renderer renderer(options);
    renderer.setScene(r);
    const Picture whole = renderer.render(s);
    EXPECT_EQ(renderer.stats().loadedBytes, 0u);
    s.tuning.mostVertexBytes = 20000;
    EXPECT_TRUE(renderer.render(s).rgba == whole.rgba);
    EXPECT_GT(renderer.stats().loadedBytes, 0u);
    for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
}

TEST(VertexLimitOfEyes, CountsBoth) {
    const Representation r = scene("sample:dna", Style::ballAndStick);
    RenderSettings s = settings(r, 128, Projection::perspective);
    s.view = paired(fromAside(s.view, -2, s.view.eyeDistance), fromAside(s.view, 2, s.view.eyeDistance));
    ValidatedRenderer renderer(Visibility::encoded, r);
    const std::array<Picture, 2> whole = renderer->renderEyes(s);
    s.tuning.mostVertexBytes = 50000;
    const std::array<Picture, 2> inShares = renderer->renderEyes(s);
    EXPECT_NE(findFit(*renderer.operator->()).how, "");
    for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(whole[i].rgba == inShares[i].rgba) << i;
}

}  // namespace
}  // namespace nacre::test
