#include "app/serve/http_server.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "engine/milliseconds.h"

namespace nacre::app {
namespace {

constexpr std::size_t kRequests = 1000;                    // of a connection
constexpr std::size_t kMostRead = std::size_t{128} << 20;  // bytes of a body, of which one that is too large is skipped
constexpr int kSliceMs = 250;                              // after which a wait looks whether the server stops

}  // namespace

/// A connection, read and written within the deadlines of the request that it is at.
class ClientStream final : public httplib::Stream {
public:
    ClientStream(socket_t socket, int seconds) : socket_(socket), seconds_(seconds) {}
    ~ClientStream() override { ::close(socket_); }
    ClientStream(const ClientStream&) = delete;

    /// The next request begins.
    void begin() {
        start_ = Clock::now();
        received_ = sent_ = 0;
        headRead_ = false;
        expected_ = 0;
    }

    /// The request's head was read.
    void takeHead(httplib::Request& request) {
        request.ranges.clear();  // pictures are sent whole; many ranges of one would take its size many times
        headRead_ = true;
        start_ = Clock::now();
        received_ = 0;
        const std::string length = request.get_header_value("Content-Length");
        expected_ = std::strtoull(length.c_str(), nullptr, 10);
        // Where a body in chunks ends only its reader knows.
        if (request.has_header("Transfer-Encoding")) expected_ = ~std::size_t{0};
    }

    /// Whether all of the request was read, so that another one may follow.
    bool isThrough() const { return headRead_ && received_ >= expected_; }

    /// @returns whether bytes are there, or the other end is gone
    bool hasBytes(int milliseconds) const { return first_ < last_ || wait(POLLIN, milliseconds); }

    /// The client learns that nothing more comes. What it still sends is read for a moment: a reset would take the
    /// answer away from it.
    void end() {
        ::shutdown(socket_, SHUT_WR);
        constexpr int kReads = 64, kLingerMs = 500;
        for (int i = 0; i < kReads && !isThrough() && wait(POLLIN, kLingerMs); ++i)
            if (::recv(socket_, buffer_.data(), buffer_.size(), MSG_DONTWAIT) <= 0) return;
    }

    ssize_t read(char* to, std::size_t size) override {
        if (first_ == last_ && !fill()) return -1;
        const std::size_t taken = std::min(size, last_ - first_);
        std::memcpy(to, buffer_.data() + first_, taken);
        first_ += taken;
        received_ += taken;
        sent_ = 0;  // after "100 Continue" the answer is still to come
        // httplib reads lines byte by byte, into a buffer that grows.
        line_ = size == 1 && *to != '\n' ? line_ + 1 : 0;
        if (line_ > kMostHeadBytes) return -1;
        return static_cast<ssize_t>(taken);
    }

    ssize_t write(const char* from, std::size_t size) override {
        if (sent_ == 0) start_ = Clock::now();
        for (;;) {
            const ssize_t sent = ::send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
            if (sent >= 0) {
                sent_ += static_cast<std::size_t>(sent);
                return sent;
            }
            if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) return -1;
            if (!wait(POLLOUT, left(sent_))) return -1;
        }
    }

    bool is_readable() const override { return hasBytes(0); }
    bool is_writable() const override { return wait(POLLOUT, 0); }
    // Nobody is told who asks.
    void get_remote_ip_and_port(std::string& ip, int& port) const override { ip.clear(), port = 0; }
    void get_local_ip_and_port(std::string& ip, int& port) const override { ip.clear(), port = 0; }
    socket_t socket() const override { return socket_; }

private:
    bool wait(short events, int milliseconds) const {
        pollfd one{socket_, events, 0};
        int ready = 0;
        do ready = ::poll(&one, 1, std::max(milliseconds, 0));
        while (ready < 0 && errno == EINTR);
        return ready > 0;
    }

    /// Milliseconds until the deadline of what has moved so many bytes.
    int left(std::size_t moved) const {
        const double most = 1000.0 * (seconds_ + static_cast<double>(moved) / static_cast<double>(kLeastRate));
        return static_cast<int>(std::clamp(most - millisecondsSince(start_), 0.0, 3.6e6));
    }

    bool fill() {
        if (received_ >= (headRead_ ? kMostRead : kMostHeadBytes)) return false;
        if (!wait(POLLIN, left(headRead_ ? received_ : 0))) return false;
        const ssize_t got = ::recv(socket_, buffer_.data(), buffer_.size(), MSG_DONTWAIT);
        first_ = 0;
        last_ = got > 0 ? static_cast<std::size_t>(got) : 0;
        return got > 0;
    }

    const socket_t socket_;
    const int seconds_;
    Clock::time_point start_ = Clock::now();
    bool headRead_ = false;
    std::size_t received_ = 0, sent_ = 0, expected_ = 0;
    std::size_t line_ = 0;  // bytes of the line that is being read
    std::array<char, 16384> buffer_{};
    std::size_t first_ = 0, last_ = 0;
};

HttpServer::HttpServer(std::size_t connections, ClientTimes times) : most_(connections), times_(times) {
    new_task_queue = [connections] { return new httplib::ThreadPool(connections); };
    set_keep_alive_timeout(times.idle);  // as the answers tell
    set_keep_alive_max_count(kRequests);
}

bool HttpServer::awaitRequest(ClientStream& stream, bool first) const {
    const Clock::time_point start = Clock::now();
    while (!stream.hasBytes(kSliceMs)) {
        const bool crowded = served_ >= most_;
        const int seconds = crowded ? times_.crowded : first ? times_.head : times_.idle;
        if (svr_sock_ == INVALID_SOCKET || millisecondsSince(start) >= 1000.0 * seconds) return false;
    }
    return true;
}

bool HttpServer::process_and_close_socket(socket_t socket) {
    ++served_;
    {
        ClientStream stream(socket, times_.head);
        for (std::size_t left = kRequests; left > 0 && awaitRequest(stream, left == kRequests); --left) {
            bool closed = false;
            stream.begin();
            const bool last = left == 1 || svr_sock_ == INVALID_SOCKET;
            const auto taken = [&](httplib::Request& request) { stream.takeHead(request); };
            if (!process_request(stream, last, closed, taken) || closed || last || !stream.isThrough()) break;
        }
        stream.end();
    }
    --served_;
    return true;
}

}  // namespace nacre::app
