#version 440
// Visibility of the `tiles` path without subgroup operations: the number of each pixel's nearest primitive, or 0, in an
// image. A workgroup draws a tile of 8 x 8 pixels, an invocation each pixel. It goes through the list of the tile's bin,
// sorted by nearest depth: each invocation fetches an entry and, if that meets the tile, passes it on by shared memory.
// It ends where the next entry begins behind the tile's farthest pixel.
//   CYLINDERS, TRIANGLES   the scene has some
#extension GL_GOOGLE_include_directive : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 0
#include "common/hit.glsl"
#include "common/streams.glsl"
#include "common/tile_entries.glsl"

layout(local_size_x = 64) in;
const uint kGroup = 64u;
layout(constant_id = kTilesInBinId) const int kTilesInBin = 2;
layout(push_constant) uniform Push { TileConstants push; };
layout(set = 0, binding = 2, std430) readonly buffer Lists { uint lists[]; };
layout(set = 0, binding = 3, r32ui) writeonly uniform uimage2D numbers;

// Entries of a chunk that meet the tile, in any order. Shapes as in view space: a sphere; a stick; a triangle's corners.
shared uint passed;    // their number
shared uint farthest;  // of the tile's pixels, encoded depth as bits: floats from 0 on have the order of their bits
shared float next;     // encoded depth at which the next chunk begins
shared uint candidates[kGroup];
shared vec4 first[kGroup];
#ifdef CYLINDERS
shared vec4 second[kGroup], third[kGroup];
shared vec2 fourth[kGroup];
shared uint kinds[kGroup];
const uint kBall = 0u, kStick = 1u, kFacet = 2u;
#endif

void passOn(Entry e) {
    uint to = atomicAdd(passed, 1u);
    candidates[to] = e.number;
    first[to] = e.a;
#ifdef CYLINDERS
    kinds[to] = e.cylinder ? kStick : e.facet ? kFacet : kBall;
    if (e.cylinder) {
        first[to] = vec4(e.stick.a, e.stick.radius);
        second[to] = vec4(e.stick.axis, e.stick.len);
        third[to] = vec4(e.stick.ahead, e.stick.sine, e.stick.perSine);
        fourth[to] = vec2(e.stick.perFall, e.stick.perLen);
    }
#ifdef TRIANGLES
    if (e.facet) second[to] = vec4(e.b, 0.0), third[to] = vec4(e.c, 0.0);
#endif
#endif
}

Hit hitOf(uint i, vec2 through) {
#ifdef TRIANGLES
    if (kinds[i] == kFacet) return triangleHitThrough(first[i].xyz, second[i].xyz, third[i].xyz, 0u, through);
#endif
#ifdef CYLINDERS
    if (kinds[i] == kStick) {
        vec4 a = first[i], axis = second[i], seen = third[i];
        return stickHitThrough(
            Stick(a.xyz, a.w, axis.xyz, axis.w, seen.xy, seen.z, seen.w, fourth[i].x, fourth[i].y), through);
    }
#endif
    return numberedBallHit(candidates[i], first[i], through);
}

/// The number of a pixel's nearest primitive. @param wanted  the pixel matters
uint findNearest(uvec2 corner, vec2 through, bool wanted, uint at, uint end) {
    uint lane = gl_LocalInvocationIndex, number = 0u;
    float nearest = wanted ? 1.0 : -1.0;
    vec2 middle = planePoint(vec2(corner) + float(kTile / 2)), reach = vec2(float(kTile / 2) * view.pixel);
    for (bool more = at < end; more;) {
        if (lane == 0u) farthest = 0u;
        Entry e = entryAt(lists[min(at + lane, end - 1u)], middle, reach);
        if (at + lane < end && e.meets) passOn(e);
        if (lane + 1u == kGroup) next = e.next;
        barrier();
        for (uint i = 0u; i < passed; ++i) {
            Hit hit = hitOf(i, through);
            float depth = encodedDepth(hit.order);
            // At equal depths the last wins, as with a LESS_OR_EQUAL test.
            bool wins = hit.inside && (depth < nearest || (depth == nearest && candidates[i] > number));
            nearest = wins ? depth : nearest;
            number = wins ? candidates[i] : number;
        }
        atomicMax(farthest, floatBitsToUint(max(nearest, 0.0)));
        at += kGroup;
        barrier();
        more = at < end && uintBitsToFloat(farthest) >= next;
        if (lane == 0u) passed = 0u;
        barrier();
    }
    return number;
}

void main() {
    view = push;
    uint lane = gl_LocalInvocationIndex;
    if (lane == 0u) passed = 0u;
    barrier();
    // If rows of workgroups are uneven, the last tile is drawn again.
    uint tile = lists[min(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x, view.offsets - 1u)];
    if ((tile & kOtherRoundBit) != 0u) return;  // another round draws it
    uvec2 corner = tileCorner(tile), bin = corner / uint(kTile * kTilesInBin);
    uint list = view.offsets + bin.y * view.across + bin.x;
    uvec2 pixel = corner + uvec2(lane % uint(kTile), lane / uint(kTile));
    uint begin = lists[list], end = lists[list + 1u], number = 0u;
    if (begin < end) number = findNearest(corner, planePoint(vec2(pixel) + 0.5), isWanted(tile, lane), begin, end);
    if (all(lessThan(pixel, uvec2(imageSize(numbers))))) imageStore(numbers, ivec2(pixel), uvec4(number));
}
