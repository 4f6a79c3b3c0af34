// Calls of primitives for compute stages with an invocation per primitive.
//   CALLS   binding: a header, then for each call the number of its first item and the number of its first primitive

layout(set = 0, binding = CALLS, std430) readonly buffer Calls {
    uint callCount, items, down;  // `down`: bins per column, for lists
    float small;                  // half a width below which a primitive may lie between pixel centres, pixels
    uint share, unused;           // `share`: invocations that find the bins of a primitive together
    uvec2 calls[];
};

/// The number of an item's primitive. Calls are sorted by their first items.
uint findNumber(uint item) {
    uint low = 0u, high = callCount;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (calls[middle].x <= item)
            low = middle;
        else
            high = middle;
    }
    return calls[low].y + (item - calls[low].x);
}
