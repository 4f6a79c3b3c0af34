// Which view of a draw call this is.
#ifndef NACRE_VIEW_INDEX_GLSL
#define NACRE_VIEW_INDEX_GLSL
/// 0. In stages of draw calls of two views, engine/gpu/two_view_shader.h makes it gl_ViewIndex, which needs a capability.
int viewIndex() { return 0; }
#endif
