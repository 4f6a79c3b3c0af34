# Nacre.app for macOS: the desktop's window, started by the Finder. The command line program is next to it.
# NACRE_MOLTENVK: folder of MoltenVK's dylib and its MoltenVK_icd.json, to be part of the app; without it the app
# uses the Vulkan that is installed.
enable_language(OBJCXX)
include(${CMAKE_CURRENT_LIST_DIR}/../documents.cmake)
set(NACRE_MOLTENVK "" CACHE PATH "Folder of libMoltenVK.dylib and MoltenVK_icd.json, to be put into Nacre.app")

target_sources(nacre_desktop PRIVATE ${CMAKE_CURRENT_LIST_DIR}/opened_files.mm)
target_link_libraries(nacre_desktop PUBLIC "-framework AppKit")
add_executable(nacre-mac MACOSX_BUNDLE ${CMAKE_CURRENT_LIST_DIR}/main.mm)
target_link_libraries(nacre-mac PRIVATE nacre_desktop)
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/main.mm ${CMAKE_CURRENT_LIST_DIR}/opened_files.mm
                            PROPERTIES COMPILE_OPTIONS -fobjc-arc)
configure_file(${CMAKE_CURRENT_LIST_DIR}/Info.plist.in ${CMAKE_CURRENT_BINARY_DIR}/mac/Info.plist.in @ONLY)
set_target_properties(nacre_desktop nacre-mac PROPERTIES OBJCXX_STANDARD 20 OBJCXX_STANDARD_REQUIRED ON)
set_target_properties(nacre-mac PROPERTIES
    OUTPUT_NAME Nacre
    MACOSX_BUNDLE_INFO_PLIST ${CMAKE_CURRENT_BINARY_DIR}/mac/Info.plist.in
    BUILD_RPATH "@executable_path/../Frameworks"
    INSTALL_RPATH "@executable_path/../Frameworks")

if(NACRE_MOLTENVK)
    # The path where Vulkan's loader looks for drivers within an app; the manifest names ../../../Frameworks.
    file(READ ${NACRE_MOLTENVK}/MoltenVK_icd.json manifest)
    string(JSON manifest SET "${manifest}" ICD library_path "\"../../../Frameworks/libMoltenVK.dylib\"")
    set(made ${CMAKE_CURRENT_BINARY_DIR}/mac/MoltenVK_icd.json)
    file(WRITE ${made} "${manifest}")
    target_sources(nacre-mac PRIVATE ${made} ${NACRE_MOLTENVK}/libMoltenVK.dylib)
    set_source_files_properties(${made} PROPERTIES MACOSX_PACKAGE_LOCATION Resources/vulkan/icd.d)
    set_source_files_properties(${NACRE_MOLTENVK}/libMoltenVK.dylib ${Vulkan_LIBRARY}
                                PROPERTIES MACOSX_PACKAGE_LOCATION Frameworks)
    target_sources(nacre-mac PRIVATE ${Vulkan_LIBRARY})
endif()
install(TARGETS nacre-mac BUNDLE DESTINATION .)
