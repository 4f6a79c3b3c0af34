#include "app/desktop/state_files.h"

#include <cstdlib>
#include <filesystem>

#include "app/viewer/kept_files.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

/// Path of a file of a kind; empty if the environment names no folder.
std::string pathOf(const char* variable, const char* underHome, const char* name) {
    if (const char* set = std::getenv(variable); set && *set == '/') return fs::path(set) / "nacre" / name;
    if (const char* home = std::getenv("HOME"); home && *home == '/')
        return fs::path(home) / underHome / "nacre" / name;
    return {};
}

std::string viewPath() { return pathOf("XDG_STATE_HOME", ".local/state", "view.json"); }
std::string pipelinePath() { return pathOf("XDG_CACHE_HOME", ".cache", "pipelines.bin"); }

}  // namespace

std::string recentPath() { return pathOf("XDG_STATE_HOME", ".local/state", "recent.json"); }
std::optional<PictureDescription> loadState() { return loadView(viewPath()); }
void saveState(const PictureDescription& view) { keepView(viewPath(), view); }
std::vector<std::byte> loadPipelineCache() { return loadPipelineCache(pipelinePath()); }
void savePipelineCache(const std::vector<std::byte>& data) { keepPipelineCache(pipelinePath(), data); }

std::string freeName(const std::string& input, const std::string& extension) {
    std::string stem =
        fs::path(input.substr(input.find(':') == std::string::npos ? 0 : input.find(':') + 1)).filename().string();
    if (const std::size_t dot = stem.find('.', 1); dot != std::string::npos) stem.resize(dot);
    if (stem.empty() || stem == "-") stem = "nacre";
    for (int n = 1;; ++n) {
        std::string name = stem;
        if (n > 1) name.append("-").append(std::to_string(n));
        name += extension;
        if (!fs::exists(name)) return name;
    }
}

}  // namespace nacre::app
