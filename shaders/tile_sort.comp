#version 440
// Sorts the entries of a bin from near to far, one workgroup per bin. Short lists are sorted by merging (bitonic), long
// ones by counting the entries of each step of depth. Entries of one step get any order: pixels do not depend on it.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/list_layout.glsl"

layout(local_size_x = 128) in;
layout(push_constant) uniform Push {
    uint bins;
    uint offsets;  // place of the bins' offsets in the lists
    uint last;     // 1: the last round
};
layout(set = 0, binding = 0, std430) buffer Work { uint work[]; };
layout(set = 0, binding = 1, std430) buffer Lists { uint lists[]; };

const uint kGroup = 128u, kShort = 128u, kRun = kListSteps / kGroup;
shared uint keys[kListSteps];  // of short lists: step << 10 | index of the entry; of long ones: entries of each step
shared uint sums[kGroup];

void sortShort(uint first, uint count, uint to, uint lane) {
    uint size = 2u;
    while (size < count) size <<= 1;
    for (uint i = lane; i < size; i += kGroup) keys[i] = i < count ? work[first + 2u * i] << 10 | i : 0xffffffffu;
    for (uint run = 2u; run <= size; run <<= 1)
        for (uint apart = run / 2u; apart > 0u; apart >>= 1) {
            barrier();
            for (uint i = lane; i < size / 2u; i += kGroup) {
                uint low = 2u * i - (i & (apart - 1u)), high = low + apart;
                uint a = keys[low], b = keys[high];
                if ((a > b) == ((low & run) == 0u)) {
                    keys[low] = b;
                    keys[high] = a;
                }
            }
        }
    barrier();
    for (uint i = lane; i < count; i += kGroup) lists[to + i] = work[first + 2u * (keys[i] & (kShort - 1u)) + 1u];
}

void sortLong(uint first, uint count, uint to, uint lane) {
    for (uint i = lane; i < kListSteps; i += kGroup) keys[i] = 0u;
    barrier();
    for (uint i = lane; i < count; i += kGroup) atomicAdd(keys[work[first + 2u * i]], 1u);
    barrier();
    uint own = 0u;
    for (uint i = 0u; i < kRun; ++i) own += keys[lane * kRun + i];
    sums[lane] = own;
    barrier();
    for (uint step = 1u; step < kGroup; step <<= 1) {
        uint other = lane >= step ? sums[lane - step] : 0u;
        barrier();
        sums[lane] += other;
        barrier();
    }
    uint before = sums[lane] - own;
    for (uint i = 0u; i < kRun; ++i) {
        uint here = keys[lane * kRun + i];
        keys[lane * kRun + i] = before;
        before += here;
    }
    barrier();
    for (uint i = lane; i < count; i += kGroup) {
        uint at = atomicAdd(keys[work[first + 2u * i]], 1u);
        lists[to + at] = work[first + 2u * i + 1u];
    }
}

void main() {
    uint lane = gl_LocalInvocationIndex, bin = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    if (bin >= bins) return;
    if (last != 0u && lane == 0u) work[bin] = 0u;  // for the next frame
    if ((lists[uint(kTilesInBin * kTilesInBin) * bin] & kOtherRoundBit) != 0u) return;
    uint begin = lists[offsets + bin], count = lists[offsets + bin + 1u] - begin;
    uint first = 2u * (bins + begin - (offsets + bins + 2u));
    if (count > 0u && count <= kShort) sortShort(first, count, begin, lane);
    if (count > kShort) sortLong(first, count, begin, lane);
}
