#pragma once
// SIMD: four floats at once, by the vector extensions of GCC and Clang. Compilers do not vectorise plain loops with
// selections by comparison.

#include <cstdint>
#include <cstring>

/// Before the definition of a function: it is compiled for AVX2, too, and the loader picks one. Clang 14 has no such
/// members.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
#define NACRE_CLONED __attribute__((target_clones("avx2", "default")))
#else
#define NACRE_CLONED
#endif

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
inline void storeLanes(Lanes lanes, float* to) { std::memcpy(to, &lanes, sizeof lanes); }
inline void storeLanes(Mask lanes, std::int32_t* to) { std::memcpy(to, &lanes, sizeof lanes); }

inline Lanes lesser(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes greater(Lanes a, Lanes b) { return a > b ? a : b; }

inline float leastOf(Lanes lanes) {
    const Lanes two = lesser(lanes, __builtin_shufflevector(lanes, lanes, 2, 3, 0, 1));
    return lesser(two, __builtin_shufflevector(two, two, 1, 0, 3, 2))[0];
}

inline bool any(Mask mask) {
    std::uint64_t halves[2];
    std::memcpy(halves, &mask, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

inline Mask bitsOf(Lanes lanes) {
    Mask bits;
    std::memcpy(&bits, &lanes, sizeof bits);
    return bits;
}
/// The sign bits of four numbers, the first in the lowest bit.
inline std::uint32_t signsOf(Mask bits) {
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

/// x, y and z of four points, as separate vectors.
struct LanePoints {
    Lanes x, y, z;
    LanePoints(Lanes a, Lanes b, Lanes c, Lanes d) {
        const Lanes abLow = __builtin_shufflevector(a, b, 0, 4, 1, 5),
                    cdLow = __builtin_shufflevector(c, d, 0, 4, 1, 5);
        x = __builtin_shufflevector(abLow, cdLow, 0, 1, 4, 5);
        y = __builtin_shufflevector(abLow, cdLow, 2, 3, 6, 7);
        z = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 3, 7),
                                    __builtin_shufflevector(c, d, 2, 6, 3, 7), 0, 1, 4, 5);
    }
};

}  // namespace nacre
