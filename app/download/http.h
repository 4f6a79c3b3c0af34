#pragma once
// One HTTP transfer, by libcurl.

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace nacre::app {

struct HttpLimits {
    std::uint64_t maxBytes = 512ull << 20;  ///< of the whole file
    std::chrono::seconds patience{30};      ///< to connect, and with less than slowest bytes a second
    long slowestBytesPerSecond = 100;       ///< on average over `patience`
    long redirects = 5;                     ///< followed one after the other; https stays https, http stays http
    std::string certificates;               ///< file of trusted certificates (PEM) instead of the system's
};

/// Receives a body, and holds what an earlier transfer that broke off has left of it.
class HttpBody {
public:
    HttpBody() = default;
    HttpBody(const HttpBody&) = delete;
    HttpBody& operator=(const HttpBody&) = delete;
    virtual ~HttpBody() = default;

    virtual std::uint64_t size() const = 0;
    /// What names the version that `size()` bytes are there of: an ETag or a date. Empty: they cannot be gone on with.
    virtual std::string validator() const = 0;
    /// Forgets what is there; the bytes of this version follow. @throws Error
    virtual void restart(const std::string& validator) = 0;
    /// @throws Error
    virtual void append(std::string_view bytes) = 0;
};

/// Why a transfer failed, in words; none of them names the address.
struct HttpFailure : std::runtime_error {
    HttpFailure(const std::string& why, bool lostOnTheWay) : std::runtime_error(why), brokeOff(lostOnTheWay) {}
    bool brokeOff;  ///< the connection was lost on the way: to go on where it ended may help
};

/// Gets an address into a body, from where the body ends. @param onProgress bytes there, and in all (0: not known)
/// @throws HttpFailure; Error where the body does
void httpGet(const std::string& url, const HttpLimits& limits, HttpBody& body,
             const std::function<void(std::uint64_t, std::uint64_t)>& onProgress);

}  // namespace nacre::app
