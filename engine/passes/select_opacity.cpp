#include "engine/passes/select_opacity.h"

#include <algorithm>
#include <utility>

namespace nacre::passes {
namespace {

using Call = PlacedCopies::Call;

/// The part of a call from one primitive to another, if there is one.
void addPart(const Call& call, std::uint32_t first, std::uint32_t end, std::vector<Call>& list) {
    first = std::max(first, call.first);
    end = std::min(end, call.first + call.count);
    if (first < end) list.push_back({call.copy, first, end - first});
}

void selectRuns(std::vector<Call>& calls, const TranslucentRuns& runs, Opacity which) {
    if (runs.empty() && which == Opacity::translucent) calls.clear();
    if (runs.empty()) return;
    std::vector<Call> list;
    for (const Call& call : calls) {
        std::uint32_t at = call.first;
        // Most calls overlap few of the runs.
        const auto from = std::ranges::partition_point(
            runs, [&](const TranslucentRun& run) { return run.first + run.count <= call.first; });
        for (auto run = from; run != runs.end() && run->first < call.first + call.count; ++run) {
            if (which == Opacity::solid && run->kind == Translucency::dense) continue;
            if (which == Opacity::translucent) {
                addPart(call, run->first, run->first + run->count, list);
                continue;
            }
            addPart(call, at, run->first, list);
            at = std::max(at, run->first + run->count);
        }
        if (which != Opacity::translucent) addPart(call, at, call.first + call.count, list);
    }
    calls = std::move(list);
}

}  // namespace

void select(PlacedCopies& copies, const TranslucentParts& parts, Opacity which) {
    selectRuns(copies.spheres, parts.spheres, which);
    selectRuns(copies.cylinders, parts.cylinders, which);
    selectRuns(copies.triangles, parts.triangles, which);
}

}  // namespace nacre::passes
