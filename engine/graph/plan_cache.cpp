#include "engine/graph/plan_cache.h"

#include <algorithm>

namespace nacre::graph {
namespace {

constexpr std::size_t kMost = 16;

bool samePass(const PassDecl& a, const PassDecl& b) {
    return a.name == b.name && a.kind == b.kind && a.sideEffect == b.sideEffect && a.uses == b.uses;
}

}  // namespace

bool sameDeclarations(const Graph& a, const Graph& b) {
    return a.name() == b.name() && a.images() == b.images() && a.buffers() == b.buffers() &&
           std::equal(a.passes().begin(), a.passes().end(), b.passes().begin(), b.passes().end(), samePass);
}

const Plan& PlanCache::planOf(const Graph& graph, const PlanCaps& caps) {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& e) { return e.caps == caps && sameDeclarations(e.graph, graph); });
    if (found != entries_.end()) {
        entries_.splice(entries_.begin(), entries_, found);
        return entries_.front().plan;
    }
    entries_.push_front({graph.declarations(), caps, compile(graph, caps)});
    if (entries_.size() > kMost) entries_.pop_back();
    return entries_.front().plan;
}

}  // namespace nacre::graph
