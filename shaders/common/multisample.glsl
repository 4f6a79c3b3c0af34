// Coverage of the four samples of a pixel, and the point at which the fragment is shaded: the mean of the covered
// samples, which is the pixel's centre if all are covered. Projected primitives are convex, so the mean is covered as
// well.

/// @param covered  receives a bit per sample
vec2 placeOfCovered(out int covered) {
    // "Standard sample locations" of the Vulkan specification, relative to the pixel's centre.
    const vec2 kA = vec2(-0.125, -0.375), kB = vec2(0.375, -0.125), kC = vec2(-0.375, 0.125), kD = vec2(0.125, 0.375);
    vec2 pixel = gl_FragCoord.xy;
    vec4 inside = vec4(primitiveHitAt(pixel + kA).inside, primitiveHitAt(pixel + kB).inside,
                       primitiveHitAt(pixel + kC).inside, primitiveHitAt(pixel + kD).inside);
    covered = int(dot(inside, vec4(1.0, 2.0, 4.0, 8.0)));
    vec2 sum = kA * inside.x + kB * inside.y + kC * inside.z + kD * inside.w;
    return pixel + sum / max(dot(inside, vec4(1.0)), 1.0);
}
