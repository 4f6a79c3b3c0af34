#pragma once
// Structures from public databases: from the cache if present, else over the network and into the cache.

#include <functional>
#include <string>

#include "app/download/database_id.h"
#include "app/download/http.h"

namespace nacre::app {

struct DownloadSettings {
    std::string cacheFolder;  ///< empty: no cache; interrupted downloads start again
    bool offline = false;     ///< use the cache only
    bool verbose = false;     ///< errors include the answer of each address
    HttpLimits limits;
    Environment environment = environmentVariable;
    /// Called as bytes arrive, with the share of the file if its size is known, 0..1.
    std::function<void(double)> onProgress;
    /// Called with the molecule's source: its name, its bytes, and its format.
    std::function<void(const std::string&, std::string, Format)> onContent;
};

/// Maximum size of the cache of structures.
constexpr std::uint64_t kDownloadCacheBytes = 1000ull << 20;

/// Limits from the environment: NACRE_DOWNLOAD_TIMEOUT (seconds), NACRE_CA_FILE (PEM). @throws Error
HttpLimits httpLimits(const Environment& environment = environmentVariable);

/// Caches a readable file; an unreadable one is an error and is not kept. A cached structure is never downloaded again.
/// @throws Error  with the answer of each address, in one line
Molecule downloadMolecule(const DatabaseId& id, const ReadOptions& options, const DownloadSettings& settings);

/// Another kind of file, cached in the same way. @param input  as the user wrote it, for messages
/// @param read  called with source and bytes; if it throws, the file is not cached
void downloadFile(const std::string& input, const std::string& cacheName, const std::string& url,
                  const DownloadSettings& settings, const std::function<void(const std::string&, std::string)>& read);

}  // namespace nacre::app
