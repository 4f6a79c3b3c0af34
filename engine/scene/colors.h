#pragma once
// What colour an atom has. Colours are sRGB, 8 bits a channel, red in the lowest byte, the highest byte 255.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Hues after the CPK and Jmol conventions that chemists know, in calmer tones. Every element has one; an unknown
/// element is pink.
std::uint32_t elementColor(Element element);

/// Colour of the nth chain: eight tones that colour-blind people tell apart (hues of Paul Tol's "light" scheme,
/// SRON/EPS/TN/09-002, 2021), then the same darker; repeats after sixteen.
std::uint32_t chainColor(std::size_t chain);

/// Colour of a residue by its kind: amino acids in families (acid, base, polar, aromatic, aliphatic, sulphur),
/// nucleotides by base, water; everything else is warm grey.
std::uint32_t residueColor(std::string_view name);

}  // namespace nacre
