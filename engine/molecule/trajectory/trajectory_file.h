#pragma once
// Bounds-checked reading of a binary file in pieces; and the readers of the formats.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/byte_file.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

class TrajectoryFile {
public:
    /// @throws Error
    explicit TrajectoryFile(const std::string& path);
    TrajectoryFile(std::string name, std::shared_ptr<ByteFile> file) : name_(std::move(name)), file_(std::move(file)) {}

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return file_->size(); }
    bool holds(std::uint64_t offset, std::uint64_t count) const { return offset <= size() && count <= size() - offset; }
    /// @throws Error if the file does not contain these bytes
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;
    [[noreturn]] void fail(const std::string& why) const { throw Error("cannot read trajectory", name_, why); }

private:
    std::string name_;
    std::shared_ptr<ByteFile> file_;
};

/// A number from a file. @param swapped  the file's byte order is not this machine's
template <typename Number>
Number numberAt(const std::byte* bytes, bool swapped) {
    std::array<std::byte, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes, sizeof(Number));
    if (swapped)
        for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) std::swap(raw[i], raw[sizeof(Number) - 1 - i]);
    return std::bit_cast<Number>(raw);
}

/// Consecutive numbers of a file.
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
    /// A number in double or single precision.
    double next(bool twice) { return twice ? next<double>() : static_cast<double>(next<float>()); }
    std::uint64_t offset() const { return offset_; }
    void skip(std::uint64_t bytes) { offset_ += bytes; }

private:
    const TrajectoryFile& file_;
    std::uint64_t offset_;
    bool swapped_;
};

constexpr bool kBigEndianSwapped = std::endian::native == std::endian::little;  ///< for files in XDR and NetCDF

/// Refuses impossible numbers of atoms: zero, or more than kMaxAtoms. @throws Error
std::size_t checkedAtoms(const TrajectoryFile& file, std::int64_t atoms);

using OwnedFile = std::unique_ptr<TrajectoryFile>;

/// Base of trajectories in files.
class FileTrajectory : public Trajectory {
protected:
    FileTrajectory(OwnedFile file, const char* format, bool swapped = kBigEndianSwapped);

    /// Non-finite positions are refused afterwards.
    virtual void readWhole(std::size_t frame, TrajectoryFrame& result) = 0;
    NumberReader numbersAt(std::uint64_t offset) const { return {*file_, offset, swapped_}; }
    /// x, y and z of all atoms in turn. @param twice  in double precision @param factor  Å per unit
    void readPositions(std::uint64_t offset, bool twice, float factor, TrajectoryFrame& result);
    [[noreturn]] void damaged(std::size_t frame) const {
        file_->fail("frame " + std::to_string(frame + 1) + " is damaged");
    }

    OwnedFile file_;
    bool swapped_;
    std::vector<std::byte> buffer_;

private:
    void readFrame(std::size_t frame, TrajectoryFrame& result) final;
};

std::unique_ptr<Trajectory> openDcd(OwnedFile file, bool swapped);
std::unique_ptr<Trajectory> openXtc(OwnedFile file);
std::unique_ptr<Trajectory> openTrr(OwnedFile file);
std::unique_ptr<Trajectory> openNetcdf(OwnedFile file);
std::unique_ptr<Trajectory> openH5md(OwnedFile file);
/// The models of a structure file. @throws Error if their atoms differ, or it has no positions
std::unique_ptr<Trajectory> openModels(const std::string& path);

}  // namespace nacre
