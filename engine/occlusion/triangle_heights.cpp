#include "engine/occlusion/triangle_heights.h"

#include "engine/simd/processor_lanes.h"

namespace nacre::occlusion {

constexpr int kAcross = 4;
using Four = float __attribute__((vector_size(16)));
using FourNumbers = std::int32_t __attribute__((vector_size(16)));

#define NACRE_LANES_CODE "engine/occlusion/triangle_lanes.inc"
#include "engine/simd/each_lanes.inc"

std::span<const TriangleLanes> triangleLanes() {
    static constexpr TriangleLanes kLaneTable[] = {
        {4, lanes4::draw},
#if defined(__x86_64__)
        {8, lanes8::draw},
#endif
    };
    return usableLanes<TriangleLanes>(kLaneTable);
}

}  // namespace nacre::occlusion
