// Texels of the occlusion atlas in linear order: all sphere patches, then all cylinder patches, row by row.
#include "encoding.glsl"

layout(push_constant) uniform Push { OcclusionConstants bake; };

struct Texel {
    vec3 position, normal;  // object space, Å
    vec3 a;                 // sphere's centre or cylinder's first end
    vec3 axis;              // unit axis of a cylinder
    float radius;
    bool cylinder;
    bool whole;             // one value for a whole sphere: its point that faces the direction asked about
};
layout(set = 0, binding = 0, std430) readonly buffer Shapes { vec4 shapes[]; };

Texel texelAt(uint index) {
    Texel t;
    uint edge = uint(bake.patches.x), around = uint(bake.patches.y), along = uint(bake.patches.z);
    uint sphereTexels = (bake.sphereCount * edge * edge + 3u) & ~3u;
    t.cylinder = index >= sphereTexels;
    t.whole = !t.cylinder && edge == 1u;
    if (!t.cylinder) {
        uint shape = index / (edge * edge), local = index % (edge * edge);
        vec4 sphere = shapes[shape];
        t.normal = t.whole ? vec3(0.0) : octahedralNormal(vec2(local % edge, local / edge) / float(edge - 1u));
        t.a = sphere.xyz;
        t.axis = vec3(0.0);
        t.radius = sphere.w;
        t.position = sphere.xyz + sphere.w * t.normal;
        return t;
    }
    uint rest = index - sphereTexels;
    uint shape = rest / (around * along), local = rest % (around * along);
    vec4 a = shapes[bake.sphereCount + 2u * shape];
    vec3 b = shapes[bake.sphereCount + 2u * shape + 1u].xyz;
    t.a = a.xyz;
    t.axis = normalize(b - a.xyz);
    t.radius = a.w;
    t.normal = directionAbout(t.axis, float(local % around) / float(around - 1u));
    t.position = mix(a.xyz, b, float(local / around) / float(along - 1u)) + t.radius * t.normal;
    return t;
}
