#pragma once
// A connection of the server, read and written within the deadlines of its request.

#include <httplib.h>
#include <poll.h>

#include <string>

#include "engine/milliseconds.h"

namespace nacre::app {

/// Least average rate of bodies and answers that take longer than ClientTimes::head, bytes per second.
constexpr std::size_t kLeastRate = std::size_t{64} << 10;
constexpr std::size_t kMostHeadBytes = std::size_t{64} << 10;

class ClientStream final : public httplib::Stream {
public:
    enum class Head {
        partial,
        whole,    ///< complete, or too long
        missing,  ///< the client disconnected
    };

    /// @param seconds  for a small body or answer
    ClientStream(socket_t socket, int seconds) : socket_(socket), seconds_(seconds) {}
    ~ClientStream() override;
    ClientStream(const ClientStream&) = delete;

    /// Reads available bytes of the next request's head, without waiting.
    Head readHead();
    /// Bytes read but not used.
    std::string_view ahead() const { return std::string_view(buffer_).substr(first_); }

    /// Begins the request whose head was read. @param waits  false: cancel an answer that the system does not accept at
    /// once
    void begin(bool waits);
    /// httplib received the head.
    void takeHead(httplib::Request& request);
    /// Whether the whole request was read, so that another one may follow.
    bool isThrough() const { return headTaken_ && received_ >= expected_; }

    /// Tells the client that nothing more follows. skip() then reads what it still sends: closing at once would reset
    /// the connection, and the client could lose the answer.
    void end();
    /// Drops available bytes, without waiting. @returns whether more may come
    bool skip();

    ssize_t read(char* to, std::size_t size) override;
    ssize_t write(const char* from, std::size_t size) override;
    bool is_readable() const override { return first_ < buffer_.size() || wait(POLLIN, 0); }
    bool is_writable() const override { return wait(POLLOUT, 0); }
    // Handlers do not learn the client's address.
    void get_remote_ip_and_port(std::string& ip, int& port) const override { ip.clear(), port = 0; }
    void get_local_ip_and_port(std::string& ip, int& port) const override { ip.clear(), port = 0; }
    socket_t socket() const override { return socket_; }

private:
    bool wait(short events, int milliseconds) const;
    int left(std::size_t moved) const;
    bool fill(bool waits);

    const socket_t socket_;
    const int seconds_;
    Clock::time_point start_ = Clock::now();
    bool headTaken_ = false, waits_ = true;
    std::size_t received_ = 0, sent_ = 0, expected_ = 0;
    std::size_t line_ = 0;  ///< bytes of the line being read
    std::string buffer_;
    std::size_t first_ = 0, searched_ = 0;  ///< bytes of buffer_ that were used, and that contain no end of a head
};

}  // namespace nacre::app
