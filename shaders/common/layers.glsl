// Layers of translucent primitives: what is one layer, and the colours that are blended.

// At a common edge the depths of two triangles agree up to rounding: hits closer than
// this in encoded depth are one layer.
const float kLayerStep = 2e-6;

/// A layer's colour as all paths blend it: `tiles` keeps it in a buffer.
uvec2 halves(vec4 color) { return uvec2(packHalf2x16(color.rg), packHalf2x16(color.ba)); }
vec4 fromHalves(uvec2 words) { return vec4(unpackHalf2x16(words.x), unpackHalf2x16(words.y)); }
vec4 asHalves(vec4 color) {
    return fromHalves(halves(color));
}
