// Pictures with depth of field. All paths and all ways to sample end in one image, which is blurred on the device.

#include <algorithm>
#include <span>
#include <utility>

#include "engine/frame/lens.h"
#include "engine/frame/picture_frames.h"

namespace nacre {

/// What a picture is put over before the lens: nothing, if there is one.
std::array<float, 4> PictureFrames::behind(const RenderSettings& settings) {
    return hasLens(settings) ? std::array<float, 4>{} : settings.background;
}

/// Draws a picture, then how far away its pixels are, and blurs it by that.
Picture PictureFrames::throughLens(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    const graph::Extent image = imageExtent(wanted.view);
    const Picture all = sharp(settings, atlas, {wanted.view, {0, 0, image.width, image.height}});
    const PictureStats first = stats_;
    const gpu::Buffer pixels =
        gpu::makeBuffer(device_, std::span(all.rgba), vk::BufferUsageFlagBits::eTransferSrc, "sharp pixels");
    RenderSettings depths = settings;
    depths.supersample = 1;
    depths.occlusion.directions = 0;
    lens_ = lensOf(settings, wanted.view);
    const Drawn drawn =
        draw(depths, {}, wanted.view, kLensTargets, true, "depth of field", Samples::one, nullptr, &pixels);
    Picture blurred = emptyPicture(image.width, image.height);
    const auto* const floats = reinterpret_cast<const float*>(drawn.pixels[0].mapped);
    std::copy_n(floats, blurred.rgba.size(), blurred.rgba.begin());
    blurred = cut(std::move(blurred), wanted.inner);
    stats_.frames = first.frames + 1;
    stats_.samples = first.samples;
    stats_.frameMilliseconds += first.frameMilliseconds;
    stats_.passes.insert(stats_.passes.begin(), first.passes.begin(), first.passes.end());
    stats_.passTimes.insert(stats_.passTimes.begin(), first.passTimes.begin(), first.passTimes.end());
    stats_.coveredPixels = putOver(blurred, settings.background);
    return blurred;
}

}  // namespace nacre
