#pragma once
// What is known of well-known GPUs, as data, so that a frame can be judged without owning one. Every vendor quirk that
// a plan honours stands in capability_sets.cpp, with its source; real devices start from these sets, by the table in
// known_drivers.cpp.

#include <span>
#include <string_view>

#include "engine/device_options.h"
#include "engine/graph/encoded_format.h"
#include "engine/graph/visibility.h"

namespace nacre::graph {

struct Fact {
    const char* what;
    const char* source;
};

struct CapabilitySet {
    PlanCaps plan;
    DeviceKind kind{};
    EncodedFormat encoded;  ///< what `auto` takes
    std::span<const Fact> facts;
};

std::span<const CapabilitySet> capabilitySets();
/// @throws Error that lists the names
const CapabilitySet& capabilitySet(std::string_view name);

}  // namespace nacre::graph
