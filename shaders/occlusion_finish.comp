#version 450
// Sums of light -> bytes of the atlas, four texels a word. A texel that lies inside a neighbour (sum < 0) takes the
// mean of its lit neighbours in the patch, so that interpolation does not pull darkness out of the contact.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/patch.glsl"
#include "common/texel.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 1, std430) readonly buffer Directions { vec4 rows[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Atlas { uint words[]; };
layout(set = 0, binding = 3, std430) readonly buffer Sums { float sums[]; };

/// Share of the open hemisphere's light that a texel got: 1 if every direction above it is open.
float occlusion(uint index) {
    Texel texel = texelAt(index);
    // A whole sphere that lies in a surface is seen from half of all directions: that half is what shows of it.
    if (texel.whole) return clamp(2.0 * sums[index] / float(bake.directionCount), 0.0, 1.0);
    vec3 normal = texel.normal;
    float all = 0.0;
    for (uint i = 0u; i < bake.directionCount; ++i) all += max(dot(normal, rows[3u * i + 2u].xyz), 0.0);
    return clamp(sums[index] / max(all, 1e-6), 0.0, 1.0);
}

float filled(uint base, uvec2 at, uvec2 size) {
    uint index = base + at.y * size.x + at.x;
    if (sums[index] >= 0.0) return occlusion(index);
    for (int reach = 1; reach <= 2; ++reach) {
        float sum = 0.0, count = 0.0;
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                ivec2 place = ivec2(at) + ivec2(x, y);
                if (any(lessThan(place, ivec2(0))) || any(greaterThanEqual(place, ivec2(size)))) continue;
                uint other = base + uint(place.y) * size.x + uint(place.x);
                if (sums[other] < 0.0) continue;
                sum += occlusion(other);
                count += 1.0;
            }
        if (count > 0.0) return sum / count;
    }
    return 0.0;
}

void main() {
    uint word = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    if (word >= bake.texelCount) return;
    uint first = word * 4u;  // patch rows are multiples of four texels
    uint edge = uint(bake.patches.x);
    uint sphereTexels = (bake.sphereCount * edge * edge + 3u) & ~3u;
    bool cylinder = first >= sphereTexels;
    uvec2 size = cylinder ? uvec2(bake.patches.yz) : uvec2(edge);
    uint rest = cylinder ? first - sphereTexels : first;
    uint shape = rest / (size.x * size.y), local = rest % (size.x * size.y);
    uvec2 at = uvec2(local % size.x, local / size.x);
    uint base = first - local;
    vec4 values;
    for (uint i = 0u; i < 4u; ++i) values[i] = filled(base, at + uvec2(i, 0u), size);
    uint perRow = bake.atlasWidth / size.x;
    uint top = cylinder ? bake.sphereRows : 0u;
    uvec2 place = uvec2(shape % perRow, shape / perRow) * size + uvec2(0u, top) + at;
    words[(place.y * bake.atlasWidth + place.x) / 4u] = packUnorm4x8(values);
}
