#pragma once
// Drawing threads. Each has a canvas and keeps its last molecule and scene: a request that only changes the view costs
// one frame, and goes to the worker with its molecule if that is free.

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/serve/picture_request.h"
#include "app/serve/problem.h"
#include "engine/milliseconds.h"

namespace nacre::app {

/// A picture as sent.
struct ServedPicture {
    std::string bytes;
    std::vector<std::string> warnings;
    bool asAsked = true;  ///< no input changed between the request and its reading
};

/// The problem response for an unreadable input. @param place  its file or identifier
Problem unreadable(const std::exception& error, const std::string& place);

class Workers {
public:
    /// @param options  outlives this @throws Error if there is no device
    explicit Workers(const ServeOptions& options);
    /// Finishes pictures in progress; waiting requests get 503.
    ~Workers();
    Workers(const Workers&) = delete;

    /// Draws one picture. @throws Problem: 429 if too many wait, 503 if it takes too long or the device is lost, 404 or
    /// 422 for input that cannot be read or drawn
    /// @param newest  not empty: identifies the client. Its older waiting request gets 429
    ServedPicture draw(const PictureRequest& request, const std::string& newest = {});

    /// Work that calls `check` between its steps, which throws when nobody waits for the result any more.
    using Work = std::function<std::string(const std::function<void()>& check)>;
    /// Runs other work in its turn, within the same limits. @throws Problem as above
    std::string run(Work work);

    std::size_t waiting() const;
    /// Renderers created so far: one per worker, and another after a loss or when it holds too many pipelines.
    std::uint64_t devices() const { return devices_; }

private:
    struct Task {
        PictureRequest request;
        Work work;  ///< instead of the request
        std::string newest;
        std::promise<ServedPicture> promise;
        Clock::time_point deadline;  ///< when the client gives up
        bool given = false;          ///< the client gave up
    };
    class Worker;

    ServedPicture result(const std::shared_ptr<Task>& task);
    void work(Worker& worker);
    static ServedPicture done(Worker& worker, const Task& task);
    std::optional<std::size_t> choice(const Worker& worker) const;
    std::shared_ptr<Task> next(Worker& worker);

    const ServeOptions& options_;
    std::atomic<std::uint64_t> devices_{0};
    mutable std::mutex turn_;  // guards the following
    std::condition_variable wake_;
    std::deque<std::shared_ptr<Task>> tasks_;
    bool stopping_ = false;
    std::vector<std::unique_ptr<Worker>> workers_;
    std::vector<std::thread> threads_;
};

}  // namespace nacre::app
