#include "app/mvs/scene_file.h"

#include <array>
#include <filesystem>
#include <fstream>

#include "engine/error.h"

namespace nacre::app::mvs {
namespace {

constexpr std::uint64_t kMostArchiveBytes = 512ull << 20;

enum class Beginning { archive, object, other };

/// How a file begins: as an archive, or as JSON that may be a scene.
Beginning beginningOf(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return Beginning::other;
    std::ifstream file(path, std::ios::binary);
    std::array<char, 4096> start{};
    file.read(start.data(), start.size());
    const std::string_view head(start.data(), static_cast<std::size_t>(file.gcount()));
    if (looksLikeArchive(head)) return Beginning::archive;
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || head[first] != '{') return Beginning::other;
    if (head.find("\"data_") < 64 || std::filesystem::file_size(path, error) > kMostSceneBytes) return Beginning::other;
    return Beginning::object;
}

}  // namespace

bool isScene(std::string_view bytes) { return looksLikeArchive(bytes) || looksLikeScene(bytes); }

std::optional<std::string> readScene(const std::string& path) {
    const Beginning beginning = beginningOf(path);
    if (beginning == Beginning::other) return std::nullopt;
    std::string bytes = readSceneBytes(path);
    if (beginning == Beginning::object && !looksLikeScene(bytes)) return std::nullopt;
    return bytes;
}

bool isSceneFile(const std::string& path) {
    return beginningOf(path) == Beginning::archive || readScene(path).has_value();
}

std::string readSceneBytes(const std::string& path) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (error) throw Error("cannot read scene", path, error.message());
    if (size > kMostArchiveBytes)
        throw Error("cannot read scene", path, "it is larger than " + std::to_string(kMostArchiveBytes >> 20) + " MiB");
    std::string bytes(size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

SceneFile::SceneFile(const std::string& itsName, std::string bytes) : name(itsName) {
    if (looksLikeArchive(bytes)) {
        archive = std::make_unique<SceneArchive>(name, std::move(bytes));
        bytes = archive->read("index.mvsj");
    }
    tree = parseScene(bytes, name);
}

}  // namespace nacre::app::mvs
