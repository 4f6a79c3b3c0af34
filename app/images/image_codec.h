#pragma once
// The one call into the module that knows image formats. It brings hundreds of libraries with it, which a program that
// writes no picture does not load.

#include <cstdint>

namespace nacre::app {

enum class Samples { bytes, words, halves, floats };  ///< in the file; halves are handed over as floats

struct ImageRequest {
    const char* path;  ///< a plain file that is there; its extension tells the format
    std::uint32_t width, height, channels;
    Samples samples;
    const char* const* channelNames;  ///< null: grey, RGB, RGBA as their number tells
    int alphaChannel, depthChannel;   ///< -1: none
    float dotsPerInch;                ///< 0: not said
    /// Rows from `first` on, interleaved; good until the next call.
    const void* (*rows)(void* context, std::uint32_t first, std::uint32_t count);
    void* context;
};

constexpr std::uint32_t kRowsAtOnce = 64;  ///< that are asked for at most

/// Writes a picture. @param why in words, of a failure @returns whether it is whole and on disk
using WriteImage = bool(const ImageRequest* request, char* why, std::size_t whyBytes);

}  // namespace nacre::app

extern "C" nacre::app::WriteImage nacreWriteImage;
/// Of this file, in the module: a module of another build, to whom a request is something else, is told by it.
extern "C" const char nacreImageCall[];
