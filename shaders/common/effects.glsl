// Parameters of the effects.
//   EFFECTS   binding, if not 1
#ifndef NACRE_EFFECTS_GLSL
#define NACRE_EFFECTS_GLSL
#include "layout.h"
#ifndef EFFECTS
#define EFFECTS 1
#endif

layout(set = 0, binding = EFFECTS, std140) uniform Effects { EffectConstants effects; };
layout(constant_id = kFogId) const bool kFog = false;

/// Fraction of fog at distance Z.
float fogAt(float Z) { return clamp((Z - effects.fogStart) * effects.perFog, 0.0, 1.0) * effects.fog.a; }

/// Composites halos and outlines over a colour. @param seen  linear, premultiplied @param rim  from shadeRim()
vec4 underRim(vec4 seen, vec3 rim) {
    precise vec4 shown = mix(seen, vec4(effects.halo.rgb, 1.0), rim.b * effects.halo.a);
    if (rim.g > 0.5) shown = vec4(mix(effects.fog.rgb, effects.contour.rgb, rim.r), 1.0);
    return shown;
}
#endif
