#include "engine/occlusion/triangle_heights.h"

namespace nacre::occlusion {

constexpr int kAcross = 4;
using Four = float __attribute__((vector_size(16)));
using FourNumbers = std::int32_t __attribute__((vector_size(16)));

#define NACRE_FOUR                                   \
    static inline Four loadFour(const float* from) { \
        Four four;                                   \
        __builtin_memcpy(&four, from, sizeof four);  \
        return four;                                 \
    }                                                \
    static inline void storeFour(Four four, float* to) { __builtin_memcpy(to, &four, sizeof four); }

// The same code for each number of lanes: the compiler must know the processor's instructions where it is compiled, and
// none of them may get into a function that others use, too.
namespace lanes4 {
NACRE_FOUR
#define NACRE_LANES 4
#include "engine/occlusion/triangle_lanes.inc"
#undef NACRE_LANES
}  // namespace lanes4

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace lanes8 {
NACRE_FOUR
#define NACRE_LANES 8
#include "engine/occlusion/triangle_lanes.inc"
#undef NACRE_LANES
}  // namespace lanes8
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

std::span<const TriangleLanes> triangleLanes() {
    static constexpr TriangleLanes kLanesOf[] = {
        {4, lanes4::draw},
#if defined(__x86_64__)
        {8, lanes8::draw},
#endif
    };
#if defined(__x86_64__)
    static const std::size_t count = __builtin_cpu_supports("avx2") ? 2 : 1;
#else
    constexpr std::size_t count = 1;
#endif
    return std::span(kLanesOf).first(count);
}

}  // namespace nacre::occlusion
