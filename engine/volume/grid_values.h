#pragma once
// Grid values in text: numbers between blanks, the last axis fastest. Used by read_dx.cpp and read_cube.cpp.

#include <string>
#include <string_view>
#include <vector>

#include "engine/volume/map_grid.h"

namespace nacre {

class GridValues {
public:
    /// @param perNode  numbers per node: only the first is used
    GridValues(const std::string& name, const glm::ivec3& size, const MapLimits& limits, std::size_t perNode = 1);
    /// Reads the expected number of values. @param line  of the text's first @throws Error if some are missing
    void read(std::string_view text, std::uint64_t line);
    /// With the first axis fastest.
    std::vector<float> done() { return std::move(values_); }

private:
    const std::string& name_;
    glm::ivec3 size_;
    std::size_t perNode_;
    std::vector<float> values_;
};

}  // namespace nacre
