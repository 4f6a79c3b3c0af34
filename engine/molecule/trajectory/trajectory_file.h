#pragma once
// A binary file that is read in pieces, within its bounds; and the readers of the formats.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>

#include "engine/error.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

class TrajectoryFile {
public:
    /// @throws Error
    explicit TrajectoryFile(const std::string& path);
    ~TrajectoryFile();
    TrajectoryFile(const TrajectoryFile&) = delete;
    TrajectoryFile& operator=(const TrajectoryFile&) = delete;

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }
    bool holds(std::uint64_t offset, std::uint64_t count) const { return offset <= size_ && count <= size_ - offset; }
    /// @throws Error if the file does not hold that
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;
    [[noreturn]] void fail(const std::string& why) const { throw Error("cannot read trajectory", name_, why); }

private:
    std::string name_;
    int file_ = -1;
    std::uint64_t size_ = 0;
};

/// A number as it stands in a file. @param swapped  whether the file's byte order is not this machine's
template <typename Number>
Number numberAt(const std::byte* bytes, bool swapped) {
    std::array<std::byte, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes, sizeof(Number));
    if (swapped)
        for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) std::swap(raw[i], raw[sizeof(Number) - 1 - i]);
    return std::bit_cast<Number>(raw);
}

/// Numbers one after the other from a place of a file.
class NumberReader {
public:
    NumberReader(const TrajectoryFile& file, std::uint64_t offset, bool swapped)
        : file_(file), offset_(offset), swapped_(swapped) {}
    template <typename Number>
    Number next() {
        std::array<std::byte, sizeof(Number)> bytes;
        file_.read(offset_, bytes);
        offset_ += sizeof(Number);
        return numberAt<Number>(bytes.data(), swapped_);
    }
    std::uint64_t offset() const { return offset_; }
    void skip(std::uint64_t bytes) { offset_ += bytes; }

private:
    const TrajectoryFile& file_;
    std::uint64_t offset_;
    bool swapped_;
};

constexpr bool kBigEndianSwapped = std::endian::native == std::endian::little;  ///< of files in XDR and NetCDF

/// Numbers of atoms that no frame has are refused: more than kMaxAtoms, or none. @throws Error
std::size_t checkedAtoms(const TrajectoryFile& file, std::int64_t atoms);
/// @throws Error of a number that is none
void checkFinite(const TrajectoryFile& file, std::size_t frame, std::span<const glm::vec3> positions);

using OwnedFile = std::unique_ptr<TrajectoryFile>;
std::unique_ptr<Trajectory> openDcd(OwnedFile file, bool swapped);
std::unique_ptr<Trajectory> openXtc(OwnedFile file);
std::unique_ptr<Trajectory> openTrr(OwnedFile file);
std::unique_ptr<Trajectory> openNetcdf(OwnedFile file);

}  // namespace nacre
