// libFuzzer target for scenes: what is read of the bytes is completed by hydrogens, its interactions are found, and it
// becomes a scene in some style. The first two bytes choose; the rest is a file. Any bytes are drawn or refused.

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "engine/error.h"
#include "engine/molecule/chemistry/hydrogens.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/threads.h"

namespace {

using namespace nacre;

constexpr std::size_t kMostAtoms = 300;  // more find nothing new, and take longer

void require(bool holds, const char* what) {
    if (holds) return;
    std::cerr << "a molecule was drawn that " << what << std::endl;
    std::abort();
}

void draw(Molecule molecule, unsigned style, unsigned look) {
    if (look & 1) molecule = withMissingHydrogens(molecule);
    const std::vector<std::uint32_t> drawn = drawnAtoms(molecule, DrawnAtomsOptions{.water = (look & 2) != 0});
    RepresentationOptions options{.style = static_cast<Style>(style % 8)};
    options.surface.resolution = 1.2;
    options.bondOrders = look & 4 ? BondOrders::on : BondOrders::ligands;
    if (look & 8) options.color = ColorScheme::chain;
    if (look & 16) options.contacts.of = parseSelection(style & 64 ? "hetatm" : "all");
    if (look & 32) options.contacts.rules = InteractionRules::plip;
    if (look & 64 && !molecule.assemblies.empty()) options.assembly = molecule.assemblies.front().id;
    if (look & 128) options.carbohydrates = Carbohydrates::on;
    const Representation scene = represent(molecule, drawn, options);
    require(std::isfinite(scene.radius) && scene.radius > 0, "has no extent");
    require(scene.spheres.size() == scene.sphereLooks.size(), "has spheres without looks");
    require(scene.cylinders.size() == scene.cylinderLooks.size(), "has sticks without looks");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    nacre::setThreadsPerTask(1);  // starting others takes longer than their work
    if (size < 2) return 0;
    ReadOptions reading{.maxBytes = std::size_t{1} << 20, .maxAtoms = kMostAtoms};
    try {
        draw(readMolecule("input", std::string(reinterpret_cast<const char*>(data + 2), size - 2), reading), data[0],
             data[1]);
    } catch (const Error&) {
    }
    return 0;
}
