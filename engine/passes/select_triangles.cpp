#include "engine/passes/select_triangles.h"

#include <algorithm>
#include <utility>

namespace nacre::passes {
namespace {

using Call = PlacedCopies::Call;

/// The part of a call from one triangle to another, if there is one.
void addPart(const Call& call, std::uint32_t first, std::uint32_t end, std::vector<Call>& list) {
    first = std::max(first, call.first);
    end = std::min(end, call.first + call.count);
    if (first < end) list.push_back({call.copy, first, end - first});
}

}  // namespace

void selectTriangles(std::vector<Call>& calls, const TranslucentRuns& runs, Triangles which) {
    if (runs.empty() && which == Triangles::translucent) calls.clear();
    if (runs.empty()) return;
    std::vector<Call> list;
    for (const Call& call : calls) {
        std::uint32_t at = call.first;
        for (const TranslucentRun& run : runs) {
            if (which == Triangles::solid && run.kind == Translucency::dense) continue;
            if (which == Triangles::translucent) {
                addPart(call, run.first, run.first + run.count, list);
                continue;
            }
            addPart(call, at, run.first, list);
            at = std::max(at, run.first + run.count);
        }
        if (which != Triangles::translucent) addPart(call, at, call.first + call.count, list);
    }
    calls = std::move(list);
}

}  // namespace nacre::passes
