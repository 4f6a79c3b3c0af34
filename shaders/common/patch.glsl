// Patches of the occlusion atlas. The texels of a patch include its corners and edges, so that bilinear interpolation
// inside a patch needs no gutter and is continuous where the map is folded or wrapped.
#ifndef NACRE_PATCH_GLSL
#define NACRE_PATCH_GLSL

/// Octahedral map of a unit vector to [0, 1]^2 (Meyer et al. 2010, "On Floating-Point Normal Vectors").
vec2 octahedralCoordinate(vec3 n) {
    // The lower half is folded out by as much as it lies below: there 1 - |p.y| is |p.x| + |p.z|.
    float below = max(-n.z, 0.0);
    vec2 p = n.xy + vec2(n.x >= 0.0 ? below : -below, n.y >= 0.0 ? below : -below);
    return p * (0.5 / (abs(n.x) + abs(n.y) + abs(n.z))) + 0.5;
}
vec3 octahedralNormal(vec2 uv) {
    vec2 p = uv * 2.0 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return normalize(n);
}

/// Two unit vectors that make a right-handed frame with the unit vector w (Duff et al. 2017, JCGT 6(1)).
void frameAbout(vec3 w, out vec3 u, out vec3 v) {
    float s = w.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + w.z);
    float b = w.x * w.y * a;
    u = vec3(1.0 + s * w.x * w.x * a, s * b, -s * w.x);
    v = vec3(b, s + w.y * w.y * a, -w.y);
}
const float kTwoPi = 6.283185307179586;

/// Angle of a direction in the plane, -0.5..0.5 of a turn, within 1.3e-5 of it: a polynomial fitted by Remez' exchange
/// for an eighth of a turn. atan() of two arguments takes three times the instructions.
float toTurn(vec2 p) {
    vec2 size = abs(p);
    precise float ratio = min(size.x, size.y) / max(max(size.x, size.y), 1e-30), square = ratio * ratio;
    precise float curve = fma(square, -0.006204896448, 0.02327871239);
    curve = fma(curve, square, -0.05111658397);
    curve = fma(curve, square, 0.1590298175) * ratio;
    if (size.y > size.x) curve = 0.25 - curve;
    if (p.x < 0.0) curve = 0.5 - curve;
    return p.y < 0.0 ? -curve : curve;
}

/// Angle about the axis w of a direction n, as 0..1 around.
float angleAbout(vec3 w, vec3 n) {
    vec3 u, v;
    frameAbout(w, u, v);
    return toTurn(vec2(dot(n, u), dot(n, v))) + 0.5;
}
vec3 directionAbout(vec3 w, float around) {
    vec3 u, v;
    frameAbout(w, u, v);
    float angle = (around - 0.5) * kTwoPi;
    return u * cos(angle) + v * sin(angle);
}
#endif
