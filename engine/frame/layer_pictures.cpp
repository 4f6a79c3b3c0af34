// Pictures of what pixels show beside colour, and the atom at a place.

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/frame/picture.h"
#include "engine/frame/picture_frames.h"

namespace nacre {
namespace {

using passes::Output;

constexpr ScreenTarget kLayerTargets[] = {kFineTargets[0],
                                          {"surface", VK_FORMAT_R32G32B32A32_SFLOAT, Output::surface, "surface layer"},
                                          {"identity", VK_FORMAT_R32G32_UINT, Output::identity, "identity layer"}};

/// Where layers are translucent, colour is of a frame of its own.
constexpr ScreenTarget kSolidTargets[] = {kLayerTargets[1], kLayerTargets[2]};

constexpr ScreenTarget kPickTargets[] = {{"identity", VK_FORMAT_R32G32_UINT, Output::identity, "identity layer"}};

}  // namespace

LayerPicture PictureFrames::layers(const RenderSettings& settings, const passes::Atlas& atlas) {
    std::vector<gpu::Buffer> pixels;
    if (frames_.translucent()) {
        pixels = draw(settings, atlas, settings.view, kFineTargets, {FrameEnd::readBack}, "screen").pixels;
        for (gpu::Buffer& layer :
             draw(settings, atlas, settings.view, kSolidTargets, {FrameEnd::readBack}, "solid").pixels)
            pixels.push_back(std::move(layer));
    } else {
        pixels = draw(settings, atlas, settings.view, kLayerTargets, {FrameEnd::readBack}, "screen").pixels;
    }
    return assembleLayers(settings.view.width, settings.view.height, reinterpret_cast<const float*>(pixels[0].mapped),
                          reinterpret_cast<const float*>(pixels[1].mapped),
                          reinterpret_cast<const std::uint32_t*>(pixels[2].mapped), settings.background,
                          stats_.coveredPixels);
}

std::uint32_t PictureFrames::atomAt(const RenderSettings& settings, double x, double y, double reach) {
    // A separate picture around the position, as large as the reach. Its middle pixel contains (x, y).
    const auto side = static_cast<std::uint32_t>(2 * std::ceil(std::clamp(reach, 0.0, 100.0)) + 1);
    RenderSettings small = settings;
    small.occlusion.directions = 0;
    small.tuning.countFragments = false;
    small.view.pan = -planePointAt(settings.view, std::floor(x) + 0.5, std::floor(y) + 0.5);
    small.view.width = small.view.height = side;
    const auto pixels = draw(small, {}, small.view, kPickTargets, {FrameEnd::readBack}, "pick").pixels;
    return nearestAtom(reinterpret_cast<const std::uint32_t*>(pixels[0].mapped), side, reach);
}

}  // namespace nacre
