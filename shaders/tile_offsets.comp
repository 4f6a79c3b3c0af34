#version 440
// Places the list of each bin behind the one before: one workgroup per 128 bins, which first sums all bins before its
// own. A round has the bins whose lists begin within its share of all entries.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/list_layout.glsl"

layout(local_size_x = 128) in;
layout(push_constant) uniform Push {
    uint bins;
    uint offsets;  // place of the bins' offsets in the lists
    uint earlier, share;  // entries of earlier rounds; of this one
};
layout(set = 0, binding = 0, std430) buffer Work { uint work[]; };
layout(set = 0, binding = 1, std430) buffer Lists { uint lists[]; };

const uint kGroup = 128u;  // the most of the least phone
shared uint sums[kGroup];

uint countAt(uint bin) { return bin < bins ? work[bin] & ~kSmallBit : 0u; }

/// Turns sums[] into running sums.
void sumUp(uint lane) {
    barrier();
    for (uint step = 1u; step < kGroup; step <<= 1) {
        uint other = lane >= step ? sums[lane - step] : 0u;
        barrier();
        sums[lane] += other;
        barrier();
    }
}

void main() {
    const uint tiles = uint(kTilesInBin * kTilesInBin);
    uint lane = gl_LocalInvocationIndex, first = gl_WorkGroupID.x * kGroup, bin = first + lane;
    uint own = 0u;
    for (uint other = lane; other < first; other += kGroup) own += countAt(other);
    sums[lane] = own;
    sumUp(lane);
    uint base = offsets + bins + 2u, before = sums[kGroup - 1u], count = countAt(bin);
    barrier();
    sums[lane] = count;
    sumUp(lane);
    uint end = before + sums[lane] - earlier, begin = end - count;
    if (bin < bins) {
        bool drawn = begin < share;
        work[bins + bin] = drawn ? begin : kNoRoom;
        lists[offsets + bin] = base + begin;
        uint bits = (work[bin] & kSmallBit) | (drawn ? 0u : kOtherRoundBit);
        for (uint i = 0u; i < tiles; ++i) {
            uint tile = tiles * bin + i;
            lists[tile] = (lists[tile] & ~(kSmallBit | kOtherRoundBit)) | bits;
        }
    }
    if (bin + 1u == bins) {
        lists[offsets + bins] = base + end;
        lists[offsets + bins + 1u] = 1u;  // read where a list is empty
    }
}
