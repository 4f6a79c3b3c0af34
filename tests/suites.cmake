# One entry of ctest for each suite of a GoogleTest program, or for several, since starting a program that draws costs more
# than most of its tests, and a driver compiles all its pipelines again. ctest includes this file itself, once for each program: see nacre_suites() in CMakeLists.txt.
#   program, prefix   the program, and what the names of its entries begin with
#   filter            of the tests to run, as --gtest_filter takes it
#   together          how many suites are an entry, "A+B+C": they share the renderers that scenes.h keeps
#   properties        of the entries
if(NOT EXISTS ${program})
    add_test(${prefix}not_built ${program})
    return()
endif()
execute_process(COMMAND ${program} --gtest_list_tests --gtest_filter=${filter}
                OUTPUT_VARIABLE list RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} does not list its tests: ${result}")
endif()
# Suites stand at the beginning of a line and end in a point; their tests are indented.
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${list}")
list(TRANSFORM suites STRIP)
string(REGEX MATCH "-.*" without "${filter}")
string(REGEX REPLACE "-.*" "" patterns "${filter}")
string(REPLACE ":" ";" patterns "${patterns}")
if(NOT together)
    set(together 1)
endif()
set(names "")
set(filters "")
foreach(suite IN LISTS suites)
    string(REGEX REPLACE "\\.$" "" name ${suite})
    list(APPEND names ${name})
    # Of a suite of which the filter names single tests, those.
    set(own ${patterns})
    list(FILTER own INCLUDE REGEX "^${name}\\.")
    if(NOT own)
        set(own "${suite}*")
    endif()
    list(APPEND filters ${own})
    list(LENGTH names count)
    list(GET suites -1 last)
    if(count LESS together AND NOT suite STREQUAL last)
        continue()
    endif()
    list(JOIN names "+" name)
    list(JOIN filters ":" filter_of_entry)
    set(names "")
    set(filters "")
    add_test(${prefix}${name} ${program} --gtest_filter=${filter_of_entry}${without})
    # Skipped is what skips all of its tests; tools/test counts the single ones.
    set_tests_properties(${prefix}${name} PROPERTIES ${properties} SKIP_REGULAR_EXPRESSION
        "PASSED  \\] 0 tests\\.\n\\[  SKIPPED \\] [0-9]+ tests?, listed below:\n(\\[  SKIPPED \\] [^\n]*\n)+$")
endforeach()
