#include "engine/passes/depth_encoding.h"

#include "shaders.h"

namespace nacre::passes {
void encodeDepth(gpu::PassContext& context, const SceneView& view, const Encoding& encoding) {
    PrimitivePass pass;
    pass.encoding = encoding;
    pass.blend = gpu::Blend::minimum;
    drawImpostors(context, view, pass,
                  {shaders::geometrySphereVertex, {shaders::encodeSphere, shaders::encodeSphereCounting}},
                  {shaders::geometryCylinderVertex, {shaders::encodeCylinder, shaders::encodeCylinderCounting}});
}

void encodeDepthInOrder(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, vk::ImageView nearest) {
    const Reads reads{NearestFrom::ownAttachment, atlas, nearest};
    PrimitivePass pass;
    pass.reads = &reads;
    drawImpostors(
        context, view, pass,
        {shaders::geometrySphereVertex, {shaders::encodeSphereOrdered, shaders::encodeSphereOrderedCounting}},
        {shaders::geometryCylinderVertex, {shaders::encodeCylinderOrdered, shaders::encodeCylinderOrderedCounting}});
}

}  // namespace nacre::passes
