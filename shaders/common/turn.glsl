// Clockwise quarter turns from the upright picture to the image: the display's pre-rotation.
#include "layout.h"

layout(constant_id = kQuarterTurnsId) const int kQuarterTurns = 0;

vec2 turned(vec2 p) {
    return kQuarterTurns == 1 ? vec2(-p.y, p.x) : kQuarterTurns == 2 ? -p : kQuarterTurns == 3 ? vec2(p.y, -p.x) : p;
}
vec2 upright(vec2 p) {
    return kQuarterTurns == 1 ? vec2(p.y, -p.x) : kQuarterTurns == 2 ? -p : kQuarterTurns == 3 ? vec2(-p.y, p.x) : p;
}
