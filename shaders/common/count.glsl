// Counts shaded fragments, in the variants that `nacre bench` uses.
#ifdef COUNT
layout(set = 1, binding = 0, std430) buffer Counter { uint shaded; };
void countFragment() { atomicAdd(shaded, 1u); }
#else
void countFragment() {}
#endif
