#pragma once
// Colours for numbers and for kinds, chosen so that people with any colour vision tell them apart. Colours are packed
// as in colors.h.

#include <cstddef>
#include <cstdint>
#include <string>

namespace nacre {

/// 0xRRGGBB as it is read -> red in the lowest byte, opaque.
constexpr std::uint32_t packedColor(std::uint32_t rgb) {
    return (rgb >> 16 & 0xff) | (rgb & 0xff00) | (rgb & 0xff) << 16 | 0xff000000u;
}

/// "#rrggbb" of a packed colour.
std::string colorText(std::uint32_t color);

enum class Palette {
    sunset,         ///< blue over pale yellow to red: P. Tol, "Colour schemes", SRON/EPS/TN/09-002 (2021), "sunset"
    viridis,        ///< dark violet to yellow: matplotlib's "viridis" (S. van der Walt and N. Smith, 2015, CC0)
    rainbow,        ///< blue over green and yellow to red: Tol's "smooth rainbow", from its blue to its red
    lipophilicity,  ///< dark cyan over white to dark goldenrod (CSS colour names), as ChimeraX shows lipophilicity
};

/// Colour at 0..1 along a palette; what lies outside counts as the end, NaN as the begin.
std::uint32_t paletteColor(Palette palette, double at);

/// The nth of kinds: M. Okabe and K. Ito, "Color Universal Design" (2008), without its black, lightened a little for
/// shaded spheres; then the same darker; repeats after fourteen.
std::uint32_t kindColor(std::size_t kind);

/// The same colour at three quarters of its sRGB values.
std::uint32_t darkerColor(std::uint32_t color);

}  // namespace nacre
