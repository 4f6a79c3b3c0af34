#include "engine/software/front_band.h"

#include "engine/simd/lanes.h"
#include "engine/simd/processor_lanes.h"
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace nacre {

bool FrontBand::isHidden(const FrontRectangle& r) const {
    constexpr Mask kLane = {0, 1, 2, 3};
    const std::uint32_t x0 = pixelAt(r.left, 0, width), x1 = pixelAt(r.right, 0, width);
    const std::uint32_t y1 = pixelAt(r.bottom, first, end);
    for (std::uint32_t y = pixelAt(r.top, first, end); y < y1; ++y) {
        const float* row = depth + std::size_t{y} * pitch;
        for (std::uint32_t x = x0; x < x1; x += kLanes)
            if (any((loadLanes(row + x) >= r.near) & (kLane < static_cast<std::int32_t>(x1 - x)))) return false;
    }
    return true;
}

namespace front_lanes {

#define NACRE_LANES_CODE "engine/software/front_lanes.inc"
#include "engine/simd/each_lanes.inc"

}  // namespace front_lanes

std::span<const FrontLanes> frontLanes() {
    using namespace front_lanes;
    static constexpr FrontLanes kLaneTable[] = {
        {4, lanes4::drawGroup, lanes4::findRectangles},
#if defined(__x86_64__)
        {8, lanes8::drawGroup, lanes8::findRectangles},
#endif
    };
    return usableLanes<FrontLanes>(kLaneTable);
}

}  // namespace nacre
