#pragma once
// The interface of this folder; the rest of the engine includes no other file of it. On software devices the host
// lists the primitives of tiles, culls hidden spheres and draws triangles of depth maps. A build without NACRE_SOFTWARE
// compiles absent.cpp instead of the folder.

#include <cstdint>
#include <memory>

#include "engine/gpu/execute.h"
#include "engine/occlusion/occluder_mesh.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/view/camera.h"
#include "engine/tiles/tile_maps.h"
#include "engine/tiles/tiles.h"

namespace nacre::passes {

/// @returns null in a build without the folder: the device makes all lists
std::unique_ptr<HostLister> makeHostLister();

/// Culls spheres hidden behind others of the same picture.
class HiddenSpheres {
public:
    virtual ~HiddenSpheres() = default;
    /// Drops hidden spheres; splits the calls into many. @param centers  only pixel centres are sampled
    virtual void drop(SceneView& seen, const Representation& representation, const Chunks& chunks, const View& view,
                      graph::Extent image, bool centers) = 0;
};
/// @returns null in a build without the folder: devices then draw hidden spheres
std::unique_ptr<HiddenSpheres> makeHiddenSpheres();

}  // namespace nacre::passes

namespace nacre::occlusion {

enum class Texels : std::uint8_t;

/// Depth maps by tiles whose lists the host makes. It draws triangles itself.
/// @param pixels  width of a map @param radius  of the scene's bounding sphere, Å @param across  maps per row of a
/// batch @param occluders  made ahead @returns null in a build without the folder
std::unique_ptr<TileMaps> makeListedMaps(const gpu::Device& device, const passes::SceneBuffers& scene,
                                         const Representation& representation, std::uint32_t pixels, double radius,
                                         std::uint32_t across, OccluderMeshes occluders);

/// The stage that reads heights of depth maps as texels.
gpu::ShaderWords questionsToTexelMaps(Texels texels);

}  // namespace nacre::occlusion
