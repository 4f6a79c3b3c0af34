#include "engine/scene/color/value_colors.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "engine/molecule/text.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/scene/color/palettes.h"

namespace nacre {
namespace {

constexpr int kLegendStops = 5;  // of the ramp in the legend

ColorRange usualRange(std::vector<double> values, bool signs) {
    std::erase_if(values, [](double v) { return std::isnan(v); });
    if (values.empty()) return {};
    const auto percentile = [&](std::size_t percent) {
        const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * percent / 100);
        std::nth_element(values.begin(), at, values.end());
        return *at;
    };
    ColorRange range{percentile(2), percentile(98)};
    if (signs && range.first < 0 && range.last > 0) {
        range.last = std::max(-range.first, range.last);
        range.first = -range.last;
    }
    if (range.first == range.last) range.last = range.first + std::max(std::abs(range.first), 1.0) * 1e-6;
    return range;
}

std::string formatNumber(double value) { return formatted("%.3g", value); }

}  // namespace

ValueColors::ValueColors(const ValueColoring& coloring, std::span<const double> values, const AnyPalette& ramp,
                         bool signs)
    : range_(coloring.range ? *coloring.range : usualRange({values.begin(), values.end()}, signs)),
      palette_(coloring.palette),
      tint_(coloring.tint) {
    if (palette_ == Palette::automatic)
        palette_ = signs && range_.first * range_.last < 0 ? AnyPalette(Palette::redWhiteBlue) : ramp;
}

std::uint32_t ValueColors::toStep(double value) const {
    if (std::isnan(value)) return kSteps;
    const double at = (value - range_.first) / (range_.last - range_.first);
    return static_cast<std::uint32_t>(std::lround(std::clamp(at, 0.0, 1.0) * (kSteps - 1)));
}

std::uint32_t ValueColors::colorAt(double share) const {
    if (tint_ == 0) return paletteColor(palette_, share);
    std::uint32_t color = 0xff000000u;
    for (int shift = 0; shift < 24; shift += 8)
        color |= static_cast<std::uint32_t>(std::lround((tint_ >> shift & 0xff) * share)) << shift;
    return color;
}

std::uint32_t ValueColors::stepColor(std::uint32_t step, std::uint32_t otherwise) const {
    return step >= kSteps ? otherwise : colorAt(step / (kSteps - 1.0));
}

Legend ValueColors::legend(const std::string& name) const {
    Legend legend{"all", name, {}, palette_, kLegendStops};
    for (int i = 0; i < kLegendStops; ++i) {
        const double share = i / (kLegendStops - 1.0);
        legend.entries.push_back({formatNumber(range_.first + (range_.last - range_.first) * share), colorAt(share)});
    }
    return legend;
}

std::optional<ColorRange> colorSurfaces(const ValueColoring& coloring, Representation& scene) {
    std::vector<std::uint32_t> vertices;
    std::vector<double> values;
    for (const MeshRun& run : scene.meshes) {
        if (!run.surface || run.count == 0) continue;
        const float step = scene.triangles[run.first].step();
        for (std::uint32_t v = run.firstVertex; v < run.endVertex; ++v) {
            vertices.push_back(v);
            const MeshVertex& vertex = scene.meshVertices[v];
            const glm::dvec3 at =
                glm::dvec3(decodePosition(vertex, step)) + coloring.offset * glm::dvec3(decodeNormal(vertex));
            values.push_back(valueAt(*coloring.map, at + scene.center));
        }
    }
    if (vertices.empty()) return std::nullopt;
    const ValueColors colors(coloring, values, Palette::viridis);
    constexpr std::uint32_t kOpacity = 0xff000000u;
    std::unordered_map<std::uint64_t, std::uint32_t> looks;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        MeshVertex& vertex = scene.meshVertices[vertices[i]];
        const std::uint32_t step = colors.toStep(values[i]);
        if (step == ValueColors::kSteps) continue;
        const SphereLook before = scene.meshLooks[vertex.look];
        const auto [look, added] =
            looks.emplace(std::uint64_t{vertex.look} << 32 | step, static_cast<std::uint32_t>(scene.meshLooks.size()));
        if (added)
            scene.meshLooks.push_back(
                {(colors.stepColor(step, 0) & ~kOpacity) | (before.color & kOpacity) | 1u << 24, before.atom});
        vertex.look = look->second;
    }
    scene.blendsColors = true;
    // If nothing else is drawn, the other colours are gone.
    if (scene.spheres.empty() && scene.cylinders.empty() &&
        std::all_of(scene.meshes.begin(), scene.meshes.end(), [](const MeshRun& run) { return run.surface; }))
        scene.legends.clear();
    scene.legends.push_back(colors.legend(coloring.name));
    return colors.range();
}

}  // namespace nacre
