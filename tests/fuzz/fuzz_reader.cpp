// libFuzzer target for the readers: any bytes are a molecule or an Error, and nothing else.
// --format=NAME fuzzes one reader; without it the format is told from the bytes, gzip among them.
// fuzz_render draws what was read, too: a small picture, with occlusion, in a style that the bytes choose.
// --list prints the formats. tools/fuzz runs them all.

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "engine/error.h"
#include "engine/molecule/read.h"
#include "engine/threads.h"
#ifdef NACRE_FUZZ_RENDER
#include "engine/mesh/surface.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"
#endif

namespace {

nacre::ReadOptions options;

void require(bool holds, const char* what) {
    if (holds) return;
    std::cerr << "a molecule was read that " << what << std::endl;
    std::abort();
}

void check(const nacre::Molecule& molecule) {
    require(!molecule.atoms.empty(), "has no atoms");
    const std::size_t count = molecule.atoms.size();
    for (const nacre::Atom& atom : molecule.atoms) {
        require(atom.residue < molecule.residues.size(), "has an atom of no residue");
        for (int axis = 0; axis < 3; ++axis) require(std::isfinite(atom.position[axis]), "has an atom nowhere");
    }
    for (const nacre::Residue& residue : molecule.residues) {
        require(residue.chain < molecule.chains.size(), "has a residue of no chain");
        require(residue.firstAtom < count && residue.atomCount <= count - residue.firstAtom, "has a wrong residue");
    }
    for (const nacre::Bond& bond : molecule.bonds) require(bond.a < bond.b && bond.b < count, "has a wrong bond");
    for (const auto* values : {&molecule.partialCharges, &molecule.radii})
        require(values->empty() || values->size() == count, "has charges or radii of other atoms");
}

#ifdef NACRE_FUZZ_RENDER
/// Draws it in one of the styles and, if it has any, as an assembly.
void draw(const nacre::Molecule& molecule, std::size_t choice) {
    const std::vector<std::uint32_t> drawn = nacre::drawnAtoms(molecule);
    if (drawn.empty() || drawn.size() > 20000) return;
    nacre::RepresentationOptions look{.style = static_cast<nacre::Style>(choice % 5)};
    look.surface.resolution = nacre::kCoarsestSurface;
    if (choice / 5 % 2 && !molecule.assemblies.empty()) look.assembly = molecule.assemblies.front().id;
    nacre::Representation scene = nacre::represent(molecule, drawn, look);
    nacre::RenderSettings settings{.view = nacre::makeView({}, scene.radius, 24, 24), .supersample = 1};
    settings.occlusion.directions = 1;
    static nacre::Renderer renderer{nacre::DeviceOptions{}};
    renderer.setScene(std::move(scene));
    require(!renderer.render(settings).rgba.empty(), "has no picture");
}
#endif

/// Reads one model; says whether there are more.
bool read(const std::string& bytes, int model) {
    options.model = model;
    try {
        const nacre::Molecule molecule = nacre::readMolecule("input", bytes, options);
        check(molecule);
        for (std::size_t i = 0; i < molecule.others.size(); ++i) {
            const nacre::OtherModel other = molecule.others[i];
            require(other.whole || other.positions.size() == molecule.atoms.size(), "has another model of other atoms");
            if (other.whole) check(*other.whole);
        }
#ifdef NACRE_FUZZ_RENDER
        draw(molecule, bytes.size());
#endif
        return molecule.file.models.value_or(1) > model || molecule.file.records.value_or(1) > model;
    } catch (const nacre::Error&) {
        return false;
    }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    options.maxBytes = std::size_t{16} << 20;
    nacre::setThreadsPerTask(1);  // starting others takes longer than their work
    const std::string start = "--format=";
    for (int i = 1; i < *count; ++i) {
        const std::string argument = (*arguments)[i];
        if (argument == "--list") {
            std::cout << nacre::formatNames() << std::endl;
            std::exit(0);
        }
        if (argument.compare(0, start.size(), start) != 0) continue;
        options.format = nacre::formatFromName(argument.substr(start.size()));
        if (!options.format) {
            std::cerr << "unknown format: " << argument << std::endl;
            std::exit(2);
        }
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    options.others = true;
    if (!read(bytes, 1)) return 0;
    options.others = false;
    read(bytes, size % 2 ? 2 : nacre::kAllModels);
    return 0;
}
