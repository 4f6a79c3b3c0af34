#pragma once
// HTTP by the app's host system, where there is no libcurl: replaces http.cpp.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace nacre::app {

/// Receives bytes; the number received, including those held back; and the total (0: unknown). An exception ends the
/// transfer.
using HttpTake = std::function<void(std::string_view bytes, std::uint64_t come, std::uint64_t all)>;
/// Downloads from an address. @throws HttpFailure
using HttpFetch = std::function<void(const std::string& url, const HttpTake& take)>;

/// Process-wide; the last one set by any owner is used. Thread-safe.
/// @param fetch  empty: removes this owner's
void setHttpFetch(HttpFetch fetch, const void* owner = nullptr);

}  // namespace nacre::app
