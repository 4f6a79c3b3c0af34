#pragma once
// Which way to find a pixel's nearest surface suits a device: the one table for real devices and named ones.

#include "engine/device_options.h"
#include "engine/graph/plan.h"

namespace nacre::graph {

/// What decides how a GPU wants to be fed.
enum class DeviceKind : std::uint8_t {
    tiler,      ///< draws tile by tile in memory of its own
    layered,    ///< Vulkan on another interface: MoltenVK, KosmicKrisp
    immediate,  ///< no tile memory
    software,   ///< a CPU draws: triangles cost more than fragments
};

struct VisibilityChoice {
    Visibility visibility{};
    const char* why = "";
};

/// Whether plates in the hardware depth buffer reject anything on a path: where impostors write depth themselves, the
/// test must run before the fragment shader all the same.
bool platesReject(Visibility path, const PlanCaps& caps);

/// What `auto` takes.
VisibilityChoice chooseVisibility(DeviceKind kind, const PlanCaps& caps);

}  // namespace nacre::graph
