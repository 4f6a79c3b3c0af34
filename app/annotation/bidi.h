#pragma once
// Finds the parts of a line that run from right to left: Unicode's bidirectional algorithm (UAX #9) for one line.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace nacre::app {

/// Character classes, named as in UAX #9.
enum class BidiClass : std::uint8_t {
    L,
    R,
    AL,
    EN,
    ES,
    ET,
    AN,
    CS,
    NSM,
    BN,
    B,
    S,
    WS,
    ON,
    LRE,
    LRO,
    RLE,
    RLO,
    PDF,
    LRI,
    RLI,
    FSI,
    PDI  // NOLINT
};

/// Derived from HarfBuzz's script and general category of a character.
BidiClass findBidiClass(char32_t c);

/// Neighbouring characters of one direction.
struct DirectedRun {
    std::size_t first, count;  ///< in the order of the text
    bool rightToLeft;
};

/// The runs of a line in visual order, from left to right. The line's own direction is that of its first letter.
/// Characters that only control directions are in no run.
std::vector<DirectedRun> visualRuns(std::span<const char32_t> text);

}  // namespace nacre::app
