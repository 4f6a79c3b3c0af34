// Constants that have one value in most pictures (engine/software/usual_stages.h). With USUAL they have it when the stage
// is built: a driver, which leaves out what depends on others before each first picture, then never sees that.
#ifndef NACRE_USUAL_GLSL
#define NACRE_USUAL_GLSL
#ifdef USUAL
#define USUALLY(id)
#else
#define USUALLY(id) layout(constant_id = id)
#endif
// Rims are outlines.
#if defined(USUAL) && defined(RIMS)
#define USUAL_CONTOURS true
#else
#define USUAL_CONTOURS false
#endif
#endif
