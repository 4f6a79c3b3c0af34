#include "app/download/load_molecule.h"

#include <filesystem>

#include "app/download/download.h"
#include "app/files/cache_folder.h"
#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "app/input/read_input.h"
#include "app/mvs/scene_file.h"
#include "engine/molecule/memory_bound.h"

namespace nacre::app {
namespace {

using OnContent = std::function<void(const std::string&, std::string, Format)>;

Molecule loadDownload(const InputOptions& input, const DatabaseId& id, const std::function<void(double)>& onDownload,
                      const std::function<void(double)>& onModel, const OnContent& onContent = {}) {
    if (input.format) throw Error("cannot download", input.path, "a download takes no --format");
    ReadOptions options = readWithin(memoryLimit(input));
    options.model = input.model;
    options.onModel = onModel;
    options.others = !input.alone;
    const bool forbidden = !input.namedBy.empty() && !input.allowDownload;
    DownloadSettings settings;
    settings.cacheFolder = cacheFolder(input.cache, "downloads");
    settings.offline = input.offline || forbidden;
    settings.limits = httpLimits();
    settings.verbose = isVerbose();
    settings.onProgress = onDownload;
    settings.onContent = onContent;
    try {
        return downloadMolecule(id, options, settings);
    } catch (const Error&) {
        if (!forbidden || input.offline) throw;
        throw DownloadForbidden("cannot download", input.path,
                                input.namedBy + " names it, and it is not in the cache: use --allow-download");
    }
}

bool isPlain(const std::string& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

/// Opens the file of a view's input and prints its notices. @throws Error unless it is a regular file; others might
/// block
std::string namedPath(const InputOptions& input) {
    if (input.path == "-")
        throw Error("cannot read molecule", input.namedBy, "it names standard input: give an INPUT as well");
    if (const std::string notice = outsideNotice(input); !notice.empty()) sayNotice(notice);
    const std::string named = (std::filesystem::path(input.namedBy).parent_path() / input.path).string();
    const std::string path = resolveInputPath(input);
    if (path != named && isPlain(path))
        sayNote(input.namedBy + " names a missing file; this one has the same content: " + path);
    else if (!input.hash.empty() && isPlain(path) && fileHash(path) != input.hash)
        sayNotice(path + " has changed since " + input.namedBy + " was saved");
    std::error_code error;
    if (std::filesystem::exists(path, error) && !isPlain(path))
        throw Error("cannot read molecule", path, input.namedBy + " names it, and it is not a regular file");
    return path;
}

Error notNamed(const InputOptions& input) {
    return Error("cannot read molecule", input.path,
                 "it is missing, or not the one that " + input.namedBy + " names (nacre info tells why)");
}

/// A file named by a view.
Molecule loadNamed(InputOptions input, const std::function<void(double)>& onModel) {
    input.path = namedPath(input);
    try {
        return readLocally(input, memoryLimit(input), {}, onModel);
    } catch (const Error&) {
        throw notNamed(input);
    }
}

/// @throws InputMissing
void checkThere(const std::string& path) {
    std::error_code error;
    if (path == "-" || path.find(':') != std::string::npos || std::filesystem::exists(path, error) || error) return;
    const std::string meant = meantInput(path);
    throw InputMissing(path, meant.empty() ? meant : " (did you mean '" + meant + "'?)");
}

/// A scene has its own molecules and representations.
void checkScene(const InputOptions& input) {
    if (!input.trajectory.path.empty())
        throw Error("cannot read scene", input.path, "a scene stands still: it takes no --trajectory");
    if (!input.further.empty())
        throw Error("cannot read scene", input.path, "a scene stands alone: name no other INPUT");
    if (input.addHydrogens) throw Error("cannot read scene", input.path, "its molecules take no hydrogens");
}

Molecule loadSceneFile(InputOptions input, std::string bytes, const std::function<void(double)>& onDownload,
                       const std::function<void()>& onStep) {
    checkScene(input);
    if (!input.namedBy.empty()) input.path = namedPath(input);
    return loadScene(input, std::move(bytes), readWithin(memoryLimit(input)), onDownload, onStep);
}

Molecule loadStructure(const InputOptions& input, const std::function<void(double)>& onDownload,
                       const std::function<void(double)>& onModel, const std::function<void()>& onStep) {
    if (const auto id = parseDatabaseId(input.path))
        return completed(input, loadDownload(input, *id, onDownload, onModel));
    if (!input.format)
        if (auto bytes = mvs::readScene(openedPath(input)))
            return loadSceneFile(input, std::move(*bytes), onDownload, onStep);
    if (!input.namedBy.empty()) return loadNamed(input, onModel);
    if (!input.opened) checkThere(input.path);
    return readLocally(input, memoryLimit(input), {}, onModel);
}

}  // namespace

Molecule loadMolecule(const InputOptions& input, const std::function<void(double)>& onDownload,
                      const std::function<void(double)>& onModel, const std::function<void()>& onStep) {
    InputOptions structure = input;
    // Frames of a trajectory do not match other models, and several molecules are not models of one file.
    structure.alone = input.alone || !input.trajectory.path.empty() || !input.further.empty();
    if (input.conformations && !input.further.empty()) structure.model = 1;  // --model counts the INPUTs
    Molecule molecule = loadStructure(structure, onDownload, onModel, onStep);
    moveToFrame(input.trajectory, molecule);
    if (!input.further.empty()) {
        std::vector<Molecule> molecules;
        molecules.push_back(std::move(molecule));
        for (const FurtherInput& further : input.further)
            molecules.push_back(loadStructure(furtherInput(structure, further), onDownload, onModel, onStep));
        if (input.several()) return joinInputs(input, std::move(molecules), sayNote);
        molecule = joinConformations(input, std::move(molecules), sayNote);
    } else if (!input.fits.empty() || !input.alignments.empty()) {
        throw Error("cannot fit", input.path, "--fit and --align superpose one INPUT on another: name two");
    }
    fitModels(input, molecule);
    return molecule;
}

Molecule loadSnapshot(OpenScene& scene, const InputOptions& input, const std::function<void(double)>& onDownload,
                      std::optional<double> seconds) {
    checkScene(input);
    return scene.snapshot(input, readWithin(memoryLimit(input)), onDownload, seconds);
}

std::unique_ptr<ModelFile> openModels(const InputOptions& input, const std::function<void(double)>& onDownload) {
    ReadOptions options = readWithin(memoryLimit(input));
    options.format = input.format;
    std::unique_ptr<ModelFile> file;
    if (const auto id = parseDatabaseId(input.path)) {
        InputOptions first = input;
        first.model = 1;
        first.alone = true;
        loadDownload(first, *id, onDownload, {}, [&](const std::string& name, std::string bytes, Format format) {
            options.format = format;
            file = std::make_unique<ModelFile>(name, std::move(bytes), options);
        });
    } else if (!input.path.starts_with("sample:")) {
        InputOptions named = input;
        if (input.namedBy.empty())
            checkThere(input.path);
        else
            named.path = namedPath(input);
        try {
            file = std::make_unique<ModelFile>(named.path, options);
        } catch (const Error&) {
            if (input.namedBy.empty()) throw;
            throw notNamed(named);
        }
    }
    if (!file || file->count() < 2) throw Error("cannot show models", input.path, "it has only one");
    return file;
}

}  // namespace nacre::app
