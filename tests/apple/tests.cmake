# What can be shown of iOS and macOS without either. Included by tests/CMakeLists.txt.
set(apple_tests ${CMAKE_CURRENT_SOURCE_DIR}/apple)

# Every shader in Metal's language; what the renderer hands to MoltenVK.
add_test(NAME apple/shaders COMMAND python3 ${apple_tests}/shaders_test.py ${NACRE_SHADER_DIR} $<TARGET_FILE:nacre-cli>
         ${phone_layers} ${lavapipe})
set_tests_properties(apple/shaders PROPERTIES TIMEOUT 300)
