#pragma once
// Structures that pages sent: files of this process, of which the oldest make room.

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
    /// @returns the input that it is from now on, "upload:9f0c..." @throws Problem
    std::string keep(const std::string& body);

private:
    static constexpr std::size_t kMost = 32;
    std::string folder_;
    std::mutex turn_;
    std::deque<std::string> names_;
};

}  // namespace nacre::app
