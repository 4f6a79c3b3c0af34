#pragma once
// What the desktop keeps from one run to the next: the last view and what the driver compiled. A file that cannot be
// read, or is not whole, counts as absent; one that cannot be written is not missed.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/saved_view.h"

namespace nacre::app {

/// $XDG_STATE_HOME/nacre/view.json, by default ~/.local/state/nacre/view.json
std::optional<SavedView> loadState();
void saveState(const SavedView& view);

/// $XDG_CACHE_HOME/nacre/pipelines.bin, by default ~/.cache/nacre/pipelines.bin
std::vector<std::byte> loadPipelineCache();
void savePipelineCache(const std::vector<std::byte>& data);

/// A name in the current folder that no file has yet: "1bna.png", "1bna-2.png", ...
std::string freeName(const std::string& input, const std::string& extension);

}  // namespace nacre::app
