#pragma once
// HTTP by the system that the app runs on, where there is no libcurl: instead of http.cpp.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace nacre::app {

/// Is given bytes as they come; how many have come, should some be held back until later; and how many there are in all
/// (0: not known). What it throws ends the transfer.
using HttpTake = std::function<void(std::string_view bytes, std::uint64_t come, std::uint64_t all)>;
/// Gets an address. @throws HttpFailure
using HttpFetch = std::function<void(const std::string& url, const HttpTake& take)>;

/// Of the whole program: the one that was set last, of the owners that have one. For any thread.
/// @param fetch  empty: this owner has none any more
void setHttpFetch(HttpFetch fetch, const void* owner = nullptr);

}  // namespace nacre::app
