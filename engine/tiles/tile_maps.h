#pragma once
// Depth maps of a bake by compute: heights in a buffer. The device draws them by an invocation per primitive
// (splat_maps.h), software devices from lists (engine/software).

#include <cstdint>
#include <memory>
#include <span>

#include "engine/gpu/execute.h"
#include "engine/passes/placed_copies.h"
#include "engine/passes/scene_buffers.h"
#include "engine/passes/tile_frame.h"

namespace nacre::occlusion {

/// Depth maps of a batch.
class TileMaps {
public:
    virtual ~TileMaps() = default;

    /// Pixels from one map to the next.
    static constexpr std::uint32_t apartFor(std::uint32_t pixels) {
        return (pixels + TileBins::kPixels - 1) / TileBins::kPixels * TileBins::kPixels;
    }
    /// Device memory, bytes. Lists differ between parts: the estimate per primitive is that of large molecules.
    static constexpr std::uint64_t bytesFor(std::uint32_t pixels, std::uint32_t across) {
        const std::uint64_t side = std::uint64_t{apartFor(pixels)} * across;
        return sizeof(float) * side * side;
    }
    static constexpr std::uint64_t kBytesPerPrimitive = 9;

    /// Begins a batch with empty maps. @param maps  contents of each, at most across x across
    virtual void begin(std::span<const passes::PlacedCopies> maps) = 0;
    /// Declares the passes that draw these primitives of the batch, counted across its maps. Earlier declared passes
    /// must have run.
    virtual graph::Buffer declare(graph::Graph& g, gpu::Imports& imports, std::uint64_t first, std::uint64_t end) = 0;
    /// Requests the pipelines of these passes.
    virtual void wantPipelines(gpu::PipelineContext& context) const = 0;
    /// The maps, for passes that draw or read them.
    virtual graph::Buffer import(graph::Graph& g, gpu::Imports& imports) const = 0;
    virtual const gpu::Buffer& buffer() const = 0;
    /// The maps as texels, if the device reads streams as texels; else null.
    virtual vk::BufferView texels() const = 0;
    virtual std::uint32_t pitch() const = 0;  ///< pixels per row of the batch
    virtual std::uint32_t apart() const = 0;  ///< pixels from one map to the next
};

/// Maps that the device draws alone. @param pixels  width of a map @param radius  of the scene's bounding sphere, Å
/// @param across  maps per row of a batch
std::unique_ptr<TileMaps> makeSplatMaps(const gpu::Device& device, const passes::SceneBuffers& scene,
                                        std::uint32_t pixels, double radius, std::uint32_t across);

}  // namespace nacre::occlusion
