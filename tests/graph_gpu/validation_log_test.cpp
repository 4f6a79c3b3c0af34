// What the validation layer says on one thread is read on another.

#include "engine/gpu/validation_log.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace nacre::gpu {
namespace {

TEST(ValidationLog, IsReadWhileOthersSpeak) {
    constexpr int kSpeakers = 3;
    const std::string said = "a message that is too long to fit into a string itself";
    for (int i = 0; i < 200; ++i) {
        ValidationLog log;
        std::atomic<int> ended{0};
        std::vector<std::thread> speakers;
        for (int s = 0; s < kSpeakers; ++s)
            speakers.emplace_back([&] {
                for (std::size_t m = 0; m < ValidationLog::kMost; ++m) log.add(said);
                ++ended;
            });
        std::size_t before = 0;
        do {
            const std::vector<std::string> heard = log.messages();
            EXPECT_GE(heard.size(), before);  // none is taken back
            before = heard.size();
            for (const std::string& message : heard) ASSERT_EQ(message, said);
        } while (ended < kSpeakers);
        for (std::thread& speaker : speakers) speaker.join();
        EXPECT_EQ(log.messages().size(), ValidationLog::kMost);
    }
}

}  // namespace
}  // namespace nacre::gpu
