#pragma once

#include <string>

namespace gemmi {
struct SpaceGroup;
}

namespace nacre {

/// The space group of a Hermann-Mauguin name ("P 21 21 21", "Fm-3m"), also as files from before 1995 write cubic ones
/// ("F m 3 m" for F m -3 m), and with an origin's letter; null if there is none.
const gemmi::SpaceGroup* spaceGroupOf(const std::string& name);

}  // namespace nacre
