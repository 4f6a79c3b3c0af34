// Pictures with depth of field. All paths and all ways to sample end in one image, which is blurred on the device.

#include <algorithm>

#include "engine/frame/lens.h"
#include "engine/frame/picture_frames.h"

namespace nacre {

/// Draws a picture into its image. The host does not read it.
void PictureFrames::sharp(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    const bool edges = wantsEdges(settings);
    if (!edges || drawsEdges(settings)) {
        Ending ending = inImage(settings, wanted.view, edges ? Samples::edges : singleOrResolved(settings));
        if (!edges) ending.picture.samples = std::max(settings.supersample, 1u);
        const Drawn drawn = inOneFrame(settings, atlas, wanted, ending);
        if (!edges || drawn.edges) return;
    }
    finerPicture(settings, atlas, wanted);
}

/// Draws a picture, then how far away its pixels are, and blurs it by that.
PictureFrames::Drawn PictureFrames::throughLens(const RenderSettings& settings, const passes::Atlas& atlas,
                                                const Wanted& wanted) {
    const graph::Extent image = imageExtent(wanted.view);
    sharp(settings, atlas, {wanted.view, {0, 0, image.width, image.height}});
    const PictureStats first = stats_;
    RenderSettings depths = settings;
    depths.supersample = 1;
    depths.occlusion.directions = 0;
    picture_.lens = lensOf(settings, wanted.view);
    Drawn drawn =
        draw(depths, {}, wanted.view, kLensTargets, {FrameEnd::throughLens, {picture_.image.desc}}, "depth of field");
    stats_.frames = first.frames + 1;
    stats_.samples = first.samples;
    stats_.frameMilliseconds += first.frameMilliseconds;
    stats_.passes.insert(stats_.passes.begin(), first.passes.begin(), first.passes.end());
    stats_.passTimes.insert(stats_.passTimes.begin(), first.passTimes.begin(), first.passTimes.end());
    return drawn;
}

}  // namespace nacre
