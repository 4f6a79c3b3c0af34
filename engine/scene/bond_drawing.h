#pragma once
// Draws the bonds of a scene: sticks, parallel strands, inner lines, and dashes for coordination. Used by
// representation.cpp.

#include <span>

#include "engine/scene/appearance.h"
#include "engine/scene/assembly_scene.h"
#include "engine/scene/bond_orders.h"
#include "engine/scene/contact_lines.h"
#include "engine/scene/representation.h"

namespace nacre {

/// Adds the bonds of what has a style with bonds.
/// @param contacts  that are drawn, too: coordination that one of them shows is left to it
/// @param assembly  null: there is none @param result  has the atoms' spheres, in the order of the appearance
void addBonds(const ResidueFacts& facts, const Appearance& appearance, const DrawnOrders& orders,
              std::span<const PlacedContact> contacts, AssemblyScene* assembly, Representation& result);

}  // namespace nacre
