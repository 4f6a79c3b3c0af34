// Light. All in linear light; directions in view space, so that it stays with the viewer.

const vec3 kLight = normalize(vec3(-0.35, 0.55, 0.76));  // over the viewer's left shoulder

/// @param base       linear base colour
/// @param occlusion  0 closed to 1 open, scales all light that arrives
vec3 shade(vec3 base, vec3 normal, float occlusion) {
    vec3 light = kLight;
    float facing = max(dot(normal, light), 0.0);
    // The sky's share is wrapped a little upwards: what looks up is brighter than what looks down.
    float sky = 0.5 + 0.5 * normal.y;
    vec3 ambient = mix(vec3(0.54, 0.52, 0.52), vec3(0.70, 0.73, 0.77), sky);
    vec3 half_ = normalize(light + vec3(0.0, 0.0, 1.0));
    float highlight = pow(max(dot(normal, half_), 0.0), 42.0) * 0.16;
    // Clefts darken a little faster than light falls off in them, as the eye expects of depth.
    float open = occlusion * mix(occlusion, 1.0, 0.55);
    return open * (base * (ambient + facing * 0.74) + vec3(highlight));
}
