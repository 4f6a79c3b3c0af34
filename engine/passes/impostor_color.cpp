#include "engine/passes/impostor_color.h"

#include "shaders.h"

namespace nacre::passes {
namespace {

/// A variant of shaders/impostor.frag for each kind of primitives.
struct Variant {
    Stage sphere, cylinder, triangle;
};

// The counting variant of a stage has the same name with "Counting" behind it.
#define NACRE_VARIANT(output, path)                                                         \
    Variant {                                                                               \
        {shaders::output##Sphere##path, shaders::output##Sphere##path##Counting},           \
            {shaders::output##Cylinder##path, shaders::output##Cylinder##path##Counting}, { \
            shaders::output##Triangle##path, shaders::output##Triangle##path##Counting      \
        }                                                                                   \
    }
#define NACRE_VARIANTS(path) \
    { NACRE_VARIANT(color, path), NACRE_VARIANT(surface, path), NACRE_VARIANT(identity, path) }

const Variant& variantOf(Output output, NearestFrom from, bool settles) {
    static const Variant kDepthBuffer[] = NACRE_VARIANTS(Fragdepth), kInput[] = NACRE_VARIANTS(Input),
                         kTexture[] = NACRE_VARIANTS(Sampled), kOwn[] = NACRE_VARIANTS(Ordered),
                         kInputSettles[] = NACRE_VARIANTS(InputSettle),
                         kTextureSettles[] = NACRE_VARIANTS(SampledSettle);
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

}  // namespace

void drawImpostorColor(gpu::PassContext& context, const SceneView& view, Output output, const Reads& reads,
                       const Encoding& encoding, bool settles) {
    const bool own = reads.from == NearestFrom::ownAttachment;
    PrimitivePass pass;
    pass.looks = true;
    pass.reads = &reads;
    pass.encoding = encoding;
    pass.depth = reads.from == NearestFrom::depthBuffer || settles ? gpu::DepthUse::write : gpu::DepthUse::test;
    pass.colorsWritten = own ? 2 : 1;  // the nearest depth, too
    const Variant& variant = variantOf(output, reads.from, settles);
    const bool atoms = output == Output::identity;
    drawPrimitives(context, view, Primitive::sphere,
                   {atoms ? shaders::atomSphereVertex : shaders::lookSphereVertex, variant.sphere}, pass);
    drawPrimitives(context, view, Primitive::cylinder,
                   {atoms ? shaders::atomCylinderVertex : shaders::lookCylinderVertex, variant.cylinder}, pass);
    drawPrimitives(context, view, Primitive::triangle,
                   {atoms ? shaders::atomTriangleVertex : shaders::lookTriangleVertex, variant.triangle}, pass);
}

}  // namespace nacre::passes
