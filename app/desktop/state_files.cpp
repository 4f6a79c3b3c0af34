#include "app/desktop/state_files.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/headless/output_file.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMagic = 0x31434c5045434e4eull;  // "NNCEPLC1"
constexpr std::uintmax_t kLargestCache = 256u << 20;

/// Folder of a kind of files; empty if the environment names none.
fs::path folder(const char* variable, const char* underHome) {
    if (const char* set = std::getenv(variable); set && *set == '/') return fs::path(set) / "nacre";
    if (const char* home = std::getenv("HOME"); home && *home == '/') return fs::path(home) / underHome / "nacre";
    return {};
}

void write(const fs::path& directory, const char* name, const std::string& content) {
    if (directory.empty()) return;
    try {
        fs::create_directories(directory);
        OutputFile file((directory / name).string());
        writeText(file, content);
    } catch (const std::exception&) {
        // A full or read-only home is no reason to lose the window.
    }
}

/// FNV-1a, 64 bits: tells a cut or damaged file.
std::uint64_t hashOf(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return hash;
}

}  // namespace

std::optional<SavedView> loadState() {
    const fs::path directory = folder("XDG_STATE_HOME", ".local/state");
    if (directory.empty()) return std::nullopt;
    try {
        return readSavedView((directory / "view.json").string());
    } catch (const Error&) {
        return std::nullopt;
    }
}

void saveState(const SavedView& view) {
    write(folder("XDG_STATE_HOME", ".local/state"), "view.json", savedViewJson(view));
}

std::vector<std::byte> loadPipelineCache() {
    const fs::path path = folder("XDG_CACHE_HOME", ".cache") / "pipelines.bin";
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error || size < 16 || size > kLargestCache) return {};
    std::ifstream stream(path, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (content.size() < 16) return {};
    std::uint64_t head[2];
    std::memcpy(head, content.data(), sizeof head);
    const std::string_view data = std::string_view(content).substr(sizeof head);
    if (head[0] != kMagic || head[1] != hashOf(data)) return {};
    std::vector<std::byte> bytes(data.size());
    std::memcpy(bytes.data(), data.data(), data.size());
    return bytes;
}

void savePipelineCache(const std::vector<std::byte>& data) {
    if (data.empty() || data.size() > kLargestCache) return;
    const std::string_view bytes(reinterpret_cast<const char*>(data.data()), data.size());
    const std::uint64_t head[2] = {kMagic, hashOf(bytes)};
    std::string content(reinterpret_cast<const char*>(head), sizeof head);
    write(folder("XDG_CACHE_HOME", ".cache"), "pipelines.bin", content.append(bytes));
}

std::string freeName(const std::string& input, const std::string& extension) {
    std::string stem =
        fs::path(input.substr(input.find(':') == std::string::npos ? 0 : input.find(':') + 1)).filename().string();
    if (const std::size_t dot = stem.find('.', 1); dot != std::string::npos) stem.resize(dot);
    if (stem.empty() || stem == "-") stem = "nacre";
    for (int n = 1;; ++n) {
        const std::string name = stem + (n == 1 ? "" : "-" + std::to_string(n)) + extension;
        if (!fs::exists(name)) return name;
    }
}

}  // namespace nacre::app
