#include "engine/graph/plan.h"

#include "engine/graph/plan_internal.h"

namespace nacre::graph {

std::string naming(const Graph& graph, const PassDecl& pass, const Use& use) {
    const std::string& name = use.isImage ? graph.images()[use.resource].name : graph.buffers()[use.resource].name;
    return "pass '" + pass.name + "', " + (use.isImage ? "image '" : "buffer '") + name + "'";
}

std::vector<bool> cullPasses(const Graph& graph) {
    const auto& passes = graph.passes();
    std::vector<bool> imageWanted(graph.images().size());
    std::vector<bool> bufferWanted(graph.buffers().size(), true);  // they live on outside
    for (std::size_t i = 0; i < imageWanted.size(); ++i)
        imageWanted[i] = graph.images()[i].output || graph.images()[i].imported.has_value();

    std::vector<bool> culled(passes.size(), true);
    for (std::size_t p = passes.size(); p-- > 0;) {
        const PassDecl& pass = passes[p];
        auto wanted = [&](const Use& use) {
            return use.isImage ? imageWanted[use.resource] : bufferWanted[use.resource];
        };
        bool live = pass.sideEffect;
        for (const Use& use : pass.uses) live = live || (isWrite(use.verb) && wanted(use));
        if (!live) continue;
        culled[p] = false;
        for (const Use& use : pass.uses) {
            // What a clear overwrites is not wanted from earlier passes; everything else that is used is.
            const bool wantedBefore = !use.clear;
            if (use.isImage)
                imageWanted[use.resource] = wantedBefore;
            else
                bufferWanted[use.resource] = wantedBefore;
        }
    }
    return culled;
}

Verb effectiveVerb(const Plan& plan, std::uint32_t pass, const Use& use) {
    return use.verb == Verb::input && plan.inputIsSampled[pass] ? Verb::samples : use.verb;
}

Plan compile(const Graph& graph, const PlanCaps& caps) {
    validate(graph, caps);
    Plan plan;
    plan.culled = cullPasses(graph);
    plan.inputIsSampled.resize(graph.passes().size());
    plan.images.resize(graph.images().size());
    plan.traffic.resize(graph.images().size());
    mergePasses(graph, caps, plan);
    deriveOperations(graph, caps, plan);
    deriveSynchronization(graph, plan);
    return plan;
}

}  // namespace nacre::graph
