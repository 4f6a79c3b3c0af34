#pragma once

#include <cstdint>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// perceivedOrders() as pictures draw them: 4 in rings that are drawn as aromatic, and 1, 2 or 3 in aromatic rings that
/// are drawn as a Kekulé structure, such as those of fullerenes, haem and caffeine.
std::vector<std::uint8_t> drawnOrders(const ResidueFacts& facts);

}  // namespace nacre
