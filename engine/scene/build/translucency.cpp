#include "engine/scene/build/translucency.h"

#include <algorithm>

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

void orderByTranslucency(const Representation& r, std::vector<Triangle>::iterator first,
                         std::vector<Triangle>::iterator end) {
    if (!hasTranslucentMeshes(r)) return;
    std::stable_sort(first, end, [&](const Triangle& a, const Triangle& b) {
        return classifyTranslucency(r, a) < classifyTranslucency(r, b);
    });
}

}  // namespace nacre
