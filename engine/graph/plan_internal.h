#pragma once
// The stages of compile(), in order. Private to engine/graph.

#include "engine/graph/plan.h"

namespace nacre::graph {

constexpr VkAccessFlags kWriteAccess = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT |
                                       VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT |
                                       VK_ACCESS_HOST_WRITE_BIT;

/// "pass 'x', image 'y'"
std::string naming(const Graph& graph, const PassDecl& pass, const Use& use);

/// Rejects graphs that are invalid on any device. @throws GraphError
void validate(const Graph& graph, const PlanCaps& caps);
/// Marks passes that reach no output.
std::vector<bool> cullPasses(const Graph& graph);
/// Groups the remaining passes into steps, and those of a render pass into subpasses. No ops or layouts yet.
void mergePasses(const Graph& graph, const PlanCaps& caps, Plan& plan);
/// Load and store operations, transience, usage flags, traffic.
void deriveOperations(const Graph& graph, const PlanCaps& caps, Plan& plan);
/// Layouts, subpass dependencies and barriers.
void deriveSynchronization(const Graph& graph, Plan& plan);

/// Usage flag that an image needs for a verb.
VkImageUsageFlags usageFlag(Verb verb);

/// Finds the verb with which a subpass uses an attachment. @returns false if it does not use it
bool attachmentVerb(const Subpass& subpass, std::uint32_t attachment, Verb& verb);
/// The verb of a use, after inputs that left the tile became texture reads.
Verb effectiveVerb(const Plan& plan, std::uint32_t pass, const Use& use);

}  // namespace nacre::graph
