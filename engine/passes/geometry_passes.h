#pragma once
// Describes the passes over the scene's primitives. primitives.h draws them.

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// The opaque prepass (paper section 5): depth of flat plates that lie fully inside their primitives.
/// @param triangles  draw them as well; in a bake they cost more than they save
GeometryPass opaquePrepass(bool triangles);

/// Depth encoding (paper section 3): the nearest depth of every pixel as a colour, by MIN blending.
GeometryPass depthEncoding(const Encoding& encoding);
/// As above without blending: each fragment reads the pixel's value, in raster order.
GeometryPass orderedDepth(const Reads& reads);
/// The nearest depth of every pixel in the depth buffer, by gl_FragDepth: depth maps of the bake.
GeometryPass nearestDepth();

/// Impostor colour (paper sections 2 to 4), or a layer: writes each pixel's nearest hit.
/// @param settles  encoded depth is coarse (graph::EncodedFormat::settles): the depth buffer resolves ties
GeometryPass impostorColor(Output output, const Reads& reads, const Encoding& encoding = {}, bool settles = false);

/// Colour with kMultisamples samples per pixel. A primitive has one fragment per pixel, which states the samples that
/// it covers. That fragment has one depth: where primitives cut into each other, the line is as jagged as with one
/// sample.
/// @param reads  nearest depth from the depth buffer or the pass's own attachment
GeometryPass multisampledColor(const Reads& reads);

/// The number of every pixel's nearest primitive, counted from 1 over all copies, and its depth by gl_FragDepth.
/// @param distance  also store its Z next to the number
GeometryPass nearestPrimitive(bool distance);

/// Outlines by group and halos around every primitive, which depend on the surface behind: per pixel whether there is
/// an outline, how free of fog it is, and the density of a halo.
/// @param reads  `nearest` holds numbers and distances, as an input attachment or a texture
GeometryPass rims(const SceneView& view, const Reads& reads);

/// Number of impostor fragments per pixel that pass the depth test, in steps of 1/255.
GeometryPass overdraw();

/// A layer of translucent triangles: the nearest behind the previous layer.
/// @param before  depth of the previous layer; none: the first layer
GeometryPass translucentLayer(const std::optional<Reads>& before);

}  // namespace nacre::passes
