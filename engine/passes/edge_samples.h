#pragma once
// The samples of a pixel that shows an edge, one frame each.

#include "engine/scene/camera.h"
#include "engine/settings.h"
#include "shaders/common/layout.h"

namespace nacre {

/// Where a sample stands in its pixel, from the corner, pixels; as shaders/common/samples.glsl has it.
inline glm::dvec2 edgeSample(std::uint32_t i) {
    const std::uint32_t rows = i < 8 ? layout::kSampleRowsLow : layout::kSampleRowsHigh;
    return (glm::dvec2(i, rows >> 4 * (i & 7) & 15) + 0.5) / double{RenderSettings::kEdgeSamples};
}

/// The view whose pixels look through their sample i with their middles.
inline View throughSample(View view, std::uint32_t i) {
    const glm::dvec2 away = edgeSample(i) - 0.5;
    view.pan += glm::dvec2(-away.x, away.y) / view.pixelsPerAngstrom;
    return view;
}

}  // namespace nacre
