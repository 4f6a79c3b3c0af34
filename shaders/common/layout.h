// Layouts that C++ and GLSL share. Included by both: keep to the common subset.
#ifdef __cplusplus
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
namespace nacre::layout {
using glm::vec4;
#endif

/// Push constants of every geometry pass. Lengths in Å, view space as in engine/scene/camera.h.
/// Z is the distance that the layers report: origin - z (orthographic: origin = R, perspective: origin = eye).
struct ViewConstants {
    vec4 row0;     // xyz: first row of the rotation, w: NDC x per Å on the plane z = 0
    vec4 row1;     // xyz: second row,               w: NDC y per Å (negative: Vulkan's y points down)
    vec4 row2;     // xyz: third row,                w: Z origin
    vec4 screen;   // xy: pixel of the view axis, z: Å per pixel at z = 0, w: rasteriser's snap margin in Å at z = 0
    vec4 depth;    // x: Z at encoded depth 0, y: 1 / (range of Z), zw: NDC of the view axis in the upright picture
    vec4 atlas;    // xy: 1 / atlas size, z: texels across a sphere's patch, w: texels around a cylinder's patch
    vec4 shading;  // x: lighting 0 or 1, y: occlusion 0 or 1, z: texels along a cylinder's patch,
                   // w: number of spheres, as bits
};

/// Push constants of the occlusion accumulation.
struct OcclusionConstants {
    vec4 map;      // x: pixels across one depth map, y: maps per row of the grid, z: pixels per Å, w: slack in Å
    vec4 depth;    // x: Z at encoded depth 0, y: 1 / (range of Z), z: R, w: 0
    vec4 patches;  // x: texels across a sphere's patch, y: around, z: along a cylinder's patch, w: 0
    // First entry of the texel list, number of entries (accumulate) or of words (finish), first direction, number of
    // directions; spheres, texels across the atlas, rows of it that spheres take.
#ifdef __cplusplus
    std::uint32_t firstTexel, texelCount, firstDirection, directionCount;
    std::uint32_t sphereCount, atlasWidth, sphereRows, unused;
#else
    uint firstTexel, texelCount, firstDirection, directionCount;
    uint sphereCount, atlasWidth, sphereRows, unused;
#endif
};

#ifdef __cplusplus
static_assert(sizeof(ViewConstants) == 112, "push constants: 128 bytes at most");
static_assert(sizeof(OcclusionConstants) == 80);
static_assert(offsetof(OcclusionConstants, firstTexel) == 48);
}  // namespace nacre::layout
#endif
