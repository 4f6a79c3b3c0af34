# One entry of ctest for each suite of a GoogleTest program, since starting a program that draws costs more than most of
# its tests. ctest includes this file itself, once for each program: see nacre_suites() in CMakeLists.txt.
#   program, prefix   the program, and what the names of its entries begin with
#   filter            of the tests to run, as --gtest_filter takes it
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
foreach(suite IN LISTS suites)
    string(REGEX REPLACE "\\.$" "" name ${suite})
    add_test(${prefix}${name} ${program} --gtest_filter=${suite}*${without})
    # Skipped is what skips all of its tests; tools/test counts the single ones.
    set_tests_properties(${prefix}${name} PROPERTIES ${properties} SKIP_REGULAR_EXPRESSION
        "PASSED  \\] 0 tests\\.\n\\[  SKIPPED \\] [0-9]+ tests?, listed below:\n(\\[  SKIPPED \\] [^\n]*\n)+$")
endforeach()
