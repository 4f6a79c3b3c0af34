# The server, as its clients meet it. Included by tests/CMakeLists.txt.
add_test(NAME serve COMMAND ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/serve_test.py $<TARGET_FILE:nacre-cli>
                            $<TARGET_FILE:nacre_no_memory>)
add_test(NAME serve/attack COMMAND ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/attack_test.py
                                   $<TARGET_FILE:nacre-cli>)
add_library(nacre_resolve_here SHARED serve/resolve_here.cpp)
target_link_libraries(nacre_resolve_here PRIVATE ${CMAKE_DL_LIBS})
add_test(NAME serve/files COMMAND ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/files_test.py $<TARGET_FILE:nacre-cli>
                                  $<TARGET_FILE:nacre_resolve_here>)
add_test(NAME serve/page COMMAND ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/page_test.py $<TARGET_FILE:nacre-cli>)
add_test(NAME serve/load COMMAND ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/load_test.py $<TARGET_FILE:nacre-cli>
                                 ${fault_layer_folder})
add_test(NAME serve/nginx COMMAND ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/nginx_test.py $<TARGET_FILE:nacre-cli>
                                  ${CMAKE_SOURCE_DIR})
set_tests_properties(serve serve/attack serve/files serve/page serve/load serve/nginx PROPERTIES TIMEOUT 600 ENVIRONMENT "${on_lavapipe}")
# They mostly wait: begun last, they would wait alone.
set_tests_properties(serve/attack serve/page serve/load PROPERTIES COST 95)
