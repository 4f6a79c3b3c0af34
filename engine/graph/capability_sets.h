#pragma once
// Known facts about common GPUs, as data, so that a frame can be planned for a GPU that is not at hand.
// capability_sets.cpp lists every vendor quirk that a plan honours, with its source; real devices start from these
// sets, by the table in known_drivers.cpp.

#include <span>
#include <string_view>

#include "engine/graph/frame_caps.h"

namespace nacre::graph {

struct Fact {
    const char* what;
    const char* source;
};

struct CapabilitySet : FrameCaps {
    std::span<const Fact> facts;
};

std::span<const CapabilitySet> capabilitySets();
/// @throws Error that lists the names
const CapabilitySet& capabilitySet(std::string_view name);

}  // namespace nacre::graph
