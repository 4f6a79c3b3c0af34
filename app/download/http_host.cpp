#include "app/download/http_host.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include "app/download/http.h"

namespace nacre::app {
namespace {

std::mutex fetchMutex;
std::vector<std::pair<const void*, HttpFetch>> fetches;  // most recent last

}  // namespace

void setHttpFetch(HttpFetch fetch, const void* owner) {
    const std::lock_guard lock(fetchMutex);
    std::erase_if(fetches, [&](const auto& entry) { return entry.first == owner; });
    if (fetch) fetches.emplace_back(owner, std::move(fetch));
}

/// Interrupted transfers start again: host systems do not report versions.
void httpGet(const std::string& url, const HttpLimits& limits, HttpBody& body,
             const std::function<void(std::uint64_t, std::uint64_t)>& onProgress) {
    HttpFetch fetch;
    {
        const std::lock_guard lock(fetchMutex);
        if (!fetches.empty()) fetch = fetches.back().second;
    }
    if (!fetch) throw HttpFailure("no network available", false);
    body.restart("");
    fetch(url, [&](std::string_view bytes, std::uint64_t come, std::uint64_t all) {
        if (all > limits.maxBytes || body.size() + bytes.size() > limits.maxBytes)
            throw HttpFailure("it is larger than " + std::to_string(limits.maxBytes >> 20) + " MB", false);
        body.append(bytes);
        if (onProgress) onProgress(std::max(body.size(), come), all);
    });
}

}  // namespace nacre::app
