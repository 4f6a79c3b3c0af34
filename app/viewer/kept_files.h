#pragma once
// Files that a shell keeps between runs: the last view and compiled pipelines. Unreadable or incomplete files count as
// absent; write failures are ignored. An empty path means no file.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/saved_view.h"

namespace nacre::app {

std::optional<PictureDescription> loadView(const std::string& path);
/// Creates the folder if missing.
void keepView(const std::string& path, const PictureDescription& view);

/// Any other text.
void keepText(const std::string& path, const std::string& text);

std::vector<std::byte> loadPipelineCache(const std::string& path);
void keepPipelineCache(const std::string& path, const std::vector<std::byte>& data);

}  // namespace nacre::app
