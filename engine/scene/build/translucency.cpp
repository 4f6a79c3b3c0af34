#include "engine/scene/build/translucency.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

/// @param least, most  opacity of its ends or vertices, steps
Translucency classify(std::uint32_t least, std::uint32_t most) {
    if (least == kOpacitySteps) return Translucency::opaque;
    return 2 * most > kOpacitySteps ? Translucency::dense : Translucency::faint;
}

bool hasTranslucentMeshes(const Representation& r) {
    return std::ranges::any_of(r.meshLooks, [](const SphereLook& look) { return !isOpaque(look.color); });
}

/// @param classify  of a primitive
template <typename Classify>
TranslucentRuns splitRuns(std::size_t count, const Classify& classify) {
    TranslucentRuns runs;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Translucency kind = classify(i);
        if (kind == Translucency::opaque) continue;
        if (!runs.empty() && runs.back().kind == kind && runs.back().first + runs.back().count == i)
            ++runs.back().count;
        else
            runs.push_back({i, 1, kind});
    }
    return runs;
}

/// Calls `visit` with the number of each translucent primitive. @param end  of the numbers
template <typename Visit>
void eachIn(const TranslucentRuns& runs, std::size_t end, const Visit& visit) {
    for (const TranslucentRun& run : runs)
        for (std::size_t i = run.first; i < std::min<std::size_t>(run.first + run.count, end); ++i) visit(i);
}

}  // namespace

Translucency classifyTranslucency(const SphereLook& look) {
    const std::uint32_t steps = opacitySteps(look.color);
    return classify(steps, steps);
}

Translucency classifyTranslucency(const CylinderLook& look) {
    const auto [least, most] = std::minmax({opacitySteps(look.colorA), opacitySteps(look.colorB)});
    return classify(least, most);
}

Translucency classifyTranslucency(const Representation& r, const Triangle& t) {
    const auto vertexOpacity = [&](std::uint32_t v) { return opacitySteps(r.meshLooks[r.meshVertices[v].look].color); };
    const auto [least, most] = std::minmax({vertexOpacity(t.a), vertexOpacity(t.b), vertexOpacity(t.c)});
    return classify(least, most);
}

TranslucentParts translucentParts(const Representation& r) {
    TranslucentParts parts;
    parts.spheres =
        splitRuns(r.sphereLooks.size(), [&](std::uint32_t i) { return classifyTranslucency(r.sphereLooks[i]); });
    parts.cylinders =
        splitRuns(r.cylinderLooks.size(), [&](std::uint32_t i) { return classifyTranslucency(r.cylinderLooks[i]); });
    if (hasTranslucentMeshes(r))
        parts.triangles = splitRuns(r.triangles.size() + r.coarseTriangles.size(),
                                    [&](std::uint32_t i) { return classifyTranslucency(r, drawnTriangle(r, i)); });
    return parts;
}

double layersPerLength(const Representation& r, const TranslucentParts& parts) {
    constexpr double kFar = std::numeric_limits<double>::infinity(), kPi = std::numbers::pi;
    glm::dvec3 low(kFar), high(-kFar);
    double area = 0;
    const auto cover = [&](const glm::vec3& p, double room) {
        low = glm::min(low, glm::dvec3(p) - room), high = glm::max(high, glm::dvec3(p) + room);
    };
    eachIn(parts.spheres, r.spheres.size(), [&](std::size_t i) {
        const double radius = static_cast<double>(r.spheres[i].radius);
        cover(r.spheres[i].center, radius);
        area += kPi * radius * radius;
    });
    // The mean area of a convex body in a picture is a quarter of its surface.
    eachIn(parts.cylinders, r.cylinders.size(), [&](std::size_t i) {
        const Cylinder& c = r.cylinders[i];
        const double radius = static_cast<double>(c.radius);
        cover(c.a, radius), cover(c.b, radius);
        area += kPi / 2 * radius * (static_cast<double>(glm::distance(c.a, c.b)) + radius);
    });
    eachIn(parts.triangles, r.triangles.size(), [&](std::size_t i) {
        const Triangle& t = r.triangles[i];
        const auto corner = [&](std::uint32_t v) { return decodePosition(r.meshVertices[v], t.step()); };
        const glm::vec3 a = corner(t.a), b = corner(t.b), c = corner(t.c);
        cover(a, 0), cover(b, 0), cover(c, 0);
        area += static_cast<double>(glm::length(glm::cross(b - a, c - a))) / 4;
    });
    const glm::dvec3 size = high - low;
    const double volume = area > 0 ? kPi / 6 * size.x * size.y * size.z : 0;
    return volume > 0 ? area / volume : 0;
}

void orderByTranslucency(const Representation& r, std::vector<Triangle>::iterator first,
                         std::vector<Triangle>::iterator end) {
    if (!hasTranslucentMeshes(r)) return;
    std::stable_sort(first, end, [&](const Triangle& a, const Triangle& b) {
        return classifyTranslucency(r, a) < classifyTranslucency(r, b);
    });
}

}  // namespace nacre
