#pragma once

#include <span>
#include <string_view>

#include "engine/graph/plan.h"

namespace nacre::graph {

/// What the planner knows of well-known GPUs, so that a frame can be judged without owning one.
std::span<const PlanCaps> capabilitySets();
/// @throws Error that lists the names
const PlanCaps& capabilitySet(std::string_view name);

}  // namespace nacre::graph
