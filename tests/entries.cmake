# Entries of ctest: suites of a program, which share its start.

# nacre_suites(PROGRAM PREFIX [OPTIMISED] [FILTER OF_TESTS] [TOGETHER COUNT] [ENVIRONMENT NAME=VALUE...]
# [PROPERTIES NAME VALUE...]): an entry of ctest for each suite of a program, or for so many of them.
# OPTIMISED: as users have it, lavapipe optimises the shaders that it compiles.
function(nacre_suites target prefix)
    cmake_parse_arguments(suites "OPTIMISED" "FILTER;TOGETHER" "ENVIRONMENT;PROPERTIES" ${ARGN})
    list(APPEND suites_ENVIRONMENT ${compiled_shaders})
    list(REMOVE_DUPLICATES suites_ENVIRONMENT)
    if(suites_OPTIMISED)
        list(REMOVE_ITEM suites_ENVIRONMENT ${unoptimised})
    endif()
    if(NOT suites_FILTER)
        set(suites_FILTER "*")
    endif()
    set(timeout 900)
    if(NACRE_LONG_TESTS OR NACRE_SANITIZE OR suites_TOGETHER)
        set(timeout 3600)
    endif()
    set(properties TIMEOUT ${timeout} ${suites_PROPERTIES})
    string(REPLACE ";" "\\\\;" environment "${suites_ENVIRONMENT}")
    string(APPEND properties ";ENVIRONMENT;${environment}")
    string(MD5 name "${prefix} ${suites_FILTER}")
    set(script ${CMAKE_CURRENT_BINARY_DIR}/suites_${name}.cmake)
    file(GENERATE OUTPUT ${script} CONTENT
"set(program \"$<TARGET_FILE:${target}>\")
set(prefix \"${prefix}\")
set(filter \"${suites_FILTER}\")
set(together \"${suites_TOGETHER}\")
set(properties \"${properties}\")
include(\"${CMAKE_CURRENT_FUNCTION_LIST_DIR}/suites.cmake\")
")
    set_property(DIRECTORY ${CMAKE_CURRENT_FUNCTION_LIST_DIR} APPEND PROPERTY TEST_INCLUDE_FILES ${script})
endfunction()
