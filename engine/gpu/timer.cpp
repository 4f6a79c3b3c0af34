#include "engine/gpu/timer.h"

namespace nacre::gpu {
namespace {

constexpr auto kEnd = vk::PipelineStageFlagBits::eBottomOfPipe;

}  // namespace

Timer::Timer(const Device& device) : device_(device) {
    if (device.caps().timestampBits == 0) return;
    pool_ = vk::raii::QueryPool(*device, vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, kStamps));
    device.name(*pool_, "times");
}

void Timer::begin(const vk::raii::CommandBuffer& commands) {
    parts_.clear();
    begun_ = there();
    if (!begun_) return;
    commands.resetQueryPool(*pool_, 0, kStamps);
    commands.writeTimestamp(kEnd, *pool_, 0);
}

void Timer::lap(const vk::raii::CommandBuffer& commands, std::string part) {
    if (!begun_ || parts_.size() + 1 == kStamps) return;
    parts_.push_back(std::move(part));
    commands.writeTimestamp(kEnd, *pool_, static_cast<std::uint32_t>(parts_.size()));
}

std::size_t Timer::read(Stamps& stamps) const {
    if (!begun_ || parts_.empty()) return 0;
    const auto count = static_cast<std::uint32_t>(parts_.size() + 1);
    const vk::Result result = (**device_).getQueryPoolResults(
        *pool_, 0, count, count * sizeof(stamps[0]), stamps.data(), sizeof(stamps[0]), vk::QueryResultFlagBits::e64);
    return result == vk::Result::eSuccess ? count : 0;
}

double Timer::millisecondsBetween(std::uint64_t from, std::uint64_t to) const {
    // A counter may have fewer bits than its timestamps, and wraps around.
    const std::uint32_t bits = device_.caps().timestampBits;
    const std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    return static_cast<double>((to - from) & mask) * device_.caps().nanosecondsPerTick * 1e-6;
}

std::vector<PassTime> Timer::times() const {
    Stamps at;
    std::vector<PassTime> times;
    for (std::size_t i = 1, count = read(at); i < count; ++i)
        times.push_back({parts_[i - 1], millisecondsBetween(at[i - 1], at[i])});
    return times;
}

std::optional<double> Timer::milliseconds() const {
    Stamps at;
    const std::size_t count = read(at);
    if (count == 0) return {};
    double sum = 0;
    for (std::size_t i = 1; i < count; ++i) sum += millisecondsBetween(at[i - 1], at[i]);
    return sum;
}

}  // namespace nacre::gpu
