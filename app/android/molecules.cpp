#include "app/android/molecules.h"

#include "engine/error.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

constexpr std::string_view kSample = "sample:";

Molecule read(const SavedView& view) {
    if (view.input.starts_with(kSample)) return sampleMolecule(std::string_view(view.input).substr(kSample.size()));
    ReadOptions options;
    options.format = formatFromName(view.format);
    options.model = view.model;
    return readMoleculeFile(view.input, options);
}

Representation build(const Molecule& molecule, const SavedView& view) {
    const std::vector<std::uint32_t> drawn = drawnAtoms(molecule, view.drawn);
    if (drawn.empty())
        throw Error("cannot draw molecule", view.input,
                    "none of its " + std::to_string(molecule.atoms.size()) + " atoms is shown");
    return represent(molecule, drawn, lookOf(view));
}

}  // namespace

Sources moleculeSources() { return {read, build}; }

}  // namespace nacre::app
