// The rest as a layer (rest.glsl): colour, and the light that comes through, which halves keep better than opacity.
// @param sum  of weighted colours and weights @param depth  sum of optical depths
vec4 mixedRest(vec4 sum, float depth) {
    precise vec3 mean = sum.rgb / max(sum.a, 1e-6);
    return vec4(mean, exp2(-depth));
}
