#pragma once
// Upper memory bound of a molecule, from reading to the scene on the device, and the largest molecule that fits.

#include <cstdint>

#include "engine/molecule/read.h"

namespace nacre {

/// Host and device together, per atom, with its bonds and sticks, including the peak while reading. Excludes fixed
/// costs of programs and drivers (lavapipe: about 100 MB for large scenes). Verified by a test.
constexpr std::uint64_t kBytesPerAtom = 700;
/// The file's text stays in memory while it is read, and inflated text briefly twice.
constexpr std::uint64_t kBytesPerTextByte = 2;
/// Occlusion has its own limit: RenderSettings::occlusionBytes.

// A window's frame takes 28 bytes of device memory per pixel: depth 4, encoded depth 8 at most, colour
// 4, three swapchain images 12. Refinement of a still picture adds up to ViewerOptions::refinedPixels samples of 16
// bytes each, or 4 where depth never leaves the tile.

/// Host and device together, per pixel of a picture for a file, counting supersamples.
constexpr std::uint64_t kBytesPerPicturePixel = 64;

/// Limits for reading a molecule that fits. Reading stops at the first atom or byte too many.
/// @param bytes  memory for the molecule alone
inline ReadOptions readWithin(std::uint64_t bytes, ReadOptions options = {}) {
    const std::uint64_t text = bytes / 2 / kBytesPerTextByte, atoms = bytes / 2 / kBytesPerAtom;
    if (text < options.maxBytes) options.maxBytes = static_cast<std::size_t>(text);
    if (atoms < options.maxAtoms) options.maxAtoms = static_cast<std::size_t>(atoms);
    return options;
}

}  // namespace nacre
