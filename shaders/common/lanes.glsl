// What the lanes of a subgroup find out together. Votes and ballots go lane by lane on lavapipe 22.3, a dozen instructions
// each: there (TEXELS) they are shuffles, as many as the number of lanes has bits. All lanes take part.
/// The bits that any lane has.
uint bitsOfAll(uint bits) {
    for (uint step = 1u; step < uint(kLanes); step <<= 1) bits |= subgroupShuffle(bits, gl_SubgroupInvocationID ^ step);
    return bits;
}
#ifdef TEXELS
uint ballotOf(bool mine) {
    return bitsOfAll(mine ? 1u << gl_SubgroupInvocationID : 0u);
}
bool anyLane(bool mine) { return ballotOf(mine) != 0u; }
#else
uint ballotOf(bool mine) { return subgroupBallot(mine).x; }
bool anyLane(bool mine) { return subgroupAny(mine); }
#endif
