#pragma once
// Structures from public databases: from the cache if they are there, else over the network and into the cache.

#include <functional>
#include <string>

#include "app/download/database_id.h"
#include "app/download/http.h"

namespace nacre::app {

struct DownloadSettings {
    std::string cacheFolder;  ///< empty: nothing is kept, and what breaks off starts anew
    bool offline = false;     ///< the cache alone
    bool verbose = false;     ///< errors tell what each address answered
    HttpLimits limits;
    Environment environment = environmentVariable;
    /// Called as bytes arrive, with the share of the file that is there if its size is known, 0..1.
    std::function<void(double)> onProgress;
    /// Called with what the molecule was read from: its name, its bytes, and its format.
    std::function<void(const std::string&, std::string, Format)> onContent;
};

/// Most bytes of structures that are kept.
constexpr std::uint64_t kDownloadCacheBytes = 1000ull << 20;

/// The limits that the environment sets: NACRE_DOWNLOAD_TIMEOUT (seconds), NACRE_CA_FILE (PEM). @throws Error
HttpLimits httpLimits(const Environment& environment = environmentVariable);

/// What can be read is kept; what cannot is an error, and nothing of it stays. Once kept it is never asked for again.
/// @throws Error  with what each place said, in one line
Molecule downloadMolecule(const DatabaseId& id, const ReadOptions& options, const DownloadSettings& settings);

/// A file of another kind, kept likewise. @param input  as the user wrote it, for messages
/// @param read  gets where it comes from, and its bytes; what it throws is why they are not kept
void downloadFile(const std::string& input, const std::string& cacheName, const std::string& url,
                  const DownloadSettings& settings,
                  const std::function<void(const std::string&, std::string)>& read);

}  // namespace nacre::app
