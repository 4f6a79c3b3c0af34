#pragma once
// Colours for numbers and for classes, distinguishable with any colour vision. Packed as in colors.h.
// tests/scene/palettes_test.cpp measures the colour differences within each palette.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nacre {

/// 0xRRGGBB as written -> red in the lowest byte, opaque.
constexpr std::uint32_t packedColor(std::uint32_t rgb) {
    return (rgb >> 16 & 0xff) | (rgb & 0xff00) | (rgb & 0xff) << 16 | 0xff000000u;
}

/// "#rrggbb" of a packed colour.
std::string colorText(std::uint32_t color);

enum class Palette : std::uint8_t {
    automatic,  ///< the scheme's own
    // For classes. "Tol": P. Tol, "Colour schemes", SRON/EPS/TN/09-002 (2021).
    distinct,  ///< our own, by search: far apart (CIEDE2000) for any vision, and from the colours of N, O and S
    light,     ///< Tol
    okabeIto,  ///< M. Okabe and K. Ito, "Color Universal Design" (2008), without its black, lightened for shading
    bright,    ///< Tol
    vibrant,   ///< Tol
    muted,     ///< Tol
    // For numbers: ramps.
    viridis,        ///< dark violet to yellow: matplotlib's (S. van der Walt and N. Smith, 2015, CC0)
    plasma,         ///< dark blue over red to yellow: likewise
    sunset,         ///< blue over pale yellow to red: Tol
    blueWhiteRed,   ///< our own, as crystallographers colour B factors
    redWhiteBlue,   ///< the reverse, as potentials are drawn
    rainbow,        ///< blue over green and yellow to red: Tol's "smooth rainbow", from its blue to its red
    lipophilicity,  ///< dark cyan over white to dark goldenrod (CSS colour names), as ChimeraX shows lipophilicity
    grays,          ///< dark to light
};

constexpr std::size_t kMostRampColors = 16;

/// A palette by name, or a ramp through own colours.
struct AnyPalette {
    Palette named = Palette::automatic;
    std::vector<std::uint32_t> own = {};  ///< two to kMostRampColors, 0xRRGGBB, evenly spaced; empty: the named one

    AnyPalette() = default;
    AnyPalette(Palette palette) : named(palette) {}
    static AnyPalette ramp(std::vector<std::uint32_t> colors) {
        AnyPalette palette;
        palette.own = std::move(colors);
        return palette;
    }
    friend bool operator==(const AnyPalette&, const AnyPalette&) = default;
};

/// "okabe-ito"; empty for automatic.
std::string_view paletteName(Palette palette);
/// The palette's name, or its own colours: "#ffffff:#ff0000".
std::string paletteName(const AnyPalette& palette);
std::optional<Palette> paletteFromName(std::string_view name);
/// Whether it is a ramp, for numbers.
bool isRamp(const AnyPalette& palette);
/// All except automatic, in order.
std::span<const Palette> allPalettes();

/// Colour at 0..1 along a ramp; values outside are clamped, NaN counts as 0.
std::uint32_t paletteColor(const AnyPalette& ramp, double at);

/// Number of colours in a palette of classes before it repeats in darker tones.
std::size_t kindCount(const AnyPalette& kinds);
/// The nth class colour: first the palette, then the same darker, then repeated.
std::uint32_t kindColor(std::size_t kind, const AnyPalette& kinds = Palette::okabeIto);

/// The same colour at three quarters of its sRGB values.
std::uint32_t darkerColor(std::uint32_t color);

}  // namespace nacre
