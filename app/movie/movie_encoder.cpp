#include "app/movie/movie_encoder.h"

#include <utility>

#include "engine/threads.h"

namespace nacre::app {

MovieEncoder::MovieEncoder(MovieFile& file) : file_(file), thread_(startThread([this] { run(); })) {}

MovieEncoder::~MovieEncoder() {
    {
        const std::lock_guard lock(mutex_);
        dropped_ = true;
    }
    join();
}

void MovieEncoder::add(Picture picture) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    waiting_.push_back(std::move(picture));
    changed_.notify_all();
}

void MovieEncoder::finish() {
    join();
    if (failure_) std::rethrow_exception(failure_);
    file_.finish();
}

void MovieEncoder::join() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void MovieEncoder::run() {
    try {
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            if (dropped_ || waiting_.empty()) return;
            const Picture picture = std::move(waiting_.front());
            waiting_.pop_front();
            changed_.notify_all();
            lock.unlock();
            file_.add(picture);
            lock.lock();
        }
    } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
        changed_.notify_all();
    }
}

}  // namespace nacre::app
