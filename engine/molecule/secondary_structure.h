#pragma once
// Helices and strands as files list them: ranges of residues.

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
    std::uint64_t line = 0;  ///< 0: not known
};

/// The range of a HELIX or SHEET line of a PDB file (wwPDB format 3.3); empty for other lines and unreadable ones.
std::optional<SecondaryRange> secondaryOfPdbLine(std::string_view line);

/// Marks the residues of each range, in file order within the chain. Helices take precedence. Ranges with missing ends
/// are skipped, with one warning. Linear time, also for overlapping ranges.
void applySecondaryStructure(Molecule& molecule, const std::vector<SecondaryRange>& ranges);

}  // namespace nacre
