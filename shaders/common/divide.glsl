// Exact integer division through floats: several times as fast as a driver's / and %.
#ifndef NACRE_DIVIDE_GLSL
#define NACRE_DIVIDE_GLSL
/// Quotient and remainder.
uvec2 divided(uint number, uint by) {
    uint quotient = uint(float(number) / float(by));
    // A float is exact to 24 bits: a second estimate corrects a large quotient, and a last step the remainder.
    int rest = int(number - quotient * by);
    int more = int(floor(float(rest) / float(by)));
    quotient += uint(more);
    rest -= more * int(by);
    int off = rest < 0 ? -1 : rest >= int(by) ? 1 : 0;
    return uvec2(quotient + uint(off), uint(rest - off * int(by)));
}
/// For quotients below 2^20.
uvec2 dividedSmall(uint number, uint by) {
    int quotient = int(float(number) / float(by));
    int rest = int(number) - quotient * int(by);
    int off = rest < 0 ? -1 : rest >= int(by) ? 1 : 0;
    return uvec2(quotient + off, rest - off * int(by));
}
#endif
