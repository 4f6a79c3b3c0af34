#pragma once
// One column of a BinaryCIF category: its chain of encodings undone, its values handed out row after row.
// Encodings as github.com/molstar/BinaryCIF, encoding.md, has them.

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
    /// @param rows   rows of the category
    /// @param mostStrings  different strings that it may hold
    /// @throws PackedFault if it is malformed, as far as that is seen before its values are
    BcifColumn(const MsgpackValue& column, std::size_t rows, std::size_t mostStrings);

    /// The next row's value. @throws PackedFault if there is none, or it is malformed
    MmcifCell next();
    /// To be called after the last row. @throws PackedFault if there are values left
    void finish();

private:
    enum class Kind : std::uint8_t { integers, fixedPoint, intervals, float32, float64, strings };

    void decode(const MsgpackValue& data, std::size_t rows);
    void decodeFloats(std::string_view bytes, std::size_t rows);
    void decodeStrings(const MsgpackValue& encoding, std::string_view bytes, std::size_t rows);
    std::string_view string(std::int32_t index) const;

    Kind kind_ = Kind::integers;
    std::size_t mostStrings_;
    IntegersPointer integers_;            ///< or, of strings, which one; -1 is none
    std::string_view floats_;             ///< little-endian, as they lie in the file
    std::string_view text_;               ///< the different strings, one after the other
    std::vector<std::uint32_t> offsets_;  ///< where each of them begins, and the end of the last
    IntegersPointer missing_;             ///< null: no value is; else 1 is '.', 2 is '?'
    double factor_ = 1, lowest_ = 0;      ///< of fixed point: the divisor; of intervals: the step, and where they begin
};

}  // namespace nacre
