#include "app/download/molecule_sources.h"

#include <atomic>
#include <filesystem>
#include <memory>

#include "app/download/database_id.h"
#include "app/download/load_map.h"
#include "app/download/load_molecule.h"
#include "app/files/cache_folder.h"
#include "app/files/printable.h"
#include "app/input/read_input.h"
#include "app/mvs/scene_file.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

/// Thrown when a download is no longer wanted.
struct Cancelled : Error {
    Cancelled() : Error("stopped", "", "") {}
};

struct Progress {
    std::atomic<double> share{-1};
    std::atomic<bool> cancelled{false};
};

/// "pdb:1bna, pubchem:aspirin"
std::string listDownloads(const InputOptions& input) {
    std::string text;
    const auto add = [&](const std::string& path) {
        const std::optional<DatabaseId> id = parseDatabaseId(path);
        if (!id) return;
        const std::string url = listSources(*id).front().url, host = url.substr(url.find("://") + 3);
        text += (text.empty() ? "" : ", ") + printable(path) + " from " + host.substr(0, host.find('/'));
    };
    add(input.path);
    for (const FurtherInput& further : input.further) add(further.path);
    return text;
}

}  // namespace

Sources windowSources(const InputOptions& first) {
    const auto allowed = std::make_shared<std::atomic<bool>>(first.allowDownload);
    const auto progress = std::make_shared<Progress>();
    Sources all;
    all.read = [first, allowed, progress](const PictureDescription& view) {
        InputOptions input = makeInput(view, first);
        input.alone = input.alone || !input.trajectory.path.empty();
        input.trajectory = {};  // trajectories start at their first frame
        input.namedBy = view.input.namedBy;
        input.allowDownload = *allowed;
        progress->share = -1;
        progress->cancelled = false;
        const auto onDownload = [&](double share) {
            progress->share = share;
            if (progress->cancelled) throw Cancelled();
        };
        try {
            return loadMolecule(input, onDownload);
        } catch (const DownloadForbidden&) {
            const std::string downloads = listDownloads(input);
            throw Question(downloads.empty() ? "This scene downloads the files that it names."
                                             : "This view downloads " + downloads + ".",
                           "Download", [allowed] { *allowed = true; });
        }
    };
    all.maps = [first, allowed](const PictureDescription& view) {
        PictureDescription asked = view;
        asked.input = makeInput(view, first);
        asked.input.allowDownload = *allowed;
        loadMaps(asked);
    };
    all.motion = [](const std::shared_ptr<const Molecule>& molecule,
                    const PictureDescription& view) -> std::unique_ptr<Motion> {
        if (!view.input.trajectory.path.empty()) return openMotion(view.input.trajectory, *molecule);
        auto models = trajectoryOfModels(molecule, view.input.model);
        if (!models) return nullptr;
        return std::make_unique<Motion>(std::move(models), *molecule, motionOptions(view.input.trajectory, *molecule));
    };
    all.progress = [progress] { return progress->share.load(); };
    all.cancel = [progress] { progress->cancelled = true; };
    return all;
}

Sources phoneSources(const InputOptions& first, const std::function<std::string(const std::string&)>& readFile) {
    constexpr std::uint64_t kShare = 4;  // of the memory for a molecule: systems end apps that use about half of it
    Sources all = windowSources(first);
    all.motion = {};
    all.read = [readFile, fetched = all.read](const PictureDescription& view) {
        if (parseDatabaseId(view.input.path) || mvs::isSceneFile(view.input.path)) return fetched(view);
        return readLocally(makeInput(view), memoryShare(kShare), readFile);
    };
    return all;
}

std::string lasting(const std::string& input) {
    if (input.empty() || input.find(':') != std::string::npos || input == "-") return input;
    std::filesystem::path path = input;
    if (const std::string home = environmentVariable("HOME"); input.starts_with("~/") && !home.empty())
        path = std::filesystem::path(home) / input.substr(2);
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        if (const std::string meant = meantInput(input); meant.starts_with("sample:") || parseDatabaseId(meant))
            return meant;
    return std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace nacre::app
