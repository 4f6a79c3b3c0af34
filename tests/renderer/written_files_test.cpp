// A sample read from a file of any format is drawn as the sample is: pixel for pixel, the same atoms and bonds.

#include "tests/support/written_files.h"

#include <algorithm>
#include <map>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// Visible ids of a molecule in balls and sticks, one stick a bond: not every format has orders.
std::vector<std::uint32_t> visibleIds(ValidatedRenderer& renderer, Molecule m) {
    for (Bond& bond : m.bonds) bond.order = 1;
    std::sort(m.bonds.begin(), m.bonds.end(),
              [](const Bond& x, const Bond& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
    RepresentationOptions options{Style::ballAndStick, ColorScheme::element};
    options.bondOrders = BondOrders::off;  // few formats state them
    const Representation r = represent(m, drawnAtoms(m), options);
    renderer->setScene(r);
    return renderer->layers(settings(r, 128, Projection::orthographic)).id;
}

TEST(WrittenFiles, AreDrawnAsTheSamples) {
    NACRE_NEEDS_WRITTEN_FILES();
    ValidatedRenderer renderer(Visibility::encoded);
    std::map<std::string, std::vector<std::uint32_t>> exact;
    for (const WrittenFile& file : writtenFiles()) {
        SCOPED_TRACE(file.name);
        const Molecule read = readMoleculeFile(file.path);
        Molecule sample = sampleMolecule(file.sample);
        if (exact[file.sample].empty()) exact[file.sample] = visibleIds(renderer, sample);
        const std::vector<std::uint32_t> ids = visibleIds(renderer, read);

        // Rounded coordinates change pixels at the edges alone ...
        std::size_t covered = 0, different = 0;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            covered += exact[file.sample][i] != 0;
            different += ids[i] != exact[file.sample][i];
        }
        EXPECT_GT(covered, 1000u);
        EXPECT_LT(different, covered / 50);

        // ... and the sample with the same coordinates is the same picture.
        ASSERT_EQ(read.atoms.size(), sample.atoms.size());
        for (std::size_t i = 0; i < sample.atoms.size(); ++i) sample.atoms[i].position = read.atoms[i].position;
        EXPECT_TRUE(visibleIds(renderer, sample) == ids);
    }
}

}  // namespace
}  // namespace nacre::test
