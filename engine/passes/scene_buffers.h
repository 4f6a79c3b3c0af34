#pragma once

#include "engine/gpu/resources.h"
#include "engine/scene/representation.h"

namespace nacre::passes {

/// The streams of a representation on the device. Geometry passes fetch stream A alone, shading A and B.
struct SceneBuffers {
    gpu::Buffer shapes;  ///< stream A: spheres, cylinders, triangles, and vertices of these
    gpu::Buffer
        looks;  ///< stream B: of spheres, of cylinders, and those that vertices share; then the groups of their atoms
    gpu::Buffer corners, pyramid;                                    ///< of passes/corners.h: the stream, the indices
    vk::raii::BufferView shapeTexels{nullptr}, lookTexels{nullptr};  ///< where texel buffers hold whole streams
    std::uint32_t sphereCount = 0, cylinderCount = 0, triangleCount = 0;
    std::uint32_t firstGroup = 0;                               ///< word of the looks at which groups begin
    vk::DeviceSize cylinderOffset = 0, cylinderLookOffset = 0;  ///< bytes into shapes and looks

    std::uint32_t primitives() const { return sphereCount + cylinderCount + triangleCount; }
    bool empty() const { return primitives() == 0; }  ///< then without buffers
};

/// Bytes of shapes that a device's shaders read. Texel buffers, where they are used, hold at least as many vectors of
/// four words as storage buffers hold words.
std::uint64_t mostShapeBytes(const gpu::Caps& caps);

/// @throws Error if its shaders cannot read so much
SceneBuffers makeSceneBuffers(const gpu::Device& device, const Representation& representation);

}  // namespace nacre::passes
