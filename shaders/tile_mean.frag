#version 440
// The mean of a tile's fragment counts: one pixel per tile.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"

layout(set = 0, binding = 0) uniform sampler2D counts;
layout(location = 0) out vec4 mean;
layout(constant_id = kTileId) const int kTile = 16;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * kTile;
    ivec2 end = min(first + kTile, textureSize(counts, 0));
    float sum = 0.0;
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x) sum += texelFetch(counts, ivec2(x, y), 0).x;
    mean = vec4(sum * 255.0 / float((end.x - first.x) * (end.y - first.y)), 0.0, 0.0, 0.0);
}
