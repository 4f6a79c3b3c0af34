#pragma once
// Kinds of files that a window opens.

#include <string>

namespace nacre::app {

enum class FileKind {
    structure,   ///< also a download, a sample, and what no other kind is
    scene,       ///< MolViewSpec
    map,         ///< a density map
    trajectory,  ///< positions alone
    view         ///< a saved view, or a look
};
/// By its content; a scene by its name.
FileKind kindOf(const std::string& path);

/// Whether a file list shows it: its name is one of a file that can be opened.
bool mayOpen(const std::string& name);

}  // namespace nacre::app
