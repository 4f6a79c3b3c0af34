// A map covers its model: the density at atoms as gemmi interpolates it.
#include <gtest/gtest.h>

#include <fstream>
#include <gemmi/ccp4.hpp>
#include <sstream>

#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/read.h"
#include "engine/volume/read_map.h"
#include "tests/support/test_data.h"

namespace nacre::test {
namespace {

TEST(DensityMap, AtAtomsIsAsGemmiInterpolatesIt) {
    NACRE_NEEDS_DATA();
    const std::string path = dataFile("maps/3nzd.ccp4.gz");
    std::ifstream file(path, std::ios::binary);
    std::stringstream packed;
    packed << file.rdbuf();
    const std::string bytes = decompress(path, packed.str(), std::size_t{1} << 28);
    gemmi::Ccp4<float> judge;
    judge.read_ccp4_stream(gemmi::MemoryStream(bytes.data(), bytes.size()), path);
    judge.setup(NAN);
    const DensityMap map = readMapFile(path);
    const Molecule molecule = readMoleculeFile(dataFile("maps/3nzd.cif"));
    double ours = 0, theirs = 0;
    std::size_t covered = 0;
    for (const Atom& atom : molecule.atoms) {
        const glm::dvec3 p(atom.position);
        const double value = valueAt(map, p), judged = judge.grid.interpolate_value(gemmi::Position(p.x, p.y, p.z));
        EXPECT_NEAR(value, judged, 0.01 * map.statistics.rms);
        ours += value;
        theirs += judged;
        covered += value > map.statistics.mean + 1.5 * map.statistics.rms;
    }
    EXPECT_NEAR(ours / theirs, 1, 0.01);
    EXPECT_GT(static_cast<double>(covered) / static_cast<double>(molecule.atoms.size()), 0.7)
        << "of atoms at 1.5 sigma";
}

}  // namespace
}  // namespace nacre::test
