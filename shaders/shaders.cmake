# Compiles every stage at build time, validates it, and embeds it as words.
# nacre_shader(NAME SOURCE [DEFINE...]) makes `inline const std::uint32_t NAME[]` in the header "shaders.h".
set(NACRE_SHADER_DIR ${CMAKE_BINARY_DIR}/shaders)
file(MAKE_DIRECTORY ${NACRE_SHADER_DIR})
file(GLOB NACRE_SHADER_COMMON CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/common/*)
set(NACRE_SHADER_HEADERS)
set(NACRE_SHADER_INCLUDES "#pragma once\n#include <cstdint>\nnamespace nacre::shaders {\n")

function(nacre_shader name source)
    set(input ${CMAKE_SOURCE_DIR}/shaders/${source})
    set(binary ${NACRE_SHADER_DIR}/${name}.spv)
    set(header ${NACRE_SHADER_DIR}/${name}.h)
    set(defines ${ARGN})
    list(TRANSFORM defines PREPEND -D)
    add_custom_command(
        OUTPUT ${header}
        COMMAND ${GLSLANG_VALIDATOR} -V --quiet --target-env vulkan1.1 ${defines} -o ${binary} ${input}
        COMMAND ${SPIRV_VAL} --target-env vulkan1.1 ${binary}
        COMMAND ${GLSLANG_VALIDATOR} -V --quiet --target-env vulkan1.1 ${defines} --vn ${name} -o ${header} ${input}
        DEPENDS ${input} ${NACRE_SHADER_COMMON}
        COMMENT "Shader ${name}"
        VERBATIM)
    set(NACRE_SHADER_HEADERS ${NACRE_SHADER_HEADERS} ${header} PARENT_SCOPE)
    string(APPEND NACRE_SHADER_INCLUDES "#include \"${name}.h\"\n")
    set(NACRE_SHADER_INCLUDES ${NACRE_SHADER_INCLUDES} PARENT_SCOPE)
endfunction()

# A fragment stage comes twice: as it is, and counting what it shades.
function(nacre_fragment name source)
    nacre_shader(${name} ${source} ${ARGN})
    nacre_shader(${name}Counting ${source} ${ARGN} COUNT)
    set(NACRE_SHADER_HEADERS ${NACRE_SHADER_HEADERS} PARENT_SCOPE)
    set(NACRE_SHADER_INCLUDES ${NACRE_SHADER_INCLUDES} PARENT_SCOPE)
endfunction()

nacre_shader(plateVertex plate.vert)
nacre_shader(screenVertex screen.vert)
nacre_fragment(plateFragment plate.frag)
foreach(primitive Sphere Cylinder)
    string(TOUPPER ${primitive} define)
    string(TOLOWER ${primitive} file)
    nacre_shader(geometry${primitive}Vertex ${file}.vert)
    nacre_shader(look${primitive}Vertex ${file}.vert LOOK)
    nacre_shader(number${primitive}Vertex ${file}.vert NUMBER)
    nacre_fragment(encode${primitive} depth_encode.frag ${define})
    nacre_fragment(encode${primitive}Ordered depth_encode.frag ${define} ORDERED)
    nacre_fragment(nearest${primitive} depth_write.frag ${define})
    nacre_fragment(identify${primitive} identify.frag ${define})
    foreach(path Input Sampled Fragdepth Ordered InputSettle SampledSettle)
        string(REPLACE Settle "" plain ${path})
        string(TOUPPER ${plain} path_defines)
        if(NOT path STREQUAL plain)
            list(APPEND path_defines SETTLE)
        endif()
        nacre_fragment(color${primitive}${path} impostor.frag ${define} ${path_defines})
        nacre_fragment(surface${primitive}${path} impostor.frag ${define} ${path_defines} SURFACE)
        nacre_fragment(identity${primitive}${path} impostor.frag ${define} ${path_defines} IDENTITY)
    endforeach()
endforeach()
foreach(path Input Sampled)
    string(TOUPPER ${path} path_define)
    nacre_fragment(colorDeferred${path} deferred.frag ${path_define})
    nacre_fragment(surfaceDeferred${path} deferred.frag ${path_define} SURFACE)
    nacre_fragment(identityDeferred${path} deferred.frag ${path_define} IDENTITY)
endforeach()
nacre_shader(occlusionAccumulate occlusion_accumulate.comp)
nacre_shader(occlusionFinish occlusion_finish.comp)

file(CONFIGURE OUTPUT ${NACRE_SHADER_DIR}/shaders.h CONTENT "${NACRE_SHADER_INCLUDES}}  // namespace nacre::shaders\n")
add_custom_target(nacre_shader_files DEPENDS ${NACRE_SHADER_HEADERS})
add_library(nacre_shaders INTERFACE)
target_include_directories(nacre_shaders INTERFACE ${NACRE_SHADER_DIR})
add_dependencies(nacre_shaders nacre_shader_files)
