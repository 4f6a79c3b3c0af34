#include "app/viewer/file_kind.h"

#include <algorithm>

#include "app/picture/saved_view.h"
#include "engine/molecule/read.h"
#include "engine/molecule/text.h"
#include "engine/molecule/trajectory/trajectory.h"
#include "engine/volume/read_map.h"

namespace nacre::app {
namespace {

bool endsWithAny(const std::string& name, std::initializer_list<const char*> endings) {
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return name.ends_with(ending); });
}

bool isSceneName(const std::string& name) { return endsWithAny(name, {".mvsj", ".mvsx"}); }

}  // namespace

FileKind detectKind(const std::string& path) {
    if (isSceneName(lowerCase(path))) return FileKind::scene;
    if (isViewFile(path)) return FileKind::view;
    if (isTrajectoryFile(path)) return FileKind::trajectory;
    return isMapFile(path) ? FileKind::map : FileKind::structure;
}

bool mayOpen(const std::string& name) {
    const std::string lower = lowerCase(name);
    return isSceneName(lower) || formatOfFileName(name) ||
           endsWithAny(lower, {".json", ".dcd", ".xtc", ".trr", ".nc", ".ncdf", ".netcdf", ".h5", ".h5md", ".ccp4",
                               ".mrc", ".mrcs", ".map", ".map.gz", ".dsn6", ".omap", ".brix", ".dx", ".cube"});
}

}  // namespace nacre::app
