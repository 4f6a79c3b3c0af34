#pragma once
// HTTP by the host system of the app, where there is no libcurl: replaces http.cpp.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace nacre::app {

/// Receives bytes; the number received, including any held back; and the total (0: unknown). Its exception ends the
/// transfer.
using HttpTake = std::function<void(std::string_view bytes, std::uint64_t come, std::uint64_t all)>;
/// Downloads from an address. @throws HttpFailure
using HttpFetch = std::function<void(const std::string& url, const HttpTake& take)>;

/// Process-wide: of all owners that have one, the last set. Thread-safe.
/// @param fetch  empty: removes this owner's
void setHttpFetch(HttpFetch fetch, const void* owner = nullptr);

}  // namespace nacre::app
