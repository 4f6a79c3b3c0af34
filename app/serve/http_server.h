#pragma once
// httplib's server with limits that it lacks. One thread, the gate, waits for all heads: a connection gets another
// thread once its request's head is complete, so that slow clients occupy none. A request has one deadline as a whole,
// not one per read, and its head has a maximum size.

#include <httplib.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/serve/client_stream.h"
#include "engine/milliseconds.h"

namespace nacre::app {

/// Times of a client, in seconds.
struct ClientTimes {
    int head = 10;   ///< to send a request's head; also the minimum time for a body or an answer
    int idle = 15;   ///< between two requests
    int linger = 1;  ///< to stop sending after the last answer
};

class HttpServer : public httplib::Server {
public:
    /// @param requests  read and answered at the same time @param connections  waiting; when exceeded, the oldest is
    /// closed
    HttpServer(std::size_t requests, std::size_t connections, ClientTimes times = {});
    ~HttpServer() override;

    /// The gate itself answers requests for this path: its handler must be fast.
    void answerAtGate(std::string path) { atGate_.push_back(std::move(path)); }

    /// Serves until stop(), and finishes received requests. Call after binding. @throws Error if there is no thread
    void serve();
    /// Thread-safe.
    void stop();

private:
    struct Connection {
        std::unique_ptr<ClientStream> stream;
        Clock::time_point since = Clock::now();  ///< start of waiting
        std::size_t requests = 0;                ///< answered
        enum class State { idle, head, ending } state = State::head;
    };
    using Connections = std::list<Connection>;

    // Called by the gate.
    void accept();
    void look(Connections::iterator connection);
    void dropLate();
    void takeBack();
    bool isForGate(std::string_view head) const;

    /// @returns whether another request may follow
    bool answer(Connection& connection, bool waits);
    void hand(Connection connection);
    void work();
    void wake() const;

    const std::size_t mostRequests_, mostConnections_;
    const ClientTimes times_;
    std::vector<std::string> atGate_;
    Connections waiting_;
    int wake_[2] = {-1, -1};  ///< a pipe
    std::atomic<bool> stopping_{false};

    std::mutex turn_;  // guards the following
    std::condition_variable ready_;
    std::deque<Connection> heads_;  ///< their requests wait for a thread
    std::deque<Connection> back_;   ///< return to the gate
    std::vector<std::thread> threads_;
    std::size_t idleThreads_ = 0;
    bool closed_ = false;  ///< no more heads follow
};

}  // namespace nacre::app
