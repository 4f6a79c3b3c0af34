#include "app/headless/input.h"

#include <string_view>

#include "engine/error.h"

namespace nacre::app {

Molecule loadMolecule(const InputOptions& input) {
    constexpr std::string_view kSample = "sample:";
    const std::string_view path = input.path;
    if (path.substr(0, kSample.size()) == kSample) {
        if (input.format) throw Error("cannot read molecule", input.path, "a sample takes no --format");
        if (input.model != 1 && input.model != kAllModels)
            throw Error("cannot read molecule", input.path, "a sample has one model");
        return sampleMolecule(path.substr(kSample.size()));
    }
    ReadOptions options;
    options.format = input.format;
    options.model = input.model;
    return readMoleculeFile(input.path, options);
}

Representation sceneOf(const Molecule& molecule, const std::string& name, const DrawnAtomsOptions& drawnOptions,
                       const RepresentationOptions& look) {
    const std::vector<std::uint32_t> drawn = drawnAtoms(molecule, drawnOptions);
    if (drawn.empty())
        throw Error(
            "cannot draw molecule", name,
            "none of its " + std::to_string(molecule.atoms.size()) + " atoms is drawn; see --water and --hydrogens");
    return represent(molecule, drawn, look);
}

}  // namespace nacre::app
