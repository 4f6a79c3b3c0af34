// Subgroup operations. Votes and ballots take a dozen instructions per lane on lavapipe 22.3, so that TEXELS variants
// use shuffles, one per bit of the lane count. All lanes must be active.
// Bitwise OR over all lanes.
uint bitsOfAll(uint bits) {
    for (uint step = 1u; step < uint(kLanes); step <<= 1) bits |= subgroupShuffle(bits, gl_SubgroupInvocationID ^ step);
    return bits;
}
#ifdef TEXELS
uint ballotLanes(bool mine) {
    return bitsOfAll(mine ? 1u << gl_SubgroupInvocationID : 0u);
}
bool anyLane(bool mine) { return ballotLanes(mine) != 0u; }
#else
uint ballotLanes(bool mine) { return subgroupBallot(mine).x; }
bool anyLane(bool mine) { return subgroupAny(mine); }
#endif
