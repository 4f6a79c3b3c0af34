#include "app/shared/input.h"

#include <unistd.h>

#include <string_view>

#include "app/download/download.h"
#include "app/shared/cache_folder.h"
#include "engine/error.h"
#include "engine/molecule/memory_bound.h"

namespace nacre::app {

namespace {

Molecule loadDownload(const InputOptions& input, const DatabaseId& id, const ReadOptions& options,
                      const std::function<void(double)>& onDownload) {
    if (input.format) throw Error("cannot download", input.path, "a download takes no --format");
    DownloadSettings settings;
    const std::string folder = cacheFolder(input.cache);
    if (!folder.empty()) settings.cacheFolder = folder + "/downloads";
    settings.offline = input.offline;
    settings.limits = httpLimits();
    settings.onProgress = onDownload;
    return downloadMolecule(id, options, settings);
}

/// Bytes that the molecule may take.
std::uint64_t memoryOf(const InputOptions& input) {
    if (input.memoryMegabytes) return static_cast<std::uint64_t>(*input.memoryMegabytes) << 20;
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? static_cast<std::uint64_t>(pages) / 2 * static_cast<std::uint64_t>(size)
                                 : std::uint64_t{2} << 30;
}

}  // namespace

Molecule loadMolecule(const InputOptions& input, const std::function<void(double)>& onDownload) {
    constexpr std::string_view kSample = "sample:";
    const std::string_view path = input.path;
    if (path.substr(0, kSample.size()) == kSample) {
        if (input.format) throw Error("cannot read molecule", input.path, "a sample takes no --format");
        if (input.model != 1 && input.model != kAllModels)
            throw Error("cannot read molecule", input.path, "a sample has one model");
        return sampleMolecule(path.substr(kSample.size()));
    }
    ReadOptions options = readWithin(memoryOf(input));
    options.format = input.format;
    options.model = input.model;
    if (const auto id = parseDatabaseId(input.path)) return loadDownload(input, *id, options, onDownload);
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

std::string occlusionCacheFolder(const InputOptions& input) {
    const std::string folder = cacheFolder(input.cache);
    return folder.empty() ? folder : folder + "/occlusion";
}

}  // namespace nacre::app
