#version 440
// The least that a bake can do: every word of the depth maps read once, every texel's sums written once.

layout(local_size_x = 64) in;

layout(push_constant) uniform Push {
    uint words;   // of the maps, 16 bytes each
    uint texels;
    uint last;    // 1: the sums are written
};
layout(set = 0, binding = 0, std430) readonly buffer Maps { uvec4 maps[]; };
layout(set = 0, binding = 1, std430) buffer Sums { uvec2 sums[]; };

void main() {
    uint texel = gl_GlobalInvocationID.x;
    uint step = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    uvec4 sum = uvec4(0u);
    for (uint i = texel; i < words; i += step) sum += maps[i];
    uvec2 folded = sum.xy ^ sum.zw;
    // Never true of maps that hold 1: the reads are not to be optimised away.
    bool never = folded.x == 0xffffffffu;
    for (uint i = texel; i < texels && (last == 1u || never); i += step) sums[i] = folded;
}
