#include "app/serve/http_server.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <new>

#include "engine/error.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

constexpr std::size_t kRequests = 1000;  // per connection
constexpr int kSliceMs = 250;            // interval of deadline checks

double secondsSince(Clock::time_point start) { return millisecondsSince(start) / 1000; }

}  // namespace

HttpServer::HttpServer(std::size_t requests, std::size_t connections, ClientTimes times)
    : mostRequests_(requests), mostConnections_(connections), times_(times) {
    set_keep_alive_timeout(times.idle);  // announced in answers
    set_keep_alive_max_count(kRequests);
    if (pipe(wake_) != 0) throw Error("cannot serve", "", "no pipe can be opened");
    for (const int end : wake_) {
        fcntl(end, F_SETFD, FD_CLOEXEC);
        fcntl(end, F_SETFL, O_NONBLOCK);
    }
}

HttpServer::~HttpServer() {
    for (const int end : wake_) ::close(end);
    if (svr_sock_ != INVALID_SOCKET) ::close(svr_sock_);
    svr_sock_ = INVALID_SOCKET;
}

void HttpServer::wake() const {
    const char byte = 0;
    [[maybe_unused]] const ssize_t written = ::write(wake_[1], &byte, 1);  // a full pipe also wakes the gate
}

void HttpServer::stop() {
    stopping_ = true;
    wake();
}

void HttpServer::serve() {
    threads_.reserve(mostRequests_);
    threads_.push_back(startThread([this] { work(); }));
    constexpr int kBacklog = 1024;
    ::listen(svr_sock_, kBacklog);
    fcntl(svr_sock_, F_SETFL, O_NONBLOCK);  // a client that disconnects before accept() must not block it
    std::vector<pollfd> polled;
    std::vector<Connections::iterator> order;
    while (!stopping_) {
        polled.assign({{svr_sock_, POLLIN, 0}, {wake_[0], POLLIN, 0}});
        order.clear();
        for (auto at = waiting_.begin(); at != waiting_.end(); ++at) {
            polled.push_back({at->stream->socket(), POLLIN, 0});
            order.push_back(at);
        }
        if (::poll(polled.data(), polled.size(), kSliceMs) > 0) {
            for (std::size_t i = 0; i < order.size(); ++i)
                if (polled[i + 2].revents != 0) look(order[i]);
            if (polled[0].revents != 0) accept();
            if (polled[1].revents != 0) takeBack();
        }
        dropLate();
    }
    ::close(svr_sock_);
    svr_sock_ = INVALID_SOCKET;
    waiting_.clear();
    {
        const std::lock_guard lock(turn_);
        closed_ = true;
    }
    ready_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    back_.clear();
}

void HttpServer::accept() {
    constexpr int kAtOnce = 64;
    for (int i = 0; i < kAtOnce; ++i) {
        pollfd more{svr_sock_, POLLIN, 0};
        if (i > 0 && ::poll(&more, 1, 0) <= 0) return;
        const socket_t socket = ::accept(svr_sock_, nullptr, nullptr);
        if (socket == INVALID_SOCKET) {
            // Without free descriptors, closes the oldest connection.
            if ((errno == EMFILE || errno == ENFILE) && !waiting_.empty()) waiting_.pop_front();
            return;
        }
        fcntl(socket, F_SETFD, FD_CLOEXEC);
        const int yes = 1;
        setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        if (waiting_.size() >= mostConnections_) waiting_.pop_front();
        Connection connection;
        connection.stream = std::make_unique<ClientStream>(socket, times_.head);
        waiting_.push_back(std::move(connection));
        look(std::prev(waiting_.end()));
    }
}

/// Handles a connection that is readable.
void HttpServer::look(Connections::iterator at) {
    if (at->state == Connection::State::ending) {
        if (!at->stream->skip()) waiting_.erase(at);
        return;
    }
    const ClientStream::Head head = at->stream->readHead();
    if (head == ClientStream::Head::missing) {
        waiting_.erase(at);
        return;
    }
    if (head == ClientStream::Head::partial) {
        if (at->state == Connection::State::idle && !at->stream->ahead().empty()) {
            at->state = Connection::State::head;
            at->since = Clock::now();
        }
        return;
    }
    Connection connection = std::move(*at);
    waiting_.erase(at);
    if (!isForGate(connection.stream->ahead())) return hand(std::move(connection));
    const bool more = answer(connection, false);
    connection.since = Clock::now();
    connection.state = more ? Connection::State::idle : Connection::State::ending;
    if (!more) connection.stream->end();
    waiting_.push_back(std::move(connection));
}

/// Only if nothing follows the head: otherwise answers might have to wait for the client to read them.
bool HttpServer::isForGate(std::string_view head) const {
    if (head.find("\r\n\r\n") + 4 != head.size()) return false;
    for (const std::string_view method : {"GET ", "HEAD "})
        if (head.starts_with(method))
            return std::ranges::any_of(
                atGate_, [&](const std::string& path) { return head.substr(method.size()).starts_with(path + " "); });
    return false;
}

void HttpServer::dropLate() {
    for (auto at = waiting_.begin(); at != waiting_.end();) {
        const int most = at->state == Connection::State::idle   ? times_.idle
                         : at->state == Connection::State::head ? times_.head
                                                                : times_.linger;
        at = secondsSince(at->since) > most ? waiting_.erase(at) : std::next(at);
    }
}

void HttpServer::takeBack() {
    char bytes[64];
    while (::read(wake_[0], bytes, sizeof bytes) > 0) {
    }
    std::deque<Connection> back;
    {
        const std::lock_guard lock(turn_);
        back.swap(back_);
    }
    for (Connection& connection : back) {
        connection.since = Clock::now();
        waiting_.push_back(std::move(connection));
        look(std::prev(waiting_.end()));  // it may already have sent another request
    }
}

bool HttpServer::answer(Connection& connection, bool waits) {
    ClientStream& stream = *connection.stream;
    const bool last = ++connection.requests >= kRequests || stopping_;
    bool closed = false;
    stream.begin(waits);
    const auto taken = [&](httplib::Request& request) { stream.takeHead(request); };
    try {
        return process_request(stream, last, closed, taken) && !closed && !last && stream.isThrough();
    } catch (const std::bad_alloc&) {
        return false;  // there is no memory for an answer either
    }
}

void HttpServer::hand(Connection connection) {
    bool starts = false;
    {
        const std::lock_guard lock(turn_);
        heads_.push_back(std::move(connection));
        starts = heads_.size() > idleThreads_ && threads_.size() < mostRequests_;
    }
    ready_.notify_one();
    if (std::thread thread; starts && mayStart(thread, [this] { work(); })) threads_.push_back(std::move(thread));
}

void HttpServer::work() {
    std::unique_lock lock(turn_);
    for (;;) {
        ++idleThreads_;
        ready_.wait(lock, [&] { return closed_ || !heads_.empty(); });
        --idleThreads_;
        if (heads_.empty()) return;
        Connection connection = std::move(heads_.front());
        heads_.pop_front();
        lock.unlock();
        const bool more = answer(connection, true);
        connection.state = more ? Connection::State::idle : Connection::State::ending;
        if (!more) connection.stream->end();
        lock.lock();
        back_.push_back(std::move(connection));
        wake();
    }
}

}  // namespace nacre::app
