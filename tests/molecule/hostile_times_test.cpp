// Small files on which some algorithm used to be quadratic. Processor time is judged, generously: what is refused or
// ends takes a second at most, what it was took minutes or never ended.

#include <gtest/gtest.h>

#include <ctime>

#include "engine/molecule/chain_summary.h"
#include "engine/molecule/chemistry/chemistry.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/text.h"
#include "engine/occlusion/atlas_layout.h"
#include "engine/occlusion/open_texels.h"
#include "engine/scene/build/representation.h"
#include "tests/molecule/bcif_writer.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/error_text.h"

namespace nacre {
namespace {

using namespace test;

/// Seconds of this process.
template <typename Work>
double seconds(const Work& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}
constexpr double kGenerous = 30;

Representation spheres(std::size_t count, const std::function<glm::vec3(std::size_t)>& place) {
    Representation r;
    for (std::size_t i = 0; i < count; ++i) r.spheres.push_back({place(i), 1.7f});
    r.sphereLooks.resize(count);
    return r;
}
float fraction(std::size_t i, double step) {
    const double value = static_cast<double>(i) * step;
    return static_cast<float>(value - static_cast<double>(static_cast<std::int64_t>(value)));
}
glm::vec3 scattered(std::size_t i, float size) {
    return glm::vec3(fraction(i, 0.7548776662), fraction(i, 0.5698402910), fraction(i, 0.3819660113)) * size;
}

void findOpenTexels(const Representation& r) {
    const PrimitiveTree tree(r);
    const auto layouts = occlusionLayouts(r.spheres.size(), r.cylinders.size(), 0, 16384, 16384);
    EXPECT_GT(openTexels(layouts.back(), r, tree).words.size(), 0u);
    std::size_t most = 0;
    for (std::uint32_t i = 0; i < r.spheres.size(); i += 100) {
        std::size_t visited = 0;
        tree.near(i, [&](std::uint32_t) { return ++visited < 1000; });
        most = std::max(most, visited);
    }
    EXPECT_LE(most, 1000u);
}

TEST(HostileTimes, CrowdsInTheBake) {
    EXPECT_LT(seconds([] { findOpenTexels(spheres(50'000, [](std::size_t) { return glm::vec3(0); })); }), kGenerous);
    EXPECT_LT(seconds([] { findOpenTexels(spheres(200'000, [](std::size_t i) { return scattered(i, 1); })); }),
              kGenerous);
    const auto oneFarAway = [](std::size_t i) { return i == 0 ? glm::vec3(1e9f, 0, 0) : scattered(i, 140); };
    Representation far = spheres(200'000, oneFarAway);
    EXPECT_LT(seconds([&] { findOpenTexels(far); }), kGenerous);
    far.cylinders.push_back({far.spheres[0].center, 0.2f, far.spheres[1].center, 0.0f});
    EXPECT_LT(seconds([&] { findOpenTexels(far); }), kGenerous);
}

TEST(HostileTimes, NoFloatLeadsOutOfTheTree) {
    const float values[] = {0.0f, 1e30f, -1e30f, 3e38f, INFINITY, -INFINITY, NAN};
    const Representation r =
        spheres(343, [&](std::size_t i) { return glm::vec3(values[i % 7], values[i / 7 % 7], values[i / 49]); });
    const PrimitiveTree tree(r);
    for (std::uint32_t i = 0; i < r.spheres.size(); ++i)
        tree.near(i, [&](std::uint32_t other) {
            EXPECT_LT(other, r.spheres.size());
            return true;
        });
    const PrimitiveTree none((Representation()));
}

TEST(HostileTimes, ManyAtomsAtOnePlaceAreRefused) {
    std::string text = "100000\n\n";
    for (int i = 0; i < 100'000; ++i) text += "C 0 0 0\n";
    const Molecule molecule = readMolecule("a.xyz", text);
    const auto drawn = drawnAtoms(molecule, {});
    test::expectThrows([&] { represent(molecule, drawn, {}); }, "100000 times, more than the limit of 10000");
}

TEST(HostileTimes, AnOverlayOfAThousandModelsIsNot) {
    // Three hundred atoms in a ball of 13 Å, as a small protein has them, a thousand times.
    std::string text;
    for (int model = 0; model < 1000; ++model) {
        text += "300\n\n";
        for (int i = 0; i < 300; ++i)
            text += "C " + std::to_string(i % 7 * 3 - 9) + " " + std::to_string(i / 7 % 7 * 3 - 9) + " " +
                    std::to_string(i / 49 * 3 - 9) + "\n";
    }
    const Molecule molecule = readMolecule("a.xyz", text, {.model = kAllModels});
    const Representation r = represent(molecule, drawnAtoms(molecule, {}), {});
    EXPECT_EQ(r.spheres.size(), 300'000u);
    EXPECT_EQ(r.sphereModels.size(), 1000u);
}

/// Models of one alpha carbon each.
Molecule lonelyModels(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += "MODEL\n" +
                formatted("ATOM      1  CA  ALA A   1    %8.3f%8.3f%8.3f  1.00  0.00           C\n", i % 100 * 4.0,
                          i / 100 % 100 * 4.0, i / 10000 * 4.0) +
                "ENDMDL\n";
    }
    return readMolecule("a.pdb", text, {.model = kAllModels});
}

TEST(HostileTimes, CartoonsOfManyModels) {
    const Molecule molecule = lonelyModels(20'000);
    RepresentationOptions look{.style = Style::cartoon};
    EXPECT_LT(seconds([&] { EXPECT_FALSE(represent(molecule, drawnAtoms(molecule, {}), look).triangles.empty()); }),
              kGenerous);
    const Molecule more = lonelyModels(64'000);
    test::expectThrows([&] { represent(more, drawnAtoms(more, {}), look); }, "64000 models or parts of 64000 atoms");
}

TEST(HostileTimes, LongNamesOfChains) {
    // A megabyte each, once in the file, in turn over 200,000 rows.
    std::string text(std::size_t{1} << 20, 'a');
    const auto length = static_cast<std::int32_t>(text.size());
    std::string inTurn;
    for (int i = 0; i < 200'000; ++i) inTurn += static_cast<char>(i % 2);
    const auto names = bcifData(
        inTurn, {bcifEncoding("StringArray", {{"dataEncoding", packArray({bcifByteArray(4)})},
                                              {"stringData", packText(text + text + "b")},
                                              {"offsetEncoding", packArray({bcifByteArray(3)})},
                                              {"offsets", packBinary(int32Bytes({0, length, 2 * length + 1}))}})});
    const auto zeros = bcifRuns(BcifIntegers(200'000, 0));
    const std::string file =
        bcifFile({bcifCategory("_atom_site", 200'000,
                               {bcifColumn("Cartn_x", zeros), bcifColumn("Cartn_y", zeros),
                                bcifColumn("Cartn_z", zeros), bcifColumn("auth_asym_id", names)})});
    expectError("a.bcif", file, {"longer than 64 bytes"});
    const std::string mol2 =
        "@<TRIPOS>MOLECULE\na\n1 0\nSMALL\nNO\n@<TRIPOS>ATOM\n1 C 0 0 0 C 1 LIG\n@<TRIPOS>SUBSTRUCTURE\n"
        "1 LIG 1 RESIDUE 1 " +
        text + "\n";
    expectError("a.mol2", mol2, {"the name of a chain is longer"});
}

TEST(HostileTimes, IdsThatCollide) {
    std::string mol2 = "@<TRIPOS>MOLECULE\na\n100000 0\nSMALL\nNO\n@<TRIPOS>ATOM\n";
    std::string sdf = "a\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 BEGIN ATOM\n";
    for (std::int64_t i = 0; i < 100'000; ++i) {
        // Multiples of a size that a hash table of so many has.
        const std::string id = std::to_string(i * 107'897);
        const std::string place =
            std::to_string(i % 50 * 2) + " " + std::to_string(i / 50 % 50 * 2) + " " + std::to_string(i / 2500 * 2);
        mol2 += id + " C " + place + " C.3\n";
        sdf += "M  V30 " + id + " C " + place + " 0\n";
    }
    sdf += "M  V30 END ATOM\nM  V30 END CTAB\nM  END\n";
    EXPECT_LT(seconds([&] { EXPECT_EQ(readMolecule("a.mol2", mol2).atoms.size(), 100'000u); }), kGenerous);
    EXPECT_LT(seconds([&] { EXPECT_EQ(readMolecule("a.sdf", sdf).atoms.size(), 100'000u); }), kGenerous);
}

std::string atomLine(int serial, int residue, const char* name, glm::vec3 at) {
    return formatted("ATOM  %5d  %-3s ALA A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n", serial, name, residue,
                     static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z));
}

TEST(HostileTimes, RingsOfBondsAtRandom) {
    // 803,254 rings, whose sums grow long. Work on them is bounded.
    constexpr std::uint32_t kAtoms = 50'000;
    MoleculeText text;
    text.residue("LIG");
    for (std::uint32_t i = 0; i < kAtoms; ++i) text.atom("C", "C", scattered(i, 90));
    std::uint32_t random = 1;
    const auto any = [&] { return (random = 1664525 * random + 1013904223) % kAtoms; };
    for (std::uint32_t i = 0; i < 4 * kAtoms; ++i) {
        const auto [a, b] = std::minmax({any(), any()});
        if (a != b) text.molecule.bonds.push_back({a, b});
    }
    const auto atoms = drawnAtoms(text.molecule, {.water = true, .hydrogens = true});
    std::size_t rings = 0;
    EXPECT_LT(seconds([&] { rings = perceiveChemistry(text.molecule, atoms).rings.size(); }), kGenerous);
    EXPECT_GT(rings, 100'000u);
    EXPECT_LT(rings, 500'000u);
}

TEST(HostileTimes, BondsOfEveryAtomWithEveryOther) {
    // As many bonds as atoms may have on average, all of them at some of the atoms, which crowd.
    constexpr int kAtoms = 60'000, kHubs = 1'000;
    std::string text;
    for (int i = 0; i < kAtoms; ++i) {
        const auto at = static_cast<std::size_t>(i);
        text +=
            atomLine(i + 1, i / 2 % 9999, i % 2 ? "C" : "N", i < kHubs ? scattered(at, 8) : scattered(at, 90) + 20.0f);
    }
    for (int hub = 1; hub <= kHubs; ++hub)
        for (int k = 0; k < 400; k += 4) {
            char line[40];
            const auto partner = [&](int j) { return (hub + k + j) % kHubs + 1; };
            std::snprintf(line, sizeof line, "CONECT%5d%5d%5d%5d%5d\n", hub, partner(0), partner(1), partner(2),
                          partner(3));
            text += line;
        }
    EXPECT_LT(seconds([&] { EXPECT_GT(readMolecule("a.pdb", text).bonds.size(), 150'000u); }), kGenerous);

    // More than atoms can form are no bonds.
    std::string few;
    for (int i = 0; i < 100; ++i) few += atomLine(i + 1, i, "N", {static_cast<float>(4 * i), 0, 0});
    for (int a = 1; a <= 100; ++a)
        for (int b = 1; b <= 100; ++b) {
            few += formatted("CONECT%5d%5d\n", a, b);
        }
    const Molecule molecule = readMolecule("a.pdb", few);
    EXPECT_EQ(molecule.bonds.size(), 0u);
    ASSERT_FALSE(molecule.warnings.empty());
    EXPECT_NE(molecule.warnings[0].find("more than its atoms could form"), std::string::npos);
}

TEST(HostileTimes, ProductsOfOperators) {
    std::string text =
        "data_a\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.label_asym_id\n"
        "0 0 0 A\n_pdbx_struct_assembly.id 1\nloop_\n_pdbx_struct_assembly_gen.assembly_id\n"
        "_pdbx_struct_assembly_gen.oper_expression\n_pdbx_struct_assembly_gen.asym_id_list\n";
    for (int i = 0; i < 1000; ++i) text += "1 (1-1000)(1001-2000) A\n";
    text += "loop_\n_pdbx_struct_oper_list.id\n";
    for (const char* row : {"1", "2", "3"})
        for (const char* column : {"1", "2", "3"})
            text += "_pdbx_struct_oper_list.matrix[" + std::string(row) + "][" + column + "]\n";
    for (const char* row : {"1", "2", "3"}) text += "_pdbx_struct_oper_list.vector[" + std::string(row) + "]\n";
    for (int i = 1; i <= 2000; ++i) text += std::to_string(i) + " 1 0 0 0 1 0 0 0 1 " + std::to_string(i) + " 0 0\n";
    EXPECT_LT(seconds([&] {
                  const Molecule molecule = readMolecule("a.cif", text);
                  EXPECT_EQ(molecule.assemblies.size(), 0u);
                  ASSERT_FALSE(molecule.warnings.empty());
                  EXPECT_NE(molecule.warnings[0].find("more than 4194304 transforms"), std::string::npos);
              }),
              kGenerous);
}

TEST(HostileTimes, ManyChainsOfOneSequence) {
    std::string text =
        "data_a\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
        "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n_atom_site.Cartn_x\n"
        "_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    for (int i = 0; i < 100'000; ++i)
        text += "ATOM C CA ALA c" + std::to_string(i) + " 1 " + std::to_string(i % 50 * 4) + " " +
                std::to_string(i / 50 % 50 * 4) + " " + std::to_string(i / 2500 * 4) + "\n";
    EXPECT_LT(seconds([&] {
                  const Molecule molecule = readMolecule("a.cif", text);
                  EXPECT_EQ(summariseChains(molecule).size(), 100'000u);
                  RepresentationOptions look{.color = ColorScheme::entity};
                  const auto drawn = drawnAtoms(molecule, {});
                  EXPECT_EQ(represent(molecule, drawn, look).spheres.size(), 100'000u);
              }),
              kGenerous);
}

TEST(HostileTimes, AtomsThatMightShareSites) {
    // A plane across x, where a sort by x tells nothing apart; and a crowd of smaller cubes than a site.
    constexpr int kAtoms = 300'000;
    for (const bool crowd : {false, true}) {
        std::string text =
            "data_a\n_cell_length_a 1000\n_cell_length_b 1000\n_cell_length_c 1000\n_cell_angle_alpha 90\n"
            "_cell_angle_beta 90\n_cell_angle_gamma 90\nloop_\n_atom_site_label\n_atom_site_occupancy\n"
            "_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n";
        for (int i = 0; i < kAtoms; ++i) {
            const double y = i % 1000 / (crowd ? 1e7 : 1e3), z = i / 1000 / (crowd ? 1e7 : 1e3);
            text += "C1 0.5 0.5 " + std::to_string(y) + " " + std::to_string(z) + "\n";
        }
        EXPECT_LT(seconds([&] { EXPECT_EQ(readMolecule("a.cif", text).atoms.size(), std::size_t{kAtoms}); }), kGenerous)
            << crowd;
    }
}

}  // namespace
}  // namespace nacre
