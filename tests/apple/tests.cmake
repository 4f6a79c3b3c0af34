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

# The projects and property lists that CMake makes for Apple's systems.
add_test(NAME apple/project COMMAND python3 ${apple_tests}/project_test.py ${CMAKE_SOURCE_DIR})
set_tests_properties(apple/project PROPERTIES TIMEOUT 300)

# The toolchains of both phones, with stand-ins for the NDK and vcpkg.
add_test(NAME toolchains COMMAND python3 -B ${CMAKE_CURRENT_SOURCE_DIR}/toolchains/toolchains_test.py ${CMAKE_SOURCE_DIR})
set_tests_properties(toolchains PROPERTIES TIMEOUT 1800)
