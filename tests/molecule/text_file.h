#pragma once
// Reads a test file whole, inflating it if it is gzipped; independent of the engine's own inflation.

#include <zlib.h>

#include <stdexcept>
#include <string>

namespace nacre::test {

inline std::string readText(const std::string& path) {
    gzFile file = gzopen(path.c_str(), "rb");
    if (!file) throw std::runtime_error("cannot open " + path);
    std::string text;
    std::string block(1 << 16, '\0');
    for (int got = 0; (got = gzread(file, block.data(), static_cast<unsigned>(block.size()))) > 0;)
        text.append(block, 0, static_cast<std::size_t>(got));
    gzclose(file);
    return text;
}

}  // namespace nacre::test
