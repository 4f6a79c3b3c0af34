#include "app/input/input_files.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/files/opened_file.h"
#include "app/picture/appearance_values.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace fs = std::filesystem;

namespace {

/// "sample:dna" and "pdb:1bna" are not files; names with a colon after a folder are.
bool isFile(const std::string& path) { return path != "-" && path.find('/') <= path.find(':'); }

fs::path real(const fs::path& path) {
    std::error_code error;
    const fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? path : found;
}

constexpr int kMostNeighbours = 1000;  // files examined next to a view

using ComputeHash = std::string (*)(const std::string& path);

/// The file next to a view with the content that the view states; tries its own name first.
fs::path beside(const fs::path& folder, const fs::path& name, const std::string& hash, ComputeHash computeHash) {
    if (computeHash((folder / name).string()) == hash) return folder / name;
    std::error_code error;
    int seen = 0;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (++seen > kMostNeighbours) break;
        const std::uintmax_t bytes = entry->is_regular_file(error) ? entry->file_size(error) : 0;
        if (!error && hash.starts_with(std::to_string(bytes) + "-") && computeHash(entry->path().string()) == hash)
            return folder / entry->path().filename();
    }
    return {};
}

/// @param most  bytes to read at either end; 0: all
std::string hashOfFile(const std::string& path, std::uint64_t most) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return {};
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) return {};
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
    XXH3_64bits_reset(state.get());
    std::array<char, 1 << 16> buffer{};
    const std::uint64_t size = fs::file_size(path, error);
    const bool ends = most > 0 && size > 2 * most;
    std::uint64_t bytes = 0;
    for (std::size_t count; (count = std::fread(buffer.data(), 1, buffer.size(), file.get())) > 0;) {
        XXH3_64bits_update(state.get(), buffer.data(), count);
        bytes += count;
        if (ends && bytes == most) {  // a multiple of the buffer
            if (std::fseek(file.get(), -static_cast<long>(most), SEEK_END) != 0) return {};
            bytes = size - most;
        }
    }
    if (std::ferror(file.get())) return {};
    return std::to_string(bytes) +
           formatted("-%016llx", static_cast<unsigned long long>(XXH3_64bits_digest(state.get())));
}

bool isOutside(const std::string& view, const std::string& path) {
    const fs::path file = real(path), folder = real(view).parent_path();
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first != folder.end();
}

std::string outsideText(const std::string& view, const std::string& path) {
    return view + " has this file opened, which is not in its folder: " + real(path).string();
}

}  // namespace

std::string pathInView(const std::string& view, const std::string& path) {
    if (path.empty() || !isFile(path) || isOutside(view, path)) return path;
    return real(path).lexically_relative(real(view).parent_path()).string();
}

std::string fileHash(const std::string& path) { return hashOfFile(path, 0); }

std::string trajectoryHash(const std::string& path) { return hashOfFile(path, std::uint64_t{16} << 20); }

PictureDescription withPathsIn(const std::string& view, PictureDescription picture) {
    const auto move = [&](std::string& file) { file = pathInView(view, file); };
    InputOptions& input = picture.input;
    input.path = resolveInputPath(input);
    input.hash = fileHash(input.path);
    input.trajectory.hash = trajectoryHash(input.trajectory.path);
    move(input.path);
    move(input.trajectory.path);
    for (FurtherInput& further : input.further) {
        further.hash = fileHash(further.path);
        move(further.path);
    }
    changeMapFiles(picture.maps, [&](const std::string& map) { return pathInView(view, map); });
    for (PrimitiveSource& source : picture.primitives)
        if (!source.made && !isJsonText(source.text)) move(source.text);
    for (Coloring& table : picture.look.colorFrom)
        if (!table.table && !isTableText(table.source)) move(table.source);
    return picture;
}

std::string resolveInputPath(const InputOptions& input) {
    if (input.namedBy.empty() || !isFile(input.path)) return input.path;
    const fs::path folder = fs::path(input.namedBy).parent_path(),
                   named = folder / input.path;  // an absolute path stays
    std::error_code error;
    if (input.hash.empty() || fs::exists(named, error)) return named.string();
    const fs::path moved = beside(folder, fs::path(input.path).filename(), input.hash, fileHash);
    return moved.empty() ? named.string() : moved.string();
}

std::string openedPath(const InputOptions& input) {
    return input.opened ? input.opened->path() : resolveInputPath(input);
}

std::string resolveTrajectoryPath(const InputOptions& input) {
    const fs::path path = input.trajectory.path;
    if (input.namedBy.empty() || path.empty()) return path.string();
    const fs::path folder = fs::path(input.namedBy).parent_path();
    const std::string& hash = input.trajectory.hash;
    std::error_code error;
    if (fs::exists(folder / path, error)) return (folder / path).string();
    if (!hash.empty()) {
        const fs::path moved = beside(folder, path.filename(), hash, trajectoryHash);
        return moved.empty() ? (folder / path).string() : moved.string();
    }
    return fs::exists(folder / path.filename(), error) ? (folder / path.filename()).string() : (folder / path).string();
}

std::vector<std::string> trajectoryNotices(const TrajectoryOptions& trajectory) {
    std::vector<std::string> notices;
    const std::string& path = trajectory.path;
    if (trajectory.namedBy.empty() || path.empty()) return notices;
    if (isOutside(trajectory.namedBy, path)) notices.push_back(outsideText(trajectory.namedBy, path));
    std::error_code error;
    if (!trajectory.hash.empty() && fs::is_regular_file(path, error) && trajectoryHash(path) != trajectory.hash)
        notices.push_back(path + " has changed since " + trajectory.namedBy + " was saved");
    return notices;
}

std::string outsideNotice(const InputOptions& input) {
    if (input.namedBy.empty() || !isFile(input.path) || !isOutside(input.namedBy, resolveInputPath(input))) return {};
    return outsideText(input.namedBy, resolveInputPath(input));
}

}  // namespace nacre::app
