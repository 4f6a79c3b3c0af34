// Whole numbers that depend on everything that a pass reads, so that a wrong value anywhere shows.
layout(push_constant) uniform Push { float z; uint seed; uint reads; } push;  // reads: 1 texture, 2 depth, 4 buffer
layout(set = 0, binding = 0) uniform usampler2D colorTexture;
layout(set = 0, binding = 1) uniform sampler2D depthTexture;
layout(set = 0, binding = 2, std430) readonly buffer Words { uint words[]; };

uint mixIn(uint h, uint v) {
    h = (h ^ v) * 0x9E3779B1u;
    return h ^ (h >> 15);
}
uint valueAt(ivec2 p) {
    uint h = mixIn(mixIn(push.seed, uint(p.x)), uint(p.y));
    // Neighbours, so that what a tile holds is not enough.
    if ((push.reads & 1u) != 0u) h = mixIn(h, texelFetch(colorTexture, (p + ivec2(3, 1)) % textureSize(colorTexture, 0), 0).x);
    if ((push.reads & 2u) != 0u)
        h = mixIn(h, floatBitsToUint(texelFetch(depthTexture, (p + ivec2(9, 2)) % textureSize(depthTexture, 0), 0).x));
    if ((push.reads & 4u) != 0u) h = mixIn(h, words[(p.y * 16 + p.x) % 512]);
    return h;
}
