#pragma once
// The only call into the module for image formats. It loads their libraries, which programs that write PNG do not need.

#include <cstdint>

namespace nacre::app {

enum class Samples { bytes, words, halves, floats };  ///< in the file; halves are passed as floats

struct ImageRequest {
    const char* path;       ///< of the file, for the libraries' messages
    int file;               ///< open for reading and writing, empty; stays open
    const char* extension;  ///< decides the format: ".webp"
    std::uint32_t width, height, channels;
    Samples samples;
    const char* const* channelNames;  ///< null: grey, RGB or RGBA by their number
    int alphaChannel, depthChannel;   ///< -1: none
    float dotsPerInch;                ///< 0: not stated
    /// Rows from `first` on, interleaved; valid until the next call.
    const void* (*rows)(void* context, std::uint32_t first, std::uint32_t count);
    void* context;
};

constexpr std::uint32_t kRowsAtOnce = 64;  ///< maximum per call

/// Writes a picture. @param why  receives the reason of a failure @returns whether it is complete and on disk
using WriteImage = bool(const ImageRequest* request, char* why, std::size_t whyBytes);

}  // namespace nacre::app

extern "C" nacre::app::WriteImage nacreWriteImage;
/// Version of this interface, in the module: detects a module from another build.
extern "C" const char nacreImageCall[];
