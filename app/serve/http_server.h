#pragma once
// httplib's server with bounds that it lacks. One thread, the gate, waits for all heads: a connection takes another
// thread once its request's head is there, and a client that sends a byte now and then takes none. A request has a
// deadline as a whole, not one per read, and a head has a size.

#include <httplib.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
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
    int head = 10;   ///< to send the head of a request, and what a body or an answer may take in any case
    int idle = 15;   ///< between two requests
    int linger = 1;  ///< to stop sending after the last answer
};

class HttpServer : public httplib::Server {
public:
    /// @param requests  that are read and answered at the same time @param connections  that wait; the one that has
    /// waited longest makes room for another
    HttpServer(std::size_t requests, std::size_t connections, ClientTimes times = {});
    ~HttpServer() override;

    /// Requests for this path are answered by the gate itself: its handler takes no time.
    void answerAtGate(std::string path) { atGate_.push_back(std::move(path)); }

    /// Once it is bound: serves until stop(), and finishes what has been received. @throws Error if there is no thread
    void serve();
    /// From any thread.
    void stop();

private:
    struct Connection {
        std::unique_ptr<ClientStream> stream;
        Clock::time_point since = Clock::now();  ///< it waits
        std::size_t requests = 0;                ///< answered
        enum class State { idle, head, ending } state = State::head;
    };
    using Connections = std::list<Connection>;

    // By the gate.
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

    std::mutex turn_;  // of all below
    std::condition_variable ready_;
    std::deque<Connection> heads_;  ///< whose requests no thread has yet
    std::deque<Connection> back_;   ///< for the gate again
    std::vector<std::thread> threads_;
    std::size_t idleThreads_ = 0;
    bool closed_ = false;  ///< no more heads come
};

}  // namespace nacre::app
