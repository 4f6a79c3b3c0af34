#pragma once
// Messages of the validation layer, which calls from any thread.

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace nacre::gpu {

class ValidationLog {
public:
    static constexpr std::size_t kMost = 100;  // keeps the first, which usually cause the rest

    void add(std::string_view message) {
        const std::lock_guard lock(turn_);
        if (messages_.size() < kMost) messages_.emplace_back(message);
    }
    std::vector<std::string> messages() const {
        const std::lock_guard lock(turn_);
        return messages_;
    }

private:
    mutable std::mutex turn_;
    std::vector<std::string> messages_;
};

}  // namespace nacre::gpu
