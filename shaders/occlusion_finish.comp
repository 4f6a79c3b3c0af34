#version 440
// Sums of light to atlas bytes, four texels per word. A texel inside a neighbouring primitive extrapolates two open
// texels linearly, so that interpolation reaches the crease with the right slope.
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 64) in;

struct Word {
    uint address;  // atlas index, words
    uint base;
    // Source of each texel's value, less base, in the lower half (0xffff: none); in the upper half the next one, for
    // linear extrapolation (equal: none).
    uint sources[4];
};
layout(push_constant) uniform Push { uint count; };
layout(set = 0, binding = 0, std430) readonly buffer Sums { vec2 sums[]; };
layout(set = 0, binding = 1, std430) readonly buffer Words { Word words[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Atlas { uint atlas[]; };

/// Before the first direction everything is open.
float occlusion(uint base, uint entry) {
    if (entry == 0xffffu) return 0.0;
    vec2 sum = sums[base + entry];
    return sum.y > 0.0 ? min(sum.x / sum.y, 1.0) : 1.0;
}

void main() {
    uint word = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    if (word >= count) return;
    uint base = words[word].base;
    vec4 values;
    for (int i = 0; i < 4; ++i) {
        uint source = words[word].sources[i], entry = source & 0xffffu, beyond = source >> 16;
        values[i] = occlusion(base, entry);
        if (beyond != entry) values[i] = clamp(2.0 * values[i] - occlusion(base, beyond), 0.0, 1.0);
    }
    atlas[words[word].address] = packUnorm4x8(values);
}
