// Hits of spheres and ellipsoids by their numbers. Needs shapeAt(), and countShapes() of the stream.

/// @param index  in its copy, whose rows are selected @param sphere  in view space
Hit ballHitThrough(uint index, vec4 sphere, vec2 q) {
    Hit hit;
    if (kEllipsoids == 0) {
        hit = sphereHitThrough(sphere, q);
    } else {
        uint at = countShapes() - 2u * (view.spheres - index);  // records end the stream
        hit = ellipsoidHitThrough(sphere, rowToView(shapeAt(at)), rowToView(shapeAt(at + 1u)), q);
    }
    return hit;
}
