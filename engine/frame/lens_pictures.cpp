// Pictures with depth of field. All paths and all ways to sample end in one image, which is blurred on the device.

#include <algorithm>

#include "engine/frame/lens.h"
#include "engine/frame/picture_frames.h"

namespace nacre {

namespace {

/// Of frames that tell how far away pixels are.
RenderSettings distances(RenderSettings settings) {
    settings.supersample = 1;
    settings.occlusion.directions = 0;
    return settings;
}

}  // namespace

/// Drops the places that the lens blurs so much that one sample is enough. @returns whether that took a frame
bool PictureFrames::leaveBlurred(const RenderSettings& settings, const View& view, FinerPlaces& places) {
    if (!places.any()) return false;
    // Pixels go together from the top left, in parts of pictures, too.
    constexpr std::uint32_t n = FinerPlaces::kTogether;
    const auto wholes = [](std::uint32_t pixels) { return (pixels + n - 1) / n * n; };
    const View few = scaled(partOf(view, 0, 0, wholes(view.width), wholes(view.height)), 1.0 / n);
    const Drawn drawn =
        draw(distances(settings), {}, few, kLensTargets, {FrameEnd::readBack, {}, {}, true}, "distances");
    const auto* shown = reinterpret_cast<const float*>(drawn.pixels[0].mapped);
    const double rim = std::max(settings.effects.contours.width, settings.effects.halos.width);
    places.keep(sharpPlaces(shown, imageExtent(few), lensOf(settings, view), rim / n));
    return true;
}

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
    picture_.lens = lensOf(settings, wanted.view);
    const Ending ending{FrameEnd::throughLens, {picture_.image.desc}, {}, true};
    Drawn drawn = draw(distances(settings), {}, wanted.view, kLensTargets, ending, "depth of field");
    stats_.frames = first.frames + 1;
    stats_.samples = first.samples;
    stats_.frameMilliseconds += first.frameMilliseconds;
    stats_.passes.insert(stats_.passes.begin(), first.passes.begin(), first.passes.end());
    stats_.passTimes.insert(stats_.passTimes.begin(), first.passTimes.begin(), first.passTimes.end());
    return drawn;
}

}  // namespace nacre
