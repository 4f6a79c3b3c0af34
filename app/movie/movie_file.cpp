#include "app/movie/movie_file.h"

#include <algorithm>
#include <filesystem>

#include "app/files/output_file.h"

namespace nacre::app {

bool isFrameFolder(const std::string& path) {
    std::error_code error;
    return path.ends_with('/') || std::filesystem::is_directory(path, error);
}

std::vector<std::string> movieEndings() { return {".mp4", ".webm", ".gif", ".png"}; }

bool isMovieName(const std::string& path) {
    return isStandardOutput(path) || isFrameFolder(path) || std::ranges::count(movieEndings(), extensionOf(path)) > 0;
}

std::unique_ptr<MovieFile> makeMovieFile(const std::string& path, const MovieShape& shape) {
    if (!isStandardOutput(path) && isFrameFolder(path)) return makeFrameFolder(path, shape);
    const std::string extension = extensionOf(path);
    if (extension == ".mp4" || extension == ".webm") return makeVideo(path, shape);
    if (extension == ".gif") return makeGif(path, shape);
    return makeAnimatedPng(path, shape);
}

PixelBox changedBox(const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& after, const Size& size,
                    std::size_t channels) {
    const std::size_t row = std::size_t{size.width} * channels;
    std::size_t top = size.height, bottom = 0, left = row, right = 0;
    for (std::size_t y = 0; y < size.height; ++y) {
        const auto a = before.begin() + static_cast<std::ptrdiff_t>(y * row);
        const auto b = after.begin() + static_cast<std::ptrdiff_t>(y * row);
        const auto end = a + static_cast<std::ptrdiff_t>(row);
        const auto first = std::mismatch(a, end, b).first;
        if (first == end) continue;
        top = std::min(top, y);
        bottom = y;
        left = std::min(left, static_cast<std::size_t>(first - a));
        std::size_t last = row - 1;
        while (last > right && a[static_cast<std::ptrdiff_t>(last)] == b[static_cast<std::ptrdiff_t>(last)]) --last;
        right = std::max(right, last);
    }
    if (top == size.height) return {};
    const auto x = static_cast<std::uint32_t>(left / channels), end = static_cast<std::uint32_t>(right / channels + 1);
    return {x, static_cast<std::uint32_t>(top), end - x, static_cast<std::uint32_t>(bottom - top + 1)};
}

}  // namespace nacre::app
