#version 440
// A picture at another resolution: the mean of n x n texels in linear light, or, if the picture is not a whole
// multiple of the target, bilinear.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/srgb.glsl"

layout(set = 0, binding = 0) uniform sampler2D picture;
layout(location = 0) out vec4 color;
layout(constant_id = kSamplesId) const int kSamples = 0;     // n; 0: bilinear
layout(constant_id = kCodedId) const bool kCoded = false;  // the target takes sRGB-coded colour

layout(push_constant) uniform Push { vec4 scale; };  // xy: 1 / pixels of the target; z: weight of the picture

void main() {
    vec3 sum = vec3(0.0);
    if (kSamples > 0) {
        ivec2 first = ivec2(gl_FragCoord.xy) * kSamples;
        for (int j = 0; j < kSamples; ++j)
            for (int i = 0; i < kSamples; ++i) sum += texelFetch(picture, first + ivec2(i, j), 0).rgb;
        sum /= float(kSamples * kSamples);
    } else {
        sum = textureLod(picture, gl_FragCoord.xy * scale.xy, 0.0).rgb;
    }
    sum *= scale.z;
    color = vec4(kCoded ? srgbFromLinear(sum) : sum, 1.0);
}
