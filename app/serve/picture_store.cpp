#include "app/serve/picture_store.h"

#include <xxhash.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include "app/files/output_file.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::string contentKey(const std::string& bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return text;
}

PictureStore::PictureStore(std::string folder, std::uint64_t bytes) : folder_(std::move(folder)), most_(bytes) {
    std::error_code error;
    if (folder_.empty()) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) held_ += entry.file_size(error);
}

std::optional<std::string> PictureStore::find(const std::string& name) const {
    if (folder_.empty()) return std::nullopt;
    const fs::path path = fs::path(folder_) / name;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::error_code error;
    fs::last_write_time(path, fs::file_time_type::clock::now(), error);
    return bytes;
}

void PictureStore::keep(const std::string& name, const std::string& picture) {
    if (folder_.empty() || picture.size() > most_ / 4) return;
    const std::lock_guard lock(turn_);
    try {
        OutputFile file((fs::path(folder_) / name).string());
        writeText(file, picture);
        held_ += picture.size();
        if (held_ > most_) makeRoom();
    } catch (const Error&) {
    }
}

void PictureStore::makeRoom() {
    struct Kept {
        fs::path path;
        fs::file_time_type used;
        std::uint64_t bytes;
    };
    std::vector<Kept> all;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error))
        all.push_back({entry.path(), entry.last_write_time(error), entry.file_size(error)});
    std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
    held_ = 0;
    for (const Kept& kept : all) held_ += kept.bytes;
    for (const Kept& kept : all) {
        if (held_ <= most_ / 10 * 9) return;
        if (fs::remove(kept.path, error)) held_ -= kept.bytes;
    }
}

}  // namespace nacre::app
