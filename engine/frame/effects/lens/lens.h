#pragma once
// Depth of field: passes after a frame that draws the distance of each pixel, and the lens that they model.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/frame/effects/lens/choice.h"
#include "engine/frame/effects/lens/lens_pass.h"
#include "engine/frame/frame.h"
#include "engine/passes/tile_frame.h"
#include "engine/settings.h"

namespace nacre {

struct PictureImage;

/// Z of an empty pixel, as shaders/lens.frag has it.
constexpr float kNoDistance = 1e30f;
/// The target of such a frame: Z of the surface layer.
constexpr ScreenTarget kLensTargets[] = {
    {"distances", VK_FORMAT_R32_SFLOAT, passes::Output::surface, "surface layer", kNoDistance}};

/// The lens of a view's pictures. @param view  the settings' view, or a part of it
passes::Lens makeLens(const RenderSettings& settings, const View& view);

/// Where a picture through the lens is sharp: one byte per pixel of a frame of lower resolution; 0 where everything
/// nearby is blurred more. @param distances  drawn by that frame (kLensTargets)
/// @param lens  of the picture @param rim  width of outlines and halos, pixels of that frame
std::vector<std::uint8_t> sharpPlaces(const float* distances, graph::Extent extent, const passes::Lens& lens,
                                      double rim);

/// Largest radius of a lens's circle, pixels.
double largestCircle(const RenderSettings& settings);

/// A view through a point of the lens; the mean over all points is the lens's picture. @param point  in the unit disc
View throughLens(const RenderSettings& settings, View view, glm::dvec2 point);

/// The parts of a picture that a lens may change: the margins of its shapes. @param spans  bins that show anything
std::vector<PictureRect> blurredBy(const passes::Lens& lens, std::span<const TileBins::Span> spans,
                                   graph::Extent extent);

/// Declares the passes that blur a picture, Frame::picture. The first target becomes the result.
/// @param format  of picture and result @param from  read when the passes are recorded; null: the frame is only planned
void declareLens(Frame& frame, graph::Extent extent, VkFormat format, const PictureImage* from);

}  // namespace nacre
