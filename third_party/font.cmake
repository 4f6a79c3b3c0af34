# The font of pictures and panel, built in: nacre_font() makes the library of that name from DejaVuSans.ttf, which may be
# embedded and distributed (its licence is among the notices).
find_file(NACRE_FONT DejaVuSans.ttf
          PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/dejavu-sans-fonts /usr/share/fonts/TTF
                /opt/homebrew/share/fonts /usr/local/share/fonts
          NO_CMAKE_FIND_ROOT_PATH
          DOC "DejaVu Sans (Debian: fonts-dejavu-core; else from https://dejavu-fonts.github.io)" REQUIRED)

# As eight bytes a number, which compiles in a tenth of the time that single bytes take.
if(CMAKE_SCRIPT_MODE_FILE)
    file(READ ${NACRE_FONT} bytes HEX)
    file(SIZE ${NACRE_FONT} size)
    string(APPEND bytes "00000000000000")
    string(REGEX REPLACE "(..)(..)(..)(..)(..)(..)(..)(..)" "0x\\8\\7\\6\\5\\4\\3\\2\\1," words "${bytes}")
    string(REGEX REPLACE ",[0-9a-f]*$" "," words "${words}")
    file(CONFIGURE OUTPUT ${SOURCE} @ONLY CONTENT [[
#include <bit>
#include <cstdint>
#include "app/annotation/system_font.h"
namespace nacre::app {
static_assert(std::endian::native == std::endian::little, "the words below are");
static const std::uint64_t kWords[] = {@words@};
std::span<const std::byte> fontFile() { return std::as_bytes(std::span(kWords)).first(@size@); }
}
]])
    return()
endif()

function(nacre_font)
    set(source ${CMAKE_BINARY_DIR}/generated/font.cpp)
    add_custom_command(OUTPUT ${source}
        COMMAND ${CMAKE_COMMAND} -DNACRE_FONT=${NACRE_FONT} -DSOURCE=${source}
                -P ${CMAKE_SOURCE_DIR}/third_party/font.cmake
        DEPENDS ${NACRE_FONT} ${CMAKE_SOURCE_DIR}/third_party/font.cmake
        COMMENT "Font ${NACRE_FONT}" VERBATIM)
    add_library(nacre_font STATIC ${source})
    target_include_directories(nacre_font PRIVATE ${CMAKE_SOURCE_DIR})
    target_link_libraries(nacre_font PRIVATE nacre_flags)
endfunction()
