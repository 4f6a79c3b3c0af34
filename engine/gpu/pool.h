#pragma once

#include <algorithm>
#include <memory>
#include <vector>

namespace nacre::gpu {

/// Objects that frames in flight hold. An object that no frame holds is reused, so steady frames allocate none. For one
/// thread.
template <typename T>
class Pool {
public:
    /// An object that nobody else holds, in its last state.
    const std::shared_ptr<T>& free() {
        auto found = std::find_if(all_.begin(), all_.end(), [](const auto& one) { return one.use_count() == 1; });
        if (found == all_.end()) found = all_.insert(found, std::make_shared<T>());
        return *found;
    }
    /// @param work  receives each object that nobody else holds
    template <typename Work>
    void eachFree(const Work& work) {
        for (const auto& one : all_)
            if (one.use_count() == 1) work(*one);
    }

private:
    std::vector<std::shared_ptr<T>> all_;
};

}  // namespace nacre::gpu
