// Linked into every program of a sanitizer build. A leak report is written when the program ends, and calls the frames
// of a library that was unloaded by then "<unknown module>", so that a Vulkan driver's leak could not be told from
// ours by name. Here no library is ever unloaded.

#include <dlfcn.h>

extern "C" int dlclose(void* /*handle*/) noexcept { return 0; }
