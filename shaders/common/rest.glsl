// Translucent primitives behind the layers in order: sums over a pixel, in any order (M. McGuire and L. Bavoil 2013,
// "Weighted Blended Order-Independent Transparency"). Optical depths add up, so that the rest hides exactly what its
// layers hide. Its colour is a mean of theirs. A layer's weight is the light that comes through what probably lies
// between it and the last layer in order: as many layers of its own opacity as the scene has on the way, on average.
// Needs color.glsl and layers.glsl.

/// The part of one hit in the sums. Parts are multiples of kRestStep: 32-bit sums do not depend on the order.
struct RestPart {
    vec4 color;  // weighted colour, weight
    float depth;  // optical depth
};
const float kRestStep = 1.0 / 65536.0;
const float kLeastWeight = 1.0 / 256.0;
const float kOpaqueDepth = 16.0;  // bits

/// @param opacity  of the layer @param behind  distance from the last layer in order, encoded depth
RestPart restPart(vec3 lit, float opacity, float behind) {
    // In bits: a layer of opacity 0.5 has 1.
    precise float depth = opacity < 1.0 ? -log2(1.0 - opacity) : kOpaqueDepth;
    precise float layers = behind * (effects.layersPerLength / view.perRange);
    precise float weight = max(exp2(-depth * layers), kLeastWeight) * opacity;
    precise vec4 steps = floor(vec4(lit * weight, weight) * (1.0 / kRestStep) + 0.5);
    precise float depthSteps = floor(depth * (1.0 / kRestStep) + 0.5);
    return RestPart(steps * kRestStep, depthSteps * kRestStep);
}

/// Of a triangle's hit on its edge: whether it belongs to this one of the two triangles there, which have the edge in
/// opposite directions.
bool ownsEdge(vec3 a, vec3 b, vec3 c, vec2 q) {
    precise vec2 pa = a.xy - q, pb = b.xy - q, pc = c.xy - q;
    precise float ofA = edgeSide(pb, pc), ofB = edgeSide(pc, pa), ofC = edgeSide(pa, pb);
    bool turned = ofA + ofB + ofC < 0.0, owns = true;
    precise vec2 bc = pc - pb, ca = pa - pc, ab = pb - pa;
    if (ofA == 0.0) owns = owns && turned != (bc.y > 0.0 || (bc.y == 0.0 && bc.x > 0.0));
    if (ofB == 0.0) owns = owns && turned != (ca.y > 0.0 || (ca.y == 0.0 && ca.x > 0.0));
    if (ofC == 0.0) owns = owns && turned != (ab.y > 0.0 || (ab.y == 0.0 && ab.x > 0.0));
    return owns;
}
