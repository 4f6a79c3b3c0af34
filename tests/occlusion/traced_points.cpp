#include "tests/occlusion/traced_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <iostream>
#include <numbers>
#include <random>

#include "tests/reference/ambient_occlusion.h"
#include "tests/renderer/scenes.h"
#include "tests/support/on_every_core.h"

namespace nacre::test {
namespace {

constexpr std::uint32_t kSide = 384;
constexpr std::size_t kViews = 10;

RenderSettings layerSettings(const View& view) {
    RenderSettings s{.view = view};
    s.occlusion.directions = 0;
    return s;
}

Difference measureDifference(const std::vector<double>& values, const std::vector<TracedPoint>& points) {
    Difference d;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double difference = values[i] - points[i].open;
        d.rootMeanSquare += difference * difference;
        d.mean += difference;
        d.worst = std::max(d.worst, std::abs(difference));
    }
    const auto count = static_cast<double>(std::max<std::size_t>(points.size(), 1));
    d.rootMeanSquare = std::sqrt(d.rootMeanSquare / count);
    d.mean /= count;
    return d;
}

}  // namespace

std::vector<View> tracedViews(const Representation& scene) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> degrees(0, 360);
    std::vector<View> views;
    for (std::size_t v = 0; v < kViews; ++v) {
        Camera camera{.rotationDegrees = {degrees(random), degrees(random), degrees(random)}};
        views.push_back(makeView(camera, scene.radius, kSide, kSide));
    }
    return views;
}

std::vector<TracedPoint> tracePoints(Renderer& renderer, const Representation& scene, std::size_t count,
                                     std::size_t rays) {
    const std::vector<View> views = tracedViews(scene);
    std::vector<TracedPoint> points;
    std::mt19937 random(11);
    for (std::size_t v = 0; v < views.size(); ++v) {
        const View& view = views[v];
        const LayerPicture p = renderer.layers(layerSettings(view));
        const glm::dmat3 back = glm::transpose(view.rotation);
        std::uniform_int_distribution<std::uint32_t> anyPixel(0, static_cast<std::uint32_t>(p.id.size()) - 1);
        const std::size_t wanted = count * (v + 1) / views.size();
        while (points.size() < wanted) {
            const std::uint32_t i = anyPixel(random);
            if (p.id[i] == 0) continue;
            const glm::dvec3 seen((i % p.width + 0.5 - p.width / 2.0) / view.pixelsPerAngstrom,
                                  (p.height / 2.0 - i / p.width - 0.5) / view.pixelsPerAngstrom,
                                  view.radius - static_cast<double>(p.z[i]));
            const glm::dvec3 normal(p.normal[3 * i], p.normal[3 * i + 1], p.normal[3 * i + 2]);
            points.push_back({static_cast<std::uint32_t>(v), i, back * seen, glm::normalize(back * normal), 0});
        }
    }
    const reference::OcclusionScene truth(scene);
    onEveryCore(points.size(),
                [&](std::size_t i) { points[i].open = truth.occlusionAt(points[i].position, points[i].normal, rays); });
    return points;
}

Difference bakedDifference(Renderer& renderer, const Representation& scene, RenderSettings settings,
                           const std::vector<TracedPoint>& points) {
    const std::vector<View> views = tracedViews(scene);
    std::vector<double> values;
    for (std::uint32_t v = 0; v < views.size(); ++v) {
        settings.view = views[v];
        const LayerPicture p = renderer.layers(settings);
        for (const TracedPoint& point : points)
            if (point.view == v) values.push_back(p.occlusion[point.pixel]);
    }
    return measureDifference(values, points);
}

void expectNearRays(const Representation& scene, double bound) {
    ValidatedRenderer renderer(Visibility::automatic, scene);
    const auto points = tracePoints(*renderer.operator->(), scene, 2000, 1024);
    RenderSettings s;
    s.supersample = 1;
    s.occlusion.directions = 128;
    const Difference d = bakedDifference(*renderer.operator->(), scene, s, points);
    std::cout << "RMS " << d.rootMeanSquare << ", mean " << d.mean << ", worst " << d.worst << "\n";
    EXPECT_LE(d.rootMeanSquare, bound);
    EXPECT_LE(std::abs(d.mean), 0.02);
}

std::vector<WeightedDirection> originalDirections() {
    // In units of pi / 4.
    constexpr int kAngles[22][2] = {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {0, 2}, {0, 6}, {1, 1}, {3, 1},
                                    {5, 1}, {7, 1}, {1, 7}, {3, 7}, {5, 7}, {7, 7}, {1, 0}, {3, 0},
                                    {5, 0}, {7, 0}, {0, 1}, {0, 3}, {0, 5}, {0, 7}};
    std::vector<WeightedDirection> directions;
    for (const auto& pair : kAngles)
        for (const bool advanced : {false, true}) {
            const double more = advanced ? std::numbers::pi / 8 : 0;
            const double x = pair[0] * std::numbers::pi / 4 + more, y = pair[1] * std::numbers::pi / 4 + more;
            // What the matrix Rx Ry turns towards the viewer, +z: its third row.
            directions.push_back(
                {{-std::cos(x) * std::sin(y), std::sin(x), std::cos(x) * std::cos(y)}, (advanced ? 1.5 : 0.5) / 22});
        }
    return directions;
}

Difference directionsDifference(const Representation& scene, const std::vector<WeightedDirection>& directions,
                                const std::vector<TracedPoint>& points) {
    const reference::OcclusionScene truth(scene);
    std::vector<double> values(points.size());
    onEveryCore(points.size(), [&](std::size_t i) {
        const TracedPoint& p = points[i];
        for (const WeightedDirection& d : directions)
            if (glm::dot(d.direction, p.normal) > 0 && truth.openTowards(p.position, p.normal, d.direction))
                values[i] += d.weight;
    });
    return measureDifference(values, points);
}

}  // namespace nacre::test
