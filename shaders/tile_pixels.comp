#version 440
// Colours of pixels whose nearest sphere or cylinder the host found (engine/software/front_shapes.h), sorted by kind,
// so that lanes of a subgroup take the same branch. A few pixels have several candidates. For software devices.
#extension GL_GOOGLE_include_directive : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 0
#define LOOKS 4
#define ATLAS 5
#define EFFECTS 6
#define CELLS 7
#define SHADOW 9
#include "common/numbered.glsl"

layout(constant_id = kLanesId) const int kLanes = 8;
layout(local_size_x_id = 50) in;  // kLanesId
layout(push_constant) uniform Push { TileConstants push; };
layout(set = 0, binding = 2) uniform usamplerBuffer pairs;
layout(set = 0, binding = 3, std430) writeonly buffer Colors { uint colors[]; };
// Loads a pixel and its number together. Software devices load pairs lane by lane: processors prefetch such plain
// loads, but not gathered words.
uvec2 pairAt(uint i) { return texelFetch(pairs, int(i)).xy; }
uint wordAt(uint i) {
    uvec2 pair = pairAt(i / 2u);
    return (i & 1u) == 0u ? pair.x : pair.y;
}

vec2 pixelOf(uint on) { return vec2(on & 0xffffu, on >> 16) + 0.5; }
uint colorOf(Seen seen, vec2 q) {
    return packUnorm4x8(vec4(colorOf(seen.hit, storedColor(seen), seen.occlusion, q), 1.0));
}
void write(uint on, uint color) {
    const uint kBin = 16u;
    colors[(on >> 16) * (view.across * kBin) + (on & 0xffffu)] = color;
}
uint ballColor(uint number, vec2 q) { return colorOf(seenBall(place(number), q), q); }
uint stickColor(uint number, vec2 q, const bool sideKnown) {
    return colorOf(seenStick(place(number), q, sideKnown), q);
}

/// The range of a list for this workgroup, in whole subgroups.
uvec2 shareOf(uint count) {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y, lanes = uint(kLanes);
    uint turns = (count + lanes - 1u) / lanes, each = (turns + groups - 1u) / groups;
    return min(uvec2(group, group + 1u) * each * lanes, count);
}

/// A lane's pixel of a range, and its number; arbitrary if the range is empty. Loaded while earlier pixels are shaded.
uvec2 listed(uint at, uvec2 share, uint lane) { return pairAt(at + min(share.x + lane, share.y - 1u)); }

/// The nearest of a pixel's candidates. @param number  0: none
void settle(inout uint number, uint candidate, inout float nearest, vec2 q) {
    uint index = place(max(candidate, 1u)), at = index < view.spheres ? index : 2u * index - view.spheres;
    vec4 a = shapeAt(at), b = shapeAt(at + 1u);
    Hit ball = sphereHitThrough(vec4(toView(a.xyz), a.w), q), stick = stickHitThrough(stickAt(a, b), q);
    bool round = index < view.spheres;
    bool inside = round ? ball.inside : stick.inside;
    float depth = encodedDepth(round ? ball.order : stick.order);
    // At equal depths the last wins, as in lists.
    bool wins = candidate != 0u && inside && (depth < nearest || (depth == nearest && candidate > number));
    nearest = wins ? depth : nearest;
    number = wins ? candidate : number;
}

void main() {
    view = push;
    uint lane = gl_LocalInvocationID.x;
    uvec2 counts = pairAt(0u);
    uint balls = counts.x, sticks = counts.y, doubts = pairAt(1u).x;
    uint at = 2u;
    uvec2 share = shareOf(balls);
    uvec2 next = listed(at, share, lane);
    while (share.x < share.y) {
        uint on = next.x, number = next.y;
        share.x += uint(kLanes);
        next = listed(at, share, lane);
        write(on, ballColor(number, planePoint(pixelOf(on))));
    }
    at += balls;
    share = shareOf(sticks);
    next = listed(at, share, lane);
    while (share.x < share.y) {
        uint on = next.x, number = next.y;
        share.x += uint(kLanes);
        next = listed(at, share, lane);
        write(on, stickColor(number, planePoint(pixelOf(on)), true));
    }
    at += sticks;
    share = shareOf(doubts);
    while (share.x < share.y) {
        uint slot = at + min(share.x + lane, share.y - 1u);
        uvec2 first = pairAt(slot);
        uint on = first.x, next = first.y, end = pairAt(slot + 1u).y, number = 0u;
        vec2 q = planePoint(pixelOf(on));
        float nearest = 1.0;
        do {
            settle(number, wordAt(2u * (at + doubts + 1u) + next), nearest, q);
            ++next;
        } while (next < end);
        bool round = number == 0u || place(number) < view.spheres;
        uint ball = ballColor(round ? max(number, 1u) : 1u, q), stick = stickColor(round ? view.spheres + 1u : number, q, false);
        write(on, number == 0u ? 0u : round ? ball : stick);
        share.x += uint(kLanes);
    }
}
