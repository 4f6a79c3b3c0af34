#pragma once
// Four numbers at once, as every processor takes them: the vectors of GCC and Clang. What is written in loops over
// plain numbers, they leave in single steps where comparisons choose.

#include <cstdint>
#include <cstring>

namespace nacre {

constexpr std::uint32_t kLanes = 4;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using Mask = std::int32_t __attribute__((vector_size(kLanes * sizeof(float))));  ///< -1 where it holds, else 0

inline Lanes loadLanes(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
inline void storeLanes(Lanes lanes, float* to) { std::memcpy(to, &lanes, sizeof lanes); }
inline void storeLanes(Mask lanes, std::int32_t* to) { std::memcpy(to, &lanes, sizeof lanes); }

inline Lanes lesser(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes greater(Lanes a, Lanes b) { return a > b ? a : b; }

inline bool any(Mask mask) {
    std::uint64_t halves[2];
    std::memcpy(halves, &mask, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

/// Of four points the first three coordinates, each by itself.
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
