// Counts the fragments that are shaded, in the variants that `nacre bench` draws with.
#ifdef COUNT
layout(set = 1, binding = 0, std430) buffer Counter { uint shaded; };
void countFragment() { atomicAdd(shaded, 1u); }
#else
void countFragment() {}
#endif
