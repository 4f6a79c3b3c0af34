#pragma once
// The files around a USDZ scene: an archive that is read in place, and the picture of its colours.

#include <cstdint>
#include <string>
#include <vector>

namespace nacre::app {

struct PackedFile {
    std::string name;
    std::string bytes;
};

constexpr std::size_t kMostArchive = 0xff000000;  ///< bytes before the directory: its offset has 32 bits

/// A ZIP archive without compression whose files begin at multiples of 64 bytes, as USDZ requires.
/// @param most  for tests @throws Error if the files would exceed it
std::string storedArchive(const std::vector<PackedFile>& files, std::size_t most = kMostArchive);

/// A square PNG with a block of 4 x 4 pixels per sRGB colour, row by row from the top, so that neither filtering nor
/// texture compression by blocks mixes them.
std::string colorSheet(const std::vector<std::uint32_t>& colors);

/// Blocks per side of the sheet.
std::uint32_t sheetSide(std::size_t colors);

}  // namespace nacre::app
