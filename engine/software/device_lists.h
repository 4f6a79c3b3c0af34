#pragma once
// Lists of the `tiles` path that the device makes: four passes before the one that draws from them.

#include <cstdint>
#include <memory>

#include "engine/gpu/execute.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/build/representation.h"

namespace nacre::passes {

/// The largest primitives of a scene, Å.
struct LargestPrimitives {
    float sphere = 0;    ///< radius
    float cylinder = 0;  ///< diagonal of the largest box around its picture, without a wire's width
    float wire = 0;      ///< half a width, pixels of the requested picture
    float triangle = 0;  ///< diagonal of its box
};
LargestPrimitives measureLargest(const Representation& representation);

/// An upper bound of the entries of all lists.
/// @param bins  of the picture
std::uint64_t mostEntries(const SceneView& view, const LargestPrimitives& largest, std::uint64_t bins);

/// Limit of mostEntries(): a frame with more is not listed by the device.
constexpr std::uint64_t kMostEntries = std::uint64_t{1} << 25;

}  // namespace nacre::passes
