#pragma once
// Helices and strands as files list them: from one residue to another.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

struct SecondaryRange {
    SecondaryStructure kind = SecondaryStructure::none;
    std::string chain;
    std::int32_t first = 0, last = 0;  ///< author's residue numbers
    char firstCode = '\0', lastCode = '\0';
};

/// The range of a HELIX or SHEET line of a PDB file (wwPDB format 3.3); empty for any other line or one that cannot be
/// read.
std::optional<SecondaryRange> secondaryOfPdbLine(std::string_view line);

/// Marks the residues of each range, in the file's order within the chain. Of two kinds for one residue the helix
/// stays. Ranges whose ends are not there are passed over, with one warning. Linear time, however the ranges overlap.
void applySecondaryStructure(Molecule& molecule, const std::vector<SecondaryRange>& ranges);

}  // namespace nacre
