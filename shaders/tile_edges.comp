#version 450
// The `tiles` path's edges: pixels through which a boundary runs are drawn from 16 samples each. One subgroup looks at a
// tile: a pixel is an edge if the numbers that tile_nearest.comp kept for it and for the four beside it differ (whatever
// straight boundary crosses a pixel parts its middle from one of theirs), or if the look of its one primitive changes
// inside it. Edges are drawn a lane each, as many at a time as there are lanes: the list of the tile's bin is gone
// through as there, then what a pixel's samples see is shaded once, in their middle, and weighs as many as they are.
//   TEXELS, CYLINDERS   as in tile_nearest.comp
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 2
#define LOOKS 4
#define SHADOW 9
#ifdef TEXELS
#define CELLS 10
#endif
#include "common/numbered.glsl"
#include "common/tile_lists.glsl"
#include "common/samples.glsl"
#include "common/count.glsl"

layout(push_constant) uniform Push { TileConstants push; };
layout(constant_id = kEverywhereId) const bool kEverywhere = false;
// Edges go as coded words, row by row, among the other pixels; else as halves, tile by tile as the numbers.
layout(constant_id = kRowsId) const bool kRows = false;

#ifdef TEXELS
layout(set = 0, binding = 5) uniform usamplerBuffer listTexels;
layout(set = 0, binding = 6) uniform usamplerBuffer numberTexels;
layout(set = 0, binding = 7) uniform usamplerBuffer slotTexels;
uint listAt(uint i) { return texelFetch(listTexels, int(i)).x; }
uint numberAt(uint i) { return texelFetch(numberTexels, int(i)).x; }
uint slotAt(uint i) { return texelFetch(slotTexels, int(i)).x; }
#else
layout(set = 0, binding = 5, std430) readonly buffer Lists { uint lists[]; };
layout(set = 0, binding = 6, std430) readonly buffer Numbers { uint numbers[]; };
layout(set = 0, binding = 7, std430) readonly buffer Slots { uint slots[]; };
uint listAt(uint i) { return lists[i]; }
uint numberAt(uint i) { return numbers[i]; }
uint slotAt(uint i) { return slots[i]; }
#endif
layout(set = 0, binding = 8, std430) writeonly buffer Edges { uint edges[]; };

const uint kNone = 0xffffffffu;
// What a sample sees of a primitive, beside its number.
const uint kSecondHalf = 0x80000000u;
const uint kContour = 0x40000000u;
const uint kCutFace = 0x20000000u;
const uint kThirdCorner = 0x10000000u;
const uint kNumber = 0x0fffffffu;
uint sightOf(Hit hit, uint number) {
    return number | (hit.along >= 0.5 || hit.corner == 1u ? kSecondHalf : 0u) | (hit.corner == 2u ? kThirdCorner : 0u) | (kContours && hit.contour ? kContour : 0u) |
           (kClip && hit.cap ? kCutFace : 0u);
}
const bool kPlain = !kClip && !kContours;

/// Where a tile's numbers stand. The table has a rim of bins without any.
uint slotOf(ivec2 tile) {
    ivec2 bin = (tile + kTilesInBin) / kTilesInBin;
    ivec2 inBin = (tile + kTilesInBin) % kTilesInBin;
    uint first = slotAt(uint(bin.y) * (view.across + 2u) + uint(bin.x));
    return first == kNone ? kNone : first + uint(inBin.x * kTilesInBin + inBin.y);
}
uint numberIn(uint slot, int column, int row) {
    return slot == kNone ? 0u : numberAt((slot * uint(kTile) + uint(row & 7)) * uint(kTile) + uint(column & 7));
}

#if defined(CYLINDERS)
const bool kManySights = true;
#else
const bool kManySights = !kPlain;
#endif
/// Whether the look of a primitive changes inside a pixel that sees it in the middle, and beside which it is seen, too:
/// the halves of a bond meet there, a contour line begins, or a cut.
bool looksChange(uint number, vec2 middle) {
    if (number == 0u) return false;
    uint index = place(number);
    uint first = 0u;
    bool change = false;
    for (int i = 0; i < 4; ++i) {
        vec2 q = planePoint(middle + vec2(i & 1, i >> 1) - 0.5);
        uint sight = 0u;
#ifdef TRIANGLES
        if (isTriangle(index)) {
            Facet f = facetOf(index);
            sight = sightOf(facetHitThrough(f, q), number);
        } else
#endif
#ifdef CYLINDERS
        if (index >= view.spheres) {
            uint at = 2u * index - view.spheres;
            vec4 a = shapeAt(at);
            sight = sightOf(cylinderHitThrough(toView(a.xyz), toView(shapeAt(at + 1u).xyz), a.w, q), number);
        } else
#endif
        if (!kPlain) {
            vec4 shape = shapeAt(index);
            sight = sightOf(sphereHitThrough(vec4(toView(shape.xyz), shape.w), q), number);
        }
        change = change || (i > 0 && sight != first);
        first = i == 0 ? sight : first;
    }
    return change;
}

// The edge pixels of a tile, a bit each, block by block of 4 x 2 pixels: what is drawn at a time lies together.
uvec2 found = uvec2(0u);
uvec2 pixelOf(uint bit) { return uvec2(bit & 3u | bit >> 1 & 4u, bit >> 2 & 1u | bit >> 3 & 6u); }
/// @param bits  of up to 8 pixels of a row from a column on, which is a multiple of 4
void find(int column, int row, uint bits) {
    uint first = uint((row & 2) << 3 | (row & 1) << 2 | (column & 4) << 1);
    uint placed = (bits & 15u) << first | bits >> 4 << (first + 8u);
    found.x |= row < 4 ? placed : 0u;
    found.y |= row < 4 ? 0u : placed;
}

/// Finds them, and marks all others.
void findEdges(ivec2 tile, uint slot, uint lane) {
    const int kColumns = kLanes < kTile ? kTile / kLanes : 1;      // of a lane
    const int kRowsOfLane = kLanes > kTile ? kTile * kTile / kLanes : kTile;  // of a lane, one below the other
    int top = int(lane) / kTile * kRowsOfLane;
    for (int c = 0; c < kColumns; ++c) {
        int x = c * kLanes + int(lane) % kTile;
        uint above = top > 0 ? slot : slotOf(tile - ivec2(0, 1));
        uint below = top + kRowsOfLane < kTile ? slot : slotOf(tile + ivec2(0, 1));
        uint before = x > 0 ? slot : slotOf(tile - ivec2(1, 0));
        uint behind = x + 1 < kTile ? slot : slotOf(tile + ivec2(1, 0));
        uint last = numberIn(above, x, top - 1), here = numberIn(slot, x, top);
        for (int r = 0; r < kRowsOfLane; ++r) {
            int y = top + r;
            uint next = numberIn(r + 1 < kRowsOfLane ? slot : below, x, y + 1);
            bool edge = kEverywhere || here != last || here != next || here != numberIn(before, x - 1, y) ||
                        here != numberIn(behind, x + 1, y);
            if (kManySights && !kEverywhere)
                edge = edge || looksChange(here, vec2(tile * kTile + ivec2(x, y)) + 0.5);
            uint votes = subgroupBallot(edge).x;
            if (kLanes <= kTile)
                find(c * kLanes, y, votes);
            else
                for (int b = 0; b < kLanes / kTile; ++b)
                    find(0, b * kRowsOfLane + r, votes >> uint(b * kTile) & 0xffu);
            if (!kRows && !edge) edges[2u * (slot * uint(kTile * kTile) + uint(y * kTile + x)) + 1u] = kNoEdge;
            last = here;
            here = next;
        }
    }
}

uint lowestFound(uvec2 bits) { return bits.x != 0u ? lowestOf(bits.x) : 32u + lowestOf(bits.y); }

vec2 corner;  // of the lane's pixel
float nearest[kSamples];  // Hit::order
uint seen[kSamples];      // sights

/// Of equal distances the last wins: what stands equally near is listed in the order of numbers.
void keep(int i, bool inside, float Z, uint sight) {
    bool wins = inside && Z <= nearest[i];
    nearest[i] = wins ? Z : nearest[i];
    seen[i] = wins ? sight : seen[i];
}

void keepSphere(vec4 sphere, uint number, bool live) {
    if (kPerspective || !kPlain) {
        for (int i = 0; i < kSamples; ++i) {
            Hit hit = sphereHitThrough(sphere, planePoint(corner + sampleAt(i)));
            keep(i, live && hit.inside, hit.order, sightOf(hit, number));
        }
        return;
    }
    // sphereHitThrough() with what all samples have in common taken out.
    vec2 away = planePoint(corner) - sphere.xy;
    float square = live ? sphere.w * sphere.w : 0.0, front = view.origin - sphere.z;
    for (int i = 0; i < kSamples; ++i) {
        vec2 w = away + upright(sampleAt(i)) * vec2(view.pixel, -view.pixel);
        float h = square - dot(w, w);
        keep(i, h > 0.0, front - sqrt(max(h, 0.0)), number);
    }
}

/// What the samples of the lanes' pixels see. @param low, high  corners of what holds all of them, pixels
void sampleEdges(uint at, uint end, uint lane, vec2 low, vec2 high) {
    for (int i = 0; i < kSamples; ++i) {
        nearest[i] = view.depthStart + 1.0 / view.perRange;
        seen[i] = 0u;
    }
    vec2 a = planePoint(low), b = planePoint(high);
    vec2 middle = 0.5 * (a + b), reach = 0.5 * abs(b - a);
    bool more = true;
    do {
        bool mine = at + lane < end;
        Entry e = entryAt(listAt(min(at + lane, end - 1u)), middle, reach);
        uint balls = subgroupBallot(mine && e.meets && !e.cylinder && !e.facet).x;
        do {
            uint from = lowestOf(balls);
            keepSphere(handed(e.a, from), subgroupShuffle(e.number, from), balls != 0u);
            balls &= balls - 1u;
        } while (balls != 0u);
#ifdef CYLINDERS
        uint sticks = subgroupBallot(mine && e.meets && e.cylinder).x;
        do {
            uint from = lowestOf(sticks);
            vec4 endA = handed(e.a, from), endB = handed(e.b, from);
            uint number = subgroupShuffle(e.number, from);
            bool live = sticks != 0u;
            for (int i = 0; i < kSamples; ++i) {
                Hit hit = cylinderHitThrough(endA.xyz, endB.xyz, endA.w, planePoint(corner + sampleAt(i)));
                keep(i, live && hit.inside, hit.order, sightOf(hit, number));
            }
            sticks &= sticks - 1u;
        } while (sticks != 0u);
#endif
#ifdef TRIANGLES
        uint facets = subgroupBallot(mine && e.meets && e.facet).x;
        do {
            uint from = lowestOf(facets);
            vec3 ca = handedCorner(e.a.xyz, from), cb = handedCorner(e.b.xyz, from), cc = handedCorner(e.c, from);
            uint number = subgroupShuffle(e.number, from), joins = subgroupShuffle(e.joins, from);
            bool live = facets != 0u;
            for (int i = 0; i < kSamples; ++i) {
                Hit hit = triangleHitThrough(ca, cb, cc, joins, planePoint(corner + sampleAt(i)));
                keep(i, live && hit.inside, hit.order, sightOf(hit, number));
            }
            facets &= facets - 1u;
        } while (facets != 0u);
#endif
        at += uint(kLanes);
        float farthest = nearest[0];
        for (int i = 1; i < kSamples; ++i) farthest = max(farthest, nearest[i]);
        more = at < end && !subgroupAll(encodedDepth(farthest) < subgroupShuffle(e.next, uint(kLanes - 1)));
    } while (more);
}

/// Shades what a sample sees where the ray of a place meets it. @returns linear light
vec3 shadeAt(uint sight, vec2 place) {
    vec2 q = planePoint(place);
    Seen seen = seenOf(sight & kNumber, q);
    return clamp(lightOf(seen.hit, lookAt(seen.look), seen.occlusion, q), 0.0, 1.0);
}

/// Light and coverage of the lane's pixel. The middle of what shows of a line, or of what a plane cut, may be elsewhere.
vec4 shadeEdge() {
    vec3 light = vec3(0.0);
    float covered = 0.0;
    bool more = true;
    do {
        uint sight = 0u;
        for (int i = 0; i < kSamples; ++i) sight = max(sight, seen[i]);
        vec2 sum = vec2(0.0), last = vec2(0.0);
        float count = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            bool same = seen[i] == sight;
            sum += same ? sampleAt(i) : vec2(0.0);
            last = same ? sampleAt(i) : last;
            count += same ? 1.0 : 0.0;
            seen[i] = same ? 0u : seen[i];
        }
        if (sight != 0u) {
            light += count * shadeAt(sight, corner + (kPlain ? sum / count : last));
            covered += count;
            countFragment();
        }
        uint rest = 0u;
        for (int i = 0; i < kSamples; ++i) rest |= seen[i];
        more = subgroupAny(rest != 0u);
    } while (more);
    return vec4(light, covered) / float(kSamples);
}

/// @param slot  of the tile @param there  in it @param pixel  linear, premultiplied
void writeEdge(ivec2 tile, uint slot, uvec2 there, vec4 pixel) {
    if (kRows) {
        uvec2 at = uvec2(tile * kTile) + there;
        uint pitch = view.across * uint(kTile * kTilesInBin);
        edges[at.y * pitch + at.x] = packUnorm4x8(vec4(srgbFromLinear(clamp(pixel.rgb, 0.0, 1.0)), pixel.a));
    } else {
        uint at = 2u * ((slot * uint(kTile) + there.y) * uint(kTile) + there.x);
        edges[at] = packHalf2x16(pixel.rg);
        edges[at + 1u] = packHalf2x16(pixel.ba);
    }
}

void main() {
    view = push;
    uint lane = gl_SubgroupInvocationID;
    uint group = min(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x, view.offsets / 2u - 1u);
    uvec2 entry = uvec2(listAt(2u * group), listAt(2u * group + 1u));
    ivec2 tile = ivec2(entry.x & 0xffffu, entry.x >> 16);
    findEdges(tile, entry.y, lane);
    if (found == uvec2(0u)) return;
    ivec2 bin = tile / kTilesInBin;
    uint list = view.offsets + uint(bin.y) * view.across + uint(bin.x);
    uint at = listAt(list), end = listAt(list + 1u);
    do {
        uint mine = 0u;
        bool live = false;
        uvec2 low = uvec2(kTile), high = uvec2(0u);
        for (int i = 0; i < kLanes; ++i) {
            bool some = found != uvec2(0u);
            uint pixel = lowestFound(found);
            uvec2 next = some ? pixelOf(pixel) : low;
            low = min(low, next);
            high = some ? max(high, next) : high;
            // A lane that finds none left does what the first does.
            mine = i == 0 || (some && lane == uint(i)) ? pixel : mine;
            live = some && lane == uint(i) ? true : live;
            if (found.x != 0u)
                found.x &= found.x - 1u;
            else
                found.y &= found.y - 1u;
        }
        vec2 first = vec2(tile * kTile);
        uvec2 there = pixelOf(mine);
        corner = first + vec2(there);
        sampleEdges(at, end, lane, first + vec2(low), first + vec2(high) + 1.0);
        vec4 pixel = shadeEdge();
        if (live) writeEdge(tile, entry.y, there, pixel);
    } while (found != uvec2(0u));
}
