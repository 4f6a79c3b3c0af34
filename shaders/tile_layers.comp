#version 440
// Translucent primitives of the `tiles` path. One subgroup draws a tile of 8 x 8 pixels from the list of its bin, as in
// tile_nearest.comp. A first walk over the list finds the two nearest primitives of each pixel, and ends where the next
// entry begins behind the second of every pixel. A second walk shades them, adds up the rest (common/rest.glsl), and
// ends behind opaque shapes. The layers of a pixel go to a buffer, as they are blended.
//   TEXELS   as in common/streams.glsl
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#define TILES
#define CYLINDERS
#define TRIANGLES
#define TRANSLUCENT
#define COPY_OF_PIXEL
#define STREAMS 0
#define LOOKS 4
#define ATLAS 5
#define EFFECTS 6
#ifdef TEXELS
#define CELLS 7
#endif
#define SHADOW 9
#include "common/numbered.glsl"
#include "common/tile_lists.glsl"
#include "common/layers.glsl"
#include "common/rest.glsl"
#include "common/mixed_rest.glsl"

layout(push_constant) uniform Push { TileConstants push; };
const int kPixels = kTile * kTile / kLanes;  // per lane: pixels i x kLanes + lane of the tile, quarter by quarter
/// Pixel of a tile. Lanes share the wanted quarters evenly.
const uint kHalf = uint(kTile / 2), kQuarterPixels = kHalf * kHalf;
uvec2 pixelOf(int i, uint lane) {
    uint at = uint(i * kLanes) + lane, quarter = at / kQuarterPixels;
    return uvec2(quarter % 2u, quarter / 2u) * kHalf + uvec2(at, at / kHalf) % kHalf;
}

#ifdef TEXELS
layout(set = 0, binding = 2) uniform usamplerBuffer listTexels;
uint listAt(uint i) { return texelFetch(listTexels, int(i)).x; }
#else
layout(set = 0, binding = 2, std430) readonly buffer Lists { uint lists[]; };
uint listAt(uint i) { return lists[i]; }
#endif
layout(set = 0, binding = 3, std430) writeonly buffer Layers { uvec2 layers[]; };  // see layer_color.frag
layout(set = 0, binding = 8) uniform sampler2D opaqueDepth;
layout(constant_id = kSpheresId) const bool kSpheres = true;
layout(constant_id = kCylindersId) const bool kCylinders = true;
layout(constant_id = kTrianglesId) const bool kTriangles = true;
const int kBall = 0, kStick = 1, kFacet = 2;

vec2 through[kPixels];
float first[kPixels], second[kPixels], opaque[kPixels];
uint firstNumber[kPixels], secondNumber[kPixels];
vec4 nearest[kPixels], next[kPixels];  // layers: light, opacity
vec4 sums[kPixels];
float depths[kPixels];

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

/// Hits of a chunk's entries in the lane's pixels that are seen: bit n * kPixels + i is that of entry n in pixel i.
/// There are 64.
uvec2 hits;
void mark(uint entry, int i, Hit hit, uint candidate, bool live) {
    float d = encodedDepth(hit.order);
    bool layer = candidate == firstNumber[i] || candidate == secondNumber[i];
    bool adds = live && hit.inside && (layer || d > second[i] + kLayerStep) && d <= opaque[i];
    uint at = entry * uint(kPixels) + uint(i), bit = adds ? 1u << (at & 31u) : 0u;
    hits |= at < 32u ? uvec2(bit, 0u) : uvec2(0u, bit);
}

/// A function of its own: glslangValidator 12 may take all memory to follow `precise` through the parts of a struct.
float depthBehind(float order, float before) {
    precise float behind = encodedDepth(order) - before;
    return behind;
}

/// Shades the hits. Each lane takes its own: fewer lanes idle than if all took one entry after the other.
/// @param number  of the lane's entry
void shadeHits(const int kind, uint number) {
    const uint firstOfKind = kind == kBall ? 0u : kind == kStick ? view.spheres : view.spheres + view.cylinders;
    do {
        bool upper = hits.x == 0u, adds = (hits.x | hits.y) != 0u;
        uint at = lowestBit(upper ? hits.y : hits.x) + (upper ? 32u : 0u);
        hits = upper ? uvec2(0u, hits.y & (hits.y - 1u)) : uvec2(hits.x & (hits.x - 1u), hits.y);
        at = adds ? at : 0u;
        uint i = at % uint(kPixels);
        uint candidate = subgroupShuffle(number, at / uint(kPixels));
        uint index = place(candidate);
        index = adds ? index : firstOfKind;  // the loop runs once without a hit
        vec2 q = through[0];
        float before = second[0];
        uint ofFirst = firstNumber[0], ofSecond = secondNumber[0];
        for (int k = 1; k < kPixels; ++k) {
            q = i == uint(k) ? through[k] : q;
            before = i == uint(k) ? second[k] : before;
            ofFirst = i == uint(k) ? firstNumber[k] : ofFirst;
            ofSecond = i == uint(k) ? secondNumber[k] : ofSecond;
        }
        bool isFirst = adds && candidate == ofFirst, isSecond = adds && candidate == ofSecond;
        Seen seen;
        if (kind == kBall) seen = seenBall(index, q);
        if (kind == kStick) seen = seenStick(index, q);
        if (kind == kFacet) {
            seen = seenFacet(index, q);
            Facet f = loadFacet(index);
            vec3 a = projectVertex(f.a, f.step), b = projectVertex(f.b, f.step), c = projectVertex(f.c, f.step);
            adds = adds && ownsEdge(a, b, c, q);
        }
        uint bits = storedColor(seen);
        vec3 lit = computeLight(seen.hit, bits, seen.baked, q);
        float behind = depthBehind(seen.hit.order, before);
        vec4 layer = vec4(lit, unpackOpacity(bits));
        RestPart part = restPart(lit, layer.a, behind);
        adds = adds && !isFirst && !isSecond;
        for (int k = 0; k < kPixels; ++k) {
            bool here = i == uint(k);
            nearest[k] = here && isFirst ? layer : nearest[k];
            next[k] = here && isSecond ? layer : next[k];
            sums[k] += here && adds ? part.color : vec4(0.0);
            depths[k] += here && adds ? part.depth : 0.0;
        }
    } while (anyLane((hits.x | hits.y) != 0u));
}

void findLayers(uint at, uint end, uint lane, vec2 middle, vec2 reach) {
    bool more = true;  // empty bins have no tiles
    do {
        bool mine = at + lane < end;
        Entry e = entryAt(listAt(min(at + lane, end - 1u)), middle, reach);
        uint balls = ballotLanes(mine && e.meets && !e.cylinder && !e.facet);
        uint sticks = ballotLanes(mine && e.meets && e.cylinder);
        uint facets = ballotLanes(mine && e.meets && e.facet);
        if (kSpheres) do {
            uint from = lowestBit(balls);
            vec4 sphere = handed(e.a, from);
            uint candidate = subgroupShuffle(e.number, from);
            bool live = balls != 0u;
            for (int i = 0; i < kPixels; ++i) keep(i, numberedBallHit(candidate, sphere, through[i]), candidate, live);
            balls &= balls - 1u;
        } while (balls != 0u);
        if (kCylinders) do {
            uint from = lowestBit(sticks);
            Stick stick = handed(e.stick, from);
            uint candidate = subgroupShuffle(e.number, from);
            bool live = sticks != 0u;
            for (int i = 0; i < kPixels; ++i) keep(i, stickHitThrough(stick, through[i]), candidate, live);
            sticks &= sticks - 1u;
        } while (sticks != 0u);
        if (kTriangles) do {
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
}

void shadeLayers(uint at, uint end, uint lane, vec2 middle, vec2 reach) {
    float farthest = -1.0, least = 2.0;  // opaque depth; depth of the first layer
    for (int i = 0; i < kPixels; ++i) {
        if (firstNumber[i] == 0u || first[i] > opaque[i]) opaque[i] = -1.0;  // nothing is seen
        farthest = max(farthest, opaque[i]);
        least = opaque[i] >= 0.0 ? min(least, first[i]) : least;
    }
    for (uint step = 1u; step < uint(kLanes); step <<= 1)
        least = min(least, subgroupShuffle(least, gl_SubgroupInvocationID ^ step));
    bool more = anyLane(farthest >= 0.0);
    if (!more) return;
    do {
        bool mine = at + lane < end;
        Entry e = entryAt(listAt(min(at + lane, end - 1u)), middle, reach);
        uint balls = ballotLanes(mine && e.meets && !e.cylinder && !e.facet);
        uint sticks = ballotLanes(mine && e.meets && e.cylinder);
        // Triangles in front of all first layers are not seen.
        float far = kPerspective ? 1.0 / min(e.a.z, min(e.b.z, e.c.z)) : max(e.a.z, max(e.b.z, e.c.z));
        uint facets = ballotLanes(mine && e.meets && e.facet && encodedDepth(far) + kLayerStep >= least);
        if (kSpheres) {
            hits = uvec2(0u);
            do {
                uint from = lowestBit(balls);
                vec4 sphere = handed(e.a, from);
                uint candidate = subgroupShuffle(e.number, from);
                bool live = balls != 0u;
                for (int i = 0; i < kPixels; ++i)
                    mark(from, i, numberedBallHit(candidate, sphere, through[i]), candidate, live);
                balls &= balls - 1u;
            } while (balls != 0u);
            shadeHits(kBall, e.number);
        }
        if (kCylinders) {
            hits = uvec2(0u);
            do {
                uint from = lowestBit(sticks);
                Stick stick = handed(e.stick, from);
                uint candidate = subgroupShuffle(e.number, from);
                bool live = sticks != 0u;
                for (int i = 0; i < kPixels; ++i) mark(from, i, stickHitThrough(stick, through[i]), candidate, live);
                sticks &= sticks - 1u;
            } while (sticks != 0u);
            shadeHits(kStick, e.number);
        }
        if (kTriangles) {
            hits = uvec2(0u);
            do {
                uint from = lowestBit(facets);
                vec3 a = handedCorner(e.a.xyz, from), b = handedCorner(e.b, from), c = handedCorner(e.c, from);
                uint candidate = subgroupShuffle(e.number, from);
                bool live = facets != 0u;
                for (int i = 0; i < kPixels; ++i)
                    mark(from, i, triangleHitThrough(a, b, c, 0u, through[i]), candidate, live);
                facets &= facets - 1u;
            } while (facets != 0u);
            shadeHits(kFacet, e.number);
        }
        at += uint(kLanes);
        more = at < end && anyLane(farthest >= subgroupShuffle(e.next, uint(kLanes - 1)));
    } while (more);
}

void store(uint to, vec4 layer) { layers[to] = halves(layer); }

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

    ivec2 last = textureSize(opaqueDepth, 0) - 1;
    for (int i = 0; i < kPixels; ++i) {
        ivec2 pixel = ivec2(corner + pixelOf(i, lane));
        bool wanted = wantsQuarter(tile, (uint(i * kLanes) + lane) / kQuarterPixels);
        through[i] = planePoint(vec2(pixel) + 0.5);
        first[i] = second[i] = wanted ? 1.0 : -1.0;
        opaque[i] = wanted ? texelFetch(opaqueDepth, min(pixel, last), 0).x : -1.0;
        firstNumber[i] = secondNumber[i] = 0u;
        nearest[i] = next[i] = sums[i] = vec4(0.0);
        depths[i] = 0.0;
    }
    vec2 middle = planePoint(vec2(corner) + float(kTile / 2));
    vec2 reach = vec2(float(kTile / 2) * view.pixel);
    findLayers(at, end, lane, middle, reach);
    shadeLayers(at, end, lane, middle, reach);
    // Row by row over all bins, kOrderedLayers and the rest of each pixel.
    uint pitch = view.across * uint(kTile * kTilesInBin);
    for (int i = 0; i < kPixels; ++i) {
        uvec2 pixel = corner + pixelOf(i, lane);
        uint to = uint(kLayerWords / 2) * (pixel.y * pitch + pixel.x);
        store(to, nearest[i]);
        store(to + 1u, next[i]);
        store(to + uint(kOrderedLayers), mixedRest(sums[i], depths[i]));
    }
}
