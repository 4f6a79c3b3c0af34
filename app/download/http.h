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
    std::chrono::seconds patience{30};      ///< to connect, and for transfers slower than slowestBytesPerSecond
    long slowestBytesPerSecond = 100;       ///< on average over `patience`
    long redirects = 5;                     ///< maximum in sequence; https stays https, http stays http
    bool publicAlone = false;  ///< no loopback and no private address, except that of a proxy of the environment
    std::string certificates;  ///< file of trusted certificates (PEM) instead of the system's
};

/// Receives a body, and holds the bytes of an earlier, interrupted transfer.
class HttpBody {
public:
    HttpBody() = default;
    HttpBody(const HttpBody&) = delete;
    HttpBody& operator=(const HttpBody&) = delete;
    virtual ~HttpBody() = default;

    virtual std::uint64_t size() const = 0;
    /// Version (ETag or date) of the `size()` bytes present. Empty: they cannot be resumed.
    virtual std::string validator() const = 0;
    /// Drops the bytes present; bytes of this version follow. @throws Error
    virtual void restart(const std::string& validator) = 0;
    /// @throws Error
    virtual void append(std::string_view bytes) = 0;
};

/// Why a transfer failed, without the address.
struct HttpFailure : std::runtime_error {
    HttpFailure(const std::string& why, bool lostOnTheWay) : std::runtime_error(why), brokeOff(lostOnTheWay) {}
    bool brokeOff;  ///< the connection was lost: resuming may help
};

/// Downloads into a body, from the body's end on.
/// @param onProgress bytes present, and in total (0: unknown) @throws HttpFailure; Error from the body
void httpGet(const std::string& url, const HttpLimits& limits, HttpBody& body,
             const std::function<void(std::uint64_t, std::uint64_t)>& onProgress);

}  // namespace nacre::app
