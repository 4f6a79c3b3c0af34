#include "app/input/read_input.h"

#include <unistd.h>

#include <string_view>

#include "engine/error.h"
#include "engine/molecule/chemistry/hydrogens.h"
#include "engine/molecule/memory_bound.h"

namespace nacre::app {
namespace {

constexpr std::string_view kSample = "sample:";
constexpr std::uint64_t kUsualMemory = std::uint64_t{2} << 30;  // if the system does not report it

}  // namespace

std::uint64_t memoryShare(unsigned parts) {
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
    if (pages <= 0 || size <= 0) return kUsualMemory / parts;
    return static_cast<std::uint64_t>(pages) / parts * static_cast<std::uint64_t>(size);
}

Molecule completed(const InputOptions& input, Molecule molecule) {
    if (!input.addHydrogens) return molecule;
    if (!input.trajectory.path.empty())
        throw Error("cannot add hydrogens", input.path,
                    "the trajectory " + input.trajectory.path + " has none of them");
    return withMissingHydrogens(molecule);
}

MapLimits mapLimits() { return {static_cast<std::size_t>(memoryShare(4))}; }

Molecule readLocally(const InputOptions& input, std::uint64_t bytes,
                     const std::function<std::string(const std::string&)>& readFile,
                     const std::function<void(double)>& onModel) {
    if (input.path.starts_with(kSample)) {
        if (input.format) throw Error("cannot read molecule", input.path, "a sample takes no --format");
        if (input.model != 1 && input.model != kAllModels)
            throw Error("cannot read molecule", input.path, "a sample has one model");
        return completed(input, sampleMolecule(std::string_view(input.path).substr(kSample.size())));
    }
    ReadOptions options = readWithin(bytes);
    options.format = input.format;
    options.model = input.model;
    options.onModel = onModel;
    options.others = !input.alone;
    if (readFile) return completed(input, readMolecule(input.path, readFile(input.path), options));
    try {
        return completed(input, readMoleculeFile(input.path, options));
    } catch (const Error&) {
        if (input.format || !isMapFile(input.path)) throw;
        throw Error("cannot read molecule", input.path, "it is a density map: name a molecule, and this with --map");
    }
}

}  // namespace nacre::app
