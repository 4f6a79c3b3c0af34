#include "engine/scene/build/translucency.h"

#include <algorithm>

#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

bool hasTranslucency(const Representation& r) {
    return std::any_of(r.meshLooks.begin(), r.meshLooks.end(),
                       [](const SphereLook& look) { return !isOpaque(look.color); });
}

}  // namespace

Translucency translucencyOf(const Representation& r, const Triangle& t) {
    std::uint32_t least = kOpacitySteps, most = 0;
    for (const std::uint32_t v : {t.a, t.b, t.c}) {
        const std::uint32_t steps = opacitySteps(r.meshLooks[r.meshVertices[v].look].color);
        least = std::min(least, steps);
        most = std::max(most, steps);
    }
    if (least == kOpacitySteps) return Translucency::opaque;
    return 2 * most > kOpacitySteps ? Translucency::dense : Translucency::faint;
}

TranslucentRuns translucentRuns(const Representation& r) {
    TranslucentRuns runs;
    if (!hasTranslucency(r)) return runs;
    for (std::uint32_t i = 0; i < r.triangles.size() + r.coarseTriangles.size(); ++i) {
        const Translucency kind = translucencyOf(r, drawnTriangle(r, i));
        if (kind == Translucency::opaque) continue;
        if (!runs.empty() && runs.back().kind == kind && runs.back().first + runs.back().count == i)
            ++runs.back().count;
        else
            runs.push_back({i, 1, kind});
    }
    return runs;
}

void orderByTranslucency(const Representation& r, std::vector<Triangle>::iterator first,
                         std::vector<Triangle>::iterator end) {
    if (!hasTranslucency(r)) return;
    std::stable_sort(first, end,
                     [&](const Triangle& a, const Triangle& b) { return translucencyOf(r, a) < translucencyOf(r, b); });
}

}  // namespace nacre
