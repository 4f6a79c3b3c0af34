#pragma once
// Movies to files: an interface, and one writer a format behind it.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/picture/option_values.h"
#include "engine/results.h"

namespace nacre::app {

constexpr double kSlowestMovie = 0.1, kFastestMovie = 120;  ///< frames a second
constexpr double kFastestGif = 50;  ///< shorter delays than 20 ms are taken for 100 ms by browsers
constexpr std::uint64_t kMostMovieFrames = 100'000;

/// What is known of a movie beforehand.
struct MovieShape {
    Size size;
    double framesPerSecond = 30;
    bool alpha = false;        ///< the background is not opaque: kept where the format can, otherwise over white
    std::uint64_t frames = 1;  ///< at most
};

/// A movie that is being written. It appears whole or not at all, or for a folder frame by frame. Each call is for one
/// thread at a time, whichever that is.
class MovieFile {
public:
    virtual ~MovieFile() = default;
    /// Whether sample() wants some of the movie's pictures before the first is added: for a palette.
    virtual bool wantsSamples() const { return false; }
    virtual void sample(const Picture&) {}
    /// The next frame, of the movie's size. @throws Error
    virtual void add(const Picture& picture) = 0;
    /// Puts the movie in its place, as long as it has become: at least one frame. @throws Error
    virtual void finish() = 0;
};

/// Whether a movie can be written under this name: .mp4, .webm, .gif, .png (animated), "-" (that to standard output),
/// or a folder: a name that ends in '/', or one that is there.
bool isMovieName(const std::string& path);
bool isFrameFolder(const std::string& path);
std::vector<std::string> movieEndings();

/// Makes the files, or starts the program that does, so that what cannot be is refused before any work.
/// @throws Error
std::unique_ptr<MovieFile> makeMovieFile(const std::string& path, const MovieShape& shape);

/// sRGB bytes of a picture, row by row from the top: three a pixel over white, or four with straight alpha. The very
/// values that writePicture() puts into a PNG.
void codePicture(const Picture& picture, bool alpha, std::vector<std::uint8_t>& bytes);

/// A rectangle of pixels.
struct PixelBox {
    std::uint32_t x = 0, y = 0, width = 1, height = 1;
};
/// Where two pictures of a size differ; one pixel if nowhere. @param channels bytes a pixel
PixelBox changedBox(const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& after, const Size& size,
                    std::size_t channels);

// The writers, for makeMovieFile() alone.
std::unique_ptr<MovieFile> makeAnimatedPng(const std::string& path, const MovieShape& shape);
std::unique_ptr<MovieFile> makeGif(const std::string& path, const MovieShape& shape);
std::unique_ptr<MovieFile> makeVideo(const std::string& path, const MovieShape& shape);
std::unique_ptr<MovieFile> makeFrameFolder(const std::string& path, const MovieShape& shape);

}  // namespace nacre::app
