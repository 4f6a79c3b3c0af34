#pragma once
// Triangles that an application draws over the picture: panel, labels, marks. Plain data, independent of the GPU.

#include <cstdint>
#include <vector>

namespace nacre {

struct OverlayVertex {
    float x, y;           ///< pixels of the window, from the top left
    float u, v;           ///< position in the glyph texture, 0..1
    std::uint32_t color;  ///< sRGB-coded, straight alpha, red in the lowest byte
};

/// The eye that sees an overlay's triangles. With red and cyan glasses, the left eye sees red, and the right one green
/// and blue.
enum class OverlayEye : std::uint8_t { both, left, right };

/// Triangles clipped to a rectangle of the window, in pixels.
struct OverlayBatch {
    float left = 0, top = 0, right = 0, bottom = 0;
    std::uint32_t firstIndex = 0, indexCount = 0;
    OverlayEye eye = OverlayEye::both;
};

struct Overlay {
    std::vector<OverlayVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<OverlayBatch> batches;
};

/// Coverage of glyphs, one byte per texel. Plain shapes use a fully covered texel.
struct OverlayGlyphs {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> coverage;
};

}  // namespace nacre
