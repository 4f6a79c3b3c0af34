#pragma once
// The encoded arrays of an MMTF file (github.com/rcsb/mmtf, spec.md): twelve bytes of header, then the codec's data.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/formats/msgpack.h"
#include "engine/molecule/formats/packed_integers.h"

namespace nacre {

/// An encoded array of integers as a stream. Errors name file and field.
class MmtfIntegers {
public:
    /// @throws Error if there is none left
    std::int32_t next();

private:
    friend class MmtfFields;
    friend class MmtfFloats;
    const class MmtfFields* fields_ = nullptr;
    const char* field_ = "";
    IntegersPointer values_;  ///< null: all are equal
    std::int32_t otherwise_ = 0;
};

/// An encoded array of numbers.
class MmtfFloats {
public:
    float next();

private:
    friend class MmtfFields;
    MmtfIntegers values_;
    double divisor_ = 1;
    bool bits_ = false;  ///< the integers are the bits of floats
};

/// The top level of an MMTF document. Arrays are streams, so that announced sizes take no memory. Errors name file and
/// field.
class MmtfFields {
public:
    MmtfFields(const std::string& name, std::string_view document);

    /// A count such as numAtoms. @throws Error if it is missing, or exceeds `limit` or the file's size
    std::size_t count(const char* field, std::size_t limit) const;
    std::size_t bytes() const { return bytes_; }
    /// "" if it is missing
    std::string text(const char* field) const;
    MsgpackValue list(const char* field) const { return root_.find(field).value_or(MsgpackValue{}); }
    bool has(const char* field) const;

    /// An array of exactly `size` values. @throws Error if it is missing or states another size; the stream throws if
    /// its size differs
    MmtfFloats floats(const char* field, std::size_t size) const;
    MmtfIntegers integers(const char* field, std::size_t size) const;
    /// As above; every value is `otherwise` if the file has no such array.
    MmtfFloats floats(const char* field, std::size_t size, std::int32_t otherwise) const;
    MmtfIntegers integers(const char* field, std::size_t size, std::int32_t otherwise) const;
    /// Names, pointing into the document.
    std::vector<std::string_view> names(const char* field, std::size_t size) const;

    [[noreturn]] void fail(const std::string& why) const;

private:
    struct Encoded {
        std::int32_t codec = 0;
        std::int32_t parameter = 0;
        std::string_view data;
    };
    Encoded encoded(const char* field, std::size_t size) const;
    MmtfIntegers decode(const char* field, const Encoded& array, std::size_t size) const;

    const std::string& name_;
    std::size_t bytes_;
    MsgpackValue root_;
};

}  // namespace nacre
