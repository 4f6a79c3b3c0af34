// Light, in linear values; directions in view space, so that the light follows the viewer. `precise`, because compilers
// evaluate sums and products differently in each shader.

const vec3 kLight = normalize(vec3(kLightX, kLightY, kLightZ));

layout(constant_id = kLightingId) const bool kLighting = true;
layout(constant_id = kAmbientId) const float kAmbient = 1.0;
layout(constant_id = kDirectId) const float kDirect = 1.0;
layout(constant_id = kHighlightId) const float kHighlight = 1.0;
layout(constant_id = kGlossId) const float kGloss = 42.0;
layout(constant_id = kPowersId) const bool kPowers = false;
layout(constant_id = kDeepeningId) const float kDeepening = 1.0;
layout(constant_id = kMaterialId) const int kMaterial = kPlastic;
layout(constant_id = kBounceId) const bool kBounce = false;

// Of metal: the share of other light, and the highlight's brightness. Of glow: light at the rim, and more facing the viewer.
const float kDull = 0.45, kShine = 1.1, kGlowRim = 0.95, kGlowFacing = 0.75;

/// strength * x^kGloss. Where pow() is slow, the default exponent is a product with the shortest chain of
/// multiplications.
float glossy(float x, float strength) {
    if (kPowers || kGloss != 42.0) return pow(x, kGloss) * strength;
    precise float x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8;
    precise float x42 = x16 * x16 * (x8 * (x2 * strength));
    return x42;
}

#ifdef MEAN_NORMALS
/// Mean of cos^power over the normals of a piece of surface: Toksvig, "Mipmapping Normal Maps" (2005).
/// @param facing  cosine of their mean, not normalised @param close  length of that mean: 1 if all are equal
float meanPower(float facing, float close, float power) {
    float share = close / (close + power * (1.0 - close));
    return (1.0 + share * power) / (1.0 + power) * pow(facing / close, share * power);
}
#endif

/// Baked light at a point.
struct Baked {
    float open;  // 0 closed to 1 open
    // With kBounce, otherwise 0:
    vec3 light;  // square roots of the light of the surroundings
    float lean;  // how much higher its part of the sky is than if as much were open in each direction
};
const Baked kOpen = Baked(1.0, vec3(0.0), 0.0);

/// Fractions of the light at a point.
struct Reach {
    float direct, ambient;
};
/// Ambient light with bounces: the cubic that Jimenez, Wu, Pesce and Jarabo fitted to path tracing, "Practical
/// Real-Time Strategies for Accurate Indirect Occlusion" (2016), sorted by powers of the albedo. Uses the mean albedo
/// of the channels: neighbours have other colours, and a cubic per channel differs more from path tracing. The result
/// approaches its minimum kLeastLight with slope zero, so that no border shows where few directions reach a point. It
/// is exactly 1 under an open sky.
/// @param base  linear base colour @param open  0 closed to 1 open
Reach computeReach(vec3 base, float open) {
    // Terms without the occlusion come first, since it arrives late from a texture. The cubic uses the sum of the
    // channels.
    precise float sum = base.r + base.g + base.b;
    precise float c2 = fma(sum, 2.0404 / 3.0, -0.3324), c1 = fma(sum, -4.7951 / 3.0, 0.6417);
    precise float c0 = fma(sum, 2.7552 / 3.0, 0.6903);
    precise float closed = max(2.0 * kLeastLight - open, 0.0);
    // A parabola: a square root made frames 5 % slower on a software device.
    precise float direct = fma(closed * closed, 0.25 / kLeastLight, open);
    // With light from the surroundings the cubic would count it twice.
    precise float ambient = kBounce ? direct : direct * max(fma(direct, fma(direct, c2, c1), c0), 1.0);
    Reach reach = Reach(direct, ambient);
    if (kDeepening == 1.0) return reach;
    return Reach(mix(1.0, reach.direct, kDeepening), mix(1.0, reach.ambient, kDeepening));
}

/// Light of the surroundings, which comes from where the sky is hidden; the sky's is 1.
/// @param open  0 closed to 1 @param root  its square root
vec3 bounced(float open, vec3 root) {
    precise vec3 light = (1.0 - open) * (root * root);
    return light;
}

/// @param material  one of common/layout.h
/// @param base      linear base colour
/// @param sun       fraction of the direct light
vec3 shade(int material, vec3 base, vec3 normal, Baked baked, float sun) {
    if (!kLighting) {
        float open = mix(1.0, baked.open, kDeepening);
        return kBounce ? base * (open + bounced(open, baked.light)) : base * open;
    }
    if (material == kGlow) {
        precise float own = fma(max(normal.z, 0.0), kGlowFacing, kGlowRim);
        return base * own;
    }
    vec3 light = kLight;
    // Hemisphere light: surfaces that face up are slightly brighter.
    const vec3 down = vec3(0.54, 0.52, 0.52), up = vec3(0.70, 0.73, 0.77);
    const vec3 level = 0.5 * (down + up), slope = 0.5 * (up - down);
    precise float direct = max(dot(normal, light * (0.74 * kDirect)), 0.0) * sun;
    precise vec3 ambient = fma(vec3(normal.y), slope * kAmbient, level * kAmbient);
    vec3 half_ = normalize(light + vec3(0.0, 0.0, 1.0));
    float facing = max(dot(normal, half_), 0.0);
#ifdef MEAN_NORMALS
    float close = max(length(normal), 1e-3), gloss = 0.16 * kHighlight * meanPower(facing, close, kGloss);
#else
    float gloss = glossy(facing, 0.16 * kHighlight);
#endif
    precise float highlight = material == kMatte || kHighlight == 0.0 ? 0.0 : gloss * sun;
    Reach reach = computeReach(base, baked.open);
    precise vec3 arriving = fma(ambient, vec3(reach.ambient), vec3(direct * reach.direct));
    if (kBounce) {
        precise vec3 more = fma(slope, vec3(baked.lean * kDeepening), level * bounced(reach.direct, baked.light));
        arriving += more * kAmbient;
    }
    if (material == kMetal) {
        precise float x2 = facing * facing, x4 = x2 * x2;
        precise float x8 = x4 * x4;
#ifdef MEAN_NORMALS
        x8 = meanPower(facing, close, 8.0);
#endif
        precise float shine = x8 * (kShine * kHighlight * sun * reach.direct);
        precise vec3 metal = base * fma(arriving, vec3(kDull), vec3(shine));
        return metal;
    }
    precise vec3 lit = fma(base, arriving, vec3(highlight * reach.direct));
    return lit;
}
