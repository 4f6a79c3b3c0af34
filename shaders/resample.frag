#version 440
// A picture at another resolution: the mean of n x n texels in linear light, or, if the picture is not a whole
// multiple of the target, bilinear. With INPUT: the same pixel of an earlier subpass.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/srgb.glsl"

#if defined(INPUT)
layout(input_attachment_index = 0, set = 0, binding = 0) uniform subpassInput picture;
#elif defined(LAYER)
layout(set = 0, binding = 0) uniform sampler2DArray picture;
#else
layout(set = 0, binding = 0) uniform sampler2D picture;
#endif
layout(location = 0) out vec4 color;
layout(constant_id = kSamplesId) const int kSamples = 0;     // n; 0: bilinear
layout(constant_id = kCodedId) const bool kCoded = false;  // the target takes sRGB-coded colour

layout(push_constant) uniform Push {
    vec4 scale;  // xy: 1 / pixels of the part of the target; z: weight of the picture
    vec4 red, green, blue;  // shares of the picture's channels in the target's; red.w, green.w: its corner;
                            // blue.w: layer of the picture, with LAYER
};

#ifdef LAYER
vec3 AT(vec2 place) { return vec3(place, blue.w); }
ivec3 AT(ivec2 texel) { return ivec3(texel, int(blue.w)); }
#else
#define AT(place) place
#endif

void main() {
#ifdef INPUT
    vec3 sum = subpassLoad(picture).rgb;
#else
    vec3 sum = vec3(0.0);
    vec2 place = gl_FragCoord.xy - vec2(red.w, green.w);
    if (kSamples > 0) {
        ivec2 first = ivec2(place) * kSamples;
        for (int j = 0; j < kSamples; ++j)
            for (int i = 0; i < kSamples; ++i) sum += texelFetch(picture, AT(first + ivec2(i, j)), 0).rgb;
        sum /= float(kSamples * kSamples);
    } else {
        sum = textureLod(picture, AT(place * scale.xy), 0.0).rgb;
    }
#endif
    sum = vec3(dot(red.rgb, sum), dot(green.rgb, sum), dot(blue.rgb, sum)) * scale.z;
    color = vec4(kCoded ? srgbFromLinear(sum) : sum, 1.0);
}
