#version 440
// Depth maps of the occlusion bake by tiles: one subgroup draws 8 x 8 pixels of a batch's maps, which lie side by side,
// each with its own copies and rotation. Lists and early exit as in tile_nearest.comp; keeps heights only, and merges
// them with those of earlier parts of the molecule.
//   TEXELS, CYLINDERS   as in tile_nearest.comp
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 0
#include "common/hit.glsl"
#include "common/streams.glsl"
#include "common/tile_lists.glsl"

layout(push_constant) uniform Push { MapConstants push; };
// Heights have two bindings: for reading and for writing.
#ifdef TEXELS
layout(set = 0, binding = 2) uniform usamplerBuffer listTexels;
layout(set = 0, binding = 3) uniform samplerBuffer heightTexels;
layout(set = 0, binding = 4, std430) writeonly buffer Heights { float heights[]; };
uint listAt(uint i) { return texelFetch(listTexels, int(i)).x; }
float heightAt(uint i) { return texelFetch(heightTexels, int(i)).x; }
#else
layout(set = 0, binding = 2, std430) readonly buffer Lists { uint lists[]; };
layout(set = 0, binding = 4, std430) buffer Heights { float heights[]; };
uint listAt(uint i) { return lists[i]; }
float heightAt(uint i) { return heights[i]; }
#endif

const int kPixels = kTile * kTile / kLanes;  // per lane: pixels i x kLanes + lane of the tile, row by row
const float kNothing = -1e30;

void main() {
    view.origin = push.origin;
    view.primitives = push.primitives;
    view.axisPixel = push.axisPixel;
    view.pixel = push.pixel;
    view.depthStart = 0.0;
    view.perRange = push.perRange;
    view.spheres = push.spheres;
    view.cylinders = push.cylinders;
    view.across = push.across;
    view.offsets = push.offsets;
    uint bins = push.binsOfMap, copies = push.copies;
    uint lane = gl_SubgroupInvocationID;
    uint group = min(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x, view.offsets - 1u);
    uint tile = listAt(group);  // x | y << 16
    uvec2 corner = uvec2(tile & 0xffffu, tile >> 16) * uint(kTile);
    uvec2 bin = corner / uint(kTile * kTilesInBin);
    uint list = view.offsets + bin.y * view.across + bin.x;
    uint at = listAt(list), end = listAt(list + 1u);
    uvec2 own = corner + uvec2(lane % uint(kTile), lane / uint(kTile));
    uint pitch = view.across * uint(kTile * kTilesInBin);
    // Pixel within its map, so that a map does not depend on its position.
    uvec2 map = bin / bins;
    uint firstCopy = (map.y * (view.across / bins) + map.x) * copies;
    uvec2 inMap = corner - map * bins * uint(kTile * kTilesInBin);
    vec2 through[kPixels];
    float top[kPixels];
    for (int i = 0; i < kPixels; ++i) {
        uvec2 on = uvec2((i * kLanes) % kTile, (i * kLanes) / kTile);
        through[i] = planePoint(vec2(inMap + own - corner + on) + 0.5);
        top[i] = heightAt((own.y + on.y) * pitch + own.x + on.x);
    }
    vec2 middle = planePoint(vec2(inMap) + float(kTile / 2));
    vec2 reach = vec2(float(kTile / 2) * view.pixel);
    bool more = true;
    do {
        Entry e = entryAt(listAt(min(at + lane, end - 1u)), middle, reach);
        // Parts beyond a map's edge belong to no map.
        bool mine = at + lane < end && copyIndex - firstCopy < copies;
        uint balls = ballotLanes(mine && e.meets && !e.cylinder);
        do {
            uint from = lowestBit(balls);
            vec4 sphere = handed(e.a, from);
            if (kEllipsoids == 0) {
                // sphereHitThrough() with the terms common to a column hoisted.
                float square = balls != 0u ? sphere.w * sphere.w : -1.0;
                for (int i = 0; i < kPixels; ++i) {
                    vec2 away = through[i] - sphere.xy;
                    float h = square - away.x * away.x - away.y * away.y;
                    top[i] = max(top[i], h > 0.0 ? sphere.z + sqrt(h) : kNothing);
                }
            } else {
                uint candidate = subgroupShuffle(e.number, from);
                for (int i = 0; i < kPixels; ++i) {
                    Hit hit = numberedBallHit(candidate, sphere, through[i]);
                    top[i] = max(top[i], balls != 0u && hit.inside ? view.origin - hit.Z : kNothing);
                }
            }
            balls &= balls - 1u;
        } while (balls != 0u);
#ifdef CYLINDERS
        uint sticks = ballotLanes(mine && e.meets && e.cylinder);
        do {
            Stick stick = handed(e.stick, lowestBit(sticks));
            for (int i = 0; i < kPixels; ++i) {
                Hit hit = stickHitThrough(stick, through[i]);
                top[i] = max(top[i], sticks != 0u && hit.inside ? view.origin - hit.Z : kNothing);
            }
            sticks &= sticks - 1u;
        } while (sticks != 0u);
#endif
        at += uint(kLanes);
        float lowest = top[0];
        for (int i = 1; i < kPixels; ++i) lowest = min(lowest, top[i]);
        more = at < end && anyLane(encodedDepth(view.origin - lowest) >= subgroupShuffle(e.next, uint(kLanes - 1)));
    } while (more);
    for (int i = 0; i < kPixels; ++i)
        heights[(own.y + uint((i * kLanes) / kTile)) * pitch + own.x + uint((i * kLanes) % kTile)] = top[i];
}
