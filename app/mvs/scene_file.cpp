#include "app/mvs/scene_file.h"

#include <filesystem>
#include <fstream>

#include "engine/error.h"

namespace nacre::app::mvs {
namespace {

constexpr std::uint64_t kMostArchiveBytes = 512ull << 20;

[[noreturn]] void refuseLarge(const std::string& path) {
    throw Error("cannot read scene", path, "it is larger than " + std::to_string(kMostArchiveBytes >> 20) + " MiB");
}

/// Reads a file until it is known to be a scene. @returns the bytes read; empty: it is none, or cannot be read
std::string beginningOfScene(const std::string& path, std::ifstream& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return {};
    const bool tooLarge = std::filesystem::file_size(path, error) > kMostSceneBytes;
    file.open(path, std::ios::binary);
    std::string bytes;
    for (std::size_t size = 4096;; size *= 2) {
        const std::size_t before = bytes.size();
        bytes.resize(size);
        file.read(bytes.data() + before, static_cast<std::streamsize>(size - before));
        bytes.resize(before + static_cast<std::size_t>(file.gcount()));
        if (looksLikeArchive(bytes)) return bytes;
        if (tooLarge || error || !mayBeScene(bytes)) return {};
        if (looksLikeScene(bytes)) return bytes;
        if (bytes.size() < size) return {};
    }
}

}  // namespace

bool isScene(std::string_view bytes) { return looksLikeArchive(bytes) || looksLikeScene(bytes); }

std::optional<std::string> readScene(const std::string& path) {
    std::ifstream file;
    std::string bytes = beginningOfScene(path, file);
    if (bytes.empty()) return std::nullopt;
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (error) throw Error("cannot read scene", path, error.message());
    if (size > kMostArchiveBytes) refuseLarge(path);
    const std::size_t before = bytes.size();
    if (size <= before) return bytes;
    bytes.resize(size);
    file.read(bytes.data() + before, static_cast<std::streamsize>(size - before));
    bytes.resize(before + static_cast<std::size_t>(file.gcount()));
    return bytes;
}

bool isSceneFile(const std::string& path) {
    std::ifstream file;
    return !beginningOfScene(path, file).empty();
}

std::string readSceneBytes(const std::string& path) {
    std::optional<std::string> bytes = readScene(path);
    if (!bytes) throw Error("cannot read scene", path, "it is none");
    return std::move(*bytes);
}

std::string sceneText(const std::string& name, std::string bytes) {
    return looksLikeArchive(bytes) ? SceneArchive(name, std::move(bytes)).read("index.mvsj") : bytes;
}

SceneFile::SceneFile(const std::string& itsName, std::string bytes) : name(itsName) {
    if (looksLikeArchive(bytes)) {
        archive = std::make_unique<SceneArchive>(name, std::move(bytes));
        bytes = archive->read("index.mvsj");
    }
    tree = parseScene(bytes, name);
}

}  // namespace nacre::app::mvs
