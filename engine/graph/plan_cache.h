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
    /// The plan of a graph: the one kept from an equal graph and equal caps, or a new one. Good until the next call.
    const Plan& planOf(const Graph& graph, const PlanCaps& caps);
    std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        Graph graph;  ///< without its recorders
        PlanCaps caps;
        Plan plan;
    };
    std::list<Entry> entries_;  ///< latest use first
};

}  // namespace nacre::graph
