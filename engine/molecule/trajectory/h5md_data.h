#pragma once
// HDF5 files: H5MD (particles/GROUP/position/value) and MDTraj's (coordinates, in nm). Uses libhdf5, which is loaded on
// first use, and missing on phones. Its serial build allows one call at a time: hold an Hdf5Lock. Files are untrusted:
// links to other files, external storage and plug-in filters are refused, and types and texts are checked before the
// library converts them. Damaged files can still crash it, so the server reads none.

#include <hdf5.h>

#include <array>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/molecule/trajectory/hdf5_heaps.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

/// While it exists, no other thread reads HDF5 through these readers, and the library prints no errors of this thread.
class Hdf5Lock {
public:
    Hdf5Lock();
    ~Hdf5Lock();
    Hdf5Lock(const Hdf5Lock&) = delete;
    Hdf5Lock& operator=(const Hdf5Lock&) = delete;

private:
    std::unique_lock<std::mutex> lock_;
    H5E_auto2_t print_ = nullptr;  ///< the setting of other users of the library in this process
    void* printTo_ = nullptr;
};

/// An HDF5 handle and the function that closes it.
class Hdf5Handle {
public:
    Hdf5Handle() = default;
    Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    ~Hdf5Handle() {
        if (id_ >= 0) close_(id_);
    }
    operator hid_t() const { return id_; }
    bool valid() const { return id_ >= 0; }

private:
    hid_t id_ = -1;
    herr_t (*close_)(hid_t) = nullptr;
};

using Hdf5Sizes = std::vector<hsize_t>;

/// The positions of an HDF5 file, frame by frame, and its other data by their paths. @throws Hdf5Fault
class H5mdData {
public:
    static H5mdData ofFile(const std::string& path);
    /// @param bytes  of the file; they must outlive this
    static H5mdData ofBytes(std::string_view bytes);

    std::uint64_t atoms() const { return sizes_[1]; }
    std::uint64_t frames() const { return sizes_[0]; }
    /// Path of the group of particles; empty in MDTraj's files.
    const std::string& group() const { return group_; }

    /// Reads positions, box and time. False if the frame is damaged. @param result  has as many positions as atoms
    bool read(std::size_t frame, TrajectoryFrame& result) const;
    /// Whether the box repeats along each of its vectors.
    const std::array<bool, 3>& repeats() const { return repeats_; }

    /// A dataset in this file itself; invalid if there is none.
    Hdf5Handle dataset(const std::string& path) const;
    /// An element of H5MD: constant, or with a value per frame.
    Hdf5Handle element(const std::string& path) const;
    static Hdf5Sizes readSizes(const Hdf5Handle& set);

    /// One row, as doubles; empty if it does not have this many numbers. Data without frames apply to all.
    static std::vector<double> readNumbers(const Hdf5Handle& set, std::size_t frame, std::size_t count, bool framed);
    /// As above for a number per atom, per frame or constant.
    static std::vector<double> readValues(const Hdf5Handle& set, std::size_t frame, std::size_t count);
    /// As above for texts of any string type. @param mostBytes  in memory
    std::vector<std::string> readTexts(const Hdf5Handle& set, std::size_t count, std::size_t mostBytes);
    /// Names of an enumeration's values; empty for any other type.
    static std::map<double, std::string> readEnumeration(const Hdf5Handle& set);
    /// Å per unit of a dataset, by its attribute "unit".
    double readScale(const Hdf5Handle& set);

private:
    H5mdData(hid_t opened, Hdf5Heaps::Read read, std::uint64_t fileBytes);
    std::string readFirstName(const char* group) const;
    bool isHardLink(const std::string& path) const;
    hsize_t chunkBytes() const;
    void readBoundary();

    Hdf5Handle file_;
    Hdf5Heaps heaps_;
    mutable std::set<std::string> hardLinks_;  ///< known ones: elements share their groups
    Hdf5Handle positions_, edges_, angles_, times_;
    Hdf5Sizes sizes_;
    std::string group_;
    std::array<bool, 3> repeats_{true, true, true};
    double scale_ = 1, edgeScale_ = 1;
};

}  // namespace nacre
