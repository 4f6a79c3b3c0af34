#pragma once
// Locations of the desktop's last view and compiled pipelines, and names for saved files.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/saved_view.h"

namespace nacre::app {

/// $XDG_STATE_HOME/nacre/view.json, by default ~/.local/state/nacre/view.json
std::optional<PictureDescription> loadState();
void saveState(const PictureDescription& view);

/// $XDG_STATE_HOME/nacre/recent.json, by default ~/.local/state/nacre/recent.json; empty if there is no such folder
std::string recentPath();

/// $XDG_CACHE_HOME/nacre/pipelines.bin, by default ~/.cache/nacre/pipelines.bin
std::vector<std::byte> loadPipelineCache();
void savePipelineCache(const std::vector<std::byte>& data);

/// A name in the current folder that no file has yet: "1bna.png", "1bna-2.png", ...
std::string freeName(const std::string& input, const std::string& extension);

}  // namespace nacre::app
