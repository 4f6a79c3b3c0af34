#pragma once
// Writes movies to files: an interface, and one writer per format.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/files/output_file.h"
#include "app/picture/option_values.h"
#include "engine/results.h"

namespace nacre::app {

constexpr double kSlowestMovie = 0.1, kFastestMovie = 120;  ///< frames per second
constexpr double kFastestGif = 50;                          ///< browsers play delays below 20 ms as 100 ms
constexpr std::uint64_t kMostMovieFrames = 100'000;

/// Properties of a movie known beforehand.
struct MovieShape {
    Size size;
    double framesPerSecond = 30;
    bool alpha = false;        ///< the background is not opaque: kept if the format allows, otherwise over white
    std::uint64_t frames = 1;  ///< maximum
};

/// A movie being written. It appears complete or not at all; in a folder, frame by frame. For one thread at a time.
class MovieFile {
public:
    virtual ~MovieFile() = default;
    /// Whether the writer needs sample() with some pictures before the first add(), for a palette.
    virtual bool wantsSamples() const { return false; }
    virtual void sample(const Picture&) {}
    /// The next frame, of the movie's size. @throws Error
    virtual void add(const Picture& picture) = 0;
    /// Moves the movie to its place with the frames so far: at least one. @throws Error
    virtual void finish() = 0;
};

/// Whether a movie can be written under this name: .mp4, .webm, .gif, .png (animated), "-" (animated PNG to standard
/// output), or a folder: a name that ends in '/', or an existing folder.
bool isMovieName(const std::string& path);
bool isFrameFolder(const std::string& path);
std::vector<std::string> movieEndings();

/// Creates the files, or starts the encoder, so that failures show before any work. @throws Error
std::unique_ptr<MovieFile> makeMovieFile(const std::string& path, const MovieShape& shape);

/// A rectangle of pixels.
struct PixelBox {
    std::uint32_t x = 0, y = 0, width = 1, height = 1;
};
/// Bounding box of the differences between two pictures of equal size; one pixel if there are none. @param channels
/// bytes per pixel
PixelBox changedBox(const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& after, const Size& size,
                    std::size_t channels);

// The writers, for makeMovieFile() only.
std::unique_ptr<MovieFile> makeAnimatedPng(const std::string& path, const MovieShape& shape);
std::unique_ptr<MovieFile> makeGif(const std::string& path, const MovieShape& shape);
std::unique_ptr<MovieFile> makeVideo(const std::string& path, const MovieShape& shape);
std::unique_ptr<MovieFile> makeFrameFolder(const std::string& path, const MovieShape& shape);

/// A file written sequentially, with every failure reported.
class CheckedStream {
public:
    /// @param extension  of a temporary file for standard output @throws Error
    explicit CheckedStream(const std::string& path, const std::string& extension = {});
    ~CheckedStream();
    CheckedStream(const CheckedStream&) = delete;
    CheckedStream& operator=(const CheckedStream&) = delete;

    /// Appends. @throws Error
    void write(const void* bytes, std::size_t count);
    /// Overwrites existing bytes. @throws Error
    void writeAt(std::uint64_t offset, const void* bytes, std::size_t count);
    /// Closes the file and moves it to its place. @throws Error
    void commit();
    const std::string& path() const { return file_.path(); }

private:
    OutputFile file_;
    int stream_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace nacre::app
