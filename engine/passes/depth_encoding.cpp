#include "engine/passes/depth_encoding.h"

#include "shaders.h"

namespace nacre::passes {
void encodeDepth(gpu::PassContext& context, const SceneView& view, const Encoding& encoding) {
    PrimitivePass pass;
    pass.encoding = encoding;
    pass.blend = gpu::Blend::minimum;
    drawPrimitives(context, view, Primitive::sphere,
                   {shaders::geometrySphereVertex, {shaders::encodeSphere, shaders::encodeSphereCounting}}, pass);
    drawPrimitives(context, view, Primitive::cylinder,
                   {shaders::geometryCylinderVertex, {shaders::encodeCylinder, shaders::encodeCylinderCounting}}, pass);
    drawPrimitives(context, view, Primitive::triangle,
                   {shaders::geometryTriangleVertex, {shaders::encodeTriangle, shaders::encodeTriangleCounting}}, pass);
}

void encodeDepthInOrder(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, vk::ImageView nearest) {
    const Reads reads{NearestFrom::ownAttachment, atlas, nearest};
    PrimitivePass pass;
    pass.reads = &reads;
    drawPrimitives(
        context, view, Primitive::sphere,
        {shaders::geometrySphereVertex, {shaders::encodeSphereOrdered, shaders::encodeSphereOrderedCounting}}, pass);
    drawPrimitives(
        context, view, Primitive::cylinder,
        {shaders::geometryCylinderVertex, {shaders::encodeCylinderOrdered, shaders::encodeCylinderOrderedCounting}},
        pass);
    drawPrimitives(context, view, Primitive::triangle,
                   {shaders::geometryTriangleReadsVertex,
                    {shaders::encodeTriangleOrdered, shaders::encodeTriangleOrderedCounting}},
                   pass);
}

}  // namespace nacre::passes
