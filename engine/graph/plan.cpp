#include "engine/graph/plan.h"

#include <algorithm>

#include "engine/graph/plan_internal.h"

namespace nacre::graph {

std::string naming(const Graph& graph, const PassDecl& pass, const Use& use) {
    const std::string& name = use.isImage ? graph.images()[use.resource].name : graph.buffers()[use.resource].name;
    return "pass '" + pass.name + "', " + (use.isImage ? "image '" : "buffer '") + name + "'";
}

std::vector<bool> cullPasses(const Graph& graph) {
    const auto& passes = graph.passes();
    std::vector<bool> imageWanted(graph.images().size());
    for (std::size_t i = 0; i < imageWanted.size(); ++i)
        imageWanted[i] = graph.images()[i].output || graph.images()[i].imported.has_value();

    std::vector<bool> culled(passes.size(), true);
    for (std::size_t p = passes.size(); p-- > 0;) {
        const PassDecl& pass = passes[p];
        bool live = pass.sideEffect;
        for (const Use& use : pass.uses)  // buffers outlive the graph
            live = live || (isWrite(use.verb) && (!use.isImage || imageWanted[use.resource]));
        if (!live) continue;
        culled[p] = false;
        // A cleared use needs nothing from earlier passes; every other use does.
        for (const Use& use : pass.uses)
            if (use.isImage) imageWanted[use.resource] = !use.clear;
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
    plan.bufferTraffic.resize(graph.buffers().size());
    mergePasses(graph, caps, plan);
    deriveOperations(graph, caps, plan);
    deriveSynchronization(graph, plan);
    return plan;
}

std::uint32_t tileBytesPerPixel(const Plan& plan) {
    std::uint32_t most = 0;
    for (const Step& step : plan.steps) most = std::max(most, step.renderPass.tileBytesPerPixel);
    return most;
}

}  // namespace nacre::graph
