#pragma once
// Draws the frames of a movie into its file.

#include <cstdint>
#include <functional>

#include "app/movie/movie_file.h"

namespace nacre::app {

enum class MovieStage { palette, frames, writing };

struct MovieFrames {
    std::uint64_t count;
    std::function<Picture(std::uint64_t)> draw;  ///< a frame, in any order
    /// Called before each picture, and after the last one, with the number of frames in the file. Returning false ends
    /// the movie early.
    std::function<bool(MovieStage, std::uint64_t)> goesOn;
};

/// @returns the number of frames in the file; 0: none was drawn, and no file exists @throws Error
std::uint64_t writeMovie(MovieFile& file, const MovieFrames& frames);

}  // namespace nacre::app
