#include "app/shared/local_molecules.h"

#include <unistd.h>

#include "engine/error.h"
#include "engine/molecule/memory_bound.h"

namespace nacre::app {
namespace {

constexpr std::string_view kSample = "sample:";

std::uint64_t memoryBytes() {
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? static_cast<std::uint64_t>(pages) / 4 * static_cast<std::uint64_t>(size)
                                 : std::uint64_t{512} << 20;
}

Molecule read(const SavedView& view, const std::function<std::string(const std::string&)>& readFile) {
    if (view.input.starts_with(kSample)) return sampleMolecule(std::string_view(view.input).substr(kSample.size()));
    ReadOptions options = readWithin(memoryBytes());
    options.format = formatFromName(view.format);
    options.model = view.model;
    return readFile ? readMolecule(view.input, readFile(view.input), options) : readMoleculeFile(view.input, options);
}

Representation build(const Molecule& molecule, const SavedView& view) {
    const std::vector<std::uint32_t> drawn = drawnAtoms(molecule, view.drawn);
    if (drawn.empty())
        throw Error("cannot draw molecule", view.input,
                    "none of its " + std::to_string(molecule.atoms.size()) + " atoms is shown");
    return represent(molecule, drawn, lookOf(view));
}

}  // namespace

Sources localMolecules(std::function<std::string(const std::string&)> readFile) {
    return {[readFile = std::move(readFile)](const SavedView& view) { return read(view, readFile); }, build};
}

}  // namespace nacre::app
