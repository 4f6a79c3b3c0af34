#pragma once

#include <algorithm>
#include <memory>
#include <vector>

namespace nacre::gpu {

/// What frames in flight hold, each its own: one that no frame holds any more is used again, so that steady frames make
/// none. For one thread.
template <typename T>
class Pool {
public:
    /// One that nobody else holds, as it was left.
    const std::shared_ptr<T>& free() {
        auto found = std::find_if(all_.begin(), all_.end(), [](const auto& one) { return one.use_count() == 1; });
        if (found == all_.end()) found = all_.insert(found, std::make_shared<T>());
        return *found;
    }
    /// @param work  gets each that nobody else holds
    template <typename Work>
    void eachFree(const Work& work) {
        for (const auto& one : all_)
            if (one.use_count() == 1) work(*one);
    }

private:
    std::vector<std::shared_ptr<T>> all_;
};

}  // namespace nacre::gpu
