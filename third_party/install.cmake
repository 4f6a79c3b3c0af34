# `cmake --install` puts the engine where find_package(nacre) finds it: the library nacre::nacre, its public headers
# (at most 40: those below and what they name) as <nacre/...>, and the program where it was built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(NACRE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/nacre)

set_target_properties(nacre_molecule PROPERTIES EXPORT_NAME molecule)
set_target_properties(nacre_graph PROPERTIES EXPORT_NAME graph)
foreach(library nacre_molecule nacre_graph nacre)
    target_include_directories(${library} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endforeach()
target_compile_features(nacre_molecule PUBLIC cxx_std_20)

set(headers)
set(left renderer.h scene/build/representation.h error.h threads.h molecule/read.h molecule/drawn_atoms.h molecule/chemistry/hydrogens.h)
while(left)
    list(POP_FRONT left header)
    list(APPEND headers ${header})
    file(STRINGS engine/${header} named REGEX "^#include \"engine/")
    list(TRANSFORM named REPLACE "#include \"engine/(.*)\".*" "\\1")
    list(APPEND left ${named})
    list(REMOVE_DUPLICATES left)
    list(REMOVE_ITEM left ${headers})
endwhile()
# Headers name each other as engine/..., where they stand here, and as nacre/..., where they are installed.
foreach(header ${headers})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS engine/${header})
    file(READ engine/${header} text)
    string(REPLACE "#include \"engine/" "#include \"nacre/" text "${text}")
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/include/nacre/${header} CONTENT "${text}" @ONLY)
    # One by one: the build folder may hold headers that are gone.
    get_filename_component(folder nacre/${header} DIRECTORY)
    install(FILES ${CMAKE_BINARY_DIR}/include/nacre/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder}
            COMPONENT development)
endforeach()

install(TARGETS nacre nacre_molecule nacre_graph EXPORT nacre-targets ARCHIVE COMPONENT development)
install(EXPORT nacre-targets NAMESPACE nacre:: DESTINATION ${NACRE_CMAKE_DIR} COMPONENT development)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/nacre-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_SOURCE_DIR}/third_party/nacre-config.cmake ${CMAKE_BINARY_DIR}/nacre-config-version.cmake
        DESTINATION ${NACRE_CMAKE_DIR} COMPONENT development)
