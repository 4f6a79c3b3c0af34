#pragma once

#include <optional>
#include <string>

namespace nacre::app {

/// A folder of what can be made again. Empty: nothing is kept.
/// @param name   of the folder in the cache: "downloads", "occlusion"
/// @param asked  what the user named ("off": nowhere), or nothing: then NACRE_CACHE (a folder, or "off"), else
///               $XDG_CACHE_HOME/nacre, else ~/.cache/nacre, and nowhere if that cannot be written to
/// @throws Error if a folder that was named cannot be written to
std::string cacheFolder(const std::optional<std::string>& asked, const std::string& name);

}  // namespace nacre::app
