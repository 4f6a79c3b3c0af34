// Positions of a pixel's samples. Each has its own row and column of 16.
#include "layout.h"

const int kSamples = 16;

/// From the pixel's corner, pixels.
vec2 sampleAt(int i) {
    uint row = (i < 8 ? kSampleRowsLow : kSampleRowsHigh) >> uint(4 * (i & 7)) & 15u;
    return (vec2(i, row) + 0.5) / float(kSamples);
}
