#pragma once
// The phone's own clock, if NACRE_PHONE_WORK names a file: it goes on by what commands ask for, so that no test depends
// on how fast the machine below is. A corner of a draw and an invocation of a dispatch (of groups of 64) take as many
// nanoseconds as NACRE_PHONE_NANOSECONDS says at the time; fragments and copies take none. Timestamps are told by it,
// and the file gets the milliseconds of each submission, a line each. Commands are recorded by one thread, and
// submitted as they are recorded.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <utility>

#include "tests/phone_layer/adreno.h"
#include "tests/phone_layer/below.h"
#include "tests/phone_layer/counters.h"

namespace nacre::phone {

struct WorkClock {
    double nanoseconds = 0, submitted = 0;
    std::map<std::pair<VkQueryPool, std::uint32_t>, std::uint64_t> stamps;
};

inline WorkClock workClock;

inline bool clockGoesByWork() { return std::getenv("NACRE_PHONE_WORK") != nullptr; }

inline void work(double pieces) {
    if (const char* each = std::getenv("NACRE_PHONE_NANOSECONDS")) workClock.nanoseconds += pieces * std::atof(each);
}

/// To be called when what was recorded is submitted.
inline void tellWork() {
    const char* file = std::getenv("NACRE_PHONE_WORK");
    if (!file) return;
    std::ofstream(file, std::ios::app) << (workClock.nanoseconds - workClock.submitted) * 1e-6 << '\n';
    workClock.submitted = workClock.nanoseconds;
}

inline VKAPI_ATTR void VKAPI_CALL CmdDispatch(VkCommandBuffer commands, std::uint32_t x, std::uint32_t y,
                                              std::uint32_t z) {
    crashBehindDraws(commands);
    work(64.0 * x * y * z);
    const char* wrong = std::getenv("NACRE_PHONE_WRONG");
    if (wrong && std::string_view(wrong) == "dispatch") return;
    nextCmdDispatch(commands, x, y, z);
}

inline VKAPI_ATTR void VKAPI_CALL CmdWriteTimestamp(VkCommandBuffer commands, VkPipelineStageFlagBits stage,
                                                    VkQueryPool pool, std::uint32_t query) {
    if (const char* file = std::getenv("NACRE_PHONE_DRAWS")) std::ofstream(file, std::ios::app) << "stamp\n";
    if (clockGoesByWork()) workClock.stamps[{pool, query}] = static_cast<std::uint64_t>(workClock.nanoseconds);
    nextCmdWriteTimestamp(commands, stage, pool, query);
}

inline VKAPI_ATTR VkResult VKAPI_CALL GetQueryPoolResults(VkDevice of, VkQueryPool pool, std::uint32_t first,
                                                          std::uint32_t count, std::size_t bytes, void* data,
                                                          VkDeviceSize stride, VkQueryResultFlags flags) {
    if (tellCount(pool, data)) return VK_SUCCESS;
    const VkResult result = nextGetQueryPoolResults(of, pool, first, count, bytes, data, stride, flags);
    if (result != VK_SUCCESS || !clockGoesByWork() || !(flags & VK_QUERY_RESULT_64_BIT)) return result;
    for (std::uint32_t i = 0; i < count; ++i)
        if (const auto at = workClock.stamps.find({pool, first + i}); at != workClock.stamps.end())
            std::memcpy(static_cast<char*>(data) + i * stride, &at->second, sizeof(at->second));
    return result;
}

}  // namespace nacre::phone
