#pragma once
// Kinds of files that a window opens.

#include <string>

namespace nacre::app {

enum class FileKind {
    structure,   ///< also a download, a sample, and any other input
    scene,       ///< MolViewSpec
    map,         ///< a density map
    trajectory,  ///< only positions
    view         ///< a saved view, or a look
};
/// By content; scenes by name.
FileKind detectKind(const std::string& path);

/// Whether a file list shows it: its name is that of a file that can be opened.
bool mayOpen(const std::string& name);

}  // namespace nacre::app
