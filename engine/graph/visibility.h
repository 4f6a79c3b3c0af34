#pragma once
// Chooses the visibility path for a device: one table for real devices and named sets.

#include <string>

#include "engine/device_options.h"
#include "engine/graph/plan.h"

namespace nacre::graph {

/// Kinds of GPU by how they handle geometry.
enum class DeviceKind : std::uint8_t {
    tiler,      ///< renders tile by tile in on-chip memory
    layered,    ///< Vulkan on top of another API: MoltenVK, KosmicKrisp
    immediate,  ///< no tile memory
    software,   ///< a CPU draws: triangles cost more than fragments
};

struct VisibilityChoice {
    Visibility visibility{};
    const char* why = "";
};

/// Whether plates in the hardware depth buffer reject fragments on a path. Where impostors write depth themselves, that
/// needs a depth test before the fragment shader.
bool platesReject(Visibility path, const PlanCaps& caps);

/// The choice of `auto`.
VisibilityChoice chooseVisibility(DeviceKind kind, const PlanCaps& caps);

/// Samples per pixel of multisampled frames: a fragment tells which of them it covers.
constexpr std::uint32_t kMultisamples = 4;

struct SampleChoice {
    std::uint32_t samples = 1;
    std::string why;  ///< reason for the number
};

/// Why a path cannot draw kMultisamples per pixel in one render pass without storing them. Empty: it can.
std::string lacksMultisampling(Visibility path, const PlanCaps& caps);

/// The choice of `auto` for frames in motion: several samples where they cost neither memory traffic nor a second
/// fragment.
SampleChoice chooseSamples(DeviceKind kind, Visibility path, const PlanCaps& caps);

}  // namespace nacre::graph
