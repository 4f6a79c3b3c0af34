#include "app/download/load_scene.h"

#include <xxhash.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/download/download.h"
#include "app/download/load_molecule.h"
#include "app/files/cache_folder.h"
#include "app/input/input_files.h"
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
    if (!fs::is_regular_file(path, error)) fail(uri, path.string() + " is no file");
    const std::uint64_t size = fs::file_size(path, error);
    if (error || size > most) fail(uri, path.string() + " is too large");
    std::string bytes(size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uint64_t>(file.gcount()) != size) fail(uri, path.string() + " cannot be read");
    return bytes;
}

bool isAddress(std::string_view uri) { return uri.starts_with("http://") || uri.starts_with("https://"); }

/// Normalises a relative name: "./a//b" is "a/b".
std::string plainName(const std::string& uri) { return fs::path(uri).lexically_normal().generic_string(); }

class SceneFetch {
public:
    SceneFetch(const InputOptions& input, const mvs::SceneFile& scene, const ReadOptions& reading,
               const std::function<void(double)>& onDownload)
        : input_(input), scene_(scene), most_(reading.maxBytes), onDownload_(onDownload) {}

    std::string operator()(const std::string& uri) const {
        if (const SceneMap* map = mapOf(uri)) return fileBytes(uri, map->path + uri.substr(map->url.size()), most_);
        if (isAddress(uri)) return download(uri);
        const std::string name = plainName(uri);
        if (uri.find(':') != std::string::npos) fail(uri, "it is neither http nor https nor a relative name");
        if (scene_.archive) return scene_.archive->read(name);
        return beside(uri, name);
    }

private:
    /// The longest prefix that fits.
    const SceneMap* mapOf(const std::string& uri) const {
        const SceneMap* best = nullptr;
        for (const SceneMap& map : input_.sceneMaps)
            if (uri.starts_with(map.url) && (!best || map.url.size() > best->url.size())) best = &map;
        return best;
    }

    /// A file in the scene's folder.
    std::string beside(const std::string& uri, const std::string& name) const {
        if (!input_.sceneFiles) fail(uri, "a scene without a folder may name addresses alone");
        std::error_code error;
        const fs::path folder = fs::weakly_canonical(fs::absolute(scene_.name), error).parent_path();
        const fs::path file = fs::weakly_canonical(folder / name, error);
        const bool inside = !error && !fs::path(name).is_absolute() &&
                            std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
        if (!inside) fail(uri, "it is not in the scene's folder");
        return fileBytes(uri, file, most_);
    }

    std::string download(const std::string& url) const {
        DownloadSettings settings;
        settings.cacheFolder = cacheFolder(input_.cache, "downloads");
        settings.offline = input_.offline || !input_.allowDownload;
        settings.limits = httpLimits();
        settings.limits.maxBytes = std::min<std::uint64_t>(settings.limits.maxBytes, most_);
        settings.onProgress = onDownload_;
        std::array<char, 33> digits{};
        const XXH128_hash_t hash = XXH3_128bits(url.data(), url.size());
        std::snprintf(digits.data(), digits.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                      static_cast<unsigned long long>(hash.low64));
        std::string bytes;
        try {
            downloadFile(nacre::printable(url, 200), std::string("mvs-") + digits.data(), url, settings,
                         [&](const std::string&, std::string got) { bytes = std::move(got); });
        } catch (const Error&) {
            if (input_.offline || input_.allowDownload) throw;
            throw DownloadForbidden(
                "cannot download", nacre::printable(url, 200),
                scene_.name + " names it, and the cache does not hold it: --allow-download gets it");
        }
        return bytes;
    }

    const InputOptions& input_;
    const mvs::SceneFile& scene_;
    std::size_t most_;
    const std::function<void(double)>& onDownload_;
};

Molecule moleculeOf(const mvs::SceneFile& scene, const InputOptions& input, const mvs::SceneSources& sources) {
    if (input.snapshot == kAllSnapshots)
        throw Error("cannot read scene", input.path, "--snapshot all is for render and movie: name one snapshot");
    const std::size_t snapshot = static_cast<std::size_t>(input.snapshot) - 1;
    return mvs::buildScene(scene.tree, snapshot, scene.name, sources);
}

}  // namespace

Molecule loadScene(const InputOptions& input, std::string bytes, const ReadOptions& reading,
                   const std::function<void(double)>& onDownload) {
    const mvs::SceneFile scene(input.path, std::move(bytes));
    return moleculeOf(scene, input, {SceneFetch(input, scene, reading, onDownload), reading});
}

OpenScene::OpenScene(const InputOptions& input) {
    const std::string path = filePathOf(input);
    file_ = std::make_unique<const mvs::SceneFile>(path, mvs::readSceneBytes(path));
}

OpenScene::~OpenScene() = default;

Molecule OpenScene::snapshot(const InputOptions& input, const ReadOptions& reading,
                             const std::function<void(double)>& onDownload) {
    const SceneFetch fetch(input, *file_, reading, onDownload);
    const auto once = [&](const std::string& uri) {
        if (const auto known = fetched_.find(uri); known != fetched_.end()) return known->second;
        std::string bytes = fetch(uri);
        if (held_ + bytes.size() <= reading.maxBytes) {
            held_ += bytes.size();
            fetched_.emplace(uri, bytes);
        }
        return bytes;
    };
    return moleculeOf(*file_, input, {once, reading});
}

std::vector<SnapshotTimes> OpenScene::times() const {
    std::vector<SnapshotTimes> times;
    for (const mvs::Snapshot& snapshot : file_->tree.snapshots)
        times.push_back({snapshot.lingerSeconds, snapshot.transitionSeconds});
    return times;
}

}  // namespace nacre::app
