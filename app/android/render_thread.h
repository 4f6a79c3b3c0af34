#pragma once
// The one thread of viewer, panel and renderer. It runs posted tasks and then a step, and sleeps until the next task or
// until the step is due again.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace nacre::app {

class RenderThread {
public:
    using Task = std::function<void()>;

    /// @param step   returns when to call it again, in steadySeconds(); infinity: after the next task
    /// @param await  called before pending tasks are fetched, so that input that arrives meanwhile is included
    /// @param failed called on the thread with the exception of a task or step; nothing runs after that
    RenderThread(std::function<void()> await, std::function<double()> step, std::function<void(const char*)> failed);
    /// Runs posted tasks and ends.
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;

    /// Thread-safe.
    void post(Task task);
    /// As post(), and waits for the task and the step after it, at most `seconds`.
    /// @returns whether it ran
    bool call(Task task, double seconds);

private:
    void run();

    std::function<void()> await_;
    std::function<double()> step_;
    std::function<void(const char*)> failed_;
    std::mutex mutex_;
    std::condition_variable changed_, stepped_;
    std::vector<Task> tasks_;
    std::uint64_t posted_ = 0, done_ = 0;  // tasks
    bool ends_ = false, broken_ = false;
    std::thread thread_;
};

double steadySeconds();

/// Total time, seconds, that the main thread waits for the render thread between a pause and the end: Android reports
/// an app as not responding after 5. Tests on busy machines use more.
inline double mainThreadPatience = 3;

}  // namespace nacre::app
