#include "app/shared/view_input.h"

#include <algorithm>
#include <filesystem>

namespace nacre::app {
namespace fs = std::filesystem;

namespace {

/// "sample:dna" and "pdb:1bna" are none; a name that holds a colon is one if a folder stands before it.
bool isFile(const std::string& path) { return path != "-" && path.find('/') <= path.find(':'); }

fs::path real(const fs::path& path) {
    std::error_code error;
    const fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? path : found;
}

}  // namespace

std::string filePathOf(const InputOptions& input) {
    if (input.namedBy.empty() || !isFile(input.path)) return input.path;
    return (fs::path(input.namedBy).parent_path() / input.path).string();  // an absolute one stays
}

std::string outsideNotice(const InputOptions& input) {
    if (input.namedBy.empty() || !isFile(input.path)) return {};
    const fs::path file = real(filePathOf(input)), folder = real(input.namedBy).parent_path();
    if (std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end()) return {};
    return input.namedBy + " has this file opened, which is not in its folder: " + file.string();
}

}  // namespace nacre::app
