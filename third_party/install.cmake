# `cmake --install` puts the engine where find_package(nacre) finds it: the library nacre::nacre, its public headers
# (engine/*.h but for those of its passes, engine/molecule, engine/scene), and the program where it was built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(NACRE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/nacre)
set(NACRE_INCLUDE_DIR ${CMAKE_INSTALL_INCLUDEDIR}/nacre)

set_target_properties(nacre_molecule PROPERTIES EXPORT_NAME molecule)
set_target_properties(nacre_graph PROPERTIES EXPORT_NAME graph)
file(GLOB headers CONFIGURE_DEPENDS engine/molecule/*.h engine/molecule/samples/*.h engine/molecule/selection/*.h engine/mesh/*.h engine/scene/*.h)
target_sources(nacre_molecule PUBLIC FILE_SET HEADERS BASE_DIRS ${CMAKE_SOURCE_DIR}
               FILES ${headers} ${CMAKE_SOURCE_DIR}/engine/error.h)
set(headers baked_occlusion debug_view device_options devices effects overlay renderer results settings)
list(TRANSFORM headers REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/engine/\\1.h")
target_sources(nacre PUBLIC FILE_SET HEADERS BASE_DIRS ${CMAKE_SOURCE_DIR} FILES ${headers})
target_compile_features(nacre_molecule PUBLIC cxx_std_20)

install(TARGETS nacre nacre_molecule nacre_graph EXPORT nacre-targets FILE_SET HEADERS DESTINATION ${NACRE_INCLUDE_DIR})
install(EXPORT nacre-targets NAMESPACE nacre:: DESTINATION ${NACRE_CMAKE_DIR})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/nacre-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_SOURCE_DIR}/third_party/nacre-config.cmake ${CMAKE_BINARY_DIR}/nacre-config-version.cmake
        DESTINATION ${NACRE_CMAKE_DIR})
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
