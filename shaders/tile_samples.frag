#version 440
// Pixels of a picture from the numbers of the spheres at their 4 x 4 samples, without perspective: shades each sphere
// once, by the mean of its samples' normals, and weights it by their number.
//   TEXELS   as in common/streams.glsl
#extension GL_GOOGLE_include_directive : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 4
#define LOOKS 6
#define MEAN_NORMALS
#ifdef TEXELS
#define CELLS 7
#endif
#include "common/numbered.glsl"
#include "common/span_view.glsl"
#include "common/tile_place.glsl"

#ifdef TEXELS
layout(set = 0, binding = 3) uniform usamplerBuffer numberTexels;
uvec4 numbersAt(uint quad) { return texelFetch(numberTexels, int(quad)); }
#else
layout(set = 0, binding = 3, std430) readonly buffer Numbers { uvec4 numbers[]; };
uvec4 numbersAt(uint quad) { return numbers[quad]; }
#endif
layout(set = 0, binding = 8) uniform sampler2D wanted;
layout(constant_id = kMaskedId) const bool kMasked = false;  // replaces only pixels of a mask
layout(location = 8) flat in uint origin;  // word of the picture's pixel (0, 0)
layout(location = 0) out vec4 color;       // premultiplied

const int kSide = 4;

void main() {
    fetchView();
    if (kMasked && texelFetch(wanted, ivec2(gl_FragCoord.xy), 0).r == 0.0) discard;
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint first = origin + uint(kSide) * (pixel.y * pitch + pixel.x);
    uvec4 sampled[kSide];
    for (int y = 0; y < kSide; ++y) sampled[y] = numbersAt((first + uint(y) * pitch) / 4u);
    vec2 corner = planePoint(float(kSide) * (gl_FragCoord.xy - 0.5) + 0.5);  // the first sample
    vec4 sum = vec4(0.0);
    // lavapipe 22.3 runs the last round of a lane again while others go on: that round must change nothing.
    bool more = true;
    do {
        uint number = 0u;
        for (int y = 0; y < kSide; ++y)
            number = max(number, max(max(sampled[y].x, sampled[y].y), max(sampled[y].z, sampled[y].w)));
        more = number != 0u;
        uint index = place(max(number, 1u));
        vec4 shape = shapeAt(index);
        vec3 center = toView(shape.xyz);
        vec2 from = corner - center.xy;
        vec3 away = vec3(0.0);  // sum of the surface's positions from the centre
        float count = 0.0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                bool same = sampled[y][x] == number;
                vec2 w = from + upright(vec2(x, y)) * vec2(view.pixel, -view.pixel);
                float h = sqrt(max(shape.w * shape.w - dot(w, w), 0.0));
                away += same ? vec3(w, h) : vec3(0.0);
                count += same ? 1.0 : 0.0;
                sampled[y][x] = same ? 0u : sampled[y][x];
            }
        away /= count;
        Hit hit = noHit();
        hit.inside = true;
        hit.Z = view.origin - center.z - away.z;
        hit.normal = away / shape.w;
        Baked baked = shadesOcclusion(hit) ? sphereTexel(index, sphereCoordinate(hit)) : kOpen;
        vec3 light = computeLight(hit, lookAt(2u * index), baked, center.xy + away.xy);
        sum += more ? count * vec4(clamp(light, 0.0, 1.0), 1.0) : vec4(0.0);
    } while (more);
    sum /= float(kSide * kSide);
    color = vec4(srgbFromLinear(sum.rgb), sum.a);
}
