#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gemmi {
struct Op;
struct SpaceGroup;
}  // namespace gemmi

namespace nacre {

/// The space group of a Hermann-Mauguin name ("P 21 21 21", "Fm-3m"), also as files from before 1995 write cubic ones
/// ("F m 3 m" for F m -3 m), and with an origin's letter; null if there is none.
const gemmi::SpaceGroup* spaceGroupOf(const std::string& name);

/// The symmetry operation of a text as "-x, y+1/2, 1/2-z"; none if it is no such text.
std::optional<gemmi::Op> operationOf(std::string_view text);

}  // namespace nacre
