// Layouts that C++ and GLSL share. Included by both: keep to the common subset.
#ifdef __cplusplus
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
namespace nacre::layout {
using glm::uvec4;
using glm::vec4;
#endif

/// Push constants of every geometry pass. Lengths in Å, view space as in engine/scene/camera.h.
/// Z is the distance that the layers report: origin - z (orthographic: origin = R, perspective: origin = eye).
struct ViewConstants {
    vec4 row0;  // the copy that is drawn, xyz: a row of its rotation into view space, w: of its shift, Å
    vec4 row1;
    vec4 row2;
    vec4 projection;  // x: NDC x per Å on the plane z = 0, y: NDC y per Å (negative: Vulkan's y points down),
                      // z: Z origin, w: number before that of the copy's first primitive, as bits
    vec4 screen;   // xy: pixel of the view axis, z: Å per pixel at z = 0, w: rasteriser's snap margin in Å at z = 0
    vec4 depth;    // x: Z at encoded depth 0, y: 1 / (range of Z), z: primitives in a copy, as bits,
                   // w: 1 if the viewport is the whole image, 0 if it has the view axis in its middle
    vec4 atlas;    // xy: 1 / atlas size, z: texels across a sphere's patch, w: texels around a cylinder's patch
    vec4 shading;  // x: lighting 0 or 1, y: occlusion 0 or 1, z: texels along a cylinder's patch,
                   // w: number of spheres, as bits
};

/// Push constants of the occlusion passes. A batch of depth maps lies side by side in one image, kMapsAcross in a row.
struct OcclusionConstants {
    vec4 map;       // x: pixels across one depth map, y: pixels per Å, z: slack in Å, w: 0
    vec4 depth;     // x: Z at encoded depth 0, y: 1 / (range of Z), z: Z origin, w: 0
    uvec4 patches;  // x: texels across a sphere's patch, y: around, z: along a cylinder's patch, w: number of spheres
    uvec4 range;    // x: first entry of the list, y: number of entries, zw: 0
};
/// Push constants of depth splatting.
struct SplatConstants {
#ifdef __cplusplus
    using uint = std::uint32_t;
#endif
    uint view;        // of the first map
    uint first, end;  // primitives
    uint spheres;     // in the shapes, before the cylinders
    uint pixels;      // across a map
    uint pitch;       // pixels across the image of the batch
};
/// One direction of a batch: a position p of the streams lies at (dot(u, p), dot(v, p), dot(w, p)) with p.w = 1; w
/// points to the light.
struct Direction {
    vec4 u, v, w;
};

#ifdef __cplusplus
static_assert(sizeof(ViewConstants) == 128, "push constants: 128 bytes at most");
static_assert(sizeof(OcclusionConstants) == 64);
static_assert(sizeof(Direction) == 48);
}  // namespace nacre::layout
#endif
