#pragma once
// Describes passes over the scene's primitives that several paths, effects or the bake share. primitives.h draws them.

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

/// Shaders of a pass by their names (shaders/shaders.cmake). Users include "shaders.h".
/// @param reads  variant of the triangles' vertex stage: "Reads" if the fragment stage reads
#define NACRE_SHADERS(vertex, reads, fragment, variant)                                        \
    {                                                                                          \
        {shaders::vertex##SphereVertex, NACRE_STAGE(fragment##Sphere##variant)},               \
            {shaders::vertex##CylinderVertex, NACRE_STAGE(fragment##Cylinder##variant)}, {     \
            shaders::vertex##Triangle##reads##Vertex, NACRE_STAGE(fragment##Triangle##variant) \
        }                                                                                      \
    }
/// Shaders that shade, by Output.
#define NACRE_OUTPUTS(variant)                                                          \
    {                                                                                   \
        NACRE_SHADERS(look, , color, variant), NACRE_SHADERS(look, , surface, variant), \
            NACRE_SHADERS(atom, , identity, variant)                                    \
    }
/// Shaders of colour that fetch attributes instead of taking them from varyings.
#define NACRE_FETCHED(variant)                                                                      \
    nacre::passes::FetchedShaders {                                                                 \
        {shaders::lookSphereFetchedVertex, NACRE_STAGE(colorSphereFetched##variant)}, {             \
            shaders::geometryTriangleFetchedReadsVertex, NACRE_STAGE(colorTriangleFetched##variant) \
        }                                                                                           \
    }

namespace nacre::passes {

/// The opaque prepass (paper section 5): depth of flat plates that lie fully inside their primitives.
/// @param triangles  also draw triangles; in a bake they cost more than they save
GeometryPass opaquePrepass(bool triangles);

/// Depth encoding (paper section 3): the nearest depth of every pixel as a colour, by MIN blending.
GeometryPass depthEncoding(const Encoding& encoding);
/// As above without blending: each fragment reads the pixel's value, in raster order.
GeometryPass orderedDepth(const Reads& reads);
/// The nearest depth of every pixel in the depth buffer, by gl_FragDepth, for shadow maps and the bake's depth maps.
GeometryPass nearestDepth();

/// Impostor colour (paper sections 2 to 4) or a layer, by shaders of that output. Depth is tested, not written.
GeometryPass shadingPass(const PrimitiveShaders& shaders, const Reads& reads);

}  // namespace nacre::passes
