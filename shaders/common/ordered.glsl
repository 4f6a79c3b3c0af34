// Floats as words that have the same order, so that an atomic maximum finds the largest.

uint orderedBits(float value) {
    uint bits = floatBitsToUint(value);
    return bits ^ ((bits >> 31) != 0u ? 0xffffffffu : 0x80000000u);
}
float fromOrderedBits(uint word) {
    return uintBitsToFloat(word ^ ((word >> 31) != 0u ? 0x80000000u : 0xffffffffu));
}
