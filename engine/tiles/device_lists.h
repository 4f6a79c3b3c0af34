#pragma once
// Lists of the `tiles` path that the device makes: four passes before the one that draws from them.

#include <cstddef>
#include <cstdint>

#include "engine/gpu/execute.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/build/representation.h"

namespace nacre::passes {

/// Sizes of a scene's primitives, Å.
struct PrimitiveSizes {
    float sphere = 0;    ///< radius
    float cylinder = 0;  ///< diagonal of the box around its picture, without a wire's width
    float wire = 0;      ///< half a width, pixels of the requested picture
    float triangle = 0;  ///< diagonal of its box
};
struct MeasuredPrimitives {
    PrimitiveSizes largest, mean;
};
MeasuredPrimitives measurePrimitives(const Representation& representation);

/// An upper bound of the entries of all lists, if no primitive is larger than `sizes`.
/// @param bins  of the picture
std::uint64_t boundEntries(const SceneView& view, const PrimitiveSizes& sizes, std::uint64_t bins);
/// Words before the calls (shaders/common/calls.glsl).
constexpr std::size_t kCallsHeader = 6;

/// Invocations that find the bins of a primitive together. @param entries  of all lists, about
std::uint32_t chooseShare(std::uint64_t entries, std::uint64_t primitives);

/// How a frame's entries fit the memory of its lists. Each round lists and draws the bins of a share of the entries;
/// empty rounds cost little.
struct ListRounds {
    std::uint32_t count = 0;  ///< 0: a list may be too long, or the rounds too many
    std::uint32_t share = 0;  ///< a bin belongs to the round of its first entry
};
/// @param most  boundEntries() @param longest  entries of a list, at most @param room  for entries
ListRounds planRounds(std::uint64_t most, std::uint64_t longest, std::uint32_t room);

}  // namespace nacre::passes
