#pragma once
// Which parts of a line run from right to left: Unicode's bidirectional algorithm (UAX #9) for one line.

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

/// Derived from the script and general category that HarfBuzz knows of a character.
BidiClass bidiClassOf(char32_t c);

/// Neighbouring characters of one direction.
struct DirectedRun {
    std::size_t first, count;  ///< in the order of the text
    bool rightToLeft;
};

/// The runs of a line from left to right as they are seen. The line's own direction is that of its first letter.
/// Characters that only control directions are in no run.
std::vector<DirectedRun> visualRuns(std::span<const char32_t> text);

}  // namespace nacre::app
