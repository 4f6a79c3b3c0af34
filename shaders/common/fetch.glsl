// Streams of a geometry pass for stages that fetch by index.
//   READS   the stages also read images, which precede the streams in the set
#ifdef READS
#define FIRST 4
#else
#define FIRST 0
#endif
layout(set = 0, binding = FIRST, std430) readonly buffer Shapes { uvec4 shapes[]; };
layout(set = 0, binding = FIRST + 1, std430) readonly buffer Looks { uint looks[]; };
