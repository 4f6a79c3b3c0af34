#pragma once
// One column of a BinaryCIF category: undoes its chain of encodings and returns its values row by row. Encodings:
// github.com/molstar/BinaryCIF, encoding.md.

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/formats/msgpack.h"
#include "engine/molecule/formats/packed_integers.h"

namespace nacre {

class BcifColumn {
public:
    /// @param column the map with "data" and, if values are missing, "mask"; the file's bytes must outlive this
    /// @param rows   rows of the category
    /// @param mostStrings  maximum of different strings
    /// @throws PackedFault if it is malformed, as far as can be seen before reading values
    BcifColumn(const MsgpackValue& column, std::size_t rows, std::size_t mostStrings);

    /// The next row's value. @throws PackedFault if there is none, or it is malformed
    MmcifCell next();
    /// Call after the last row. @throws PackedFault if values remain
    void finish();

private:
    enum class Kind : std::uint8_t { integers, fixedPoint, intervals, float32, float64, strings };

    void decode(const MsgpackValue& data, std::size_t rows);
    void decodeFloats(std::string_view bytes, std::size_t rows);
    void decodeStrings(const MsgpackValue& encoding, std::string_view bytes, std::size_t rows);
    std::string_view string(std::int32_t index) const;

    Kind kind_ = Kind::integers;
    std::size_t mostStrings_;
    IntegersPointer integers_;            ///< or, for strings, the string's index; -1: none
    std::string_view floats_;             ///< little-endian, in the file's bytes
    std::string_view text_;               ///< the different strings, concatenated
    std::vector<std::uint32_t> offsets_;  ///< begin of each, and the end of the last
    IntegersPointer missing_;             ///< null: none missing; else 1 is '.', 2 is '?'
    double factor_ = 1, lowest_ = 0;      ///< fixed point: the divisor; intervals: step and lowest value
};

}  // namespace nacre
