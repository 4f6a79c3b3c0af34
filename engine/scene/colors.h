#pragma once
// What colour an atom has. Colours are sRGB, 8 bits a channel, red in the lowest byte, the highest byte 255 but where
// it is said below.

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
/// Where carbons alone are coloured, beside atoms in the colours of their elements.
constexpr Palette kCarbonPalette = Palette::carbons;

/// A colour that is only a tint of the copy's that an atom stands in: a grey, by which that is darkened. The first of
/// some is white, so the copy's own.
std::uint32_t copyTint(std::size_t tint, std::size_t count);
constexpr bool isCopyTint(std::uint32_t color) { return (color >> 24 & 1) == 0; }
/// A copy's colour in a tint, as shaders mix them: multiplied in linear light.
std::uint32_t tintedColor(std::uint32_t color, std::uint32_t tint);

/// Of meshes: the other seven bits of the highest byte are how opaque a colour is, in steps of 1/128 from 1/128 to 1.
constexpr std::uint32_t kOpacitySteps = 128;
std::uint32_t withOpacity(std::uint32_t color, double opacity);
constexpr std::uint32_t opacitySteps(std::uint32_t color) { return (color >> 25) + 1; }
constexpr bool isOpaque(std::uint32_t color) { return opacitySteps(color) == kOpacitySteps; }

/// Colour of a residue by its kind: amino acids in families (acid, base, polar, aromatic, aliphatic, sulphur),
/// nucleotides by base, water; everything else is warm grey.
std::uint32_t residueColor(std::string_view name);

}  // namespace nacre
