// What a fragment shader writes of a hit: colour, or one of the layers. Outputs by SURFACE or IDENTITY.
#include "color.glsl"

#if defined(SURFACE)
layout(location = 0) out vec4 surface;  // normal, Z
#elif defined(IDENTITY)
layout(location = 0) out uvec2 identity;  // atom, occlusion as bits
#else
layout(location = 0) out vec4 color;  // opaque
#endif

/// Writes a hit. Occlusion is passed by the caller, who knows the patch.
void writeSurface(Hit hit, uint colorBits, uint atom, float occlusion) {
#if defined(SURFACE)
    surface = vec4(hit.normal, hit.Z);
#elif defined(IDENTITY)
    identity = uvec2(atom, floatBitsToUint(occlusion));
#else
    color = vec4(colorOf(hit, colorBits, occlusion, planePoint(gl_FragCoord.xy)), 1.0);
#endif
}
