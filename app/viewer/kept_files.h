#pragma once
// What a shell keeps from one run to the next: the last view and what the driver compiled. A file that cannot be read,
// or is not whole, counts as absent; one that cannot be written is not missed. An empty path names no file.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/saved_view.h"

namespace nacre::app {

std::optional<PictureDescription> loadView(const std::string& path);
/// Makes the folder where it is missing.
void keepView(const std::string& path, const PictureDescription& view);

/// Any other text.
void keepText(const std::string& path, const std::string& text);

std::vector<std::byte> loadPipelineCache(const std::string& path);
void keepPipelineCache(const std::string& path, const std::vector<std::byte>& data);

}  // namespace nacre::app
