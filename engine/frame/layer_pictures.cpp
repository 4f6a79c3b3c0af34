// Pictures of what pixels show besides colour, and the atom at a position.

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/frame/picture.h"
#include "engine/frame/picture_frames.h"

namespace nacre {

LayerPicture PictureFrames::layers(const RenderSettings& settings, const passes::Atlas& atlas) {
    const auto drawPart = [&](Part part, const char* name) {
        return run(prepare({settings, part, Ending::readBack}, {atlas, settings.view, name}), settings).pixels;
    };
    std::vector<gpu::Buffer> pixels;
    if (frames_.facts(settings).blends()) {
        pixels = drawPart(Part::color, "screen");
        for (gpu::Buffer& layer : drawPart(Part::solid, "solid")) pixels.push_back(std::move(layer));
    } else {
        pixels = drawPart(Part::layers, "screen");
    }
    return assembleLayers(settings.view.width, settings.view.height, reinterpret_cast<const float*>(pixels[0].mapped),
                          reinterpret_cast<const float*>(pixels[1].mapped),
                          reinterpret_cast<const std::uint32_t*>(pixels[2].mapped), settings.background,
                          stats_.coveredPixels);
}

std::array<LayerPicture, 2> PictureFrames::layersOfEyes(const RenderSettings& settings, const passes::Atlas& atlas) {
    const FrameRequest request{settings, Part::layers, Ending::readBack, 0, settings.tuning.countFragments, true};
    if (!drawsBoth(request)) {
        RenderSettings left = settings, right = settings;
        left.view.other.reset();
        right.view = otherView(settings.view);
        std::array<LayerPicture, 2> eyes{layers(left, atlas), layers(right, atlas)};
        asked_->eyes = true;
        return eyes;
    }
    const std::vector<gpu::Buffer> pixels = run(prepare(request, {atlas, settings.view}), settings).pixels;
    std::array<LayerPicture, 2> eyes;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto of = [&](std::size_t layer) { return pixels[layer].mapped + i * pixels[layer].size / 2; };
        eyes[i] = assembleLayers(settings.view.width, settings.view.height, reinterpret_cast<const float*>(of(0)),
                                 reinterpret_cast<const float*>(of(1)), reinterpret_cast<const std::uint32_t*>(of(2)),
                                 settings.background, stats_.coveredPixels);
    }
    return eyes;
}

std::uint32_t PictureFrames::atomAt(const RenderSettings& settings, double x, double y, double reach) {
    // A separate picture around the position, as large as the reach. Its middle pixel contains (x, y).
    const auto side = static_cast<std::uint32_t>(2 * std::ceil(std::clamp(reach, 0.0, 100.0)) + 1);
    RenderSettings small = settings;
    small.view.pan = -planePointAt(settings.view, std::floor(x) + 0.5, std::floor(y) + 0.5);
    small.view.width = small.view.height = side;
    const Drawn drawn = identify(std::move(small), "pick");
    return nearestAtom(reinterpret_cast<const std::uint32_t*>(drawn.pixels[0].mapped), side, reach);
}

std::vector<std::uint32_t> PictureFrames::atoms(const RenderSettings& settings) {
    const Drawn drawn = identify(settings, "identity");
    const auto* identity = reinterpret_cast<const std::uint32_t*>(drawn.pixels[0].mapped);  // atom, copy
    std::vector<std::uint32_t> atoms(std::size_t{settings.view.width} * settings.view.height);
    for (std::size_t i = 0; i < atoms.size(); ++i) atoms[i] = identity[2 * i];
    return atoms;
}

/// Draws the identity of each pixel. @param name  prefix of the frame's images
PictureFrames::Drawn PictureFrames::identify(RenderSettings settings, const char* name) {
    settings.occlusion.directions = 0;
    settings.tuning.countFragments = false;
    return run(prepare({settings, Part::pick, Ending::readBack}, {{}, settings.view, name}), settings);
}

}  // namespace nacre
