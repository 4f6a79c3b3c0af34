#version 440
// Rays through a brick of a density map, front to back, in front of opaque surfaces. A step is at most half a voxel and
// is sampled in its middle. All bricks have the same steps, so that no border shows.
#extension GL_GOOGLE_include_directive : require
#include "common/view.glsl"
#include "common/effects.glsl"

layout(set = 0, binding = 0) uniform sampler3D nodes;
layout(set = 0, binding = 2, std140) uniform Brick { BrickConstants brick; };
#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 3) uniform subpassInput opaque;
float opaqueDepth() { return subpassLoad(opaque).x; }
#else
layout(set = 0, binding = 3) uniform sampler2D opaque;
float opaqueDepth() { return texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).x; }
#endif
layout(set = 0, binding = 4) uniform sampler2D behind;
layout(set = 0, binding = 5) uniform sampler2D before;
layout(constant_id = kBehindLayerId) const bool kBehindLayer = false;
layout(constant_id = kBeforeLayerId) const bool kBeforeLayer = false;
layout(location = 0) out vec4 color;  // linear, premultiplied

/// Z of an encoded depth; beyond the far end if nothing is there.
float decodeDistance(float d) { return d < 1.0 ? view.depthStart + d / view.perRange : kNoPlane; }

/// Colour of a value, and its opacity over 1 Å.
vec4 valueColor(float value) {
    vec4 found = brick.colors[0];
    for (int i = 0; i + 1 < int(brick.first.w); ++i)
        found = mix(found, brick.colors[i + 1], clamp((value - brick.levels[i].x) * brick.levels[i].y, 0.0, 1.0));
    return found;
}

void main() {
    // A ray's point at distance Z is start + Z * way, in nodes.
    vec2 q = planePoint(gl_FragCoord.xy);
    vec3 way = vec3(kPerspective ? q / view.origin : vec2(0.0), -1.0);
    vec3 from = toObject(vec3(kPerspective ? vec2(0.0) : q, view.origin) -
                         vec3(copyRow0.w, copyRow1.w, copyRow2.w));
    vec3 along = toObject(way);
    vec3 start = vec3(dot(brick.nodeX, vec4(from, 1.0)), dot(brick.nodeY, vec4(from, 1.0)),
                      dot(brick.nodeZ, vec4(from, 1.0)));
    vec3 perZ = vec3(dot(brick.nodeX.xyz, along), dot(brick.nodeY.xyz, along), dot(brick.nodeZ.xyz, along));
    perZ = mix(perZ, vec3(1e-7), lessThan(abs(perZ), vec3(1e-7)));
    vec3 a = (brick.first.xyz - start) / perZ, b = (brick.last.xyz - start) / perZ;
    vec3 least = min(a, b), most = max(a, b);
    float begin = max(max(least.x, least.y), least.z), end = min(min(most.x, most.y), most.z);

    if (kPerspective) begin = max(begin, 0.0);
    if (kClip) begin = max(begin, view.clipNear), end = min(end, view.clipFar);
    end = min(end, decodeDistance(opaqueDepth()));
    if (kBehindLayer) begin = max(begin, decodeDistance(texelFetch(behind, ivec2(gl_FragCoord.xy), 0).x));
    if (kBeforeLayer) end = min(end, decodeDistance(texelFetch(before, ivec2(gl_FragCoord.xy), 0).x));
    if (!(begin < end)) discard;
    begin = min(begin, end);  // discarded invocations may continue: without steps

    float angstroms = length(way), stepZ = brick.perSize.w / angstroms;  // of a Z of 1, and of a whole step
    int first = int(floor(begin / stepZ)), last = int(floor(end / stepZ));
    vec3 light = vec3(0.0);
    float through = 1.0;
    for (int i = first; i <= last; ++i) {
        float nearer = max(float(i) * stepZ, begin), farther = min(float(i + 1) * stepZ, end);
        float Z = 0.5 * (nearer + farther);
        vec2 found = textureLod(nodes, (start + Z * perZ + 0.5) * brick.perSize.xyz, 0.0).rg;
        vec4 seen = valueColor(found.r);
        if (brick.last.w > 0.0) seen.a *= clamp(found.g, 0.0, 1.0);
        if (seen.a <= 0.0) continue;
        float hides = 1.0 - pow(1.0 - seen.a, max(farther - nearer, 0.0) * angstroms);
        vec3 shown = kFog ? mix(seen.rgb, effects.fog.rgb, fogAt(Z)) : seen.rgb;
        light += through * hides * shown;
        through *= 1.0 - hides;
        if (through < 0.001) break;
    }
    if (through == 1.0) discard;
    color = vec4(light, 1.0 - through);
}
