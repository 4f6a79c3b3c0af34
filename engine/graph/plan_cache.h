#pragma once
// Plans of graphs that are declared anew every frame: compiled once, kept by what was declared.

#include <list>
#include <string>

#include "engine/graph/plan.h"

namespace nacre::graph {

/// Whether two graphs declare the same: names, images, buffers and uses. How passes record does not count.
bool sameDeclarations(const Graph& a, const Graph& b);

class PlanCache {
public:
    /// The plan of a graph: the one kept from an equal graph, or a new one. Good until the next call.
    /// @param caps must be the same from call to call, but for `merge`
    const Plan& planOf(const Graph& graph, const PlanCaps& caps);
    std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        Graph graph;  ///< without its recorders
        bool merge;
        Plan plan;
    };
    std::list<Entry> entries_;  ///< latest use first
};

}  // namespace nacre::graph
