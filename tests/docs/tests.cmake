# What README and docs/ say of files and options; the counts that they state; the tutorial's commands without network. Included by tests/CMakeLists.txt.
foreach(test docs figures json)
    add_test(NAME docs/${test} COMMAND python3 ${CMAKE_CURRENT_LIST_DIR}/${test}_test.py ${CMAKE_SOURCE_DIR}
                                       $<TARGET_FILE:nacre-cli>)
endforeach()
add_test(NAME docs/tutorial COMMAND ${CMAKE_SOURCE_DIR}/tools/draw_tutorial --program $<TARGET_FILE:nacre-cli>
                                    --into ${CMAKE_CURRENT_BINARY_DIR} --data none)
# Figures that docs/measurements.md states, and the tool that measures them.
add_test(NAME docs/measure COMMAND python3 ${CMAKE_CURRENT_LIST_DIR}/measure_test.py ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR})
set_tests_properties(docs/docs docs/figures docs/json docs/measure docs/tutorial PROPERTIES TIMEOUT 300 ENVIRONMENT "${on_lavapipe}")
add_test(NAME docs/batch COMMAND python3 ${CMAKE_CURRENT_LIST_DIR}/batch_examples_test.py ${CMAKE_SOURCE_DIR}
                                 $<TARGET_FILE:nacre-cli> ${written_files})
set_tests_properties(docs/batch PROPERTIES TIMEOUT 600
                     ENVIRONMENT "${on_lavapipe};$<$<BOOL:${NACRE_LONG_TESTS}>:NACRE_LONG_TESTS=1>")
