#include "engine/scene/build/dashes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/scene/build/representation.h"

namespace nacre {

bool shorten(DashedLine& line, double radiusA, double radiusB) {
    const glm::dvec3 way = line.b - line.a;
    const double length = glm::length(way);
    if (!(length - radiusA - radiusB > kShortestLine)) return false;
    line.b -= way * (radiusB / length);
    line.a += way * (radiusA / length);
    return true;
}

void appendCapsule(const DashedLine& line, Representation& scene) {
    const glm::dvec3 way = line.b - line.a;
    const double length = glm::length(way);
    const LineLook &lookA = line.look, &lookB = line.lookB ? *line.lookB : line.look;
    const auto ball = [&](const glm::dvec3& at, const LineLook& look) {
        scene.spheres.push_back({glm::vec3(at), static_cast<float>(line.radius)});
        scene.sphereLooks.push_back({look.color, look.id});
    };
    if (length <= 2 * line.radius) return ball((line.a + line.b) / 2.0, lookA);
    const glm::dvec3 inset = way * (line.radius / length), from = line.a + inset, to = line.b - inset;
    ball(from, lookA);
    ball(to, lookB);
    scene.cylinders.push_back({glm::vec3(from), static_cast<float>(line.radius), glm::vec3(to), 0.0f});
    scene.cylinderLooks.push_back({lookA.color, lookB.color, lookA.id, lookB.id});
}

std::size_t appendDashes(const DashedLine& line, Representation& scene) {
    const glm::dvec3 way = line.b - line.a;
    const double length = glm::length(way), period = line.pattern.period();
    if (!(length > kShortestLine) || !(period > 0)) return 0;
    const double patterns = std::clamp(std::round(length / period), 1.0, static_cast<double>(kMostPatterns));
    const double scale = length / (patterns * period);
    const std::array<double, 4>& parts = line.pattern.lengths;
    const double lastGap = parts[3] > 0 ? parts[3] : parts[1];
    const auto at = [&](double along) { return line.a + way * (along / length); };
    std::size_t count = 0;
    double from = lastGap / 2 * scale;
    for (int k = 0; k < static_cast<int>(patterns); ++k)
        for (std::size_t part = 0; part < 4; part += 2) {
            const double dash = parts[part] * scale, gap = parts[part + 1] * scale;
            if (gap > 0) {
                ++count;
                DashedLine one = line;
                // As wide as the line, except for dots that would leave no gap.
                if (dash <= 2 * line.radius) one.radius = std::min(line.radius, (dash + 2 * gap / 3) / 2);
                one.a = at(from);
                one.b = at(from + dash);
                if (line.lookB && from > length / 2) one.look = *line.lookB;
                if (line.lookB && from + dash < length / 2) one.lookB.reset();
                appendCapsule(one, scene);
            }
            from += dash + gap;
        }
    return count;
}

}  // namespace nacre
