#version 440
// Intermediate images of a frame as a picture, by kDebugView (engine/debug_view.h).
//   NUMBERS   of the identity layer     UNDER   with a second image: the picture below
// The target or, with kCoded, this shader applies sRGB coding: linearFromSrgb() undoes it for raw numbers.
#extension GL_GOOGLE_include_directive : require
#include "common/view.glsl"
#include "common/encoding.glsl"
#include "common/srgb.glsl"

#ifdef NUMBERS
layout(set = 0, binding = 0) uniform usampler2D source;
#else
layout(set = 0, binding = 0) uniform sampler2D source;
#endif
#ifdef UNDER
layout(set = 0, binding = 1) uniform sampler2D under;
#endif
layout(location = 0) out vec4 color;
layout(constant_id = kDebugViewId) const int kDebugView = 0;
layout(constant_id = kTileId) const int kTile = 16;
layout(constant_id = kCodedId) const bool kCoded = false;
layout(constant_id = kBounceId) const bool kBounce = false;

/// Fragments in a pixel: every doubling is a step from indigo (1) over teal, green, yellow (8), orange to red (32).
vec3 heat(float fragments) {
    const vec3 steps[7] = vec3[](vec3(0.20, 0.24, 0.56), vec3(0.13, 0.54, 0.62), vec3(0.43, 0.74, 0.35),
                                 vec3(0.98, 0.86, 0.25), vec3(0.95, 0.52, 0.16), vec3(0.77, 0.10, 0.15),
                                 vec3(0.30, 0.00, 0.10));
    float at = clamp(log2(max(fragments, 1.0)), 0.0, 6.0);
    int low = min(int(at), 5);
    return mix(steps[low], steps[low + 1], at - float(low));
}

/// Well separated colours for consecutive numbers.
vec3 numberColor(uint number) {
    float hue = fract(float(number % 65536u) * 0.61803399);
    float value = 0.62 + 0.38 * fract(float(number % 65536u) * 0.75487767);
    vec3 c = clamp(abs(fract(hue + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return mix(vec3(1.0), c, 0.72) * value;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#if defined(NUMBERS)
    uvec2 identity = texelFetch(source, pixel, 0).xy;
    if (identity.x == 0u) discard;
    color.rgb = kDebugView == kDebugId ? linearFromSrgb(numberColor(identity.x)) : vec3(uintBitsToFloat(identity.y));
#elif defined(UNDER)
    if (kDebugView == kDebugPlates) {
        vec4 picture = texelFetch(under, pixel, 0);
        if (picture.a == 0.0) discard;
        if (kCoded) picture.rgb = linearFromSrgb(picture.rgb);
        bool plate = texelFetch(source, pixel, 0).x < 1.0;
        color.rgb = plate ? picture.rgb : mix(picture.rgb, vec3(1.0), 0.6);
    } else {
        ivec2 inTile = pixel % kTile;
        bool edge = inTile.x == 0 || inTile.y == 0;
        float mean = texelFetch(source, pixel / kTile, 0).x;
        vec3 tile = mean > 0.0 ? heat(mean) : vec3(0.93);
        if (mean > 0.0 && texelFetch(under, pixel, 0).x == 0.0) tile = mix(tile, vec3(1.0), 0.45);
        color.rgb = linearFromSrgb(edge ? tile * 0.8 : tile);
    }
#else
    if (kDebugView == kDebugEncoded) {
        vec4 here = texelFetch(source, pixel, 0);
        vec3 steps = vec3(toStep(here.x), kDepthChannels > 1 ? toStep(here.y) : 0,
                          kDepthChannels > 2 ? toStep(here.z) : 0) / float(kDepthSteps);
        color.rgb = linearFromSrgb(kDepthSteps == 0 ? here.xxx : steps);
    } else if (kDebugView == kDebugOverdraw) {
        float fragments = texelFetch(source, pixel, 0).x * 255.0;
        if (fragments < 0.5) discard;
        color.rgb = linearFromSrgb(heat(fragments));
    } else if (kDebugView == kDebugPatches) {
        // Shows the atlas on the plane z = 0, as large as the scene; it pans and zooms with the view without rotation.
        vec2 size = vec2(textureSize(source, 0));
        if (kBounce) size.y *= 0.5;  // the second half tells where places see the sky
        vec2 texel = planePoint(gl_FragCoord.xy) * vec2(1.0, -1.0) * view.perRange * max(size.x, size.y) + 0.5 * size;
        if (any(lessThan(texel, vec2(0.0))) || any(greaterThanEqual(texel, size))) discard;
        color.rgb = vec3(texelFetch(source, ivec2(texel), 0).x);
    } else {  // of the surface layer: Z, and the normal
        vec4 surface = texelFetch(source, pixel, 0);
        if (surface.yzw == vec3(0.0)) discard;
        color.rgb = linearFromSrgb(kDebugView == kDebugNormals
                                       ? surface.yzw * 0.5 + 0.5
                                       : vec3(1.0 - clamp(encodedDepth(surface.x), 0.0, 1.0)));
    }
#endif
    color = vec4(kCoded ? srgbFromLinear(color.rgb) : color.rgb, 1.0);
}
