#pragma once
// The number of lanes that this processor supports, among those that each_lanes.inc compiles.

#include <cstddef>
#include <cstdint>
#include <span>

namespace nacre {

/// 8 with AVX2, else 4.
inline std::uint32_t processorLanes() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return 8;
#endif
    return 4;
}

/// The variants that this processor supports. @param all  with their `lanes`, in ascending order
template <typename Way>
std::span<const Way> usableLanes(std::span<const Way> all) {
    static const std::uint32_t most = processorLanes();
    std::size_t count = 0;
    while (count < all.size() && all[count].lanes <= most) ++count;
    return all.first(count);
}

}  // namespace nacre
