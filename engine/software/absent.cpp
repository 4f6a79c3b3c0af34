// Replaces this folder and engine/tiles/lanes in a build without NACRE_SOFTWARE. No device has texel streams or draws
// by the lanes of a subgroup there (engine/gpu/caps.cpp), so none of these passes is ever recorded.

#include <stdexcept>

#include "engine/software/software.h"
#include "engine/tiles/lanes/lane_passes.h"

namespace nacre {
namespace {

[[noreturn]] void refuse() { throw std::logic_error("this build draws no tiles by the lanes of a subgroup"); }

}  // namespace

namespace passes {

std::unique_ptr<HostLister> makeHostLister() { return nullptr; }
std::unique_ptr<HiddenSpheres> makeHiddenSpheres() { return nullptr; }
void draw(gpu::PassContext&, const SceneView&, const NearestByTiles&) { refuse(); }
void want(gpu::PipelineContext&, const SceneView&, const NearestByTiles&) { refuse(); }
void draw(gpu::PassContext&, const SceneView&, const TileShading&) { refuse(); }
void want(gpu::PipelineContext&, const SceneView&, const TileShading&) { refuse(); }
void shadeSamples(gpu::PassContext&, const SceneView&, const SampledSpheres&, graph::Extent, const ResolvePlace&) {
    refuse();
}
void drawLayersByTiles(gpu::PassContext&, const SceneView&, vk::ImageView, vk::ImageView) { refuse(); }
void drawLayerColor(gpu::PassContext&, const SceneView&, std::uint32_t) { refuse(); }
void findEdgesByTiles(gpu::PassContext&, const SceneView&) { refuse(); }
void drawEdgesByTiles(gpu::PassContext&, const SceneView&, vk::ImageView) { refuse(); }
void drawEdgeColors(gpu::PassContext&, const SceneView&, const graph::Clear&) { refuse(); }

}  // namespace passes

namespace occlusion {

std::unique_ptr<TileMaps> makeListedMaps(const gpu::Device&, const passes::SceneBuffers&, const Representation&,
                                         std::uint32_t, double, std::uint32_t, OccluderMeshes) {
    return nullptr;
}
gpu::ShaderWords questionsToTexelMaps(Texels) { refuse(); }

}  // namespace occlusion
}  // namespace nacre
