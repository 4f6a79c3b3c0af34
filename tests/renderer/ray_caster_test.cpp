// The GPU's layers against the CPU ray caster: which atom, where, facing which way.

#include "tests/reference/ray_caster.h"

#include "tests/reference/compare_layers.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct RayCase {
    const char* file;
    Style style;
    Projection projection;
    Visibility visibility;
};

void PrintTo(const RayCase& c, std::ostream* out) { *out << c.file; }

class RayCaster : public SharedRenderers<RayCase> {};

TEST_P(RayCaster, AgreesWithTheGpu) {
    const RayCase& c = GetParam();
    NACRE_NEEDS_DATA(c.file);
    const Representation r = scene(c.file, c.style);
    // From afar sticks are all edge, and pixels near an edge are not judged: step closer.
    const double zoom = c.style != Style::spacefill && r.radius > 20 ? 8 : 1;
    const RenderSettings s = settings(r, 320, c.projection, {20, 30, 10}, zoom);
    ValidatedRenderer& renderer = sharedRenderer(c.visibility, r);
    const reference::Comparison comparison =
        reference::compareLayers(reference::castRays(r, s.view), toReference(renderer->layers(s)));
    RecordProperty("comparison", comparison.text());
    SCOPED_TRACE(comparison.text());
    EXPECT_GE(comparison.silhouetteAgreement(), 0.999);
    EXPECT_GE(comparison.idAgreement(), 0.9995);
    EXPECT_GT(comparison.idJudged, 500u);
    EXPECT_LE(comparison.maxDepthError, 0.01);
    EXPECT_LE(comparison.maxNormalAngle, 1.0);
    EXPECT_LE(comparison.maxNormalLengthError, 1e-3);
    EXPECT_EQ(comparison.backgroundFaults, 0u);
}

std::vector<RayCase> rayCases() {
    std::vector<RayCase> all;
    for (const char* file :
         {"sample:dna", "sample:glucose", "1bna.pdb", "4hhb.pdb", "neon-pump.pdb", "small/glucose-alpha-3d.sdf"})
        for (const Style style : {Style::spacefill, Style::ballAndStick, Style::licorice})
            for (const Projection projection : {Projection::orthographic, Projection::perspective})
                for (const Visibility visibility : {Visibility::encoded, Visibility::fragdepth})
                    all.push_back({file, style, projection, visibility});
    return all;
}

std::string rayCaseName(const testing::TestParamInfo<RayCase>& info) {
    constexpr const char* kStyles[] = {"spacefill", "ball_and_stick", "licorice"};
    std::string name = info.param.file;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name + "_" + kStyles[static_cast<int>(info.param.style)] +
           (info.param.projection == Projection::perspective ? "_perspective" : "_orthographic") +
           (info.param.visibility == Visibility::encoded ? "_encoded" : "_fragdepth");
}

INSTANTIATE_TEST_SUITE_P(Scenes, RayCaster, testing::ValuesIn(rayCases()), rayCaseName);

}  // namespace
}  // namespace nacre::test
