#include "app/movie/write_movie.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/threads.h"

namespace nacre::app {
namespace {

/// Writes a movie's frames while the next ones are drawn.
class MovieEncoder {
public:
    /// @param file  outlives this; exclusive to this until finish()
    explicit MovieEncoder(MovieFile& file) : file_(file), thread_(startThread([this] { run(); })) {}
    /// Discards unwritten frames.
    ~MovieEncoder() {
        {
            const std::lock_guard lock(mutex_);
            dropped_ = true;
        }
        join();
    }
    MovieEncoder(const MovieEncoder&) = delete;
    MovieEncoder& operator=(const MovieEncoder&) = delete;

    /// Adds a frame; waits while kMostWaiting are unwritten. @throws Error from writing
    void add(Picture picture) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting || failure_; });
        if (failure_) std::rethrow_exception(failure_);
        waiting_.push_back(std::move(picture));
        changed_.notify_all();
    }
    /// Waits for the last frame and moves the movie to its place. @throws Error
    void finish() {
        join();
        if (failure_) std::rethrow_exception(failure_);
        file_.finish();
    }

private:
    static constexpr std::size_t kMostWaiting = 3;

    void join() {
        {
            const std::lock_guard lock(mutex_);
            ending_ = true;
        }
        changed_.notify_all();
        if (thread_.joinable()) thread_.join();
    }

    void run() {
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

    MovieFile& file_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Picture> waiting_;
    bool ending_ = false, dropped_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace

std::uint64_t writeMovie(MovieFile& file, const MovieFrames& frames) {
    const std::uint64_t samples = std::min<std::uint64_t>(6, frames.count);  // for the palette
    if (file.wantsSamples())
        for (std::uint64_t i = 0; i < samples && frames.goesOn(MovieStage::palette, 0); ++i)
            file.sample(frames.draw(i * frames.count / samples));
    MovieEncoder encoder(file);
    std::uint64_t drawn = 0;
    for (; frames.goesOn(MovieStage::frames, drawn) && drawn < frames.count; ++drawn) encoder.add(frames.draw(drawn));
    if (drawn == 0) return 0;
    frames.goesOn(MovieStage::writing, drawn);
    encoder.finish();
    return drawn;
}

}  // namespace nacre::app
