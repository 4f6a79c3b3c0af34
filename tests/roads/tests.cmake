# The same description by every frontend. Included by tests/CMakeLists.txt.
if(TARGET nacre_desktop)
    add_executable(window_pictures ${CMAKE_CURRENT_LIST_DIR}/window_pictures.cpp)
    target_link_libraries(window_pictures PRIVATE nacre_desktop)
    target_include_directories(window_pictures PRIVATE ${CMAKE_SOURCE_DIR})
    set(saves_by_window $<TARGET_FILE:window_pictures>)
endif()
if(TARGET nacre_python)
    add_test(NAME roads COMMAND ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/roads_test.py $<TARGET_FILE:nacre-cli>
                                ${saves_by_window})
    set_tests_properties(roads PROPERTIES TIMEOUT 600 COST 90 RESOURCE_LOCK window
                         ENVIRONMENT "${on_lavapipe};PYTHONPATH=${CMAKE_BINARY_DIR}/python")
endif()
