// The four samples of a pixel that a primitive covers, and the place where its fragment is shaded: the middle of those,
// which of a fragment that covers them all is the pixel's. All primitives are convex as they are seen, so that the
// middle is covered, too.

/// @param covered  gets a bit of each sample
vec2 placeOfCovered(out int covered) {
    // "Standard sample locations" of the Vulkan specification, from the pixel's middle.
    const vec2 kA = vec2(-0.125, -0.375), kB = vec2(0.375, -0.125), kC = vec2(-0.375, 0.125), kD = vec2(0.125, 0.375);
    vec2 pixel = gl_FragCoord.xy;
    vec4 inside = vec4(primitiveHitAt(pixel + kA).inside, primitiveHitAt(pixel + kB).inside,
                       primitiveHitAt(pixel + kC).inside, primitiveHitAt(pixel + kD).inside);
    covered = int(dot(inside, vec4(1.0, 2.0, 4.0, 8.0)));
    vec2 sum = kA * inside.x + kB * inside.y + kC * inside.z + kD * inside.w;
    return pixel + sum / max(dot(inside, vec4(1.0)), 1.0);
}
