#pragma once

#include <span>

#include "engine/passes/full_screen.h"
#include "engine/results.h"

namespace nacre::passes {

/// A lens, as shaders/lens.frag has it.
struct Lens {
    float focus = 0;        ///< Z of the focus
    float pixels = 0;       ///< radius of a circle per Å from the focus; perspective: times Z
    float most = 0;         ///< largest radius, pixels
    float perspective = 0;  ///< 1, or 0
    float rim = 0;          ///< width of outlines, pixels
    float rimDepth = 0;     ///< least depth jump of an outline, Å
    float unused0 = 0, unused1 = 0;
};
static_assert(sizeof(Lens) == 32);

/// Pixels of a block's side.
constexpr std::uint32_t kLensBlock = 16;

enum class LensStep : std::uint8_t { circles, reach, spread, soft, gather };

struct LensPass {
    LensStep step{};
    bool coded = false;  ///< picture and result are sRGB-coded
};

/// @param images  read by the step, in the order of its bindings
/// @param parts  of the step's image, which it draws
void drawLens(gpu::PassContext& context, const LensPass& pass, const Lens& lens, std::span<const vk::ImageView> images,
              std::span<const PictureRect> parts);
/// Requests the pipeline.
void wantLens(gpu::PipelineContext& context, const LensPass& pass);

}  // namespace nacre::passes
