#pragma once
// CCP4/MRC maps, parsed in pieces from a file or decompressor. Format: A. Cheng et al. (2015), MRC2014: Extensions to
// the MRC format header, J. Struct. Biol. 192, 146-150.

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/volume/map_grid.h"

namespace nacre {

class Ccp4Reader {
public:
    static constexpr std::size_t kHeader = 1024;

    /// @param mostBytes  limit of the inflated file: a header that announces more is refused before memory is allocated
    Ccp4Reader(std::string name, const MapLimits& limits, std::uint64_t mostBytes)
        : name_(std::move(name)), limits_(limits), mostBytes_(mostBytes) {}

    /// Takes the next bytes of the file. @throws Error
    void take(std::string_view bytes);
    /// Call after the last bytes. @throws Error if bytes are missing, or no value is a number
    DensityMap finish();

    /// Whether the first bytes may be such a map: they contain the word MAP, or a plausible header.
    static bool recognises(std::string_view start);

private:
    void readHeader();
    void findByteOrder();
    void readGeometry();
    void readOperations();
    void takeValues(std::string_view& bytes);
    template <typename Stored, typename Convert>
    void convert(std::string_view bytes, const Convert& convert);
    std::int32_t integer(int word) const;
    float real(int word) const;

    std::string name_;
    MapLimits limits_;
    std::uint64_t mostBytes_;
    std::string header_;  ///< with the extended header
    bool known_ = false;  ///< the header is complete
    bool swapped_ = false, unsignedBytes_ = false;
    int mode_ = 0;
    std::size_t extended_ = 0, valueBytes_ = 0;
    MapBox box_;
    bool placed_ = false;  ///< placed by ORIGIN, not NSTART
    glm::dvec3 place_{};
    std::string rest_;         ///< first bytes of a value split between pieces
    std::uint64_t taken_ = 0;  ///< values
    glm::ivec3 files_{};       ///< columns, rows, sections
    glm::ivec3 at_{};          ///< index of the next value: column, row, section
    std::array<std::size_t, 3> strides_{};
    std::vector<std::string> warnings_;
};

}  // namespace nacre
