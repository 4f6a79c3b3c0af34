#pragma once
// The encoded arrays of an MMTF file (github.com/rcsb/mmtf, spec.md): twelve bytes of header, then the codec's data.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/formats/msgpack.h"
#include "engine/molecule/formats/packed_integers.h"

namespace nacre {

/// The top level of an MMTF document. Every size is known before an array is unpacked, and is no more than the file
/// has bytes. Errors name file and field.
class MmtfFields {
public:
    MmtfFields(const std::string& name, std::string_view document);

    /// A count such as numAtoms. @throws Error if it is missing, or exceeds `limit` or the bytes of the file
    std::size_t count(const char* field, std::size_t limit) const;
    std::size_t bytes() const { return bytes_; }
    /// "" if it is missing
    std::string text(const char* field) const;
    MsgpackValue list(const char* field) const { return root_.find(field).value_or(MsgpackValue{}); }
    bool has(const char* field) const;

    /// An array of exactly `size` values. @throws Error if it is missing or is not that
    std::vector<float> floats(const char* field, std::size_t size) const;
    Integers integers(const char* field, std::size_t size) const;
    std::vector<std::string> names(const char* field, std::size_t size) const;

    [[noreturn]] void fail(const std::string& why) const;

private:
    struct Encoded {
        std::int32_t codec = 0;
        std::int32_t parameter = 0;
        std::string_view data;
    };
    Encoded encoded(const char* field, std::size_t size) const;
    Integers decode(const Encoded& array, std::size_t size) const;

    const std::string& name_;
    std::size_t bytes_;
    MsgpackValue root_;
};

}  // namespace nacre
