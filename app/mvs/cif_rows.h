#pragma once
// Reads one category, of any name, from a CIF or BinaryCIF file.

#include <string>
#include <string_view>
#include <vector>

#include "app/mvs/annotations.h"

namespace nacre::app::mvs {

/// As readTable(), for CIF or BinaryCIF. Names are case-insensitive.
AnnotationTable readCifTable(const std::string& name, const std::string& bytes, const TablePlace& place,
                             const std::vector<std::string_view>& wanted);

}  // namespace nacre::app::mvs
