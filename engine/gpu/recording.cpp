#include "engine/gpu/recording.h"

namespace nacre::gpu {
namespace {

std::string describeWork(const graph::Graph& graph, const graph::Plan& plan) {
    std::string text;
    const auto add = [&](std::uint32_t pass) { text += (text.empty() ? ": " : ", ") + graph.passes()[pass].name; };
    for (const graph::Step& step : plan.steps) {
        if (step.kind != graph::PassKind::graphics) add(step.pass);
        for (const graph::Subpass& subpass : step.renderPass.subpasses)
            for (const std::uint32_t pass : subpass.passes) add(pass);
    }
    return graph.name() + text;
}

std::string joinNames(const graph::Graph& graph, const graph::RenderPassPlan& pass) {
    std::string name;
    for (const graph::Subpass& subpass : pass.subpasses)
        for (const std::uint32_t p : subpass.passes) name += (name.empty() ? "" : " + ") + graph.passes()[p].name;
    return name;
}

/// Clear values of the attachments, up to the last cleared one.
std::vector<vk::ClearValue> makeClears(const graph::RenderPassPlan& pass) {
    std::vector<vk::ClearValue> clears;
    std::size_t count = 0;
    for (const graph::Attachment& a : pass.attachments) {
        clears.push_back(graph::isDepthFormat(a.format)
                             ? vk::ClearValue(vk::ClearDepthStencilValue(a.clear.value[0], 0))
                             : vk::ClearValue(vk::ClearColorValue(a.clear.value)));
        if (a.load == graph::Load::clear) count = clears.size();
    }
    clears.resize(count);
    return clears;
}

}  // namespace

Recording::Recording(const graph::Graph& graph, const graph::Plan& plan)
    : graph_(graph), plan_(plan), work_(describeWork(graph, plan)) {
    for (const graph::ImageDecl& image : graph.images()) owned_.push_back(graph.name() + ": " + image.name);
    for (const graph::Step& step : plan.steps)
        renderPasses_.push_back({joinNames(graph, step.renderPass), makeClears(step.renderPass), nullptr});
}

}  // namespace nacre::gpu
