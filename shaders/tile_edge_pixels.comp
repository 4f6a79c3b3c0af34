#version 440
// Finds edge pixels of the `tiles` path's picture: their sight differs from one of their four neighbours' (any straight
// edge through a pixel separates its centre from a neighbour's), and, where colours are known, so does the colour. A
// subgroup processes a bin, each lane a column four pixels wide, and lists pixels in groups of one per lane, so that
// drawing always fills the lanes.
//   TEXELS   as in common/streams.glsl
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "common/layout.h"
#include "common/changes.glsl"

layout(push_constant) uniform Push { TileConstants view; };
layout(constant_id = kLanesId) const int kLanes = 8;
layout(constant_id = kTilesInBinId) const int kTilesInBin = 2;
layout(local_size_x_id = 50) in;  // kLanesId
#include "common/lanes.glsl"
layout(constant_id = kContoursId) const bool kContours = false;
layout(constant_id = kEverywhereId) const bool kEverywhere = false;
// Pixels are coded words, and edges overwrite them; otherwise edges are halves, with a value that means no edge.
layout(constant_id = kRowsId) const bool kRows = false;

#ifdef TEXELS
layout(set = 0, binding = 0) uniform usamplerBuffer listTexels;
layout(set = 0, binding = 1) uniform usamplerBuffer numberTexels;
layout(set = 0, binding = 2) uniform usamplerBuffer colorTexels;
uint listAt(uint i) { return texelFetch(listTexels, int(i)).x; }
uvec4 numbersAt(uint quad) { return texelFetch(numberTexels, int(quad)); }
uvec4 colorsAt(uint quad) { return texelFetch(colorTexels, int(quad)); }
#else
layout(set = 0, binding = 0, std430) readonly buffer Lists { uint lists[]; };
layout(set = 0, binding = 1, std430) readonly buffer Numbers { uvec4 numbers[]; };
uint listAt(uint i) { return lists[i]; }
uvec4 numbersAt(uint quad) { return numbers[quad]; }
layout(set = 0, binding = 2, std430) readonly buffer Colors { uvec4 colors[]; };
uvec4 colorsAt(uint quad) { return colors[quad]; }
#endif
layout(set = 0, binding = 3, std430) buffer EdgePixels { uint edgePixels[]; };
layout(set = 0, binding = 4, std430) writeonly buffer Edges { uint edges[]; };

const int kBin = 8 * kTilesInBin;
const int kQuadsAcross = kBin / 4;
const int kRowsOfLane = kBin * kQuadsAcross / kLanes;

/// A row of four pixels with their neighbours.
struct Row {
    uvec4 sights, colors;
};
Row rowAt(uint quad) { return Row(numbersAt(quad), kRows ? colorsAt(quad) : uvec4(0u)); }

/// Whether coded colours differ by 4 of 255 or more. Smaller differences show no staircase: skipping them keeps 42 dB.
bvec4 apart(uvec4 a, uvec4 b) {
    const uvec4 bytes = uvec4(0x00ff00ffu), room = uvec4(0x02040204u), within = uvec4(0x03f803f8u), none = uvec4(0x02000200u);
    uvec4 even = ((a & bytes) + room - (b & bytes)) & within, odd = ((a >> 8 & bytes) + room - (b >> 8 & bytes)) & within;
    return notEqual((even ^ none) | (odd ^ none), uvec4(0u));
}
/// 1 where a boundary lies between two pixels.
uvec4 parts(Row a, Row b) {
    uvec4 differs = uvec4(notEqual(a.sights, b.sights));
    // Equal colours may still have an outline narrower than a pixel between them.
    return kRows && !kContours ? differs & uvec4(apart(a.colors, b.colors)) : differs;
}

/// The pixels left or right of a row of four. At the picture's border the last pixels repeat.
/// @param at  position of the four @param last  there is no neighbour
Row leftOf(Row row, uint at, bool last) {
    Row beside = rowAt(last ? at : at - 1u);
    return Row(uvec4(last ? row.sights.x : beside.sights.w, row.sights.xyz),
               uvec4(last ? row.colors.x : beside.colors.w, row.colors.xyz));
}
Row rightOf(Row row, uint at, bool last) {
    Row beside = rowAt(last ? at : at + 1u);
    return Row(uvec4(row.sights.yzw, last ? row.sights.w : beside.sights.x),
               uvec4(row.colors.yzw, last ? row.colors.w : beside.colors.x));
}

uint lowestBit(uint bits) { return bits == 0u ? 0u : (floatBitsToUint(float(bits & (0u - bits))) >> 23) - 127u; }

/// @param bits  of pixels, counted from a corner @param to  where to list them
void list(uint bits, uvec2 corner, uint to) {
    bool more = true;
    do {
        uint bit = lowestBit(bits);
        uvec2 pixel = corner + uvec2(bit & 3u, bit >> 2);
        if (bits != 0u) edgePixels[to++] = pixel.x | pixel.y << 16;
        bits &= bits - 1u;
        more = anyLane(bits != 0u);
    } while (more);
}

void main() {
    uint lane = gl_SubgroupInvocationID;
    // If rows of workgroups are uneven, the last bin is processed twice but listed once.
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint bins = view.offsets / uint(kTilesInBin * kTilesInBin);  // bins with tiles
    // x | y << 16; bit 31: the bin may show primitives between pixel centres
    uint tile = listAt(min(group, bins - 1u) * uint(kTilesInBin * kTilesInBin));
    uint quadsAcross = view.across * uint(kQuadsAcross), height = edgePixels[1];
    uint x = (tile & 0xffffu) / uint(kTilesInBin) * uint(kQuadsAcross) + lane % uint(kQuadsAcross);
    uint y = (tile >> 16 & 0xfffu) / uint(kTilesInBin) * uint(kBin) + lane / uint(kQuadsAcross) * uint(kRowsOfLane);

    uint found = 0u, foundBelow = 0u;  // one bit per pixel, row by row; foundBelow holds rows from the eighth on
    uint at = y * quadsAcross + x;
    bool first = x == 0u, final = x + 1u == quadsAcross;  // in its row
    Row last = rowAt(y > 0u ? at - quadsAcross : at), here = rowAt(at);
    for (int r = 0; r < kRowsOfLane; ++r) {
        uint below = y + uint(r) + 1u < height ? at + quadsAcross : at;
        Row next = rowAt(below);
        uvec4 edge = parts(here, last) | parts(here, next) | parts(here, leftOf(here, at, first)) |
                     parts(here, rightOf(here, at, final));
        // The sight may change within a pixel while its neighbours agree.
        if (kContours) edge |= uvec4(equal(here.sights & kChanges, uvec4(kChanges)));
        if (kEverywhere && (kContours || tile >> 31 != 0u)) edge = uvec4(1u);
        uint bits = (edge.x | edge.y << 1 | edge.z << 2 | edge.w << 3) << uint(4 * (r & 7));
        found |= r < 8 ? bits : 0u;
        foundBelow |= r < 8 ? 0u : bits;
        if (!kRows)
            for (int i = 0; i < 4; ++i)
                if (edge[i] == 0u) edges[2u * (4u * at + uint(i)) + 1u] = kNoEdge;
        last = here;
        here = next;
        at += quadsAcross;
    }
    if (group >= bins) found = foundBelow = 0u;

    uint own = uint(bitCount(found) + bitCount(foundBelow)), before = 0u, all = 0u;
    for (uint i = 0u; i < uint(kLanes); ++i) {
        uint count = subgroupShuffle(own, i);
        before += i < lane ? count : 0u;
        all += count;
    }
    uint full = (all + uint(kLanes) - 1u) / uint(kLanes), begin = 0u;
    if (lane == 0u && full > 0u) begin = atomicAdd(edgePixels[0], full);
    begin = kEdgeHeader + subgroupShuffle(begin, 0u) * uint(kLanes);
    if (all + lane < full * uint(kLanes)) edgePixels[begin + all + lane] = kNoEdge;
    list(found, uvec2(4u * x, y), begin + before);
    if (kRowsOfLane > 8) list(foundBelow, uvec2(4u * x, y + 8u), begin + before + uint(bitCount(found)));
}
