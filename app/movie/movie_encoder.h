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
    /// @param file  outlives this, and is this one's alone until finish()
    explicit MovieEncoder(MovieFile& file);
    /// Drops what is not written yet.
    ~MovieEncoder();
    MovieEncoder(const MovieEncoder&) = delete;
    MovieEncoder& operator=(const MovieEncoder&) = delete;

    /// Hands over a frame; waits while kMostWaiting are not written yet. @throws Error what writing threw
    void add(Picture picture);
    /// Waits for the last frame and puts the movie in its place. @throws Error
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
