#include "app/movie/movie_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "app/files/messages.h"
#include "app/images/image_file.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;

std::string frameName(std::uint64_t number) {
    char name[40];
    std::snprintf(name, sizeof name, "frame_%05llu.png", static_cast<unsigned long long>(number));
    return name;
}

/// Frames as separate pictures: frames/frame_00001.png, each as `nacre render` would write it.
class FrameFolder : public MovieFile {
public:
    FrameFolder(const std::string& path, const MovieShape& shape) : folder_(path), shape_(shape) {
        std::error_code error;
        fs::create_directories(folder_, error);
        if (error) throw Error("cannot write folder", path, error.message());
    }

    void add(const Picture& picture) override {
        OutputFile file((folder_ / frameName(++frames_)).string());
        writePicture(file, picture, {shape_.alpha});
    }

    void finish() override {
        const fs::path next = folder_ / frameName(frames_ + 1);
        std::error_code error;
        if (fs::exists(next, error))
            sayWarning(folder_.string() + " holds frames of another movie: " + next.filename().string() +
                       " and maybe more");
    }

private:
    fs::path folder_;
    MovieShape shape_;
    std::uint64_t frames_ = 0;
};

}  // namespace

bool isFrameFolder(const std::string& path) {
    std::error_code error;
    return path.ends_with('/') || std::filesystem::is_directory(path, error);
}

std::vector<std::string> movieEndings() { return {".mp4", ".webm", ".gif", ".png"}; }

bool isMovieName(const std::string& path) {
    return isStandardOutput(path) || isFrameFolder(path) || std::ranges::count(movieEndings(), fileExtension(path)) > 0;
}

std::unique_ptr<MovieFile> makeMovieFile(const std::string& path, const MovieShape& shape) {
    if (!isStandardOutput(path) && isFrameFolder(path)) return makeFrameFolder(path, shape);
    const std::string extension = fileExtension(path);
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

CheckedStream::CheckedStream(const std::string& path, const std::string& extension) : file_(path, extension) {
    stream_ = ::open(file_.temporary().c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
    if (stream_ < 0) throw Error("cannot write file", file_.path(), std::strerror(errno));
}

CheckedStream::~CheckedStream() {
    if (stream_ >= 0) ::close(stream_);
}

void CheckedStream::write(const void* bytes, std::size_t count) {
    writeAt(size_, bytes, count);
    size_ += count;
}

void CheckedStream::writeAt(std::uint64_t offset, const void* bytes, std::size_t count) {
    for (std::size_t done = 0; done < count;) {
        const ssize_t n =
            ::pwrite(stream_, static_cast<const char*>(bytes) + done, count - done, static_cast<off_t>(offset + done));
        if (n > 0) done += static_cast<std::size_t>(n);
        if (n == 0 || (n < 0 && errno != EINTR))
            throw Error("cannot write file", file_.path(), std::strerror(n == 0 ? ENOSPC : errno));
    }
}

void CheckedStream::commit() {
    const int stream = stream_;
    stream_ = -1;
    if (::close(stream) != 0) throw Error("cannot write file", file_.path(), std::strerror(errno));
    file_.commit();
}

std::unique_ptr<MovieFile> makeFrameFolder(const std::string& path, const MovieShape& shape) {
    return std::make_unique<FrameFolder>(path, shape);
}

}  // namespace nacre::app
