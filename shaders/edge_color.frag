#version 440
// Composites the edge pixels of tile_edges.comp over the picture: one sample's colour.
//   TEXELS   as in common/streams.glsl
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/srgb.glsl"
#include "common/tile_place.glsl"

#ifdef TEXELS
layout(set = 0, binding = 0) uniform usamplerBuffer edgeTexels;
uvec2 edgeAt(uint i) { return texelFetch(edgeTexels, int(i)).xy; }
#else
layout(set = 0, binding = 0, std430) readonly buffer Edges { uvec2 edges[]; };
uvec2 edgeAt(uint i) { return edges[i]; }
#endif
layout(location = 0) out vec4 color;  // premultiplied
layout(constant_id = kCodedId) const bool kCoded = false;
// Clear colour of the picture.
layout(constant_id = kClearId) const float kRed = 0.0;
layout(constant_id = kClearId + 1) const float kGreen = 0.0;
layout(constant_id = kClearId + 2) const float kBlue = 0.0;
layout(constant_id = kClearId + 3) const float kAlpha = 0.0;

void main() {
    uvec2 edge = edgeAt(placeHere());
    if (edge.y == kNoEdge) discard;
    vec4 samples = vec4(unpackHalf2x16(edge.x), unpackHalf2x16(edge.y));
    vec4 mixed = samples + (1.0 - samples.a) * vec4(kRed, kGreen, kBlue, kAlpha);
    color = vec4(kCoded ? srgbFromLinear(clamp(mixed.rgb, 0.0, 1.0)) : mixed.rgb, mixed.a);
}
