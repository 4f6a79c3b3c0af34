#pragma once
// Which shader a geometry pass draws with.

#include <cstdint>
#include <span>

namespace nacre::passes {

enum class Primitive : std::uint8_t { sphere, cylinder, screen };

/// What a pass writes.
enum class Writes : std::uint8_t {
    plates,    ///< depth of opaque plates
    encoded,   ///< encoded depth, MIN blend
    depth,     ///< nearest depth alone
    number,    ///< nearest primitive's number, and its depth
    overdraw,  ///< how many fragments pass the depth test, 1/255 each, added up
    color,
    surface,   ///< normal and Z
    identity,  ///< atom and occlusion
};

/// How shading learns whether a hit is the nearest.
enum class Nearest : std::uint8_t { encoded, fragdepth, deferred, rasterOrder };

constexpr bool shades(Writes writes) { return writes >= Writes::color; }
/// Whether a pass keeps the nearest depth itself, read and written in raster order.
constexpr bool keepsDepth(Writes writes, Nearest nearest) {
    return nearest == Nearest::rasterOrder && (shades(writes) || writes == Writes::encoded);
}

struct ShaderKey {
    Primitive primitive{};
    Writes writes{};
    Nearest nearest{};
    bool sampled = false;  ///< the nearest depth or number comes as a texture, not as an input attachment
    bool settle = false;   ///< encoded depth is coarse: the depth buffer settles the rest
    bool counting = false;
    friend auto operator<=>(const ShaderKey&, const ShaderKey&) = default;
};

std::span<const std::uint32_t> vertexShader(const ShaderKey& key);
std::span<const std::uint32_t> fragmentShader(const ShaderKey& key);
/// The pass's name, as in the plan.
const char* nameOf(Writes writes);

}  // namespace nacre::passes
