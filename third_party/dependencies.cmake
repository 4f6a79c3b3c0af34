# How each dependency is found. Debian bookworm names stand in tools/packages.txt.
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
find_package(EXPAT REQUIRED)
find_package(Vulkan 1.3.239 REQUIRED)

find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
if(NOT TARGET glm::glm)
    add_library(glm::glm INTERFACE IMPORTED)
    target_include_directories(glm::glm SYSTEM INTERFACE ${GLM_INCLUDE_DIR})
endif()

find_path(GEMMI_INCLUDE_DIR gemmi/elem.hpp REQUIRED)
find_path(PEGTL_INCLUDE_DIR tao/pegtl.hpp REQUIRED)
add_library(gemmi::headers INTERFACE IMPORTED)
target_include_directories(gemmi::headers SYSTEM INTERFACE ${GEMMI_INCLUDE_DIR} ${PEGTL_INCLUDE_DIR})

# Debian's libxxhash-dev brings no CMake files.
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
find_library(XXHASH_LIBRARY xxhash REQUIRED)
add_library(xxhash::xxhash INTERFACE IMPORTED)
target_include_directories(xxhash::xxhash SYSTEM INTERFACE ${XXHASH_INCLUDE_DIR})
target_link_libraries(xxhash::xxhash INTERFACE ${XXHASH_LIBRARY})

find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

if(NACRE_APPS OR NACRE_TESTS)
    find_path(NLOHMANN_JSON_INCLUDE_DIR nlohmann/json.hpp REQUIRED)
    add_library(nlohmann::headers INTERFACE IMPORTED)
    target_include_directories(nlohmann::headers SYSTEM INTERFACE ${NLOHMANN_JSON_INCLUDE_DIR})
endif()
if(NACRE_APPS)
    find_package(CURL 7.84 REQUIRED)
    if(VCPKG_TOOLCHAIN)
        find_package(OpenImageIO 2.4 CONFIG REQUIRED)
    else()
        # Debian's CMake files for OpenImageIO refuse to load without every program of openimageio-tools and without
        # OpenCV's headers. Nothing here uses either, so its libraries are found by name.
        find_path(OPENIMAGEIO_INCLUDE_DIR OpenImageIO/imageio.h REQUIRED)
        find_path(IMATH_INCLUDE_DIR ImathConfig.h PATH_SUFFIXES Imath REQUIRED)
        find_library(OPENIMAGEIO_LIBRARY OpenImageIO REQUIRED)
        find_library(OPENIMAGEIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
        add_library(OpenImageIO::OpenImageIO INTERFACE IMPORTED)
        target_include_directories(OpenImageIO::OpenImageIO SYSTEM
                                   INTERFACE ${OPENIMAGEIO_INCLUDE_DIR} ${IMATH_INCLUDE_DIR})
        target_link_libraries(OpenImageIO::OpenImageIO
                              INTERFACE ${OPENIMAGEIO_LIBRARY} ${OPENIMAGEIO_UTIL_LIBRARY} Threads::Threads)
    endif()
    find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)
    add_library(cli11::headers INTERFACE IMPORTED)
    target_include_directories(cli11::headers SYSTEM INTERFACE ${CLI11_INCLUDE_DIR} ${NLOHMANN_JSON_INCLUDE_DIR})
endif()
if(NACRE_TESTS)
    find_package(GTest REQUIRED)
    find_package(embree 3 REQUIRED)
endif()
