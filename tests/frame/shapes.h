#pragma once
// Shapes of frames by a path, for tests that only plan them.

#include "engine/frame/frame.h"
#include "engine/graph/plan.h"

namespace nacre::test {

/// A frame of one colour target by a path, with the finest encoding of depth.
inline FrameShape makeShape(Visibility path, graph::Extent extent) {
    FrameShape shape;
    shape.choice.path = path;
    shape.choice.encoded = graph::encodedFormats()[0];
    if (path == Visibility::tiles) shape.choice.geometry = Geometry::hostLists;
    shape.extent = extent;
    shape.targets = screenTargets(shape.choice);
    return shape;
}

/// The frame of a shape with its targets as outputs.
inline Frame makeFrame(const FrameShape& shape) {
    Frame frame = declareFrame(shape);
    for (const graph::Image target : frame.targets) frame.graph.output(target);
    return frame;
}

}  // namespace nacre::test
