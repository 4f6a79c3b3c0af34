#pragma once
// A scene's volume on the device: a three-dimensional texture and its constants for each brick.

#include <memory>
#include <vector>

#include "engine/gpu/execute.h"
#include "engine/scene/build/volume.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

class VolumeTextures {
public:
    struct Brick {
        glm::ivec3 place{};  ///< in the lattice of bricks
        gpu::Image texture;
        gpu::Buffer constants;  ///< layout::BrickConstants
    };

    /// Uploads and waits. @throws Error if device memory runs out
    VolumeTextures(const gpu::Device& device, gpu::Executor& executor, std::shared_ptr<const Volume> volume);

    const Volume& volume() const { return *volume_; }
    /// A texture for unused bindings.
    const gpu::Image& flat() const { return flat_; }
    /// The bricks from back to front. @param eye  in nodes of the volume; w = 0: its direction
    std::vector<const Brick*> farthestFirst(const glm::dvec4& eye) const;

private:
    std::shared_ptr<const Volume> volume_;
    gpu::Image flat_;
    std::vector<Brick> bricks_;
};

}  // namespace nacre::passes

namespace nacre {

/// The textures of the volume that was shown last.
class Volumes {
public:
    /// Both outlive this.
    Volumes(const gpu::Device& device, gpu::Executor& executor) : device_(device), executor_(executor) {}

    /// Null for no volume.
    std::shared_ptr<const passes::VolumeTextures> findTextures(const std::shared_ptr<const Volume>& volume);

private:
    const gpu::Device& device_;
    gpu::Executor& executor_;
    std::shared_ptr<const Volume> volume_;
    std::shared_ptr<const passes::VolumeTextures> textures_;
};

}  // namespace nacre
