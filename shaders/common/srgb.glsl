// sRGB-coded colour and linear light, both 0..1 (IEC 61966-2-1). The curves are polynomials fitted by Remez' exchange:
// pow() of three channels is a fifth of a software device's shading.

/// Within 1.2e-4 of the value, and exact at 0 and 1.
vec3 linearFromSrgb(vec3 c) {
    precise vec3 curve = fma(c, vec3(-0.116626214), vec3(0.401858704));
    curve = fma(curve, c, vec3(-0.618510216));
    curve = fma(curve, c, vec3(0.805984839));
    curve = fma(curve, c, vec3(0.491395899));
    curve = fma(curve, c, vec3(0.0350388936));
    curve = fma(curve, c, vec3(0.000858094134));
    return mix(c * (1.0 / 12.92), curve, greaterThan(c, vec3(0.04045)));
}
/// Within 0.09 / 255: coding linearFromSrgb() of a byte gives that byte. One square root and a longer polynomial are
/// faster than a fourth root and a cubic one.
vec3 srgbFromLinear(vec3 c) {
    precise vec3 root = sqrt(c);
    precise vec3 curve = fma(root, vec3(0.5173046372), vec3(-1.62366148));
    curve = fma(curve, root, vec3(2.0315753));
    curve = fma(curve, root, vec3(-1.40273549));
    curve = fma(curve, root, vec3(1.51795042));
    curve = fma(curve, root, vec3(-0.0401095762));
    return mix(c * 12.92, curve, greaterThan(c, vec3(0.0031308)));
}
