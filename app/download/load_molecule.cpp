#include "app/download/load_molecule.h"

#include <filesystem>

#include "app/download/download.h"
#include "app/shared/cache_folder.h"
#include "app/shared/messages.h"
#include "app/shared/molecules.h"
#include "app/shared/several_inputs.h"
#include "app/shared/trajectory_input.h"
#include "app/shared/view_input.h"
#include "engine/error.h"
#include "engine/molecule/memory_bound.h"

namespace nacre::app {
namespace {

std::uint64_t memoryOf(const InputOptions& input) {
    return input.memoryMegabytes ? static_cast<std::uint64_t>(*input.memoryMegabytes) << 20 : memoryShare(2);
}

Molecule loadDownload(const InputOptions& input, const DatabaseId& id, const std::function<void(double)>& onDownload,
                      const std::function<void(double)>& onModel) {
    if (input.format) throw Error("cannot download", input.path, "a download takes no --format");
    ReadOptions options = readWithin(memoryOf(input));
    options.model = input.model;
    options.onModel = onModel;
    options.others = !input.alone;
    const bool forbidden = !input.namedBy.empty() && !input.allowDownload;
    DownloadSettings settings;
    settings.cacheFolder = cacheFolder(input.cache, "downloads");
    settings.offline = input.offline || forbidden;
    settings.limits = httpLimits();
    settings.onProgress = onDownload;
    try {
        return downloadMolecule(id, options, settings);
    } catch (const Error&) {
        if (!forbidden || input.offline) throw;
        throw DownloadForbidden("cannot download", input.path,
                                input.namedBy + " names it, and the cache does not hold it: --allow-download gets it");
    }
}

bool isPlain(const std::string& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

/// A file that a view names.
Molecule loadNamed(InputOptions input, const std::function<void(double)>& onModel) {
    if (const std::string notice = outsideNotice(input); !notice.empty()) sayNote(notice);
    const std::string named = (std::filesystem::path(input.namedBy).parent_path() / input.path).string();
    input.path = filePathOf(input);
    if (input.path != named && isPlain(input.path))
        sayNote(input.namedBy + " names a file that is gone; this one has its content: " + input.path);
    else if (!input.hash.empty() && isPlain(input.path) && fileHash(input.path) != input.hash)
        sayNote(input.path + " is not as it was when " + input.namedBy + " was saved");
    try {
        return readLocally(input, memoryOf(input), {}, onModel);
    } catch (const Error&) {
        throw Error("cannot read molecule", input.path,
                    "it is missing, or not what " + input.namedBy + " says it is (nacre info tells why)");
    }
}

Molecule loadStructure(const InputOptions& input, const std::function<void(double)>& onDownload,
                       const std::function<void(double)>& onModel) {
    if (const auto id = parseDatabaseId(input.path)) return loadDownload(input, *id, onDownload, onModel);
    return input.namedBy.empty() ? readLocally(input, memoryOf(input), {}, onModel) : loadNamed(input, onModel);
}

}  // namespace

Molecule loadMolecule(const InputOptions& input, const std::function<void(double)>& onDownload,
                      const std::function<void(double)>& onModel) {
    InputOptions structure = input;
    // What moves is not where other models are, and several molecules are no models of one file.
    structure.alone = input.alone || !input.trajectory.path.empty() || !input.further.empty();
    Molecule molecule = loadStructure(structure, onDownload, onModel);
    moveToFrame(input.trajectory, molecule);
    if (input.further.empty() && !input.fits.empty())
        throw Error("cannot fit", input.path, "one INPUT is laid onto another: name two");
    if (input.further.empty()) return molecule;
    std::vector<Molecule> molecules;
    molecules.push_back(std::move(molecule));
    InputOptions next = structure;
    for (const FurtherInput& further : input.further) {
        next.path = further.path;
        next.hash = further.hash;
        molecules.push_back(loadStructure(next, onDownload, onModel));
    }
    return joinInputs(input, std::move(molecules), sayNote);
}

}  // namespace nacre::app
