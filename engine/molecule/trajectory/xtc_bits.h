#pragma once
// The compression of positions in XTC files, "xdr3dfcoord": integers on a grid, of which neighbouring ones are written
// as small differences, in mixed radix with as many bits as their ranges need. By the description of F. van Hoesel
// (Europort-D, 1995) and of the format in the GROMACS manual.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace nacre {

/// What stands before the packed bits of a frame.
struct XtcPacking {
    float precision = 1000;  ///< grid points per nm
    std::array<std::int32_t, 3> lowest{}, highest{};
    std::int32_t smallIndex = 0;  ///< of the first range of differences
};

/// @param positions  receives nm times 10, Å; its length is the number of atoms
/// @returns false if the bits end early, or mean what cannot be
bool unpackXtc(const XtcPacking& packing, std::span<const std::byte> bits, std::span<glm::vec3> positions);

}  // namespace nacre
