#pragma once
// Draws the bonds of a scene: sticks, parallel strands, inner lines, and dashes for coordination. Used by
// representation.cpp.

#include <span>

#include "engine/scene/build/appearance.h"
#include "engine/scene/build/bond_orders.h"
#include "engine/scene/build/contact_lines.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/instances/assembly_scene.h"

namespace nacre {

/// Adds the bonds of atoms in styles with bonds.
/// @param contacts  also drawn: coordination that one of them shows is omitted here
/// @param assembly  null: there is none @param result  has the atoms' spheres, in the order of the appearance
void addBonds(const ResidueFacts& facts, const Appearance& appearance, const DrawnOrders& orders,
              std::span<const PlacedContact> contacts, AssemblyScene* assembly, Representation& result);

}  // namespace nacre
