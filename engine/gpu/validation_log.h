#pragma once
// What the validation layer says. It speaks on whichever thread makes the call; whoever asks may be on another.

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace nacre::gpu {

class ValidationLog {
public:
    static constexpr std::size_t kMost = 100;  // the first, of which the others mostly follow

    void add(std::string_view message) {
        const std::lock_guard lock(turn_);
        if (messages_.size() < kMost) messages_.emplace_back(message);
    }
    /// What was said so far.
    std::vector<std::string> messages() const {
        const std::lock_guard lock(turn_);
        return messages_;
    }

private:
    mutable std::mutex turn_;
    std::vector<std::string> messages_;
};

}  // namespace nacre::gpu
