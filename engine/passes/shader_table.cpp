#include "engine/passes/shader_table.h"

#include "shaders.h"

namespace nacre::passes {
namespace {

using Words = std::span<const std::uint32_t>;

// The counting variant of a stage has the same name with "Counting" behind it.
#define NACRE_STAGE(name) (key.counting ? Words(shaders::name##Counting) : Words(shaders::name))
#define NACRE_PRIMITIVE(before, after) \
    (key.primitive == Primitive::sphere ? NACRE_STAGE(before##Sphere##after) : NACRE_STAGE(before##Cylinder##after))
#define NACRE_SHADING(output)                                                                               \
    if (key.primitive == Primitive::screen)                                                                 \
        return key.sampled ? NACRE_STAGE(output##DeferredSampled) : NACRE_STAGE(output##DeferredInput);     \
    if (key.nearest == Nearest::fragdepth) return NACRE_PRIMITIVE(output, Fragdepth);                       \
    if (key.nearest == Nearest::rasterOrder && !key.sampled) return NACRE_PRIMITIVE(output, Ordered);       \
    if (key.settle)                                                                                         \
        return key.sampled ? NACRE_PRIMITIVE(output, SampledSettle) : NACRE_PRIMITIVE(output, InputSettle); \
    return key.sampled ? NACRE_PRIMITIVE(output, Sampled) : NACRE_PRIMITIVE(output, Input)

Words colorShader(const ShaderKey& key) { NACRE_SHADING(color); }
Words surfaceShader(const ShaderKey& key) { NACRE_SHADING(surface); }
Words identityShader(const ShaderKey& key) { NACRE_SHADING(identity); }

}  // namespace

Words fragmentShader(const ShaderKey& key) {
    switch (key.writes) {
        case Writes::plates:
            return NACRE_STAGE(plateFragment);
        case Writes::encoded:
            return key.nearest == Nearest::rasterOrder ? NACRE_PRIMITIVE(encode, Ordered) : NACRE_PRIMITIVE(encode, );
        case Writes::depth:
            return NACRE_PRIMITIVE(nearest, );
        case Writes::number:
            return NACRE_PRIMITIVE(identify, );
        case Writes::overdraw:
            return NACRE_PRIMITIVE(overdraw, );
        case Writes::color:
            return colorShader(key);
        case Writes::surface:
            return surfaceShader(key);
        case Writes::identity:
            return identityShader(key);
    }
    return {};
}

Words vertexShader(const ShaderKey& key) {
    if (key.writes == Writes::plates) return shaders::plateVertex;
    if (key.primitive == Primitive::screen) return shaders::screenVertex;
    const bool sphere = key.primitive == Primitive::sphere;
    if (key.writes == Writes::number)
        return sphere ? Words(shaders::numberSphereVertex) : Words(shaders::numberCylinderVertex);
    if (shades(key.writes)) return sphere ? Words(shaders::lookSphereVertex) : Words(shaders::lookCylinderVertex);
    return sphere ? Words(shaders::geometrySphereVertex) : Words(shaders::geometryCylinderVertex);
}

const char* nameOf(Writes writes) {
    switch (writes) {
        case Writes::plates:
            return "opaque prepass";
        case Writes::encoded:
            return "depth encoding";
        case Writes::depth:
            return "nearest depth";
        case Writes::number:
            return "nearest primitive";
        case Writes::overdraw:
            return "overdraw";
        case Writes::color:
            return "impostor colour";
        case Writes::surface:
            return "surface layer";
        case Writes::identity:
            return "identity layer";
    }
    return "";
}

}  // namespace nacre::passes
