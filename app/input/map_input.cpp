#include "app/input/map_input.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string_view>

#include "app/files/opened_file.h"
#include "app/input/input_files.h"
#include "app/input/read_input.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

/// Detects changes of a file.
struct FileState {
    std::uintmax_t size = 0;
    fs::file_time_type time{};
    friend bool operator==(const FileState&, const FileState&) = default;
};
std::optional<FileState> readState(const std::string& path) {
    std::error_code error;
    FileState state{.size = fs::file_size(path, error)};
    if (error) return {};
    state.time = fs::last_write_time(path, error);
    return error ? std::nullopt : std::optional(state);
}

struct KeptMap {
    std::optional<FileState> state;  ///< empty: no file
    std::shared_ptr<const DensityMap> map;
    std::uint64_t used = 0;
};

/// The most recent maps by name; in total no larger than the limit for one.
class KeptMaps {
public:
    std::shared_ptr<const DensityMap> find(const std::string& name, const std::optional<FileState>& state) {
        const std::lock_guard lock(mutex_);
        const auto found = maps_.find(name);
        if (found == maps_.end() || found->second.state != state) return nullptr;
        found->second.used = ++uses_;
        return found->second.map;
    }
    std::shared_ptr<const DensityMap> find(const std::string& name) {
        const std::lock_guard lock(mutex_);
        const auto found = maps_.find(name);
        return found == maps_.end() ? nullptr : found->second.map;
    }
    void keep(const std::string& name, const std::optional<FileState>& state, std::shared_ptr<const DensityMap> map,
              std::uint64_t most) {
        const std::lock_guard lock(mutex_);
        maps_[name] = {state, std::move(map), ++uses_};
        while (maps_.size() > 1 && bytes() > most) {
            auto oldest = maps_.begin();
            for (auto at = maps_.begin(); at != maps_.end(); ++at)
                if (at->second.used < oldest->second.used) oldest = at;
            maps_.erase(oldest);
        }
    }

private:
    std::size_t bytes() const {
        std::size_t sum = 0;
        for (const auto& [name, kept] : maps_) sum += kept.map->values.size() * sizeof(float);
        return sum;
    }

    std::mutex mutex_;
    std::map<std::string, KeptMap> maps_;
    std::uint64_t uses_ = 0;
};

KeptMaps& keptMaps() {
    static KeptMaps maps;
    return maps;
}

constexpr std::string_view kOpen = "open:";

/// Maps of open files by content, kept alive by their readers.
class OpenMaps {
public:
    std::shared_ptr<const DensityMap> find(const std::string& name) {
        const std::lock_guard lock(mutex_);
        const auto found = maps_.find(name);
        return found == maps_.end() ? nullptr : found->second.lock();
    }
    void add(const std::string& name, const std::shared_ptr<const DensityMap>& map) {
        const std::lock_guard lock(mutex_);
        std::erase_if(maps_, [](const auto& one) { return one.second.expired(); });
        maps_[name] = map;
    }

private:
    std::mutex mutex_;
    std::map<std::string, std::weak_ptr<const DensityMap>> maps_;
};

OpenMaps& openMaps() {
    static OpenMaps maps;
    return maps;
}

/// The name that determines the format of an open file. Empty: the file's path does.
std::string nameOfOpen(const InputOptions& input) { return input.opened ? input.path : std::string(); }

}  // namespace

bool isMap(const InputOptions& input) {
    const std::string path = openedPath(input);
    std::error_code error;
    return !input.format && fs::is_regular_file(path, error) && isMapFile(path, nameOfOpen(input));
}

std::string mapName(const InputOptions& input) {
    if (!input.opened) return resolveInputPath(input);
    const std::string shown = input.opened->hasFolder() ? fs::path(input.path).filename().string() : "map";
    return std::string(kOpen) + fileHash(input.opened->path()) + "/" + shown;
}

DensityMap readMapInput(const InputOptions& input) {
    return readMapFile(openedPath(input), mapLimits(input), nameOfOpen(input));
}

std::shared_ptr<const DensityMap> openMap(const InputOptions& input) {
    const std::string name = mapName(input);
    if (auto held = openMaps().find(name)) return held;
    auto map = std::make_shared<const DensityMap>(readMapInput(input));
    openMaps().add(name, map);
    return map;
}

std::shared_ptr<const DensityMap> loadMap(const std::string& path, const MapLimits& limits) {
    if (path.starts_with(kOpen)) {
        if (auto held = openMaps().find(path)) return held;
        throw Error("cannot read map", path.substr(path.rfind('/') + 1), "it has changed since it was opened");
    }
    const std::optional<FileState> state = readState(path);
    if (auto kept = keptMaps().find(path, state)) return kept;
    auto map = std::make_shared<const DensityMap>(readMapFile(path, limits));
    keptMaps().keep(path, state, map, limits.maxBytes);
    return map;
}

void keepMap(const std::string& name, std::shared_ptr<const DensityMap> map) {
    keptMaps().keep(name, {}, std::move(map), memoryShare(4));
}
std::shared_ptr<const DensityMap> keptMap(const std::string& name) { return keptMaps().find(name); }

}  // namespace nacre::app
