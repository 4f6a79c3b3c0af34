#pragma once
// SIMD: four floats at once, by the vector extensions of GCC and Clang. Compilers do not vectorise plain loops with
// selections by comparison.

#include <cstdint>
#include <cstring>

namespace nacre {

constexpr std::uint32_t kLanes = 4;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using Mask = std::int32_t __attribute__((vector_size(kLanes * sizeof(float))));  ///< -1 where true, else 0

inline Lanes loadLanes(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
inline Mask loadLanes(const std::int32_t* from) {
    Mask lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

inline Lanes squareRoots(Lanes lanes) {
#if defined(__SSE__)
    return __builtin_ia32_sqrtps(lanes);
#else
    for (std::uint32_t i = 0; i < kLanes; ++i) lanes[i] = __builtin_sqrtf(lanes[i]);
    return lanes;
#endif
}

inline bool any(Mask mask) {
    std::uint64_t halves[2];
    std::memcpy(halves, &mask, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

inline Mask toBits(Lanes lanes) {
    Mask bits;
    std::memcpy(&bits, &lanes, sizeof bits);
    return bits;
}
/// The sign bits of four numbers, the first in the lowest bit.
inline std::uint32_t packSigns(Mask bits) {
#if defined(__SSE__)
    Lanes lanes;
    std::memcpy(&lanes, &bits, sizeof lanes);
    return static_cast<std::uint32_t>(__builtin_ia32_movmskps(lanes));
#else
    std::uint32_t signs = 0;
    for (std::uint32_t i = 0; i < kLanes; ++i) signs |= static_cast<std::uint32_t>(bits[i] < 0) << i;
    return signs;
#endif
}

}  // namespace nacre
