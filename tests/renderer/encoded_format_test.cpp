// Every rung of the ladder of encoded depth against the exact one, R32F.

#include "engine/graph/encoded_format.h"

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

LayerPicture draw(const Representation& r, const RenderSettings& s, EncodedDepth rung) {
    Renderer renderer({true, "", Visibility::encoded, rung});
    renderer.setScene(r);
    LayerPicture p = renderer.layers(s);
    for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
    return p;
}

class Ladder : public testing::TestWithParam<const char*> {};

TEST_P(Ladder, DiffersOnlyWhereSurfacesAreCloserThanItsStep) {
    NACRE_NEEDS_DATA(GetParam());
    const Representation r = scene(GetParam(), Style::spacefill);
    const RenderSettings s = settings(r, 400, Projection::orthographic);
    const LayerPicture exact = draw(r, s, EncodedDepth::r32f);
    for (const graph::EncodedFormat& format : graph::encodedFormats()) {
        const LayerPicture p = draw(r, s, format.rung);
        // One step of the code, and the room that the encoded range has beyond the bounding sphere.
        const double step = 2.0 * (r.radius + 1.0) / format.levels();
        std::size_t differ = 0, covered = 0, tooFar = 0;
        for (std::size_t i = 0; i < p.id.size(); ++i) {
            covered += exact.id[i] != 0;
            if (p.id[i] == exact.id[i]) continue;
            ++differ;
            if (!(std::abs(p.z[i] - exact.z[i]) <= 1.01 * step + 1e-4)) ++tooFar;
        }
        std::cout << GetParam() << " " << format.name << ": " << differ << " of " << covered << " pixels differ, step "
                  << step << " A\n";
        EXPECT_EQ(tooFar, 0u) << format.name;
        EXPECT_GT(covered, 10000u);
        EXPECT_LE(static_cast<double>(differ), 1e-4 * static_cast<double>(p.id.size())) << format.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Molecules, Ladder, testing::Values("sample:dna", "1bna.pdb", "4hhb.pdb", "neon-pump.pdb"),
                         [](const auto& test) { return testName(test.param); });

}  // namespace
}  // namespace nacre::test
