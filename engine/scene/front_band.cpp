#include "engine/scene/front_band.h"

#include "engine/scene/lanes.h"
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace nacre {

void FrontBand::meet(std::size_t at, float Z, bool certain, std::uint32_t sphere) const {
    const float there = z[at];
    if (!certain || !(Z < there)) return doubts->push_back(sphere);
    if (!(Z + 2 * margin < there)) doubts->push_back(number[at]);
    z[at] = Z;
    number[at] = sphere;
}

bool FrontBand::isHidden(const FrontRectangle& r) const {
    constexpr Mask kLane = {0, 1, 2, 3};
    const std::uint32_t x0 = frontPixelAt(r.left, 0, width), x1 = frontPixelAt(r.right, 0, width);
    const std::uint32_t y1 = frontPixelAt(r.bottom, first, end);
    for (std::uint32_t y = frontPixelAt(r.top, first, end); y < y1; ++y) {
        const float* row = z + std::size_t{y} * pitch;
        for (std::uint32_t x = x0; x < x1; x += kLanes)
            if (any((loadLanes(row + x) >= r.near) & (kLane < static_cast<std::int32_t>(x1 - x)))) return false;
    }
    return true;
}

void ShapeBand::meet(std::size_t at, std::uint32_t shape, float from) const {
    meetings->push_back({static_cast<std::uint32_t>(at), shape, from});
}

// The same code for each number of lanes: the compiler must know the processor's instructions where it is compiled, and
// none of them may get into a function that others use, too.
namespace lanes4 {
#define NACRE_LANES 4
#include "engine/scene/front_lanes.inc"
#include "engine/scene/front_shapes.inc"
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
#define NACRE_LANES 8
#include "engine/scene/front_lanes.inc"
#include "engine/scene/front_shapes.inc"
#undef NACRE_LANES
}  // namespace lanes8
#if defined(__clang__)
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq")
#endif
namespace lanes16 {
#define NACRE_LANES 16
#include "engine/scene/front_lanes.inc"
#include "engine/scene/front_shapes.inc"
#undef NACRE_LANES
}  // namespace lanes16
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

std::span<const FrontLanes> frontLanes() {
    static constexpr FrontLanes kLanesOf[] = {
        {4, lanes4::drawGroup, lanes4::findRectangles, lanes4::drawShapes, lanes4::tellRow},
#if defined(__x86_64__)
        {8, lanes8::drawGroup, lanes8::findRectangles, lanes8::drawShapes, lanes8::tellRow},
        {16, lanes16::drawGroup, lanes16::findRectangles, lanes16::drawShapes, lanes16::tellRow},
#endif
    };
#if defined(__x86_64__)
    static const std::size_t count = !__builtin_cpu_supports("avx2")                                             ? 1
                                     : !__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512dq") ? 2
                                                                                                                 : 3;
#else
    constexpr std::size_t count = 1;
#endif
    return std::span(kLanesOf).first(count);
}

}  // namespace nacre
