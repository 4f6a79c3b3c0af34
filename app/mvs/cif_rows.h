#pragma once
// One category of a CIF or BinaryCIF file, whatever its name.

#include <string>
#include <string_view>
#include <vector>

#include "app/mvs/annotations.h"

namespace nacre::app::mvs {

/// As readTable(), of CIF or BinaryCIF. Names are the same in capitals and small letters.
AnnotationTable readCifTable(const std::string& name, const std::string& bytes, const TablePlace& place,
                             const std::vector<std::string_view>& wanted);

}  // namespace nacre::app::mvs
