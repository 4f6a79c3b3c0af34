#pragma once
// httplib's server with bounds that it lacks: a request has a deadline as a whole, not one per read, and a head has a
// size. A client that sends a byte now and then, or reads one, is dropped.

#include <httplib.h>

#include <atomic>

namespace nacre::app {

/// Times of a client, in seconds.
struct ClientTimes {
    int head = 10;    ///< to send the head of a request, and what a body or an answer may take in any case
    int idle = 15;    ///< between two requests
    int crowded = 1;  ///< instead of both waits for a first byte, while all connections are taken
};
/// Bodies and answers that take longer than ClientTimes::head go at this rate on average, in bytes per second.
constexpr std::size_t kLeastRate = std::size_t{64} << 10;
constexpr std::size_t kMostHeadBytes = std::size_t{64} << 10;

class HttpServer : public httplib::Server {
public:
    /// @param connections  that are served at the same time; others wait until one is free
    explicit HttpServer(std::size_t connections, ClientTimes times = {});
    /// Once it is bound: connections that the system holds until they are accepted; httplib asks for five.
    void holdConnections(int most) { ::listen(svr_sock_, most); }

private:
    bool process_and_close_socket(socket_t socket) override;
    bool awaitRequest(class ClientStream& stream, bool first) const;

    const std::size_t most_;
    const ClientTimes times_;
    std::atomic<std::size_t> served_{0};
};

}  // namespace nacre::app
