#pragma once
// Judges a plan by walking through it as a device would: layouts, hazards, and what every image holds. Written from the
// Vulkan specification's rules, apart from the planner; it shares no table with it.

#include <string>
#include <vector>

#include "engine/graph/plan.h"

namespace nacre::test {

/// What is wrong with the plan; empty is what is right.
std::vector<std::string> checkPlan(const graph::Graph& graph, const graph::Plan& plan, const graph::PlanCaps& caps);

}  // namespace nacre::test
