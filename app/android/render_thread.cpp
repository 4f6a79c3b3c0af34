#include "app/android/render_thread.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace nacre::app {

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

RenderThread::RenderThread(std::function<void()> await, std::function<double()> step,
                           std::function<void(const char*)> failed)
    : await_(std::move(await)), step_(std::move(step)), failed_(std::move(failed)), thread_([this] { run(); }) {}

RenderThread::~RenderThread() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void RenderThread::post(Task task) {
    {
        const std::lock_guard lock(mutex_);
        tasks_.push_back(std::move(task));
        ++posted_;
    }
    changed_.notify_one();
}

bool RenderThread::call(Task task, double seconds) {
    std::unique_lock lock(mutex_);
    tasks_.push_back(std::move(task));
    const std::uint64_t mine = ++posted_;
    changed_.notify_one();
    stepped_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return done_ >= mine; });
    return done_ >= mine;
}

void RenderThread::run() {
    double due = std::numeric_limits<double>::infinity();
    std::unique_lock lock(mutex_);
    for (;;) {
        const auto called = [&] { return !tasks_.empty() || ends_; };
        if (std::isinf(due))
            changed_.wait(lock, called);
        else
            changed_.wait_for(lock, std::chrono::duration<double>(due - steadySeconds()), called);
        if (ends_ && tasks_.empty()) return;
        if (!broken_) {
            lock.unlock();
            await_();
            lock.lock();
        }
        std::vector<Task> tasks = std::exchange(tasks_, {});
        const std::uint64_t count = tasks.size();
        lock.unlock();
        if (!broken_) {
            try {
                for (const Task& task : tasks) task();
                due = step_();
            } catch (const std::exception& error) {
                broken_ = true;
                due = std::numeric_limits<double>::infinity();
                failed_(error.what());
            }
        }
        tasks.clear();
        lock.lock();
        done_ += count;
        stepped_.notify_all();
    }
}

}  // namespace nacre::app
