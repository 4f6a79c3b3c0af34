#version 440
// Edges of the `tiles` path: draws the pixels listed by tile_edge_pixels.comp with 16 samples each, one pixel per lane.
// Candidates of a sample are the primitives at the centres of the pixel and its eight neighbours; where primitives may
// be smaller, the bin's list is searched as in tile_nearest.comp. Then each visible primitive is shaded once, at the
// mean of its samples, and weighted by their number.
//   TEXELS, CYLINDERS, TRIANGLES   as in tile_nearest.comp
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
#include "common/sight.glsl"
#include "common/count.glsl"

layout(push_constant) uniform Push { TileConstants push; };
// Edges overwrite coded words of the picture; otherwise they are halves.
layout(constant_id = kRowsId) const bool kRows = false;

#ifdef TEXELS
layout(set = 0, binding = 5) uniform usamplerBuffer listTexels;
layout(set = 0, binding = 6) uniform usamplerBuffer numberTexels;
layout(set = 0, binding = 7) uniform usamplerBuffer edgePixelTexels;
uint listAt(uint i) { return texelFetch(listTexels, int(i)).x; }
uint numberAt(uint i) { return texelFetch(numberTexels, int(i)).x; }
uint edgePixelAt(uint i) { return texelFetch(edgePixelTexels, int(i)).x; }
#else
layout(set = 0, binding = 5, std430) readonly buffer Lists { uint lists[]; };
layout(set = 0, binding = 6, std430) readonly buffer Numbers { uint numbers[]; };
layout(set = 0, binding = 7, std430) readonly buffer EdgePixels { uint edgePixels[]; };
uint listAt(uint i) { return lists[i]; }
uint numberAt(uint i) { return numbers[i]; }
uint edgePixelAt(uint i) { return edgePixels[i]; }
#endif
layout(set = 0, binding = 8, std430) writeonly buffer Edges { uint edges[]; };

// Samples search the list of their bin.
layout(constant_id = kListedId) const bool kListed = false;
#if defined(TRIANGLES)
layout(constant_id = kSpheresId) const bool kSpheres = true;
layout(constant_id = kCylindersId) const bool kCylinders = true;
#else
const bool kSpheres = true, kCylinders = true;
#endif
const uint kNothing = 0xffffffffu;

vec2 corner;  // of the lane's pixel
float nearest[kSamples];  // Hit::order
uint seen[kSamples];      // sights
bool holes = false;  // samples without a hit may lack candidates

/// At equal distances the largest number wins.
void keep(int i, bool inside, float Z, uint sight) {
    bool wins = inside && (Z < nearest[i] || (Z == nearest[i] && (sight & kNumber) >= (seen[i] & kNumber)));
    nearest[i] = wins ? Z : nearest[i];
    seen[i] = wins ? sight : seen[i];
}

void keepStick(Stick stick, uint number, bool live) {
    for (int i = 0; i < kSamples; ++i) {
        Hit hit = stickHitThrough(stick, planePoint(corner + sampleAt(i)));
        keep(i, live && hit.inside, hit.order, packSight(hit, number));
    }
}

void keepSphere(vec4 sphere, uint number, bool live) {
    if (kPerspective || !kPlain) {
        for (int i = 0; i < kSamples; ++i) {
            Hit hit = numberedBallHit(number, sphere, planePoint(corner + sampleAt(i)));
            keep(i, live && hit.inside, hit.order, packSight(hit, number));
        }
        return;
    }
    // sphereHitThrough() with the terms common to all samples hoisted.
    vec2 away = planePoint(corner) - sphere.xy;
    float square = live ? sphere.w * sphere.w : 0.0, front = view.origin - sphere.z;
    for (int i = 0; i < kSamples; ++i) {
        vec2 w = away + upright(sampleAt(i)) * vec2(view.pixel, -view.pixel);
        float h = square - dot(w, w);
        keep(i, h > 0.0, front - sqrt(max(h, 0.0)), number);
    }
}

#ifdef TRIANGLES
void keepFacet(vec3 a, vec3 b, vec3 c, uint division, uint number, bool live) {
    if (!kPlain) {
        for (int i = 0; i < kSamples; ++i) {
            Hit hit = triangleHitThrough(a, b, c, division, planePoint(corner + sampleAt(i)));
            keep(i, live && hit.inside, hit.order, packSight(hit, number));
        }
        return;
    }
    // triangleHitThrough() is linear in the position: the corners' weights, depth (perspective: its reciprocal), and
    // the functions of the weights that select the look.
    vec2 q = planePoint(corner), pa = a.xy - q, pb = b.xy - q, pc = c.xy - q;
    vec3 sides = vec3(edgeSide(pb, pc), edgeSide(pc, pa), edgeSide(pa, pb));
    float sum = sides.x + sides.y + sides.z;
    float unit = 1.0 / (sum == 0.0 ? 1.0 : sum);
    vec3 heights = vec3(a.z, b.z, c.z);
    mat3 shares;  // at the pixel, and their gradients along the plane's axes
    shares[0] = sides * unit;
    shares[1] = vec3(b.y - c.y, c.y - a.y, a.y - b.y) * unit;
    shares[2] = vec3(c.x - b.x, a.x - c.x, b.x - a.x) * unit;
    vec3 depth;
    mat3 alike;
    for (int k = 0; k < 3; ++k) {
        vec3 inSpace = kPerspective ? shares[k] * heights : shares[k];
        depth[k] = dot(shares[k], heights);
        alike[k] = computeClaims(inSpace, division);
    }
    // Resolves ties up to rounding in favour of the first.
    alike[0] += vec3(2e-6, 1e-6, 0.0) * (kPerspective ? abs(a.z) : 1.0);
    live = live && sum != 0.0;
    for (int i = 0; i < kSamples; ++i) {
        vec2 d = upright(sampleAt(i)) * vec2(view.pixel, -view.pixel);
        vec3 here = shares[0] + shares[1] * d.x + shares[2] * d.y;
        float along = depth.x + depth.y * d.x + depth.z * d.y;
        vec3 looks = alike[0] + alike[1] * d.x + alike[2] * d.y;
        uint flag = looks.x >= max(looks.y, looks.z) ? 0u : looks.y >= looks.z ? kSecondHalf : kThirdCorner;
        // No sample may fall between two adjacent triangles.
        bool inside = live && min(here.x, min(here.y, here.z)) >= -1e-5;
        keep(i, inside, kPerspective ? 1.0 / along : along, number | flag);
    }
}
#endif

void seeNothing() {
    for (int i = 0; i < kSamples; ++i) {
        nearest[i] = view.depthStart + 1.0 / view.perRange;
        seen[i] = 0u;
    }
}

/// Whether the rest of a list may be in front of some sample. @param next  from the chunk's last lane, as in entryAt()
bool goesOn(uint at, uint end, float next) {
    float farthest = nearest[0];
    for (int i = 1; i < kSamples; ++i) farthest = max(farthest, nearest[i]);
    return at < end && anyLane(encodedDepth(farthest) >= subgroupShuffle(next, uint(kLanes - 1)));
}

/// Draws the bin's list into the samples of the lanes' pixels. @param lane  index in the subgroup
void sampleList(uint at, uint end, uint lane) {
    vec2 low = corner, high = corner;
    for (uint i = 0u; i < uint(kLanes); ++i) {
        vec2 other = vec2(subgroupShuffle(corner.x, i), subgroupShuffle(corner.y, i));
        low = min(low, other);
        high = max(high, other);
    }
    high += 1.0;
    seeNothing();
    vec2 a = planePoint(low), b = planePoint(high);
    vec2 middle = 0.5 * (a + b), reach = 0.5 * abs(b - a);
    bool more = true;
    do {
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
                vec3 ca = handedCorner(e.a.xyz, from), cb = handedCorner(e.b, from), cc = handedCorner(e.c, from);
                keepFacet(ca, cb, cc, subgroupShuffle(e.division, from), subgroupShuffle(e.number, from), facets != 0u);
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
            keepSphere(handed(e.a, from), subgroupShuffle(e.number, from), balls != 0u);
            balls &= balls - 1u;
        } while (balls != 0u);
#ifdef CYLINDERS
        if (kCylinders) do {
            uint from = lowestBit(sticks);
            keepStick(handed(e.stick, from), subgroupShuffle(e.number, from), sticks != 0u);
            sticks &= sticks - 1u;
        } while (sticks != 0u);
#endif
        more = goesOn(at, end, e.next);
    } while (more);
}

#ifndef TRIANGLES
/// Removes the lowest of some candidates. @returns it; kNothing if none is left
uint lowestOut(inout uint candidates[9]) {
    uint lowest = kNothing;
    for (int i = 0; i < 9; ++i) lowest = min(lowest, candidates[i]);
    for (int i = 0; i < 9; ++i) candidates[i] = candidates[i] == lowest ? kNothing : candidates[i];
    return lowest;
}
bool anyOf(uint candidates[9]) {
    uint all = kNothing;
    for (int i = 0; i < 9; ++i) all &= candidates[i];
    return anyLane(all != kNothing);
}

/// Draws the primitives at the centres of surrounding pixels into a pixel's samples.
void sampleNeighbours(ivec2 pixel) {
    ivec2 last = ivec2(int(view.across), int(edgePixelAt(1u))) * ivec2(kTile * kTilesInBin, 1) - 1;
    uint candidates[9];
    holes = true;
    for (int i = 0; i < 9; ++i) {
        ivec2 p = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
        // Numbers from 0; none equals kNothing.
        candidates[i] = numberAt(uint(p.y * (last.x + 1) + p.x)) & kNumber;
        holes = holes && candidates[i] != 0u;
        candidates[i] -= 1u;
    }
#ifdef CYLINDERS
    uint sticks[9];
    for (int i = 0; i < 9; ++i) {
        bool stick = candidates[i] != kNothing && place(candidates[i] + 1u) >= view.spheres;
        sticks[i] = stick ? candidates[i] : kNothing;
        candidates[i] = stick ? kNothing : candidates[i];
    }
#endif
    seeNothing();
    bool more = true;
    do {
        uint candidate = lowestOut(candidates);
        bool live = candidate != kNothing;
        vec4 shape = shapeAt(place(live ? candidate + 1u : 1u));
        keepSphere(vec4(toView(shape.xyz), shape.w), candidate + 1u, live);
        more = anyOf(candidates);
    } while (more);
#ifdef CYLINDERS
    do {
        uint candidate = lowestOut(sticks);
        bool live = candidate != kNothing;
        uint at = 2u * place(live ? candidate + 1u : view.spheres + 1u) - view.spheres;
        vec4 shape = shapeAt(at);
        keepStick(stickAt(shape, shapeAt(at + 1u)), candidate + 1u, live);
        more = anyOf(sticks);
    } while (more);
#endif
}
#endif

/// Shades a sample's sight where the ray of a position hits it. @returns linear light
vec3 shadeAt(uint sight, vec2 place) {
    vec2 q = planePoint(place);
    Seen seen = findSeen(sight & kNumber, q);
    // The middle of what is seen beside a band may lie in it.
    if (kEllipsoids != 0 && seen.hit.corner >= kEllipsoidMark)
        seen.hit.corner = (seen.hit.corner & ~kBandMark) | ((sight & kSecondHalf) != 0u ? kBandMark : 0u);
    return clamp(computeLight(seen.hit, storedColor(seen), seen.baked, q), 0.0, 1.0);
}

/// Position for shading some samples: their centre. An outline, a clipped primitive or the face of a cut may not be
/// there: then the nearest of the samples. @param bits  of the samples
vec2 shadingPoint(uint bits, vec2 middle) {
    if (!kClip && !kContours && kEllipsoids < 2) return middle;
    vec2 place = middle;
    float least = 4.0;
    for (int i = 0; i < kSamples; ++i) {
        vec2 away = sampleAt(i) - middle;
        float square = (bits >> uint(i) & 1u) == 1u ? dot(away, away) : 4.0;
        place = square < least ? sampleAt(i) : place;
        least = min(least, square);
    }
    return place;
}

/// Light and coverage of the lane's pixel.
vec4 shadeEdge() {
    vec3 light = vec3(0.0);
    float covered = 0.0;
    bool more = true;
    do {
        uint sight = 0u;
        for (int i = 0; i < kSamples; ++i) sight = max(sight, seen[i]);
        vec2 sum = vec2(0.0);
        float count = 0.0;
        uint bits = 0u;
        for (int i = 0; i < kSamples; ++i) {
            bool same = seen[i] == sight;
            sum += same ? sampleAt(i) : vec2(0.0);
            bits |= same ? 1u << uint(i) : 0u;
            count += same ? 1.0 : 0.0;
            seen[i] = same ? 0u : seen[i];
        }
        if (sight != 0u) {
            light += count * shadeAt(sight, corner + shadingPoint(bits, sum / count));
            covered += count;
            countFragment();
        }
        uint rest = 0u;
        for (int i = 0; i < kSamples; ++i) rest |= seen[i];
        more = anyLane(rest != 0u);
    } while (more);
    return vec4(light, covered) / (holes ? max(covered, 1.0) : float(kSamples));
}

/// @param pixel  linear, premultiplied
void writeEdge(uvec2 there, vec4 pixel) {
    uint at = there.y * (view.across * uint(kTile * kTilesInBin)) + there.x;
    if (kRows) {
        edges[at] = packUnorm4x8(vec4(srgbFromLinear(clamp(pixel.rgb, 0.0, 1.0)), pixel.a));
    } else {
        edges[2u * at] = packHalf2x16(pixel.rg);
        edges[2u * at + 1u] = packHalf2x16(pixel.ba);
    }
}

void main() {
    view = push;
    uint lane = gl_SubgroupInvocationID;
    uint fillings = edgePixelAt(0u), filling = gl_WorkGroupID.x;
    do {
        bool some = filling < fillings;
        uint mine = edgePixelAt(kEdgeHeader + (some ? filling : 0u) * uint(kLanes) + lane);
        uint first = subgroupShuffle(mine, 0u);
        bool live = some && mine != kNoEdge;
        // Lanes without a pixel repeat the first lane's work.
        uint word = !some ? 0u : live ? mine : first;
        uvec2 pixel = uvec2(word & 0xffffu, word >> 16);
        corner = vec2(pixel);
#ifdef TRIANGLES
        const bool listed = true;  // neighbours name no triangle
#else
        const bool listed = kListed;
#endif
        if (listed) {
            uvec2 bin = uvec2(first & 0xffffu, first >> 16) / uint(kTile * kTilesInBin);
            uint list = view.offsets + bin.y * view.across + bin.x;
            // Without work, an empty list: the word before it is the number of a primitive.
            uint at = listAt(some ? list : view.offsets);
            sampleList(at, some ? listAt(list + 1u) : at, lane);
        }
#ifndef TRIANGLES
        if (!listed) sampleNeighbours(ivec2(pixel));
#endif
        vec4 light = shadeEdge();
        if (live) writeEdge(pixel, light);
        filling += gl_NumWorkGroups.x;
    } while (filling < fillings);
}
