#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/download/database_id.h"
#include "app/picture/description.h"

namespace nacre::app {

/// Addresses of `emdb:3001`, `pdb-map:3nzd` (2Fo-Fc) and `pdb-diff:3nzd` (Fo-Fc). NACRE_EMDB_URL, NACRE_EMDB_API_URL
/// and NACRE_PDB_MAP_URL replace their first parts.
struct MapSource {
    std::string cacheName, url;
    std::string levelUrl;  ///< JSON about an EMDB entry's map; empty: none
};
/// Empty if the text names no such database; then it is a file. @throws Error if the identifier is invalid
std::optional<MapSource> findMapSource(const std::string& name, const Environment& environment = environmentVariable);

/// Downloads the maps that a picture names, as loadMolecule() does for its molecule, and keeps them (map_input.h).
/// Local files are read when they are drawn. @throws Error
void loadMaps(const PictureDescription& picture, const std::function<void(double)>& onDownload = {});

}  // namespace nacre::app
