# Compiles every stage at build time, validates it, and embeds it as words.
# nacre_shader(NAME SOURCE [DEFINE...]) adds `const std::uint32_t NAME[]` to shaders.h's list.
add_library(nacre_shaders INTERFACE)
