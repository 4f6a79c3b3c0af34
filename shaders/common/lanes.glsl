// What the lanes of a subgroup find out together. Votes and ballots go lane by lane on lavapipe 22.3, a dozen instructions
// each: there (TEXELS) they are shuffles, as many as the number of lanes has bits. All lanes take part.
#ifdef TEXELS
uint ballotOf(bool mine) {
    uint lane = gl_SubgroupInvocationID, bits = mine ? 1u << lane : 0u;
    for (uint step = 1u; step < uint(kLanes); step <<= 1) bits |= subgroupShuffle(bits, lane ^ step);
    return bits;
}
bool anyLane(bool mine) { return ballotOf(mine) != 0u; }
#else
uint ballotOf(bool mine) { return subgroupBallot(mine).x; }
bool anyLane(bool mine) { return subgroupAny(mine); }
#endif
