#pragma once

#include <optional>
#include <string>

namespace nacre::app {

/// Value of an environment variable; empty if it is not set.
std::string environmentVariable(const char* name);

/// A folder of recreatable files. Empty: no cache.
/// @param name   of the folder in the cache: "downloads", "occlusion"
/// @param asked  the user's choice ("off": none); if empty, NACRE_CACHE (a folder, or "off"), else
/// $XDG_CACHE_HOME/nacre, else ~/.cache/nacre, or none if that is not writable
/// @throws Error if a folder named by the user is not writable
std::string cacheFolder(const std::optional<std::string>& asked, const std::string& name);

}  // namespace nacre::app
