#pragma once
// How much memory a molecule takes at most, from reading to the scene on the device; and how large a molecule fits.

#include <cstdint>

#include "engine/molecule/read.h"

namespace nacre {

/// Host and device together, per atom that is read, with its bonds and sticks; the peak while it is read, too. Beyond
/// what programs and drivers take for any molecule, lavapipe some 100 MB for large scenes. A test holds it.
constexpr std::uint64_t kBytesPerAtom = 700;
/// The file's text is held while it is read, once inflated and, for a moment, twice.
constexpr std::uint64_t kBytesPerTextByte = 2;
/// Occlusion has a bound of its own: RenderSettings::occlusionBytes.

// A window's frame takes 28 bytes of device memory a pixel by its formats: depth 4, encoded depth 8 at most, colour 4,
// three images of the display 12. While the picture that stays is refined, up to ViewerOptions::refinedPixels samples
// more, of 16 bytes; of 4 where depth never leaves the tile.

/// Host and device together, per pixel of a picture for a file, supersampled ones counted.
constexpr std::uint64_t kBytesPerPicturePixel = 64;

/// Limits of reading, so that the molecule fits. What is too large is refused at the first atom or byte too many.
/// @param bytes  memory for the molecule alone
inline ReadOptions readWithin(std::uint64_t bytes, ReadOptions options = {}) {
    const std::uint64_t text = bytes / 2 / kBytesPerTextByte, atoms = bytes / 2 / kBytesPerAtom;
    if (text < options.maxBytes) options.maxBytes = static_cast<std::size_t>(text);
    if (atoms < options.maxAtoms) options.maxAtoms = static_cast<std::size_t>(atoms);
    return options;
}

}  // namespace nacre
