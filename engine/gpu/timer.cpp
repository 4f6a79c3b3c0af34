#include "engine/gpu/timer.h"

namespace nacre::gpu {
namespace {

constexpr std::uint32_t kStamps = 64;
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

/// As many as were written; none if the device does not tell.
std::vector<std::uint64_t> Timer::stamps() const {
    if (!begun_ || parts_.empty()) return {};
    const auto count = static_cast<std::uint32_t>(parts_.size() + 1);
    const auto [result, stamps] = pool_.getResults<std::uint64_t>(0, count, count * sizeof(std::uint64_t),
                                                                  sizeof(std::uint64_t), vk::QueryResultFlagBits::e64);
    return result == vk::Result::eSuccess ? stamps : std::vector<std::uint64_t>{};
}

std::vector<PassTime> Timer::times() const {
    const std::vector<std::uint64_t> at = stamps();
    if (at.empty()) return {};
    // A queue's counter may be narrower than its stamps, and begins anew when it is full.
    const std::uint32_t bits = device_.caps().timestampBits;
    const std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    std::vector<PassTime> times;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const auto ticks = static_cast<double>((at[i + 1] - at[i]) & mask);
        times.push_back({parts_[i], ticks * device_.caps().nanosecondsPerTick * 1e-6});
    }
    return times;
}

std::optional<double> Timer::milliseconds() const {
    const std::vector<PassTime> parts = times();
    if (parts.empty()) return {};
    double sum = 0;
    for (const PassTime& part : parts) sum += part.milliseconds;
    return sum;
}

}  // namespace nacre::gpu
