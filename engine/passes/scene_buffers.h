#pragma once

#include "engine/gpu/resources.h"
#include "engine/scene/build/representation.h"

namespace nacre::passes {

/// The streams of a representation on the device. Geometry passes fetch stream A, shading passes A and B.
struct SceneBuffers {
    gpu::Buffer shapes;            ///< stream A: spheres, cylinders, triangles, their vertices, rows of ellipsoids
    gpu::Buffer looks;             ///< stream B: of spheres, cylinders and vertices; then the groups of their atoms
    gpu::Buffer balls;             ///< stream C, if fragments fetch spheres: linear colour; radius, negative for tints
    gpu::Buffer corners, pyramid;  ///< from passes/corners.h: stream, indices
    vk::raii::BufferView shapeTexels{nullptr}, lookTexels{nullptr};  ///< where texel buffers can hold whole streams
    std::uint32_t sphereCount = 0, cylinderCount = 0, triangleCount = 0;
    std::uint32_t firstGroup = 0;                               ///< index of the first group in looks, words
    vk::DeviceSize cylinderOffset = 0, cylinderLookOffset = 0;  ///< byte offsets into shapes and looks
    vk::DeviceSize ellipsoidOffset = 0;                         ///< of the spheres' rows; 0: there are none
    bool cutsOctants = false;                                   ///< of the Representation

    std::uint32_t primitives() const { return sphereCount + cylinderCount + triangleCount; }
    bool empty() const { return primitives() == 0; }  ///< an empty scene has no buffers
};

/// Maximum size of shapes that a device's shaders can read, bytes. Texel buffers, where used, hold at least as many
/// four-word vectors as storage buffers hold words.
std::uint64_t mostShapeBytes(const gpu::Caps& caps);

/// Overwrites the looks of buffers that were made of the same shapes, in streams B and C.
void putLooks(SceneBuffers& scene, const Representation& representation);

/// @throws Error if the device's shaders cannot read this much
SceneBuffers makeSceneBuffers(const gpu::Device& device, const Representation& representation);

}  // namespace nacre::passes
