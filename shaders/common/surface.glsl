// Output of a fragment shader for a hit: colour, or one of the layers. Selected by SURFACE or IDENTITY.
#include "color.glsl"
#ifdef TRANSLUCENT
#include "layers.glsl"
#endif

#ifndef PLACE
#define PLACE gl_FragCoord.xy  // that the hit is of
#endif

#if defined(SURFACE)
layout(location = 0) out vec4 surface;  // Z, normal; a target of one channel receives Z
#elif defined(IDENTITY)
layout(location = 0) out uvec2 identity;  // atom, occlusion as bits
#else
layout(location = 0) out vec4 color;  // straight alpha; opaque except for translucent layers
#endif

#ifdef RIMS
layout(constant_id = kClearId) const float kRed = 0.0;  // clear colour of the picture
layout(constant_id = kClearId + 1) const float kGreen = 0.0;
layout(constant_id = kClearId + 2) const float kBlue = 0.0;
layout(constant_id = kClearId + 3) const float kAlpha = 0.0;
#ifdef INPUT
layout(input_attachment_index = 1, set = 0, binding = 7) uniform subpassInput rims;
vec4 rimHere() { return subpassLoad(rims); }
#else
layout(set = 0, binding = 7) uniform sampler2D rims;
vec4 rimHere() { return texelFetch(rims, ivec2(gl_FragCoord.xy), 0); }
#endif
/// Writes a colour with its halos and outlines. @param seen  linear, premultiplied
void writeRimmed(vec4 seen) {
    seen = underRim(seen, rimHere().rgb);
    if (seen.a == 0.0) discard;
    seen += (1.0 - seen.a) * vec4(kRed, kGreen, kBlue, kAlpha);
    color = vec4(asTargetTakesIt(seen.rgb), seen.a);
}
#endif

/// Writes a hit. The caller passes what the bake says of it, since it knows the patch.
#if defined(IDENTITY)
void writeSurface(Hit hit, uint atom, Baked baked) { identity = uvec2(atom, floatBitsToUint(baked.open)); }
#else
/// @param base  linear colour
void writeSurface(Hit hit, vec3 base, Baked baked) {
#if defined(SURFACE)
    surface = vec4(hit.Z, hit.normal);
#else
    vec3 lit = computeLight(hit, base, baked, planePoint(PLACE));
#ifdef RIMS
    writeRimmed(vec4(lit, 1.0));
#else
    color = vec4(asTargetTakesIt(lit), 1.0);
#endif
#endif
}
#endif
/// The same with data from the looks.
void writeSurface(Hit hit, uint colorBits, uint atom, Baked baked) {
#ifdef IDENTITY
    writeSurface(hit, atom, baked);
#else
    writeSurface(hit, linearColor(colorBits), baked);
#ifdef TRANSLUCENT
    color = asHalves(vec4(color.rgb, unpackOpacity(colorBits)));
#endif
#endif
}
