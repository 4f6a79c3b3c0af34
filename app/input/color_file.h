#pragma once
// Tables of colours or values of residues and atoms: CSV or JSON (docs/geometry.md).

#include <string>

#include "engine/scene/build/appearance.h"
#include "engine/scene/color/color_table.h"

namespace nacre::app {

/// @param name  of the file, for errors @param column  of the values; empty: the only unknown one
/// @throws Error with the line, or the row of JSON
ColorTable readColorTable(const std::string& text, const std::string& name, const std::string& column);

/// Returns the look with its missing tables read. @throws Error
RepresentationOptions withTables(RepresentationOptions look);

}  // namespace nacre::app
