#pragma once
// Uploaded structures: files of this process; the oldest are removed to make room.

#include <deque>
#include <mutex>
#include <string>

namespace nacre::app {

class Uploads {
public:
    Uploads();
    ~Uploads();
    Uploads(const Uploads&) = delete;

    const std::string& folder() const { return folder_; }
    /// @returns its input name, "upload:9f0c..." @throws Problem
    std::string keep(const std::string& body);

private:
    struct Kept {
        std::string name;
        std::size_t bytes;
    };
    static constexpr std::size_t kMost = 32;
    static constexpr std::size_t kMostBytes = std::size_t{512} << 20;
    std::string folder_;
    std::mutex turn_;
    std::deque<Kept> kept_;
    std::size_t bytes_ = 0;  ///< of all of them
};

}  // namespace nacre::app
