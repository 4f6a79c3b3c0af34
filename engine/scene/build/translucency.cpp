#include "engine/scene/build/translucency.h"

#include <algorithm>

#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

/// @param least, most  opacity of its ends or vertices, steps
Translucency classOf(std::uint32_t least, std::uint32_t most) {
    if (least == kOpacitySteps) return Translucency::opaque;
    return 2 * most > kOpacitySteps ? Translucency::dense : Translucency::faint;
}

bool hasTranslucentMeshes(const Representation& r) {
    return std::ranges::any_of(r.meshLooks, [](const SphereLook& look) { return !isOpaque(look.color); });
}

/// @param classOf  of a primitive
template <typename ClassOf>
TranslucentRuns runsOf(std::size_t count, const ClassOf& classOf) {
    TranslucentRuns runs;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Translucency kind = classOf(i);
        if (kind == Translucency::opaque) continue;
        if (!runs.empty() && runs.back().kind == kind && runs.back().first + runs.back().count == i)
            ++runs.back().count;
        else
            runs.push_back({i, 1, kind});
    }
    return runs;
}

}  // namespace

Translucency translucencyOf(const SphereLook& look) {
    const std::uint32_t steps = opacitySteps(look.color);
    return classOf(steps, steps);
}

Translucency translucencyOf(const CylinderLook& look) {
    const auto [least, most] = std::minmax({opacitySteps(look.colorA), opacitySteps(look.colorB)});
    return classOf(least, most);
}

Translucency translucencyOf(const Representation& r, const Triangle& t) {
    const auto stepsOf = [&](std::uint32_t v) { return opacitySteps(r.meshLooks[r.meshVertices[v].look].color); };
    const auto [least, most] = std::minmax({stepsOf(t.a), stepsOf(t.b), stepsOf(t.c)});
    return classOf(least, most);
}

TranslucentParts translucentParts(const Representation& r) {
    TranslucentParts parts;
    parts.spheres = runsOf(r.sphereLooks.size(), [&](std::uint32_t i) { return translucencyOf(r.sphereLooks[i]); });
    parts.cylinders =
        runsOf(r.cylinderLooks.size(), [&](std::uint32_t i) { return translucencyOf(r.cylinderLooks[i]); });
    if (hasTranslucentMeshes(r))
        parts.triangles = runsOf(r.triangles.size() + r.coarseTriangles.size(),
                                 [&](std::uint32_t i) { return translucencyOf(r, drawnTriangle(r, i)); });
    return parts;
}

void orderByTranslucency(const Representation& r, std::vector<Triangle>::iterator first,
                         std::vector<Triangle>::iterator end) {
    if (!hasTranslucentMeshes(r)) return;
    std::stable_sort(first, end,
                     [&](const Triangle& a, const Triangle& b) { return translucencyOf(r, a) < translucencyOf(r, b); });
}

}  // namespace nacre
