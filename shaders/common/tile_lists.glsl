// The lists of the `tiles` path (engine/tiles/tile_set.h) in its compute stages: one subgroup per tile, in chunks of as
// many entries as it has lanes.

layout(constant_id = kLanesId) const int kLanes = 8;
layout(constant_id = kTilesInBinId) const int kTilesInBin = 2;
layout(local_size_x_id = 50) in;  // kLanesId
#include "lanes.glsl"
#include "tile_entries.glsl"

/// The lowest set bit; 0 if none.
uint lowestBit(uint bits) { return bits == 0u ? 0u : (floatBitsToUint(float(bits & (0u - bits))) >> 23) - 127u; }
vec4 handed(vec4 v, uint from) {
    return vec4(subgroupShuffle(v.x, from), subgroupShuffle(v.y, from), subgroupShuffle(v.z, from),
                subgroupShuffle(v.w, from));
}

#ifdef CYLINDERS
Stick handed(Stick c, uint from) {
    vec4 a = handed(vec4(c.a, c.radius), from), axis = handed(vec4(c.axis, c.len), from);
    vec4 seen = handed(vec4(c.ahead, c.sine, c.perSine), from);
    return Stick(a.xyz, a.w, axis.xyz, axis.w, seen.xy, seen.z, seen.w, subgroupShuffle(c.perFall, from),
                 subgroupShuffle(c.perLen, from));
}
#endif

#ifdef TRIANGLES
vec3 handedCorner(vec3 v, uint from) {
    return vec3(subgroupShuffle(v.x, from), subgroupShuffle(v.y, from), subgroupShuffle(v.z, from));
}
#endif
