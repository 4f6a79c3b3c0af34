#pragma once
// Tables of colours or values of residues and atoms: CSV or JSON (docs/geometry.md).

#include <string>

#include "engine/scene/appearance.h"
#include "engine/scene/color_table.h"

namespace nacre::app {

/// @param name  of the file, for errors @param column  of the values; empty: the only one that is none of the known
/// @throws Error with the line, or the row of JSON
ColorTable readColorTable(const std::string& text, const std::string& name, const std::string& column);

/// The same look, its tables read that are not there yet. @throws Error
RepresentationOptions withTables(RepresentationOptions look);

}  // namespace nacre::app
