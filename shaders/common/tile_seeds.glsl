// Initial hits of pixels that the host found (engine/software/front_triangles.h, front_spheres.h).

/// A pixel starts with the nearest triangle or sphere if the host found it; lists then omit that primitive. Without
/// lists it stays, however the device rounds: nothing else could fill the pixel.
void begin(int i, uint seed, Hit hit) {
    float depth = encodedDepth(hit.order);
    bool sees = seed != 0u && (!kListed || (hit.inside && depth < nearest[i]));
    nearest[i] = sees ? depth : nearest[i];
    number[i] = sees ? seed : 0u;
}
#ifdef TRIANGLES
/// Fetches all triangles before using any, so that memory reads overlap.
void beginAll(uint seeds[kPixels]) {
    uvec4 record[kPixels], a[kPixels], b[kPixels], c[kPixels];
    for (int i = 0; i < kPixels; ++i)
        record[i] = shapeBits(place(seeds[i] == 0u ? view.spheres + view.cylinders + 1u : seeds[i]) + view.cylinders);
    for (int i = 0; i < kPixels; ++i) {
        a[i] = shapeBits(record[i].x);
        b[i] = shapeBits(record[i].y);
        c[i] = shapeBits(record[i].z);
    }
    for (int i = 0; i < kPixels; ++i) {
        place(max(seeds[i], 1u));  // selects the triangle's copy
        float step = unpackStep(record[i].w);
        begin(i, seeds[i], triangleHitThrough(projectVertex(a[i], step), projectVertex(b[i], step), projectVertex(c[i], step), 0u,
                                              through[i]));
    }
}
#else
void beginAll(uint seeds[kPixels]) {
    for (int i = 0; i < kPixels; ++i) {
        vec4 shape = shapeAt(place(max(seeds[i], 1u)));
        begin(i, seeds[i], sphereHitThrough(vec4(toView(shape.xyz), shape.w), through[i]));
    }
}
#endif
