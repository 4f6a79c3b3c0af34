#include "app/download/load_scene.h"

#include <xxhash.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "app/download/allowed_hosts.h"
#include "app/download/download.h"
#include "app/download/load_molecule.h"
#include "app/files/cache_folder.h"
#include "app/files/opened_file.h"
#include "app/input/input_files.h"
#include "app/mvs/animation.h"
#include "app/mvs/build_scene.h"
#include "app/mvs/scene_file.h"
#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& uri, const std::string& why) {
    throw Error("cannot read what a scene names", nacre::printable(uri, 200), why);
}

std::string fileBytes(const std::string& uri, const fs::path& path, std::size_t most) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) fail(uri, "there is no such file");
    const std::uint64_t size = fs::file_size(path, error);
    if (error || size > most) fail(uri, "its file is too large");
    std::string bytes(size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uint64_t>(file.gcount()) != size) fail(uri, "its file cannot be read");
    return bytes;
}

bool isAddress(std::string_view uri) { return uri.starts_with("http://") || uri.starts_with("https://"); }

/// Normalises a relative name: "./a//b" is "a/b".
std::string plainName(const std::string& uri) { return fs::path(uri).lexically_normal().generic_string(); }

/// The name of an address in the cache of downloads.
std::string makeCacheName(const std::string& url) {
    const XXH128_hash_t hash = XXH3_128bits(url.data(), url.size());
    return formatted("mvs-%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                     static_cast<unsigned long long>(hash.low64));
}

class SceneFetch {
public:
    SceneFetch(const InputOptions& input, const mvs::SceneFile& scene, std::size_t most,
               const std::function<void(double)>& onDownload)
        : input_(input), scene_(scene), most_(most), onDownload_(onDownload) {}

    std::string operator()(const std::string& uri) const {
        const Place place = resolveUri(uri);
        if (place.file) return fileBytes(uri, place.file->path(), most_);
        if (place.download) return download(uri);
        if (!place.path.empty()) return fileBytes(uri, place.path, most_);
        return scene_.archive->read(plainName(uri));
    }

    /// Identifies the content of a file. Empty: it is in the scene's own file.
    std::string identify(const std::string& uri) const {
        const Place place = resolveUri(uri);
        return place.file ? fileHash(place.file->path()) : fileHash(place.path);
    }

private:
    /// Location of a file that a scene names; all members empty: in its archive.
    struct Place {
        std::shared_ptr<const OpenedFile> file;
        std::string path;       ///< of a file, or of a cached download
        bool download = false;  ///< `path` is filled by a download
    };

    Place resolveUri(const std::string& uri) const {
        if (const SceneMap* map = findMap(uri)) return {nullptr, map->path + uri.substr(map->url.size())};
        if (isAddress(uri)) {
            const std::string folder = cacheFolder(input_.cache, "downloads");
            return {nullptr, folder.empty() ? folder : (fs::path(folder) / makeCacheName(uri)).string(), true};
        }
        const std::string name = plainName(uri);
        if (uri.find(':') != std::string::npos) fail(uri, "it is neither http nor https nor a relative name");
        if (scene_.archive) return {};
        return beside(uri, name);
    }

    /// The longest prefix that fits.
    const SceneMap* findMap(const std::string& uri) const {
        const SceneMap* best = nullptr;
        for (const SceneMap& map : input_.sceneMaps)
            if (uri.starts_with(map.url) && (!best || map.url.size() > best->url.size())) best = &map;
        return best;
    }

    /// A file in the scene's folder.
    Place beside(const std::string& uri, const std::string& name) const {
        if (!input_.sceneFiles) fail(uri, "a scene without a folder may name addresses alone");
        if (input_.opened) {
            std::shared_ptr<const OpenedFile> file = input_.opened->beside(name);
            if (!file) fail(uri, "there is no such file in the scene's folder");
            return {std::move(file), {}};
        }
        std::error_code error;
        const fs::path folder = fs::weakly_canonical(fs::absolute(scene_.name), error).parent_path();
        const fs::path file = fs::weakly_canonical(folder / name, error);
        const bool inside = !error && !fs::path(name).is_absolute() &&
                            std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
        if (!inside) fail(uri, "it is not in the scene's folder");
        return {nullptr, file.string()};
    }

    std::string download(const std::string& url) const {
        DownloadSettings settings;
        settings.cacheFolder = cacheFolder(input_.cache, "downloads");
        settings.offline = input_.offline || !input_.allowDownload;
        settings.limits = httpLimits();
        settings.limits.maxBytes = std::min<std::uint64_t>(settings.limits.maxBytes, most_);
        settings.onProgress = onDownload_;
        if (input_.sceneHosts) return downloadForStranger(url, settings);
        std::string bytes;
        try {
            downloadFile(nacre::printable(url, 200), makeCacheName(url), url, settings,
                         [&](const std::string&, std::string got) { bytes = std::move(got); });
        } catch (const Error&) {
            if (input_.offline || input_.allowDownload) throw;
            throw DownloadForbidden(
                "cannot download", nacre::printable(url, 200),
                scene_.name + " names it, and the cache does not hold it: --allow-download gets it");
        }
        return bytes;
    }

    /// One error for every failure: details would describe this machine's network.
    std::string downloadForStranger(const std::string& url, DownloadSettings& settings) const {
        const HostRule rule = hostRule(url, *input_.sceneHosts);
        settings.limits.publicAlone = rule != HostRule::named;
        settings.limits.redirects = 0;  // to hosts that nobody checked
        std::string bytes;
        try {
            if (rule == HostRule::refused) throw Error("", "", "");
            downloadFile(nacre::printable(url, 200), makeCacheName(url), url, settings,
                         [&](const std::string&, std::string got) { bytes = std::move(got); });
        } catch (const Error&) {
            fail(url, "it cannot be downloaded here");
        }
        return bytes;
    }

    const InputOptions& input_;
    const mvs::SceneFile& scene_;
    std::size_t most_;
    const std::function<void(double)>& onDownload_;
};

/// Adds the names in a node and its descendants.
void collectNames(const mvs::Node& node, std::set<std::string>& names) {
    for (const char* key : {"url", "uri"})
        if (const mvs::Json* value = node.param(key); value && value->is_string())
            names.insert(value->get<std::string>());
    for (const mvs::Node& child : node.children) collectNames(child, names);
}

Molecule buildMolecule(const mvs::SceneFile& scene, const InputOptions& input, const mvs::SceneSources& sources,
                       std::optional<double> seconds = {}) {
    if (input.snapshot == kAllSnapshots)
        throw Error("cannot read scene", input.path, "--snapshot all is for render and movie: name one snapshot");
    const std::size_t snapshot = static_cast<std::size_t>(input.snapshot) - 1;
    return mvs::buildScene(scene.tree, snapshot, scene.name, sources, seconds);
}

}  // namespace

Molecule loadScene(const InputOptions& input, std::string bytes, const ReadOptions& reading,
                   const std::function<void(double)>& onDownload, const std::function<void()>& onStep) {
    const mvs::SceneFile scene(input.path, std::move(bytes));
    return buildMolecule(scene, input, {SceneFetch(input, scene, reading.maxBytes, onDownload), reading, onStep});
}

std::string contentOfNamed(const InputOptions& input) {
    std::string content;
    try {
        std::optional<std::string> bytes = mvs::readScene(openedPath(input));
        if (!bytes) return {};
        const mvs::SceneFile scene(input.path, std::move(*bytes));
        std::set<std::string> names;
        for (const mvs::Snapshot& snapshot : scene.tree.snapshots) collectNames(snapshot.root, names);
        if (names.size() > mvs::kMostFiles) return "too many files\n";
        const std::function<void(double)> none;
        const SceneFetch fetch(input, scene, 0, none);
        for (const std::string& name : names) {
            content += name + '\n';
            try {
                content += fetch.identify(name) + '\n';
            } catch (const Error&) {  // reading the scene reports it
            }
        }
    } catch (const Error&) {
        content += "unreadable\n";
    }
    return content;
}

OpenScene::OpenScene(const InputOptions& input) {
    const std::string path = resolveInputPath(input);
    file_ = std::make_unique<const mvs::SceneFile>(path, mvs::readSceneBytes(path));
}

OpenScene::~OpenScene() = default;

Molecule OpenScene::snapshot(const InputOptions& input, const ReadOptions& reading,
                             const std::function<void(double)>& onDownload, std::optional<double> seconds) {
    const SceneFetch fetch(input, *file_, reading.maxBytes, onDownload);
    const auto once = [&](const std::string& uri) {
        if (const auto known = fetched_.find(uri); known != fetched_.end()) return known->second;
        std::string bytes = fetch(uri);
        if (held_ + bytes.size() <= reading.maxBytes) {
            held_ += bytes.size();
            fetched_.emplace(uri, bytes);
        }
        return bytes;
    };
    return buildMolecule(*file_, input, {once, reading, {}}, seconds);
}

std::vector<SnapshotTimes> OpenScene::times() const {
    const std::vector<mvs::Snapshot>& snapshots = file_->tree.snapshots;
    std::vector<SnapshotTimes> times;
    for (std::size_t i = 0; i < snapshots.size(); ++i) {
        SnapshotTimes& own = times.emplace_back();
        own.linger = snapshots[i].lingerSeconds;
        own.transition = snapshots[i].transitionSeconds;
        own.animation = mvs::animationSeconds(snapshots[i]);
        own.loops = mvs::animationFlag(snapshots[i], "loop");
        own.camera = mvs::animationFlag(snapshots[i], "include_camera");
        if (const auto next = mvs::transitionTo(snapshots[(i + 1) % snapshots.size()])) {
            own.transition = next->seconds;
            own.easing = next->easing;
            own.trajectory = next->trajectory;
        }
    }
    return times;
}

}  // namespace nacre::app
