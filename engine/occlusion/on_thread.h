#pragma once

#include <future>
#include <system_error>
#include <type_traits>

namespace nacre::occlusion {

/// Runs work on a thread of its own; here, where the system has none left. The future's destructor waits for it.
template <typename Work>
auto onThread(const Work& work) {
    using Result = std::invoke_result_t<const Work&>;
    try {
        return std::async(std::launch::async, work);
    } catch (const std::system_error&) {
        std::packaged_task<Result()> here(work);
        std::future<Result> result = here.get_future();
        here();
        return result;
    }
}

}  // namespace nacre::occlusion
