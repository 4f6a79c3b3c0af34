# The licences of what Nacre's programs are made of, as one text for them to show: nacre_notices(FILE.cpp) writes it as
# `const char* nacre::app::kNotices`. The texts come from where the packages were installed: Debian's
# /usr/share/doc/PACKAGE/copyright, vcpkg's share/PORT/copyright.

# name | licence | Debian package | vcpkg port | where its source is
set(NACRE_PARTS
    "Vulkan headers and Vulkan-Hpp|Apache-2.0 or MIT|libvulkan-dev|vulkan-headers|https://github.com/KhronosGroup/Vulkan-Headers"
    "GLM|MIT|libglm-dev|glm|https://github.com/g-truc/glm"
    "gemmi|MPL-2.0|gemmi-dev|gemmi|https://github.com/project-gemmi/gemmi"
    "PEGTL|MIT|tao-pegtl-dev|pegtl|https://github.com/taocpp/PEGTL"
    "zlib|zlib|zlib1g-dev|zlib|https://zlib.net"
    "XZ Utils' liblzma|public domain|liblzma-dev|liblzma|https://tukaani.org/xz"
    "bzip2|bzip2-1.0.6|libbz2-dev|bzip2|https://sourceware.org/bzip2"
    "Zstandard|BSD-3-Clause|libzstd-dev|zstd|https://github.com/facebook/zstd"
    "Expat|MIT|libexpat1-dev|expat|https://github.com/libexpat/libexpat"
    "xxHash|BSD-2-Clause|libxxhash-dev|xxhash|https://github.com/Cyan4973/xxHash"
    "libzip|BSD-3-Clause|libzip-dev|libzip|https://libzip.org"
    "JSON for Modern C++|MIT|nlohmann-json3-dev|nlohmann-json|https://github.com/nlohmann/json"
    "DejaVu fonts|Bitstream Vera|fonts-dejavu-core||https://dejavu-fonts.github.io"
    "FreeType|FTL|libfreetype-dev|freetype|https://freetype.org"
    "HarfBuzz|MIT|libharfbuzz-dev|harfbuzz|https://harfbuzz.github.io"
    "libjpeg-turbo|IJG and BSD-3-Clause|libjpeg62-turbo-dev|libjpeg-turbo|https://libjpeg-turbo.org"
    "OpenEXR and Imath|BSD-3-Clause|libopenexr-dev|openexr|https://openexr.com"
    "libwebp|BSD-3-Clause|libwebp-dev|libwebp|https://chromium.googlesource.com/webm/libwebp"
    "libpng|libpng-2.0|libpng-dev|libpng|http://www.libpng.org"
    "libdeflate|MIT|libdeflate-dev|libdeflate|https://github.com/ebiggers/libdeflate"
    "GIFLIB|MIT|libgif-dev|giflib|https://giflib.sourceforge.net"
    "libcurl|curl|libcurl4-openssl-dev|curl|https://curl.se"
    "CLI11|BSD-3-Clause|libcli11-dev|cli11|https://github.com/CLIUtils/CLI11")
if(pybind11_FOUND)
    list(APPEND NACRE_PARTS "pybind11|BSD-3-Clause|pybind11-dev|pybind11|https://github.com/pybind/pybind11")
endif()
if(IOS)
    list(FILTER NACRE_PARTS EXCLUDE REGEX "^(libjpeg-turbo|OpenEXR|libwebp|libpng|libdeflate|GIFLIB|libcurl|CLI11)")
endif()
if(APPLE)
    list(APPEND NACRE_PARTS
        "MoltenVK|Apache-2.0||moltenvk|https://github.com/KhronosGroup/MoltenVK")
endif()
if(NACRE_DESKTOP)
    list(APPEND NACRE_PARTS
        "GLFW|zlib|libglfw3-dev|glfw3|https://www.glfw.org")
endif()
if(NACRE_DESKTOP OR ANDROID OR IOS)
    list(APPEND NACRE_PARTS
        "Dear ImGui|MIT|libimgui-dev|imgui|https://github.com/ocornut/imgui"
        "stb|MIT or public domain|libstb-dev|stb|https://github.com/nothings/stb")
endif()

function(nacre_notices target)
    file(READ ${CMAKE_SOURCE_DIR}/LICENSE own)
    set(text "Nacre\n\n${own}\n\nNacre is made of these parts as well:\n")
    set(bodies "")
    foreach(part ${NACRE_PARTS})
        string(REPLACE "|" ";" part "${part}")
        list(GET part 0 name)
        list(GET part 1 licence)
        list(GET part 2 package)
        list(GET part 3 port)
        list(GET part 4 source)
        string(APPEND text "  ${name}: ${licence} (${source})\n")
        foreach(file /usr/share/doc/${package}/copyright
                     ${VCPKG_INSTALLED_DIR}/${VCPKG_TARGET_TRIPLET}/share/${port}/copyright)
            if(EXISTS ${file} AND NOT IS_DIRECTORY ${file})
                file(READ ${file} body)
                string(APPEND bodies "\n---- ${name}\n\n${body}")
                break()
            endif()
        endforeach()
    endforeach()
    set(plain ${CMAKE_BINARY_DIR}/generated/notices.txt)
    file(WRITE ${plain} "${text}${bodies}")
    file(READ ${plain} bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    set(source ${CMAKE_BINARY_DIR}/generated/notices.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
         "namespace nacre::app {\nextern const unsigned char kNoticesBytes[];\nconst unsigned char kNoticesBytes[] = {@bytes@0};\n}\n")
    target_sources(${target} PRIVATE ${source})
endfunction()
