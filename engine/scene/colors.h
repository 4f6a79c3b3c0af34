#pragma once
// What colour an atom has. Colours are sRGB, 8 bits a channel, red in the lowest byte, the highest byte 255.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/molecule/molecule.h"
#include "engine/scene/palettes.h"

namespace nacre {

/// Hues after the CPK and Jmol conventions that chemists know, in calmer tones. Every element has one; an unknown
/// element is pink.
std::uint32_t elementColor(Element element);

/// What tells chains and copies apart where no palette is asked for.
constexpr Palette kChainPalette = Palette::distinct;
inline std::uint32_t chainColor(std::size_t chain) { return kindColor(chain, kChainPalette); }

/// A colour that is only a tint of the copy's that an atom stands in: white, so the copy's own.
constexpr std::uint32_t kCopyTint = 0xfeffffffu;
constexpr bool isCopyTint(std::uint32_t color) { return color >> 24 != 0xff; }

/// Colour of a residue by its kind: amino acids in families (acid, base, polar, aromatic, aliphatic, sulphur),
/// nucleotides by base, water; everything else is warm grey.
std::uint32_t residueColor(std::string_view name);

}  // namespace nacre
