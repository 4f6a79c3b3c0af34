#version 440
// Ambient occlusion, one batch of directions: tests every texel of the list against each depth map of the batch, and
// adds up the cosines of the maps where it is front-most. One read and one write of its sum.
// CYLINDER, VERTEX: texels of cylinders, of meshes. WHOLE: one value per sphere, tested at its point facing the light.
// HEIGHTS: the maps are a buffer of heights, with kOrderedBits from map_heights.comp, else from tile_depth.comp; without
// HEIGHTS an image of encoded depth.
// TEXELS: these and the directions are read as texels.
// NARROW: directions take few words (layout.h), for drivers that load them in every invocation.
// PAIRS: an invocation tests two texels, and loads each direction once for both.
// All lengths here are pixels of a depth map: directions rotate, scale and shift into the map, rows downwards.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#ifdef TEXELS
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require
#endif
#include "common/layout.h"
#if !defined(VERTEX) && !defined(CYLINDER)
#define BALLS
#endif
#include "common/texel.glsl"
#include "common/encoding.glsl"
#include "common/ordered.glsl"

layout(local_size_x = 64) in;

layout(constant_id = kTapsId) const int kTaps = 1;  // 1, 2 or 4: pixels sampled per texel
layout(constant_id = kSpreadId) const float kSpread = 0.0;  // distance of the taps, pixels

layout(set = 0, binding = 2, std430) readonly buffer Texels { uint texels[]; };
layout(set = 0, binding = 3, std430) buffer Sums { vec2 sums[]; };  // accumulated light, and its possible maximum
#if defined(TEXELS)
layout(set = 0, binding = 4) uniform samplerBuffer heightTexels;  // Å
float heightAt(int i) { return texelFetch(heightTexels, i).x; }
#elif defined(HEIGHTS)
layout(constant_id = kOrderedBitsId) const bool kOrderedBits = false;
layout(set = 0, binding = 4, std430) readonly buffer Heights { uint heights[]; };  // bits of Å
float heightAt(int i) { return kOrderedBits ? fromOrderedBits(heights[i]) : uintBitsToFloat(heights[i]); }
#else
layout(set = 0, binding = 4) uniform sampler2D depthMaps;
#endif

/// Height of the texel's own surface at position q of a depth map; z outside the surface.
#if defined(VERTEX)
/// Height of the tangent plane at the vertex; the slack covers curvature.
float ownHeight(vec3 center, vec3 normal, float radius, vec2 q, float z) {
    return z - dot(normal.xy, q - center.xy) / max(normal.z, 0.15);
}
#elif defined(CYLINDER)
float ownHeight(vec3 center, vec3 axis, float radius, vec2 q, float z) {
    vec2 from = q - center.xy;
    // Squared distance between the axis and the points (from, t) of the ray: a parabola in t.
    float A = max(1.0 - axis.z * axis.z, 1e-6);
    float along = dot(from, axis.xy);
    float t0 = axis.z * along / A;
    vec3 foot = vec3(from, t0) - axis * (along + axis.z * t0);
    float h = radius * radius - dot(foot, foot);
    return h > 0.0 ? center.z + t0 + sqrt(h / A) : z;
}
#else
mat3 mapToUnit;  // of an ellipsoid: from an offset in the map
float ownHeight(vec3 center, vec3 axis, float radius, vec2 q, float z) {
    vec2 from = q - center.xy;
    if (kEllipsoids != 0) {
        vec3 way = mapToUnit[2], w = mapToUnit * vec3(from, 0.0);
        float t0 = -dot(w, way) / dot(way, way), left = 1.0 - dot(w + way * t0, w + way * t0);
        return left > 0.0 ? center.z + t0 + sqrt(left / dot(way, way)) : z;
    }
    float h = radius * radius - dot(from, from);
    return h > 0.0 ? center.z + sqrt(h) : z;
}
#endif

/// Whether the depth map of direction i shows a height of at least `front` at a pixel.
bool shows(int i, ivec2 pixel, float front) {
    ivec2 at = ivec2(i % kMapsAcross, i / kMapsAcross) * bake.apart + pixel;
#ifdef HEIGHTS
    return heightAt(at.y * bake.pitch + at.x) <= front * bake.pixel;
#else
    return bake.depthAt0 - front * bake.depthPerPixel <= decodeDepth(texelFetch(depthMaps, at, 0));
#endif
}

/// Whether the depth map of direction i shows the texel at an offset `aside`, pixels. @param room  length of aside
bool frontmost(int i, vec3 center, vec3 axis, float radius, vec3 at, vec2 aside, float room) {
    vec2 place = clamp(floor(at.xy + aside), vec2(0.0), vec2(bake.mapPixels - 1));
    // Compares with the height of this surface at the pixel's centre, so that it never shadows itself, or with the
    // texel's own height if lower: near a contact, the surface at the centre may lie inside a neighbour that does not
    // hide the texel. A slack of one pixel, more for a shifted tap, covers the neighbour's slope.
    float front = max(ownHeight(center, axis, radius, place + 0.5, at.z), at.z);
    return shows(i, ivec2(place), front + 1.0 + room);
}

#ifdef BALLS
/// The place of an ellipsoid with a normal, from its centre.
vec3 onEllipsoid(mat3 toUnit, vec3 normal) {
    mat3 rows = transpose(toUnit);
    vec3 a = rows[0] / dot(rows[0], rows[0]), b = rows[1] / dot(rows[1], rows[1]), c = rows[2] / dot(rows[2], rows[2]);
    vec3 shares = vec3(dot(a, normal), dot(b, normal), dot(c, normal));
    return (a * shares.x + b * shares.y + c * shares.z) / length(shares);
}
#endif

/// Contribution of direction d to a texel, as in Sums. @param i  of the direction in the batch
vec2 asked(int i, Direction d, Texel texel) {
    vec3 center = placed(d, texel.a);
    float radius = texel.radius * bake.pixelsPerAngstrom;
#ifdef WHOLE
    // A sphere embedded in a surface is visible from half of all directions; that half is its visible part.
    float cosine = 0.5 * dot(d.w.xyz, d.w.xyz), counted = 2.0 * cosine;
    vec3 top = d.w.xyz * bake.pixel;
    vec3 at = vec3(center.xy, center.z + radius);
    vec3 axis = vec3(0.0);
#else
    vec3 normal = turned(d, texel.normal);
    float cosine = max(normal.z, 0.0), counted = cosine;
    vec3 at = center + texel.radius * normal;
    vec3 axis = turned(d, texel.axis) * bake.pixel;
#ifdef BALLS
    vec3 top = texel.normal;
#endif
#endif
#ifdef BALLS
    if (kEllipsoids != 0) {
        mapToUnit = texel.toUnit * mat3(d.u.xyz, d.v.xyz, d.w.xyz) * (bake.pixel * bake.pixel);
        at = center + turned(d, onEllipsoid(texel.toUnit, top));
    }
#endif
    float seen = 0.0;
    [[unroll]] for (int tap = 0; tap < kTaps; ++tap) {
        // Four taps form a rotated square, with one tap in each column and row. Two taps are opposite corners, chosen
        // by a bit of the direction, independently of the batch size.
        bool first = kTaps == 2 ? (floatBitsToUint(d.u.x) & 1u) == 0u : tap % 2 == 0;
        vec2 aside = first ? vec2(0.75, 0.25) : vec2(-0.25, 0.75);
        aside *= kTaps == 1 ? 0.0 : 2 * tap < kTaps ? kSpread : -kSpread;
        float room = kTaps == 1 ? 0.0 : length(vec2(0.75, 0.25) * kSpread);
        if (frontmost(i, center, axis, radius, at, aside, room)) seen += 1.0 / float(kTaps);
    }
    return vec2(seen * counted, cosine);
}

Texel loadTexel(uint entry) {
#if defined(VERTEX)
    return vertexTexel(texels[entry]);
#elif defined(CYLINDER)
    return cylinderTexel(texels[entry]);
#else
    return sphereTexel(texels[entry]);
#endif
}

void main() {
    uint listed = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    // All lanes stay active, as each holds directions that others need.
    uint entry = bake.firstEntry + min(listed, bake.entries - 1u);
    fetchDirections();
    Texel texel = loadTexel(entry);
    precise vec2 sum = sums[entry];
#ifdef PAIRS
    uint apart = (bake.entries + 1u) / 2u, pair = bake.firstEntry + min(listed + apart, bake.entries - 1u);
    Texel other = loadTexel(pair);
    precise vec2 sumOfOther = sums[pair];
#endif
#if defined(TEXELS) && !defined(WHOLE)
    [[unroll]] for (int i = 0; i < kBatch; i += kApart) {
        int faced = i;
        Direction d = loadFaced(faced, texel.normal);
        sum += asked(faced, d, texel);
    }
#else
    [[unroll]] for (int i = 0; i < kBatch; ++i) {
        Direction d = loadDirection(i);
        sum += asked(i, d, texel);
#ifdef PAIRS
        sumOfOther += asked(i, d, other);
#endif
    }
#endif
#ifdef PAIRS
    if (listed < apart) sums[entry] = sum;
    if (listed < apart && listed + apart < bake.entries) sums[pair] = sumOfOther;
#else
    if (listed < bake.entries) sums[entry] = sum;
#endif
}
