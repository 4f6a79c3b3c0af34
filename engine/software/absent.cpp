// Replaces this folder in a build without NACRE_SOFTWARE. No device has the tile path there (engine/gpu/caps.cpp), so
// none of these passes is ever recorded.

#include <stdexcept>

#include "engine/software/software.h"

namespace nacre {
namespace {

[[noreturn]] void refuse() { throw std::logic_error("this build has no tile path"); }

}  // namespace

namespace passes {

std::unique_ptr<TileFrames> makeTileFrames(const gpu::Device&) { return nullptr; }
std::unique_ptr<HiddenSpheres> makeHiddenSpheres() { return nullptr; }
void countPrimitivesOfBins(gpu::PassContext&, const SceneView&) { refuse(); }
void placeListsOfBins(gpu::PassContext&, const SceneView&, std::uint32_t) { refuse(); }
void writeListsOfBins(gpu::PassContext&, const SceneView&) { refuse(); }
void sortListsOfBins(gpu::PassContext&, const SceneView&, std::uint32_t) { refuse(); }
void draw(gpu::PassContext&, const SceneView&, const NearestByTiles&) { refuse(); }
void want(gpu::PipelineContext&, const SceneView&, const NearestByTiles&) { refuse(); }
void draw(gpu::PassContext&, const SceneView&, const TileShading&) { refuse(); }
void want(gpu::PipelineContext&, const SceneView&, const TileShading&) { refuse(); }
void findLayersByTiles(gpu::PassContext&, const SceneView&) { refuse(); }
void findEdgesByTiles(gpu::PassContext&, const SceneView&) { refuse(); }
void drawEdgesByTiles(gpu::PassContext&, const SceneView&, vk::ImageView) { refuse(); }
void drawEdgeColors(gpu::PassContext&, const SceneView&, const graph::Clear&) { refuse(); }

}  // namespace passes

namespace occlusion {

std::unique_ptr<TileMaps> makeTileMaps(const gpu::Device&, const passes::SceneBuffers&, const Representation&,
                                       std::uint32_t, double, std::uint32_t, OccluderMeshes) {
    return nullptr;
}
gpu::ShaderWords questionsToTileMaps(Texels, const graph::TileCaps&) { refuse(); }

}  // namespace occlusion
}  // namespace nacre
