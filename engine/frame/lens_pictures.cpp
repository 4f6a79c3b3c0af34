// Pictures with depth of field. All paths and sampling methods end in one image, which is blurred on the device.

#include <algorithm>

#include "engine/frame/effects/lens/lens.h"
#include "engine/frame/picture_frames.h"

namespace nacre {

namespace {

/// Settings of frames that draw the distance of each pixel.
RenderSettings distances(RenderSettings settings) {
    settings.supersample = 1;
    settings.occlusion.directions = 0;
    return settings;
}

}  // namespace

/// Drops places that the lens blurs so much that one sample is enough. @returns whether it drew a frame
bool PictureFrames::leaveBlurred(const RenderSettings& settings, const View& view, FinerPlaces& places) {
    if (!places.any()) return false;
    // Groups of pixels start at the top left, also in parts of pictures.
    constexpr std::uint32_t n = FinerPlaces::kTogether;
    const auto wholes = [](std::uint32_t pixels) { return (pixels + n - 1) / n * n; };
    const View few = scaled(cropView(view, 0, 0, wholes(view.width), wholes(view.height)), 1.0 / n);
    const RenderSettings far = distances(settings);
    const Drawn drawn = run(prepare({far, Part::distances, Ending::readBack}, {{}, few, "distances"}), far);
    const auto* shown = reinterpret_cast<const float*>(drawn.pixels[0].mapped);
    const double rim = std::max(settings.effects.contours.width, settings.effects.halos.width);
    places.keep(sharpPlaces(shown, imageExtent(few), makeLens(settings, view), rim / n));
    return true;
}

/// Blurs the picture's image by the distance of each pixel.
PictureFrames::Drawn PictureFrames::blur(const RenderSettings& settings, const Wanted& wanted) {
    const PictureStats first = stats_;
    const RenderSettings far = distances(settings);
    picture_.lens = makeLens(settings, wanted.view);
    PreparedFrame prepared = prepare({far, Part::distances, Ending::throughLens}, {{}, wanted.view, "depth of field"});
    prepared.shape.picture = {picture_.image.desc};
    Drawn drawn = run(std::move(prepared), far);
    stats_.frames = first.frames + 1;
    stats_.samples = first.samples;
    stats_.frameMilliseconds += first.frameMilliseconds;
    stats_.passes.insert(stats_.passes.begin(), first.passes.begin(), first.passes.end());
    stats_.passTimes.insert(stats_.passTimes.begin(), first.passTimes.begin(), first.passTimes.end());
    return drawn;
}

}  // namespace nacre
