#include "engine/passes/geometry_passes.h"

#include "shaders.h"

namespace nacre::passes {
namespace {

/// @param reads  of the vertex stage of triangles, where the fragment stage reads: "Reads"
#define NACRE_SHADERS(vertex, reads, fragment, variant)                                        \
    {                                                                                          \
        {shaders::vertex##SphereVertex, NACRE_STAGE(fragment##Sphere##variant)},               \
            {shaders::vertex##CylinderVertex, NACRE_STAGE(fragment##Cylinder##variant)}, {     \
            shaders::vertex##Triangle##reads##Vertex, NACRE_STAGE(fragment##Triangle##variant) \
        }                                                                                      \
    }
/// By Output.
#define NACRE_OUTPUTS(variant)                                                          \
    {                                                                                   \
        NACRE_SHADERS(look, , color, variant), NACRE_SHADERS(look, , surface, variant), \
            NACRE_SHADERS(atom, , identity, variant)                                    \
    }

/// Shaders of colour that state the samples of a pixel that they cover.
const PrimitiveShaders& multisampledShaders(NearestFrom from) {
    static const PrimitiveShaders kDepthBuffer = NACRE_SHADERS(look, , color, FragdepthMultisampled),
                                  kOwn = NACRE_SHADERS(look, , color, OrderedMultisampled);
    return from == NearestFrom::ownAttachment ? kOwn : kDepthBuffer;
}

const PrimitiveShaders& impostorShaders(Output output, NearestFrom from, bool settles) {
    static const PrimitiveShaders kDepthBuffer[] = NACRE_OUTPUTS(Fragdepth), kInput[] = NACRE_OUTPUTS(Input),
                                  kTexture[] = NACRE_OUTPUTS(Sampled), kOwn[] = NACRE_OUTPUTS(Ordered),
                                  kInputSettles[] = NACRE_OUTPUTS(InputSettle),
                                  kTextureSettles[] = NACRE_OUTPUTS(SampledSettle);
    const auto at = static_cast<std::size_t>(output);
    switch (from) {
        case NearestFrom::depthBuffer:
            return kDepthBuffer[at];
        case NearestFrom::ownAttachment:
            return kOwn[at];
        case NearestFrom::texture:
            return (settles ? kTextureSettles : kTexture)[at];
        case NearestFrom::inputAttachment:
            break;
    }
    return (settles ? kInputSettles : kInput)[at];
}

#define NACRE_FETCHED(variant)                                                            \
    FetchedShaders {                                                                      \
        {shaders::lookSphereFetchedVertex, {shaders::colorSphereFetched##variant, {}}}, { \
            shaders::geometryTriangleFetchedReadsVertex, {                                \
                shaders::colorTriangleFetched##variant, {}                                \
            }                                                                             \
        }                                                                                 \
    }

FetchedShaders fetchedShaders(NearestFrom from, bool settles) {
    switch (from) {
        case NearestFrom::depthBuffer:
            return NACRE_FETCHED(Fragdepth);
        case NearestFrom::ownAttachment:
            return NACRE_FETCHED(Ordered);
        case NearestFrom::texture:
            return settles ? NACRE_FETCHED(SampledSettle) : NACRE_FETCHED(Sampled);
        case NearestFrom::inputAttachment:
            break;
    }
    return settles ? NACRE_FETCHED(InputSettle) : NACRE_FETCHED(Input);
}

}  // namespace

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
    pass.fetched.triangle = {shaders::geometryTriangleFetchedVertex, {shaders::encodeTriangleFetched, {}}};
    pass.encoding = encoding;
    pass.blend = gpu::Blend::minimum;
    return pass;
}

GeometryPass orderedDepth(const Reads& reads) {
    GeometryPass pass{NACRE_SHADERS(geometry, Reads, encode, Ordered)};
    pass.fetched.triangle = {shaders::geometryTriangleFetchedReadsVertex, {shaders::encodeTriangleFetchedOrdered, {}}};
    pass.reads = reads;
    return pass;
}

GeometryPass nearestDepth() {
    GeometryPass pass{NACRE_SHADERS(geometry, , nearest, )};
    pass.fetched.triangle = {shaders::geometryTriangleFetchedVertex, {shaders::nearestTriangleFetched, {}}};
    pass.depth = gpu::DepthUse::write;
    pass.colorsWritten = 0;
    return pass;
}

GeometryPass multisampledColor(const Reads& reads) {
    GeometryPass pass = impostorColor(Output::color, reads);
    pass.shaders = multisampledShaders(reads.from);
    pass.fetched = {};
    return pass;
}

GeometryPass impostorColor(Output output, const Reads& reads, const Encoding& encoding, bool settles) {
    GeometryPass pass{impostorShaders(output, reads.from, settles)};
    if (output == Output::color) pass.fetched = fetchedShaders(reads.from, settles);
    pass.looks = true;
    pass.reads = reads;
    pass.encoding = encoding;
    pass.depth = reads.from == NearestFrom::depthBuffer || settles ? gpu::DepthUse::write : gpu::DepthUse::test;
    pass.colorsWritten = reads.from == NearestFrom::ownAttachment ? 2 : 1;  // also the nearest depth
    return pass;
}

GeometryPass nearestPrimitive(bool distance) {
    GeometryPass pass{NACRE_SHADERS(number, , identify, )};
    if (distance) pass.shaders = NACRE_SHADERS(number, , identify, Distance);
    pass.depth = gpu::DepthUse::write;
    return pass;
}

GeometryPass rims(const SceneView& view, const Reads& reads) {
    GeometryPass pass{NACRE_SHADERS(number, Reads, rims, Input)};
    if (reads.from == NearestFrom::texture) pass.shaders = NACRE_SHADERS(number, Reads, rims, Sampled);
    pass.reads = reads;
    pass.streams = true;
    pass.rim = view.rims.widest();
    pass.blend = gpu::Blend::maximum;
    return pass;
}

GeometryPass overdraw() {
    GeometryPass pass{NACRE_SHADERS(geometry, , overdraw, )};
    pass.blend = gpu::Blend::add;
    return pass;
}

GeometryPass translucentLayer(const std::optional<Reads>& before) {
    GeometryPass pass{{{}, {}, {shaders::numberTriangleVertex, NACRE_STAGE(identifyTriangle)}}};
    if (before) pass.shaders.triangle = {shaders::numberTriangleReadsVertex, NACRE_STAGE(peelTriangle)};
    pass.depth = gpu::DepthUse::write;
    pass.reads = before;
    return pass;
}

}  // namespace nacre::passes
