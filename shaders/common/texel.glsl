// Texels of the occlusion atlas in linear order: all sphere patches, then all cylinder patches, row by row, then vertices.
#include "divide.glsl"
#include "vertex.glsl"

layout(push_constant) uniform Push { OcclusionConstants bake; };
#ifdef TEXELS
layout(set = 0, binding = 0) uniform usamplerBuffer shapeTexels;
uvec4 shapeBits(uint i) { return texelFetch(shapeTexels, int(i)); }
uint countShapes() { return uint(textureSize(shapeTexels)); }
#else
layout(set = 0, binding = 0, std430) readonly buffer Shapes { uvec4 shapes[]; };
uvec4 shapeBits(uint i) { return shapes[i]; }
uint countShapes() { return uint(shapes.length()); }
#endif
vec4 shapeAt(uint i) { return uintBitsToFloat(shapeBits(i)); }

/// The directions of a batch; missing ones are zero and contribute nothing. Addresses are constant (loops are
/// unrolled), so that drivers can load directions once for all invocations. lavapipe 22.3 gathers them lane by lane
/// anyway: with TEXELS each lane of a subgroup fetches its share and passes it on.
layout(constant_id = kBatchId) const int kBatch = 16;
layout(constant_id = kMapsAcrossId) const int kMapsAcross = 4;
#ifdef TEXELS
layout(constant_id = kLanesId) const int kLanes = 8;
layout(set = 0, binding = 1) uniform samplerBuffer directionTexels;  // three per direction
const int kShare = (kBatch + kLanes - 1) / kLanes;
vec4 shareU[kShare], shareV[kShare], shareW[kShare];
void fetchDirections() {
    for (int i = 0; i < kShare; ++i) {
        uint mine = uint(i * kLanes) + gl_SubgroupInvocationID;
        int at = int(bake.firstDirection + 3u * min(mine, uint(kBatch - 1)));
        shareU[i] = texelFetch(directionTexels, at);
        shareV[i] = texelFetch(directionTexels, at + 1);
        shareW[i] = texelFetch(directionTexels, at + 2);
    }
}
vec4 handed(vec4 v, uint from) {
    return vec4(subgroupShuffle(v.x, from), subgroupShuffle(v.y, from), subgroupShuffle(v.z, from),
                subgroupShuffle(v.w, from));
}
Direction loadDirection(int i) {
    uint from = uint(i % kLanes);
    return Direction(handed(shareU[i / kLanes], from), handed(shareV[i / kLanes], from),
                     handed(shareW[i / kLanes], from));
}
/// In larger batches every second direction is opposite to the one before it: a surface faces one of the two.
const int kApart = kBatch > 1 ? 2 : 1;
/// @param i  receives the number of the faced direction of a pair @returns that direction
Direction loadFaced(inout int i, vec3 normal) {
    uint from = uint(i % kLanes);
    int share = i / kLanes;
    if (kApart == 2) {
        vec3 w = vec3(subgroupShuffle(shareW[share].x, from), subgroupShuffle(shareW[share].y, from),
                      subgroupShuffle(shareW[share].z, from));
        uint second = uint(dot(w, normal) < 0.0);
        from += second;
        i += int(second);
    }
    return Direction(handed(shareU[share], from), handed(shareV[share], from), handed(shareW[share], from));
}
#elif defined(NARROW)
layout(set = 0, binding = 1, std140) uniform Directions { NarrowDirections directions; };
void fetchDirections() {}
/// u and v are `pixelsPerAngstrom` long, and v runs downwards.
Direction loadDirection(int i) {
    vec4 u = directions.rows[2 * i], v = directions.rows[2 * i + 1], heights = directions.heights[i / 4];
    return Direction(u, v, vec4(cross(v.xyz, u.xyz) * bake.pixel, heights[i % 4]));
}
#else
layout(set = 0, binding = 1, std140) uniform Directions { Direction directions[kMostDirections]; };
void fetchDirections() {}
Direction loadDirection(int i) { return directions[i]; }
#endif

vec3 turned(Direction d, vec3 p) { return vec3(dot(d.u.xyz, p), dot(d.v.xyz, p), dot(d.w.xyz, p)); }
vec3 placed(Direction d, vec3 p) { return turned(d, p) + vec3(d.u.w, d.v.w, d.w.w); }

layout(constant_id = kEllipsoidsId) const int kEllipsoids = 0;
struct Texel {
    vec3 a;  // object space, Å: sphere centre, foot of the texel on the cylinder's axis, or vertex
    float radius;
    vec3 normal;  // object space, unit; zero: one value for a whole sphere
    vec3 axis;  // unit axis of a cylinder; normal at a vertex
#ifdef BALLS
    mat3 toUnit;  // of an ellipsoid (ellipsoid.glsl)
#endif
};

#ifdef VERTEX
Texel vertexTexel(uint index) {
    uint rest = index - bake.firstVertexTexel;
    uvec4 vertex = shapeBits(bake.firstVertex + rest / 2u);
    Texel t;
    t.a = vertexPosition(vertex, bake.step);
    t.radius = 0.0;
    t.normal = vertexNormal(vertex.z) * (rest % 2u == 0u ? 1.0 : -1.0);
    t.axis = t.normal;
    return t;
}
#else
Texel sphereTexel(uint index) {
    uint edge = bake.sphereEdge;
    uvec2 place = divided(index, edge * edge), local = dividedSmall(place.y, edge);  // row, column
    vec4 sphere = shapeAt(place.x);
    Texel t;
    t.a = sphere.xyz;
    t.radius = sphere.w;
    t.axis = vec3(0.0);
    t.normal = edge == 1u ? vec3(0.0) : octahedralNormal(vec2(local.yx) / float(edge - 1u));
#ifdef BALLS
    t.toUnit = mat3(0.0);
    if (kEllipsoids != 0) {
        uint at = countShapes() - 2u * (bake.spheres - place.x);
        vec4 a = shapeAt(at), b = shapeAt(at + 1u);
        t.toUnit = transpose(mat3(a.xyz, b.xyz, cross(a.xyz, b.xyz) * a.w));
    }
#endif
    return t;
}

Texel cylinderTexel(uint index) {
    uint edge = bake.sphereEdge, around = bake.around, along = bake.along, spheres = bake.spheres;
    uvec2 place = divided(index - ((spheres * edge * edge + 3u) & ~3u), around * along);
    uvec2 local = dividedSmall(place.y, around);  // along the axis, around it
    vec4 a = shapeAt(spheres + 2u * place.x);
    vec3 b = shapeAt(spheres + 2u * place.x + 1u).xyz;
    Texel t;
    t.a = mix(a.xyz, b, float(local.x) / float(along - 1u));
    t.radius = a.w;
    t.axis = normalize(b - a.xyz);
    t.normal = directionAbout(t.axis, float(local.y) / float(around - 1u));
    return t;
}
#endif
