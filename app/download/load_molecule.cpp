#include "app/download/load_molecule.h"

#include "app/download/download.h"
#include "app/shared/cache_folder.h"
#include "app/shared/molecules.h"
#include "engine/error.h"
#include "engine/molecule/memory_bound.h"

namespace nacre::app {
namespace {

std::uint64_t memoryOf(const InputOptions& input) {
    return input.memoryMegabytes ? static_cast<std::uint64_t>(*input.memoryMegabytes) << 20 : memoryShare(2);
}

Molecule loadDownload(const InputOptions& input, const DatabaseId& id, const std::function<void(double)>& onDownload) {
    if (input.format) throw Error("cannot download", input.path, "a download takes no --format");
    ReadOptions options = readWithin(memoryOf(input));
    options.model = input.model;
    DownloadSettings settings;
    settings.cacheFolder = cacheFolder(input.cache, "downloads");
    settings.offline = input.offline;
    settings.limits = httpLimits();
    settings.onProgress = onDownload;
    return downloadMolecule(id, options, settings);
}

}  // namespace

Molecule loadMolecule(const InputOptions& input, const std::function<void(double)>& onDownload) {
    if (const auto id = parseDatabaseId(input.path)) return loadDownload(input, *id, onDownload);
    return readLocally(input, memoryOf(input));
}

}  // namespace nacre::app
