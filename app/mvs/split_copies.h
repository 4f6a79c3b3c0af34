#pragma once
// Copies of a structure that are drawn in different ways: each group of them has atoms of its own.

#include <cstdint>
#include <vector>

#include "app/mvs/scene_parts.h"

namespace nacre::app::mvs {

constexpr std::uint32_t kNoGroup = UINT32_MAX;

/// Makes all instances of a structure copies, with its transform nodes applied. @throws Error if there are too many
void foldInstances(const Node& node, Structure& structure);

/// Gives the atoms once to each group of copies. @param groups  by transform, each below `count`; kNoGroup: these
/// copies are not shown
void splitCopies(const std::vector<std::uint32_t>& groups, std::uint32_t count, Structure& structure);

}  // namespace nacre::app::mvs
