#version 450
// Depth of field: what lies before or behind the focus is as blurred as a lens shows it. A point is seen as a circle
// that grows with its distance from the focus. Light goes from pixel to pixel within the circle of the nearer of the
// two: so nothing blurred shines over a sharp edge before it, and a blurred edge lets through what lies behind.
//   CIRCLES   of each pixel: its light's square root as bytes, and Z, which tells its circle
//   REACH     the largest circle of a block of pixels
//   SPREAD    the largest circle that reaches into a block
//   GATHER    the picture
#extension GL_GOOGLE_include_directive : require

layout(push_constant) uniform Push {
    vec4 lens;  // Z of the focus; pixels of radius for each Å (perspective: times Z); largest radius; 1: perspective
    vec4 rim;   // width of outlines, pixels; depth jump of an outline, Å
};

const float kNothing = 1e30;  // Z of an empty pixel
const int kBlock = 16;        // pixels of a block's side

/// Of the circle that a point is seen as, pixels.
float radiusAt(float Z) {
    float radius = lens.y * abs(Z - lens.x) * (lens.w > 0.0 ? 1.0 / Z : 1.0);
    return Z < kNothing ? min(radius, lens.z) : 0.0;
}

#if defined(CIRCLES)
layout(set = 0, binding = 0) uniform sampler2D picture;  // linear, premultiplied
layout(set = 0, binding = 1) uniform sampler2D surface;  // normal, Z
layout(location = 0) out uvec2 circle;

float depthAt(ivec2 pixel) {
    vec4 seen = texelFetch(surface, clamp(pixel, ivec2(0), textureSize(surface, 0) - 1), 0);
    return seen.xyz != vec3(0.0) ? seen.w : kNothing;
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    float Z = depthAt(here), front = Z;
    vec4 seen = texelFetch(picture, here, 0);
    // An outline is as far away as what it bounds, and so is a pixel that something covers beside its centre.
    bool partly = Z == kNothing && seen.a > 0.0;
    float room = partly ? rim.x + 1.5 : rim.x > 0.0 ? rim.x + 0.5 : 0.0;
    int most = int(min(ceil(room), 4.0));
    for (int y = -most; y <= most; ++y)
        for (int x = -most; x <= most; ++x) {
            vec2 away = vec2(x, y) * max(room / float(most), 1.0);
            float other = dot(away, away) <= room * room ? depthAt(here + ivec2(round(away))) : Z;
            front = other < Z - rim.y ? min(front, other) : front;
        }
    circle = uvec2(packUnorm4x8(sqrt(seen)), floatBitsToUint(front));
}
#elif defined(REACH)
layout(set = 0, binding = 0) uniform usampler2D circles;
layout(location = 0) out vec4 reach;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * kBlock;
    ivec2 last = min(first + kBlock, textureSize(circles, 0));
    float largest = 0.0;
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x)
            largest = max(largest, radiusAt(uintBitsToFloat(texelFetch(circles, ivec2(x, y), 0).y)));
    reach = vec4(largest);
}
#elif defined(SPREAD)
layout(set = 0, binding = 0) uniform sampler2D blocks;
layout(location = 0) out vec4 reach;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(blocks, 0) - 1;
    int most = int(ceil(lens.z / float(kBlock)));
    float largest = 0.0;
    for (int y = -most; y <= most; ++y)
        for (int x = -most; x <= most; ++x) {
            ivec2 other = here + ivec2(x, y);
            if (other != clamp(other, ivec2(0), last)) continue;
            float radius = texelFetch(blocks, other, 0).r;
            vec2 between = float(kBlock) * max(abs(vec2(x, y)) - 1.0, 0.0);
            largest = max(largest, radius >= length(between) ? radius : 0.0);
        }
    reach = vec4(largest);
}
#else
layout(set = 0, binding = 0) uniform sampler2D picture;
layout(set = 0, binding = 1) uniform usampler2D circles;
layout(set = 0, binding = 2) uniform sampler2D blocks;
layout(location = 0) out vec4 color;

const float kSharp = 0.6;  // pixels: smaller circles are none
const float kGolden = 2.399963;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(circles, 0) - 1;
    color = texelFetch(picture, here, 0);
    float reach = texelFetch(blocks, here / kBlock, 0).r;
    if (reach < kSharp) return;
    float Z = uintBitsToFloat(texelFetch(circles, here, 0).y), radius = radiusAt(Z);

    // Light that the nearer pixels spread over this one, and the light of this and farther ones.
    float ownArea = max(3.14159 * radius * radius, 1.0);
    vec4 near = vec4(0.0), far = color / ownArea;
    float nearShare = 0.0, farShare = 1.0 / ownArea;
    float samples = clamp(floor(4.0 + 3.0 * reach), 8.0, 56.0), perSample = 1.0 / samples;
    // Sixteen neighbours take different samples.
    ivec2 cell = here & 3;
    float turn = kGolden / 16.0 * samples * float((cell.x * 5 + cell.y * 3 + 7 * (cell.x ^ cell.y)) & 15);
    vec2 way = reach * vec2(cos(turn), sin(turn));
    const mat2 further = mat2(cos(kGolden), sin(kGolden), -sin(kGolden), cos(kGolden));
    for (float t = 0.5 * perSample; t < 1.0; t += perSample) {
        // Denser at the centre, where small circles lie.
        float away = reach * t, area = 6.28318 * perSample * reach * away;
        uvec2 other = texelFetch(circles, clamp(here + ivec2(round(t * way)), ivec2(0), last), 0).xy;
        way = further * way;
        float otherZ = uintBitsToFloat(other.y);
        bool nearer = otherZ < Z;
        float within = nearer ? radiusAt(otherZ) : radius;
        float spacing = max(0.5 * sqrt(area), 1.0);
        float weight = area / max(3.14159 * within * within, 1.0) * clamp((within - away) / spacing + 0.5, 0.0, 1.0);
        weight = within < kSharp ? 0.0 : weight;
        vec4 light = unpackUnorm4x8(other.x);
        light *= light * weight;
        near += nearer ? light : vec4(0.0);
        nearShare += nearer ? weight : 0.0;
        far += nearer ? vec4(0.0) : light;
        farShare += nearer ? 0.0 : weight;
    }
    if (nearShare == 0.0 && radius < kSharp) return;
    near /= max(nearShare, 1.0);
    color = near + (1.0 - min(nearShare, 1.0)) * far / farShare;
}
#endif
