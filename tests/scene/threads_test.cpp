// The threads that share a task: no more than asked for, and as many.

#include "engine/threads.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <numeric>
#include <set>
#include <stdexcept>

namespace nacre::test {
namespace {

class Threads : public testing::Test {
protected:
    ~Threads() override { setThreadsPerTask(0); }
};

/// Threads that shared 24 pieces of work, each of which waits for so many, or two seconds.
std::set<std::thread::id> runThreads(std::size_t waitedFor) {
    std::mutex mutex;
    std::condition_variable changed;
    std::set<std::thread::id> met;
    inParallel(24, [&](std::size_t) {
        std::unique_lock lock(mutex);
        met.insert(std::this_thread::get_id());
        changed.notify_all();
        changed.wait_for(lock, std::chrono::seconds(2), [&] { return met.size() >= waitedFor; });
    });
    return met;
}

TEST_F(Threads, AreAsManyAsAskedFor) {
    for (const unsigned count : {1u, 2u, 5u}) {
        setThreadsPerTask(count);
        const std::set<std::thread::id> met = runThreads(count);
        EXPECT_EQ(met.size(), count);
        EXPECT_TRUE(met.contains(std::this_thread::get_id()));
    }
}

TEST_F(Threads, AreOnePerCoreAtFirst) {
    EXPECT_EQ(threadsPerTask(), std::max(1u, std::thread::hardware_concurrency()));
    setThreadsPerTask(3);
    EXPECT_EQ(threadsPerTask(), 3u);
}

TEST_F(Threads, DoAllOfTheWorkOnceAndTellOfAFailure) {
    setThreadsPerTask(4);
    std::vector<int> done(1000);
    inParallel(done.size(), [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 1000);
    EXPECT_EQ(*std::min_element(done.begin(), done.end()), 1);
    inParallel(0, [](std::size_t) { FAIL(); });
    EXPECT_THROW(inParallel(100,
                            [](std::size_t i) {
                                if (i == 50) throw std::runtime_error("as asked");
                            }),
                 std::runtime_error);
}

}  // namespace
}  // namespace nacre::test
