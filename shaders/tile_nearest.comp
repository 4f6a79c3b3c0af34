#version 440
// Visibility of the `tiles` path: the nearest primitive per pixel. One subgroup draws a tile of 8 x 8 pixels and keeps
// nearest depth and number in registers. It processes the list of the tile's bin, sorted by nearest depth, in chunks of
// as many entries as it has lanes: each lane fetches one and tests it against the tile; entries that pass are broadcast.
// It ends where the next entry begins behind the tile's farthest pixel.
//   TEXELS      as in common/streams.glsl
//   CYLINDERS, TRIANGLES   the scene has some
// SHADED      writes sRGB-coded colours instead of numbers, row by row
// RIMS        with SHADED: finds outlines and halos in a second pass over the list, and composites them
// lavapipe 22.3 runs each loop body at least once; the extra iteration is harmless.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 0
#define LOOKS 4
#define ATLAS 5
#define EFFECTS 6
#ifdef TEXELS
#define CELLS 7
#endif
#define SHADOW 9
#ifdef SHADED
#include "common/numbered.glsl"
#else
#undef LOOKS
#include "common/hit.glsl"
#include "common/streams.glsl"
#endif
#include "common/tile_lists.glsl"
#include "common/sight.glsl"
#include "common/changes.glsl"
#ifdef RIMS
#include "common/samples.glsl"
#ifndef TRIANGLES
#define NO_TRIANGLES
#endif
#endif

layout(push_constant) uniform Push { TileConstants push; };
const int kPixels = kTile * kTile / kLanes;  // per lane: pixels i x kLanes + lane of the tile, row by row

#ifdef TEXELS
layout(set = 0, binding = 2) uniform usamplerBuffer listTexels;
uint listAt(uint i) { return texelFetch(listTexels, int(i)).x; }
#else
layout(set = 0, binding = 2, std430) readonly buffer Lists { uint lists[]; };
uint listAt(uint i) { return lists[i]; }
#endif
layout(set = 0, binding = 3, std430) buffer Numbers { uint numbers[]; };
layout(constant_id = kSeededId) const bool kSeeded = false;
layout(constant_id = kListedId) const bool kListed = true;  // false: all lists are empty
layout(constant_id = kClearsId) const bool kClears = false;
#if defined(CYLINDERS)
layout(constant_id = kSpheresId) const bool kSpheres = true;
layout(constant_id = kCylindersId) const bool kCylinders = true;
layout(constant_id = kTrianglesId) const bool kTriangles = true;
#else
const bool kSpheres = true;
#endif

vec2 through[kPixels];
float nearest[kPixels];
uint number[kPixels];

#ifdef RIMS
/// Samples of a picture's pixel are 4 x 4 pixels of this frame, at the positions of edge samples.
vec2 sampledAt(vec2 pixel) {
    uvec2 p = uvec2(pixel), own = p & 3u;
    vec2 among = vec2(p - own) + 4.0 * sampleAt(int(4u * own.y + own.x));
    return effects.subsamples != 0u ? among : pixel;
}
#else
vec2 sampledAt(vec2 pixel) { return pixel; }
#endif

/// Whether the rest of a list may be in front of some pixel. @param next  from the chunk's last lane, as in entryAt()
bool goesOn(uint at, uint end, float next) {
    float farthest = nearest[0];
    for (int i = 1; i < kPixels; ++i) farthest = max(farthest, nearest[i]);
    return at < end && anyLane(farthest >= subgroupShuffle(next, uint(kLanes - 1)));
}

#ifdef RIMS
#include "common/tile_rims.glsl"
#endif

void keep(int i, Hit hit, uint candidate, bool live) {
    float depth = encodedDepth(hit.order);
    // At equal depths the last wins, as with a LESS_OR_EQUAL test.
    bool wins = live && hit.inside && (depth < nearest[i] || (depth == nearest[i] && candidate > number[i]));
    nearest[i] = wins ? depth : nearest[i];
    number[i] = wins ? candidate : number[i];
#ifdef RIMS
    behindZ[i] = wins ? hit.Z : behindZ[i];
#endif
}

#include "common/tile_seeds.glsl"

layout(constant_id = kNumberedId) const bool kNumbered = false;
#ifndef SHADED
uint sightAt(uint number, vec2 q) {
    uint index = place(max(number, 1u));
    uint sight = number;
#ifdef TRIANGLES
    if (isTriangle(index))
        sight = packSight(facetHitThrough(loadFacet(index), q), number);
    else
#endif
#ifdef CYLINDERS
    if (index >= view.spheres) {
        uint at = 2u * index - view.spheres;
        sight = packSight(stickHitThrough(stickAt(shapeAt(at), shapeAt(at + 1u)), q), number);
    } else
#endif
    if (!kPlain) {
        vec4 shape = shapeAt(index);
        sight = packSight(ballHitThrough(index, vec4(toView(shape.xyz), shape.w), q), number);
    }
    return number == 0u ? 0u : sight;
}

/// Marks a sight that changes between corners of its pixel: the tip of an outline.
uint marked(uint sight, vec2 pixel, float width, float depth) {
    if (!kContours || !kNumbered) return sight;
    view.contourWidth = width;
    view.contourDepth = depth;
    uint first = 0u;
    bool changes = false;
    for (int i = 0; i < 4; ++i) {
        uint there = sightAt(sight & kNumber, planePoint(pixel + vec2(i & 1, i >> 1) - 0.5));
        changes = changes || (i > 0 && there != first);
        first = i == 0 ? there : first;
    }
    view.contourWidth = 1e9;
    view.contourDepth = 0.0;
    return changes ? sight | kChanges : sight;
}
#endif

#ifdef SHADED
layout(set = 0, binding = 8, std430) writeonly buffer PixelNumbers { uint pixelNumbers[]; };
const uint kBalls = 0u, kSticks = 1u, kFacets = 2u;

#ifdef RIMS
/// Coded colour with halos and outlines. @param seen  linear, premultiplied
uint rimmed(vec4 seen, uint rimWord) {
    vec4 shown = underRim(seen, unpackUnorm4x8(rimWord).rgb);
    return packUnorm4x8(vec4(asTargetTakesIt(shown.rgb), shown.a));
}
#endif

#ifdef CYLINDERS
#include "common/tile_slots.glsl"
#endif

Hit ballHit(uint index, vec2 q) {
    vec4 shape = shapeAt(index);
    return ballHitThrough(index, vec4(toView(shape.xyz), shape.w), q);
}
#define KIND kBalls
#define FIRST 0u
#define SEEN seenBall
#define HIT ballHit
#define SIGHT_AT sightOfBall
#define MARKED markedBall
#define COLOR_AT colorOfBall
#define SHADE shadeBalls
#include "common/tile_kind.glsl"
#ifdef CYLINDERS
Hit stickHit(uint index, vec2 q) {
    uint at = 2u * index - view.spheres;
    return stickHitThrough(stickAt(shapeAt(at), shapeAt(at + 1u)), q);
}
#define KIND kSticks
#define FIRST view.spheres
#define SEEN seenStick
#define HIT stickHit
#define SIGHT_AT sightOfStick
#define MARKED markedStick
#define COLOR_AT colorOfStick
#define SHADE shadeSticks
#include "common/tile_kind.glsl"
#endif
#ifdef TRIANGLES
Hit facetHit(uint index, vec2 q) { return facetHitThrough(loadFacet(index), q); }
#define KIND kFacets
#define FIRST (view.spheres + view.cylinders)
#define SEEN seenFacet
#define HIT facetHit
#define SIGHT_AT sightOfFacet
#define MARKED markedFacet
#define COLOR_AT colorOfFacet
#define SHADE shadeFacets
#include "common/tile_kind.glsl"
#endif
#endif

/// @param index  number of the tile in the lists @param last  last tile of the group
void drawTile(uint index, bool last) {
    uint lane = gl_SubgroupInvocationID;
    uint tile = listAt(index);
    uvec2 corner = tileCorner(tile);
    uvec2 bin = corner / uint(kTile * kTilesInBin);
    uint at = listAt(view.offsets + bin.y * view.across + bin.x);
    uint end = listAt(view.offsets + bin.y * view.across + bin.x + 1u);

    vec2 first = vec2(corner + uvec2(lane % uint(kTile), lane / uint(kTile))) + 0.5;
    for (int i = 0; i < kPixels; ++i) {
        through[i] = planePoint(sampledAt(first + vec2((i * kLanes) % kTile, (i * kLanes) / kTile)));
        nearest[i] = isWanted(tile, uint(i * kLanes) + lane) ? 1.0 : -1.0;
        number[i] = 0u;
#ifdef RIMS
        behindZ[i] = 1e30;
#endif
    }
    // Row by row over all bins.
    uint pitch = view.across * uint(kTile * kTilesInBin);
    uint here = (corner.y + lane / uint(kTile)) * pitch + corner.x + lane % uint(kTile);
    uint seeds[kPixels];
    if (kSeeded) {
        for (int i = 0; i < kPixels; ++i)
            seeds[i] = numbers[here + uint((i * kLanes) / kTile) * pitch + uint((i * kLanes) % kTile)];
        beginAll(seeds);
    }
    vec2 middle = planePoint(vec2(corner) + float(kTile / 2));
    vec2 reach = vec2(float(kTile / 2) * view.pixel);
    float width = view.contourWidth, depth = view.contourDepth;
#ifdef RIMS
    uint begin_ = at;
    // Outlines that are drawn as rims are no hits, nor are outlines without a width.
    view.contourWidth = effects.lineWidth > 0.0 || width == 0.0 ? -1e30 : width;
#endif
    bool more = true;  // the word before an empty list is the number of a primitive
    if (kListed) do {
#ifdef TRIANGLES
        // In lists of triangles only, a chunk skips the loops of other kinds.
        uint balls, sticks;
        Entry e;
        do {
            bool mine = at + lane < end;
            e = entryAt(listAt(min(at + lane, end - 1u)), middle, reach);
            balls = ballotLanes(mine && e.meets && !e.cylinder && !e.facet);
            sticks = ballotLanes(mine && e.meets && e.cylinder);
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
        } while ((balls | sticks) == 0u && goesOn(at, end, e.next));
#else
        bool mine = at + lane < end;
        Entry e = entryAt(listAt(min(at + lane, end - 1u)), middle, reach);
        uint balls = ballotLanes(mine && e.meets && !e.cylinder);
        uint sticks = ballotLanes(mine && e.meets && e.cylinder);
        at += uint(kLanes);
#endif
        if (kSpheres) do {
            uint from = lowestBit(balls);
            vec4 sphere = handed(e.a, from);
            uint candidate = subgroupShuffle(e.number, from);
            bool live = balls != 0u;
            for (int i = 0; i < kPixels; ++i) keep(i, numberedBallHit(candidate, sphere, through[i]), candidate, live);
            balls &= balls - 1u;
        } while (balls != 0u);
#ifdef CYLINDERS
        if (kCylinders) do {
            uint from = lowestBit(sticks);
            Stick stick = handed(e.stick, from);
            uint candidate = subgroupShuffle(e.number, from);
            bool live = sticks != 0u;
            for (int i = 0; i < kPixels; ++i) keep(i, stickHitThrough(stick, through[i]), candidate, live);
            sticks &= sticks - 1u;
        } while (sticks != 0u);
#endif
        more = goesOn(at, end, e.next);
    } while (more);
#ifdef RIMS
    float chosenWidth = view.contourWidth;
    findRims(begin_, end, lane, middle, reach);
    view.contourWidth = chosenWidth;
    if (chosenWidth > 0.0)
#endif
    view.contourWidth = 1e9;  // a chosen candidate that is not inside is on the outline
    view.contourDepth = 0.0;
#ifdef SHADED
#ifdef CYLINDERS
    // Clears empty pixels, except for halos and outlines over them, and for initial hits that turn out to be misses.
#ifdef RIMS
    for (int i = 0; i < kPixels; ++i) {
        uvec2 on = uvec2(i * kLanes) / uvec2(1u, kTile) % uint(kTile);
        if (number[i] == 0u) numbers[here + on.y * pitch + on.x] = rimmed(vec4(0.0), rimWords[i]);
    }
#else
    if (kSeeded || kClears) {
        uint lost = 0u, rows = 0u;
        for (int i = 0; i < kPixels; ++i) lost |= number[i] == 0u && (kClears || seeds[i] != 0u) ? 1u << i : 0u;
        rows = bitsOfAll(lost);
        do {
            uint i = lowestBit(rows);
            uvec2 on = uvec2(i * uint(kLanes)) / uvec2(1u, kTile) % uint(kTile);
            if ((lost >> i & 1u) != 0u) {
                numbers[here + on.y * pitch + on.x] = 0u;
                if (kClears && kNumbered) pixelNumbers[here + on.y * pitch + on.x] = 0u;
            }
            rows &= rows - 1u;
        } while (rows != 0u);
    }
#endif
    if (kSpheres) shadeBalls(leftBalls, last, corner, pitch, lane, width, depth);
    if (kCylinders) shadeSticks(leftSticks, last, corner, pitch, lane, width, depth);
#ifdef TRIANGLES
    if (kTriangles) shadeFacets(leftFacets, last, corner, pitch, lane, width, depth);
#endif
#else
    // One iteration for the pixels of all lanes, not unrolled; skipped if all are empty.
    uint shown = 0u;
    for (int i = 0; i < kPixels; ++i) shown |= number[i] != 0u ? 1u << i : 0u;
    shown = bitsOfAll(shown);
    uint empty = ~shown & ((2u << (kPixels - 1)) - 1u);
#ifdef RIMS
    uint rimmedRows = 0u;
    for (int i = 0; i < kPixels; ++i) rimmedRows |= rimWords[i] != 0u ? 1u << i : 0u;
    shown |= bitsOfAll(rimmedRows);
    empty &= ~shown;
#endif
    do {
        uvec2 on = uvec2(lowestBit(empty) * uint(kLanes)) / uvec2(1u, kTile) % uint(kTile);
        if (empty != 0u) {
            numbers[here + on.y * pitch + on.x] = 0u;
            if (kNumbered) pixelNumbers[here + on.y * pitch + on.x] = 0u;
        }
        empty &= empty - 1u;
    } while (empty != 0u);
    do {
        uint i = lowestBit(shown), seen = number[0], rim = 0u;
        for (int k = 1; k < kPixels; ++k) seen = i == uint(k) ? number[k] : seen;
#ifdef RIMS
        for (int k = 0; k < kPixels; ++k) rim = i == uint(k) ? rimWords[k] : rim;
#endif
        shown &= shown - 1u;
        uvec2 on = uvec2(i * uint(kLanes)) / uvec2(1u, kTile) % uint(kTile);
        numbers[here + on.y * pitch + on.x] = colorOfBall(seen, first + vec2(on), rim);
        if (kNumbered) pixelNumbers[here + on.y * pitch + on.x] = markedBall(seen, first + vec2(on), width, depth);
    } while (shown != 0u);
#endif
#else
    for (int i = 0; i < kPixels; ++i) {
        uvec2 on = uvec2(i * kLanes) / uvec2(1u, kTile) % uint(kTile);
        numbers[here + on.y * pitch + on.x] = 
            kNumbered ? marked(sightAt(number[i], through[i]), first + vec2(on), width, depth) : number[i];
    }
#endif
}

/// Whether a tile is drawn in this round of the device's lists.
bool drawsTile(uint index) { return !kClears || (listAt(index) & kOtherRoundBit) == 0u; }

void main() {
    view = push;
    // If rows of workgroups are uneven, the last tile is drawn again.
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
#ifdef SHADED
    // On a software device, starting a workgroup costs as much as shading some rows of pixels: each draws several
    // tiles.
    float width = view.contourWidth, depth = view.contourDepth;
    uint groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y, ofGroup = (view.offsets + groups - 1u) / groups;
    uint at = min(group * ofGroup, view.offsets - 1u), end = min(at + ofGroup, view.offsets);
#ifdef CYLINDERS
    leftBalls = leftSticks = leftFacets = Left(0u, 0u, 0u, 0u);
#endif
    do {
        view.contourWidth = width;
        view.contourDepth = depth;
        if (drawsTile(at)) drawTile(at, at + 1u == end);
        ++at;
    } while (at < end);
#else
    uint index = min(group, view.offsets - 1u);
    if (drawsTile(index)) drawTile(index, true);
#endif
}
