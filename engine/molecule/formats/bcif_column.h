#pragma once
// One column of a BinaryCIF category: its chain of encodings undone, its values handed out by row.
// Encodings as github.com/molstar/BinaryCIF, encoding.md, has them. Must also compile as C++17.

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/formats/msgpack.h"
#include "engine/molecule/formats/packed_integers.h"

namespace nacre {

class BcifColumn {
public:
    /// @param column the map with "data" and, where values are missing, "mask"; the file's bytes must outlive this
    /// @param rows   rows of the category, no more than the file has bytes
    /// @throws PackedFault if it does not decode to exactly that many values
    BcifColumn(const MsgpackValue& column, std::size_t rows);

    /// @param row below the number of rows
    MmcifCell cell(std::size_t row) const;

private:
    enum class Kind : std::uint8_t { integers, fixedPoint, intervals, float32, float64, strings };

    void decode(const MsgpackValue& data, std::size_t rows);
    void decodeFloats(std::string_view bytes, std::size_t rows);
    void decodeStrings(const MsgpackValue& encoding, std::string_view bytes, std::size_t rows);

    Kind kind_ = Kind::integers;
    Integers integers_;                      ///< or, of strings, which one; -1 is none
    std::string_view floats_;                ///< little-endian, as they lie in the file
    std::vector<std::string_view> strings_;  ///< the different ones
    std::vector<std::uint8_t> missing_;      ///< empty: no value is
    double factor_ = 1, lowest_ = 0;  ///< of fixed point: the divisor; of intervals: the step, and where they begin
};

}  // namespace nacre
