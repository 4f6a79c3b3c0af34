#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace nacre::test {

/// Calls work(i) for every i below count, on every core.
template <typename Work>
void onEveryCore(std::size_t count, Work&& work) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> threads;
    for (std::size_t core = 0; core < cores; ++core)
        threads.emplace_back([&, core] {
            for (std::size_t i = core; i < count; i += cores) work(i);
        });
}

}  // namespace nacre::test
