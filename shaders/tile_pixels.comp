#version 440
// Colours of pixels whose nearest sphere or cylinder the host knows (engine/scene/front_shapes.h), sorted by kind, so
// that no lane waits for one of another kind. Of a few pixels it knows all that they may show. For software devices.
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
layout(set = 0, binding = 2) uniform usamplerBuffer words;
layout(set = 0, binding = 3, std430) writeonly buffer Colors { uint colors[]; };
uint wordAt(uint i) { return texelFetch(words, int(i)).x; }

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

/// Numbers and pixels stand in two runs. @returns the end of both
uint listAfter(uint at, uint count) { return at + 2u * count; }

/// The part of some things that this workgroup has, of full subgroups.
uvec2 shareOf(uint count) {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y, lanes = uint(kLanes);
    uint turns = (count + lanes - 1u) / lanes, each = (turns + groups - 1u) / groups;
    return min(uvec2(group, group + 1u) * each * lanes, count);
}

/// A lane's pixel of a share, and its number; of an empty share any. Asked for while the pixels before it are shaded.
uvec2 listed(uint at, uint count, uvec2 share, uint lane) {
    uint slot = at + min(share.x + lane, share.y - 1u);
    return uvec2(wordAt(slot), wordAt(slot + count));
}

/// The nearest of what a pixel may show. @param number  0: nothing
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
    uint balls = wordAt(0u), sticks = wordAt(1u), doubts = wordAt(2u);
    uint at = 4u;
    uvec2 share = shareOf(balls);
    uvec2 next = listed(at, balls, share, lane);
    while (share.x < share.y) {
        uint on = next.x, number = next.y;
        share.x += uint(kLanes);
        next = listed(at, balls, share, lane);
        write(on, ballColor(number, planePoint(pixelOf(on))));
    }
    at = listAfter(at, balls);
    share = shareOf(sticks);
    next = listed(at, sticks, share, lane);
    while (share.x < share.y) {
        uint on = next.x, number = next.y;
        share.x += uint(kLanes);
        next = listed(at, sticks, share, lane);
        write(on, stickColor(number, planePoint(pixelOf(on)), true));
    }
    at = listAfter(at, sticks);
    share = shareOf(doubts);
    while (share.x < share.y) {
        uint slot = min(share.x + lane, share.y - 1u), on = wordAt(at + slot);
        uint next = wordAt(at + doubts + slot), end = wordAt(at + doubts + slot + 1u), number = 0u;
        vec2 q = planePoint(pixelOf(on));
        float nearest = 1.0;
        do {
            settle(number, wordAt(at + listAfter(1u, doubts) + next), nearest, q);
            ++next;
        } while (next < end);
        bool round = number == 0u || place(number) < view.spheres;
        uint ball = ballColor(round ? max(number, 1u) : 1u, q), stick = stickColor(round ? view.spheres + 1u : number, q, false);
        write(on, number == 0u ? 0u : round ? ball : stick);
        share.x += uint(kLanes);
    }
}
