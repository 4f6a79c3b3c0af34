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
    static constexpr std::size_t kMost = 32;
    std::string folder_;
    std::mutex turn_;
    std::deque<std::string> names_;
};

}  // namespace nacre::app
