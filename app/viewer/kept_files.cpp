#include "app/viewer/kept_files.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <mutex>

#include "app/files/output_file.h"
#include "engine/error.h"
#include "engine/storage/plain_file.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMagic = 0x31434c5045434e4eull;  // "NNCEPLC1"
constexpr std::uint64_t kLargestCache = 256u << 20, kLargestView = 1u << 20;

void write(const std::string& path, const std::string& content) {
    if (path.empty()) return;
    static std::mutex oneAtATime;  // as OutputFile requires
    const std::lock_guard lock(oneAtATime);
    try {
        fs::create_directories(fs::path(path).parent_path());
        OutputFile file(path);
        writeText(file, content);
    } catch (const std::exception&) {
        // A full or read-only disk must not close the window.
    }
}

/// FNV-1a, 64 bits: detects a truncated or damaged file.
std::uint64_t hashBytes(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return hash;
}

}  // namespace

std::optional<PictureDescription> loadView(const std::string& path) {
    const auto json = readPlain(path, kLargestView);
    if (!json) return std::nullopt;
    try {
        return parseSavedView(*json, path);
    } catch (const Error&) {
        return std::nullopt;
    }
}

void keepText(const std::string& path, const std::string& text) { write(path, text); }

void keepView(const std::string& path, const PictureDescription& view) { write(path, savedViewJson(view)); }

std::vector<std::byte> loadPipelineCache(const std::string& path) {
    const std::string content = readPlain(path, kLargestCache).value_or("");
    if (content.size() < 16) return {};
    std::uint64_t head[2];
    std::memcpy(head, content.data(), sizeof head);
    const std::string_view data = std::string_view(content).substr(sizeof head);
    if (head[0] != kMagic || head[1] != hashBytes(data)) return {};
    std::vector<std::byte> bytes(data.size());
    std::memcpy(bytes.data(), data.data(), data.size());
    return bytes;
}

void keepPipelineCache(const std::string& path, const std::vector<std::byte>& data) {
    if (data.empty() || data.size() > kLargestCache) return;
    const std::string_view bytes(reinterpret_cast<const char*>(data.data()), data.size());
    const std::uint64_t head[2] = {kMagic, hashBytes(bytes)};
    std::string content(reinterpret_cast<const char*>(head), sizeof head);
    write(path, content.append(bytes));
}

}  // namespace nacre::app
