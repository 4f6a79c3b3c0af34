#pragma once
// The one thread that viewer, panel and renderer live on. It runs what it is given and then takes a step, sleeps until
// the step said it is due again, and never otherwise.

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

    /// @param step   returns when to be called again, in seconds of steadySeconds(); infinity: after the next task
    /// @param await  called when something is to be done, before it is looked up: input that comes meanwhile is taken
    /// @param failed called on the thread with what a task or step threw; nothing is run after that
    RenderThread(std::function<void()> await, std::function<double()> step, std::function<void(const char*)> failed);
    /// Runs what was posted and ends.
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;

    /// From any thread.
    void post(Task task);
    /// The same, and waits until it ran and the step after it was taken, but no longer than `seconds`.
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

/// Seconds that the main thread waits for the render thread, all waits from a pause to the end together: Android calls
/// an app dead whose main thread is not back after 5. Tests on busy machines have more.
inline double mainThreadPatience = 3;

}  // namespace nacre::app
