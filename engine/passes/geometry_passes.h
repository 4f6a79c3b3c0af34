#pragma once
// The passes over the scene's primitives: what each of them does. primitives.h draws them.

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// The opaque prepass (paper section 5): depth of flat plates that lie wholly inside their primitives.
/// @param triangles  have some, too; they cost a bake more than what they hide
GeometryPass opaquePrepass(bool triangles);

/// Depth encoding (paper section 3): the nearest depth of every pixel as a colour, kept by a MIN blend.
GeometryPass depthEncoding(const Encoding& encoding);
/// The same without blending: each fragment reads what the pixel holds, in raster order.
GeometryPass orderedDepth(const Reads& reads);
/// The nearest depth of every pixel in the depth buffer, by gl_FragDepth: depth maps of the bake.
GeometryPass nearestDepth();

/// Impostor colour (paper sections 2 to 4), or a layer: each hit that is its pixel's nearest is written.
/// @param settles  encoded depth is coarse (graph::EncodedFormat::settles): the depth buffer settles what it leaves
/// open
GeometryPass impostorColor(Output output, const Reads& reads, const Encoding& encoding = {}, bool settles = false);

/// The number of every pixel's nearest primitive, counted from 1 over all copies, and its depth by gl_FragDepth.
/// @param distance  its Z stands beside the number
GeometryPass nearestPrimitive(bool distance);

/// Lines by groups and halos about every primitive, as what stands behind decides: for each pixel whether there is a
/// line, how clear of fog it is, and the density of a halo.
/// @param reads  `nearest` holds numbers and distances, as an input attachment or a texture
GeometryPass rims(const SceneView& view, const Reads& reads);

/// How many fragments of impostors pass the depth test in every pixel: 1/255 each, added up.
GeometryPass overdraw();

/// A layer of translucent triangles: those that are nearest behind another one. @param before  its depth; none: the
/// first
GeometryPass translucentLayer(const std::optional<Reads>& before);

}  // namespace nacre::passes
