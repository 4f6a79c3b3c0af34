#include "app/android/molecules.h"

#include <unistd.h>

#include "engine/error.h"
#include "engine/molecule/memory_bound.h"

namespace nacre::app {
namespace {

constexpr std::string_view kSample = "sample:";

/// Of the phone's memory a quarter is the molecule's: Android ends an app that takes half of it.
std::uint64_t memoryBytes() {
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? static_cast<std::uint64_t>(pages) / 4 * static_cast<std::uint64_t>(size)
                                 : std::uint64_t{512} << 20;
}

Molecule read(const SavedView& view) {
    if (view.input.starts_with(kSample)) return sampleMolecule(std::string_view(view.input).substr(kSample.size()));
    ReadOptions options = readWithin(memoryBytes());
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
