// A triangle of the streams of a geometry pass.
#include "fetch.glsl"
#include "mesh.glsl"

/// @param index  among the triangles of a copy
Facet loadFacet(uint index) {
    uvec4 record = shapes[view.spheres + 2u * view.cylinders + index];
    return facetFrom(shapes[record.x], shapes[record.y], shapes[record.z], record, view.primitives + view.cylinders);
}
