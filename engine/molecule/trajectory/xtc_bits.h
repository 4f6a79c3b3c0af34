#pragma once
// The compression of positions in XTC files, "xdr3dfcoord": integers on a grid, with neighbouring ones as small
// differences, in mixed radix with as many bits as their ranges need. After F. van Hoesel (Europort-D, 1995) and the
// format's description in the GROMACS manual.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace nacre {

/// Header before the packed bits of a frame.
struct XtcPacking {
    float precision = 1000;  ///< grid points per nm
    std::array<std::int32_t, 3> lowest{}, highest{};
    std::int32_t smallIndex = 0;  ///< of the first range of differences
};

/// @param positions  receives nm times 10, Å; its length is the number of atoms
/// @returns false if the bits end early or are invalid
bool unpackXtc(const XtcPacking& packing, std::span<const std::byte> bits, std::span<glm::vec3> positions);

}  // namespace nacre
