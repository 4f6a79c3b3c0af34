#version 440
// Depth of field. A point away from the focus appears as a circle that grows with its distance from the focus. Light
// spreads within the circle of the nearer of two pixels, so that blurred parts do not spill over a sharp edge in front
// of them, and a blurred edge lets through what is behind.
//   CIRCLES   of each pixel: its light's square root as bytes, and its circle
//   REACH     the largest circles of a block of pixels: of those before the focus, and of all
//   SPREAD    the largest circles that reach into a block
//   SOFT      colour of pixels with large circles, by few samples
//   GATHER    over the picture, what is not sharp: of pixels with large circles the mean of 4 x 4, whose samples are
//             others in each, and what the rest show by many samples
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/srgb.glsl"

layout(push_constant) uniform Push {
    vec4 lens;  // Z of the focus; pixels of radius for each Å (perspective: times Z); largest radius; 1: perspective
    vec4 rim;   // width of outlines, pixels; depth jump of an outline, Å
};

layout(constant_id = kCodedId) const bool kCoded = false;  // picture and result are sRGB-coded
const float kNothing = 1e30;  // Z of the background, as in engine/frame/lens.h
const int kBlock = 16;        // pixels of a block's side

/// Circle of confusion, radius in pixels; negative in front of the focus, so that circles sort by depth.
float circleAt(float Z) { return Z < kNothing ? lens.y * (Z - lens.x) * (lens.w > 0.0 ? 1.0 / Z : 1.0) : kNothing; }
float blurRadius(float circle) { return circle < kNothing ? min(abs(circle), lens.z) : 0.0; }

#if defined(CIRCLES)
layout(set = 0, binding = 0) uniform sampler2D picture;  // premultiplied
layout(set = 0, binding = 1) uniform sampler2D distances;  // Z
layout(location = 0) out uvec2 circle;

float depthAt(ivec2 pixel) {
    return texelFetch(distances, clamp(pixel, ivec2(0), textureSize(distances, 0) - 1), 0).x;
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    float Z = depthAt(here), nearest = Z;
    vec4 seen = texelFetch(picture, here, 0);
    if (kCoded) seen.rgb = linearFromSrgb(seen.rgb);
    // An outline has the depth of the shape that it surrounds, and so has a pixel that is covered only beside its
    // centre.
    bool partly = Z == kNothing && seen.a > 0.0;
    float room = partly ? rim.x + 1.5 : rim.x > 0.0 ? rim.x + 0.5 : 0.0;
    // Rings of twelve samples around the pixel: outlined shapes are wider than the gaps. A float counter, because
    // compilers unroll integer loops: 15 to 20 ms more for the pipeline on lavapipe.
    const mat2 next = mat2(0.8660254, 0.5, -0.5, 0.8660254);
    float rings = min(ceil(room / 3.0), 4.0);
    vec2 way = vec2(room / max(rings, 1.0), 0.0);
    for (float left = 12.0 * rings; left > 0.0; --left) {
        vec2 away = ceil(left / 12.0) * way;
        nearest = min(nearest, depthAt(here + ivec2(away + 0.2 * sign(away))));
        way = next * way;
    }
    circle = uvec2(packUnorm4x8(sqrt(seen)), floatBitsToUint(circleAt(nearest < Z - rim.y ? nearest : Z)));
}
#elif defined(REACH)
layout(set = 0, binding = 0) uniform usampler2D circles;
layout(location = 0) out uvec2 reach;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * kBlock;
    ivec2 last = min(first + kBlock, textureSize(circles, 0));
    vec2 largest = vec2(0.0);
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x) {
            float circle = uintBitsToFloat(texelFetch(circles, ivec2(x, y), 0).y), radius = blurRadius(circle);
            largest = max(largest, vec2(circle < 0.0 ? radius : 0.0, radius));
        }
    reach = floatBitsToUint(largest);
}
#elif defined(SPREAD)
layout(set = 0, binding = 0) uniform usampler2D blocks;
layout(location = 0) out uvec2 reach;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(blocks, 0) - 1;
    int most = int(ceil(lens.z / float(kBlock)));
    vec2 largest = vec2(0.0);
    for (int y = -most; y <= most; ++y)
        for (int x = -most; x <= most; ++x) {
            ivec2 other = here + ivec2(x, y);
            if (other != clamp(other, ivec2(0), last)) continue;
            vec2 radius = uintBitsToFloat(texelFetch(blocks, other, 0).xy);
            vec2 between = float(kBlock) * max(abs(vec2(x, y)) - 1.0, 0.0);
            largest = max(largest, mix(vec2(0.0), radius, greaterThanEqual(radius, vec2(length(between)))));
        }
    reach = floatBitsToUint(largest);
}
#else
layout(set = 0, binding = 0) uniform usampler2D circles;
layout(set = 0, binding = 1) uniform usampler2D blocks;
layout(location = 0) out vec4 color;

const float kSharp = 0.6;  // pixels: smaller circles count as sharp
const float kSoft = 2.5;  // pixels: larger circles need no detail below 4 x 4
const float kGolden = 2.399963;
const mat2 kSixteenth = mat2(0.9238795, 0.3826834, -0.3826834, 0.9238795);  // a sixteenth of a turn
const mat2 kEighth = mat2(0.7071068, 0.7071068, -0.7071068, 0.7071068);
const float kSquare = 255.0 * 255.0;  // square of a byte that is 1: light is summed as squared bytes

#if defined(SOFT)
const float kMiddle = -0.5;  // offset of a 4 x 4 mean from the pixel that it is stored at
#else
const float kMiddle = 0.0;
layout(set = 0, binding = 2) uniform sampler2D soft;  // square roots of light; (1, 1, 1, 0): no value

bool isSoft(vec4 pixel) { return pixel.r <= pixel.a; }

/// The mean of the valid values of 4 x 4 pixels around.
vec4 meanAround(ivec2 here, ivec2 last) {
    vec4 sum = vec4(0.0);
    float count = 0.0;
    for (float i = 0.0; i < 16.0; ++i) {
        int k = int(i);
        vec4 root = texelFetch(soft, clamp(here + ivec2(k & 3, k >> 2) - 1, ivec2(0), last), 0);
        if (!isSoft(root)) continue;
        sum += root * root;
        ++count;
    }
    return sum / count;
}
#endif

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(circles, 0) - 1;
    uvec2 own = texelFetch(circles, here, 0).xy;
    vec2 reaches = uintBitsToFloat(texelFetch(blocks, here / kBlock, 0).xy);
    float circle = uintBitsToFloat(own.y), radius = blurRadius(circle);
    // In front of the focus only, nearer points have larger circles; over the background all contribute.
    float reach = circle < kNothing ? max(radius, reaches.x) : reaches.y;
    float end = 1.0;
#if defined(SOFT)
    float samples = clamp(floor(2.0 + 0.9 * reach), 4.0, 10.0);
    if ((circle < kNothing ? radius : reach) < kSoft) {
        end = 0.0;
        discard;
    }
#else
    float samples = clamp(floor(4.0 + 2.5 * reach), 8.0, 48.0);
    vec4 around = vec4(0.0);
    bool ofSoft = isSoft(texelFetch(soft, here, 0));
    if (ofSoft) {
        end = 0.0;
        around = meanAround(here, last);
    }
    if (reach < kSharp) {
        end = 0.0;
        discard;
    }
#endif

    // Light that nearer pixels spread over this one, then the light of this and farther ones.
    float ownArea = max(3.14159 * radius * radius, 1.0);
    vec4 root = unpackUnorm4x8(own.x);
    vec4 near = vec4(0.0), all = root * root * kSquare / ownArea;
    float nearShare = 0.0, allShare = 1.0 / ownArea;
    float perSample = 1.0 / samples;
    // Neighbours in a block of 16 take different samples.
    ivec2 cell = here & 3;
    int order = (cell.x * 5 + cell.y * 3 + 7 * (cell.x ^ cell.y)) & 15;
    vec2 way = vec2(reach, 0.0);
    way = (order & 1) != 0 ? kSixteenth * way : way;
    way = (order & 2) != 0 ? kEighth * way : way;
    way = (order & 4) != 0 ? vec2(-way.y, way.x) : way;
    way = (order & 8) != 0 ? -way : way;
    const mat2 further = mat2(cos(kGolden), sin(kGolden), -sin(kGolden), cos(kGolden));
    float areaOut = 6.28318 * perSample * reach * reach, spacingOut = 0.5 * sqrt(areaOut);
    for (float t = perSample * (float((order * 7 + 4) & 15) + 0.5) / 16.0; t < end; t += perSample) {
        // Denser at the centre, where small circles are. Approximately the square root of t.
        float away = reach * t, spacing = max(spacingOut * (0.19 + 0.85 * t), 1.0);
        uvec2 other = texelFetch(circles, clamp(here + ivec2(round(t * way + kMiddle)), ivec2(0), last), 0).xy;
        way = further * way;
        float otherCircle = uintBitsToFloat(other.y);
        bool nearer = otherCircle < circle;
        float within = nearer ? min(abs(otherCircle), lens.z) : radius;
        float inside = clamp(within - away + 0.5 * spacing, 0.0, spacing);
        float weight = areaOut * t * inside / (max(3.14159 * within * within, 1.0) * spacing);
        weight = within < kSharp ? 0.0 : weight;
        vec4 bytes = vec4(other.x & 255u, other.x >> 8 & 255u, other.x >> 16 & 255u, other.x >> 24);
        bytes *= bytes;
        all += bytes * weight;
        allShare += weight;
        weight = nearer ? weight : 0.0;
        near += bytes * weight;
        nearShare += weight;
    }
#if defined(GATHER)
    if (!ofSoft && nearShare == 0.0 && radius < kSharp) discard;
#endif
    vec4 far = max(all - near, vec4(0.0)) / max(allShare - nearShare, 1e-6);
    color = (near / max(nearShare, 1.0) + (1.0 - min(nearShare, 1.0)) * far) / kSquare;
#if defined(SOFT)
    color = sqrt(color);
#else
    if (ofSoft) color = around;
    if (kCoded) color.rgb = srgbFromLinear(color.rgb);
#endif
}
#endif
