#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gemmi {
struct Op;
struct SpaceGroup;
}  // namespace gemmi

namespace nacre {

/// The space group of a Hermann-Mauguin name ("P 21 21 21", "Fm-3m"). Accepts names of cubic ones from before 1995 ("F
/// m 3 m" for F m -3 m), and a letter for the origin. Null if there is none.
const gemmi::SpaceGroup* findSpaceGroup(const std::string& name);

/// The symmetry operation of a text such as "-x, y+1/2, 1/2-z"; empty for any other text.
std::optional<gemmi::Op> parseTriplet(std::string_view text);

}  // namespace nacre
