#include "app/files/cache_folder.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "engine/error.h"

namespace nacre::app {
namespace fs = std::filesystem;

namespace {

/// The XDG Base Directory Specification: a relative path counts as not set.
std::string usualFolder() {
    const fs::path xdg = environmentVariable("XDG_CACHE_HOME"), home = environmentVariable("HOME");
    if (xdg.is_absolute()) return (xdg / "nacre").string();
    if (home.is_absolute()) return (home / ".cache" / "nacre").string();
    return {};
}

/// Why a folder cannot be written to; empty if it can. Creates the folder.
std::string hindrance(const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return error.message();
    return access(folder.c_str(), W_OK | X_OK) == 0 ? std::string() : std::strerror(errno);
}

}  // namespace

std::string environmentVariable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::string cacheFolder(const std::optional<std::string>& asked, const std::string& name) {
    const std::string set = environmentVariable("NACRE_CACHE");
    std::string folder = asked ? *asked : set.empty() ? usualFolder() : set;
    if (folder.empty() || folder == "off") return {};
    const std::string why = hindrance(folder);
    if (why.empty()) return (fs::path(folder) / name).string();
    if (asked || !set.empty()) throw Error("cannot use cache", folder, why);
    return {};
}

}  // namespace nacre::app
