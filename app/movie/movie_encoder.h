#pragma once
// Writes a movie's frames while the next ones are drawn.

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include "app/movie/movie_file.h"

namespace nacre::app {

class MovieEncoder {
public:
    /// @param file  outlives this; exclusive to this until finish()
    explicit MovieEncoder(MovieFile& file);
    /// Discards unwritten frames.
    ~MovieEncoder();
    MovieEncoder(const MovieEncoder&) = delete;
    MovieEncoder& operator=(const MovieEncoder&) = delete;

    /// Adds a frame; waits while kMostWaiting are unwritten. @throws Error from writing
    void add(Picture picture);
    /// Waits for the last frame and moves the movie to its place. @throws Error
    void finish();

    static constexpr std::size_t kMostWaiting = 3;

private:
    void run();
    void join();

    MovieFile& file_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Picture> waiting_;
    bool ending_ = false, dropped_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace nacre::app
