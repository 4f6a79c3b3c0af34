#version 440
// Translucent triangles of the `tiles` path: the two nearest to a pixel. One subgroup draws a tile of 8 x 8 pixels from
// the list of its bin, as in tile_nearest.comp, and ends where the next entry begins behind the second of every pixel.
// Layers hidden by opaque surfaces are dropped during compositing.
//   TEXELS   as in common/streams.glsl
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#define TILES
#define TRIANGLES
#define TRANSLUCENT
#define COPY_OF_PIXEL
#define STREAMS 0
#include "common/hit.glsl"
#include "common/streams.glsl"
#include "common/tile_lists.glsl"
#include "common/layers.glsl"

layout(push_constant) uniform Push { TileConstants push; };
const int kPixels = kTile * kTile / kLanes;  // per lane: pixels i x kLanes + lane of the tile, row by row

#ifdef TEXELS
layout(set = 0, binding = 2) uniform usamplerBuffer listTexels;
uint listAt(uint i) { return texelFetch(listTexels, int(i)).x; }
#else
layout(set = 0, binding = 2, std430) readonly buffer Lists { uint lists[]; };
uint listAt(uint i) { return lists[i]; }
#endif
layout(set = 0, binding = 3, std430) writeonly buffer Numbers { uint numbers[]; };  // two per pixel

vec2 through[kPixels];
float first[kPixels], second[kPixels];
uint firstNumber[kPixels], secondNumber[kPixels];

/// Keeps the two nearest layers. A hit in front of the first moves it to second place, unless both are one layer.
void keep(int i, Hit hit, uint candidate, bool live) {
    float d = encodedDepth(hit.order);
    bool inside = live && hit.inside;
    // At equal depths the last wins, as with a LESS_OR_EQUAL test.
    bool before = inside && (d < first[i] || (d == first[i] && candidate > firstNumber[i]));
    float least = before ? d : first[i];
    bool pushed = before && first[i] > least + kLayerStep;
    bool next = inside && !before && d > least + kLayerStep &&
                (d < second[i] || (d == second[i] && candidate > secondNumber[i]));
    second[i] = pushed ? first[i] : next ? d : second[i];
    secondNumber[i] = pushed ? firstNumber[i] : next ? candidate : secondNumber[i];
    first[i] = least;
    firstNumber[i] = before ? candidate : firstNumber[i];
}

void main() {
    view = push;
    uint lane = gl_SubgroupInvocationID;
    // If rows of workgroups are uneven, the last tile is drawn again.
    uint group = min(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x, view.offsets - 1u);
    uint tile = listAt(group);
    uvec2 corner = tileCorner(tile);
    uvec2 bin = corner / uint(kTile * kTilesInBin);
    uint at = listAt(view.offsets + bin.y * view.across + bin.x);
    uint end = listAt(view.offsets + bin.y * view.across + bin.x + 1u);

    vec2 middleOfFirst = vec2(corner + uvec2(lane % uint(kTile), lane / uint(kTile))) + 0.5;
    for (int i = 0; i < kPixels; ++i) {
        through[i] = planePoint(middleOfFirst + vec2((i * kLanes) % kTile, (i * kLanes) / kTile));
        first[i] = second[i] = isWanted(tile, uint(i * kLanes) + lane) ? 1.0 : -1.0;
        firstNumber[i] = secondNumber[i] = 0u;
    }
    vec2 middle = planePoint(vec2(corner) + float(kTile / 2));
    vec2 reach = vec2(float(kTile / 2) * view.pixel);
    bool more = true;  // empty bins have no tiles
    do {
        bool mine = at + lane < end;
        Entry e = entryAt(listAt(min(at + lane, end - 1u)), middle, reach);
        uint facets = ballotLanes(mine && e.meets && e.facet);
        do {
            uint from = lowestBit(facets);
            vec3 a = handedCorner(e.a.xyz, from), b = handedCorner(e.b, from), c = handedCorner(e.c, from);
            uint candidate = subgroupShuffle(e.number, from);
            bool live = facets != 0u;
            for (int i = 0; i < kPixels; ++i) keep(i, triangleHitThrough(a, b, c, 0u, through[i]), candidate, live);
            facets &= facets - 1u;
        } while (facets != 0u);
        at += uint(kLanes);
        float farthest = second[0];
        for (int i = 1; i < kPixels; ++i) farthest = max(farthest, second[i]);
        more = at < end && anyLane(farthest >= subgroupShuffle(e.next, uint(kLanes - 1)));
    } while (more);
    // Row by row over all bins.
    uint pitch = view.across * uint(kTile * kTilesInBin);
    uint here = (corner.y + lane / uint(kTile)) * pitch + corner.x + lane % uint(kTile);
    for (int i = 0; i < kPixels; ++i) {
        uvec2 on = uvec2(i * kLanes) / uvec2(1u, kTile) % uint(kTile);
        uint to = 2u * (here + on.y * pitch + on.x);
        numbers[to] = firstNumber[i];
        numbers[to + 1u] = secondNumber[i];
    }
}
