#include "engine/graph/capability_sets.h"

#include "engine/error.h"

namespace nacre::graph {
namespace {

PlanCaps named(const char* name) {
    PlanCaps caps;
    caps.name = name;
    return caps;
}

std::vector<PlanCaps> makeSets() {
    std::vector<PlanCaps> sets;
    PlanCaps mali = named("mali");
    mali.storeNone = true;  // VK_EXT_load_store_op_none is offered by Arm's drivers since r38
    sets.push_back(mali);
    PlanCaps adreno = named("adreno");
    adreno.storeNone = true;
    sets.push_back(adreno);
    sets.push_back(named("powervr"));
    PlanCaps apple = named("apple-moltenvk");
    apple.tileSubpasses = false;  // MoltenVK ends its Metal encoder at every subpass
    sets.push_back(apple);
    PlanCaps desktop = named("desktop");
    desktop.transient = false;  // no lazily allocated memory on immediate-mode GPUs
    sets.push_back(desktop);
    return sets;
}

}  // namespace

std::span<const PlanCaps> capabilitySets() {
    static const std::vector<PlanCaps> sets = makeSets();
    return sets;
}

const PlanCaps& capabilitySet(std::string_view name) {
    std::string names;
    for (const PlanCaps& caps : capabilitySets()) {
        if (caps.name == name) return caps;
        names += (names.empty() ? "" : ", ") + caps.name;
    }
    throw Error("unknown capability set", std::string(name), "known are " + names);
}

}  // namespace nacre::graph
