# What can be shown of iOS and macOS without either. Included by tests/CMakeLists.txt.
set(apple_tests ${CMAKE_CURRENT_SOURCE_DIR}/apple)

# Every shader in Metal's language; what the renderer hands to MoltenVK.
add_test(NAME apple/shaders COMMAND python3 ${apple_tests}/shaders_test.py ${NACRE_SHADER_DIR} $<TARGET_FILE:nacre-cli>
         ${phone_layers} ${lavapipe})
set_tests_properties(apple/shaders PROPERTIES TIMEOUT 300)

# Every source of the apps, against declarations of what it uses of Apple's frameworks.
find_program(NACRE_CLANG clang++-14 REQUIRED)
add_test(NAME apple/syntax COMMAND python3 ${apple_tests}/syntax_test.py ${CMAKE_SOURCE_DIR})
set_tests_properties(apple/syntax PROPERTIES TIMEOUT 300)

# What the apps do in plain C++, on a window that nobody sees, which SwiftShader has.
if(TARGET nacre_session)
    add_executable(test_apple apple/session_test.cpp)
    target_link_libraries(test_apple PRIVATE GTest::gtest_main nacre_session nacre_fault_layer)
    target_compile_definitions(test_apple PRIVATE NACRE_FAULT_LAYER_FOLDER="${fault_layer_folder}"
                               NACRE_PHONE_LAYER_FOLDER="${phone_layers}")
    add_dependencies(test_apple nacre_phone_layer)
    nacre_suites(test_apple apple/ ENVIRONMENT ${on_swiftshader})
endif()

# The projects and property lists that CMake makes for Apple's systems.
add_test(NAME apple/project COMMAND python3 ${apple_tests}/project_test.py ${CMAKE_SOURCE_DIR})
set_tests_properties(apple/project PROPERTIES TIMEOUT 300)
