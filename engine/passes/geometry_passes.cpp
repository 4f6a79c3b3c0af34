#include "engine/passes/geometry_passes.h"

#include "shaders.h"

namespace nacre::passes {

GeometryPass opaquePrepass(bool triangles) {
    GeometryPass pass{{{shaders::plateVertex, NACRE_STAGE(plateFragment)}, {}, {}}};
    if (triangles) pass.shaders.triangle = {shaders::plateTriangleVertex, NACRE_STAGE(plateFragment)};
    pass.depth = gpu::DepthUse::write;
    pass.colorsWritten = 0;
    pass.plates = true;
    return pass;
}

GeometryPass depthEncoding(const Encoding& encoding) {
    GeometryPass pass{NACRE_SHADERS(geometry, , encode, )};
    pass.fetched.triangle = {shaders::geometryTriangleFetchedVertex, NACRE_STAGE(encodeTriangleFetched)};
    pass.encoding = encoding;
    pass.blend = gpu::Blend::minimum;
    return pass;
}

GeometryPass orderedDepth(const Reads& reads) {
    GeometryPass pass{NACRE_SHADERS(geometry, Reads, encode, Ordered)};
    pass.fetched.triangle = {shaders::geometryTriangleFetchedReadsVertex, NACRE_STAGE(encodeTriangleFetchedOrdered)};
    pass.reads = reads;
    return pass;
}

GeometryPass nearestDepth() {
    GeometryPass pass{NACRE_SHADERS(geometry, , nearest, )};
    pass.fetched.triangle = {shaders::geometryTriangleFetchedVertex, NACRE_STAGE(nearestTriangleFetched)};
    pass.depth = gpu::DepthUse::write;
    pass.colorsWritten = 0;
    return pass;
}

GeometryPass shadingPass(const PrimitiveShaders& shaders, const Reads& reads) {
    GeometryPass pass{shaders};
    pass.looks = true;
    pass.reads = reads;
    return pass;
}

}  // namespace nacre::passes
