#pragma once
// Colours of atoms: sRGB, 8 bits per channel, red in the lowest byte. The highest byte is 255 unless stated otherwise.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "engine/effects.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/color/palettes.h"

namespace nacre {

/// Hues after the CPK and Jmol conventions, less saturated. Every element has one; an unknown element is pink.
std::uint32_t elementColor(Element element);

/// Default palette of chains, inputs and copies, for whole atoms or carbons alone.
constexpr Palette kChainPalette = Palette::distinct;

/// A tint of the copy's colour: a grey that darkens it. The first is white, which keeps the copy's colour.
std::uint32_t copyTint(std::size_t tint, std::size_t count);
constexpr bool isCopyTint(std::uint32_t color) { return (color >> 24 & 1) == 0; }
/// A copy's colour in a tint, as shaders mix them: multiplied in linear light.
std::uint32_t tintedColor(std::uint32_t color, std::uint32_t tint);

/// The mean, in linear light. @param colors  at least one @param shares  same length, above 0
std::uint32_t meanColor(std::span<const std::uint32_t> colors, std::span<const float> shares);

/// The other seven bits of the highest byte store opacity in steps of 1/128. The lowest codes denote materials of
/// opaque colours instead, so that the least opacity is 5/128. Other colours have the picture's material.
constexpr std::uint32_t kOpacitySteps = 128, kMaterials = 4, kSurfaceBits = 0xfe000000u;
/// Returns an opaque colour unchanged.
std::uint32_t withOpacity(std::uint32_t color, double opacity);
constexpr std::uint32_t opacitySteps(std::uint32_t color) {
    return color >> 25 < kMaterials ? kOpacitySteps : (color >> 25) + 1;
}
constexpr std::uint32_t withMaterial(std::uint32_t color, Material material) {
    return (color & ~kSurfaceBits) | static_cast<std::uint32_t>(material) << 25;
}
/// A colour with the opacity or material of `other`.
constexpr std::uint32_t withSurfaceFrom(std::uint32_t color, std::uint32_t other) {
    return (color & ~kSurfaceBits) | (other & kSurfaceBits);
}
constexpr bool isOpaque(std::uint32_t color) { return opacitySteps(color) == kOpacitySteps; }

/// Colour of a residue by class: amino acids by family (acid, base, polar, aromatic, aliphatic, sulphur), nucleotides
/// by base, water; the rest is warm grey.
std::uint32_t residueColor(std::string_view name);

}  // namespace nacre
