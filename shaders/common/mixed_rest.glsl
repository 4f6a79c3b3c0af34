// The rest as a layer (rest.glsl). @param sum  of weighted colours and weights @param depth  sum of optical depths
vec4 mixedRest(vec4 sum, float depth) {
    precise vec3 mean = sum.rgb / max(sum.a, 1e-6);
    precise float opacity = 1.0 - exp2(-depth);
    return vec4(mean, opacity);
}
