// HDF5 trajectories: H5MD (particles/GROUP/position/value) and MDTraj's (coordinates, in nm). By libhdf5, which is
// loaded for the first of them, and is not on phones. Its serial build takes one call at a time. Files come from
// anywhere, so links to other files, storage in other files and filters from plug-ins are not followed.

#include "engine/molecule/trajectory/trajectory_file.h"

#ifdef NACRE_HDF5
#include <dlfcn.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace nacre {
namespace {

// clang-format off
#define NACRE_HDF5_CALLS(CALL) \
    CALL(H5open) CALL(H5Eset_auto2) CALL(H5PLset_loading_state) CALL(H5Fopen) \
    CALL(H5Fclose) CALL(H5Gopen2) CALL(H5Gclose) CALL(H5Literate) \
    CALL(H5Lget_info) CALL(H5Dopen2) CALL(H5Dclose) CALL(H5Dget_create_plist) \
    CALL(H5Pget_layout) CALL(H5Pget_external_count) CALL(H5Pget_chunk) CALL(H5Pclose) \
    CALL(H5Dget_space) CALL(H5Sget_simple_extent_ndims) CALL(H5Sget_simple_extent_dims) CALL(H5Screate_simple) \
    CALL(H5Sselect_hyperslab) CALL(H5Sclose) CALL(H5Dread) CALL(H5Aopen) \
    CALL(H5Aread) CALL(H5Aget_type) CALL(H5Aclose) CALL(H5Tis_variable_str) \
    CALL(H5Tget_size) CALL(H5Tclose) CALL(H5free_memory)
// clang-format on

/// The library's functions. NACRE_HDF5 is its file's name.
struct Hdf5Library {
#define NACRE_HDF5_MEMBER(call) decltype(&::call) call = nullptr;
    NACRE_HDF5_CALLS(NACRE_HDF5_MEMBER)
#undef NACRE_HDF5_MEMBER
    hid_t nativeDouble = -1;
    std::string missing;  ///< why it cannot be used; empty: it can
};

const Hdf5Library& hdf5() {
    static const Hdf5Library library = [] {
        Hdf5Library loaded;
        void* const file = dlopen(NACRE_HDF5, RTLD_NOW | RTLD_LOCAL);
        if (!file) {
            loaded.missing = "it is HDF5, and " NACRE_HDF5 " is not installed";
            return loaded;
        }
        const auto find = [&](const char* name) {
            void* const found = dlsym(file, name);
            if (!found) loaded.missing = NACRE_HDF5 " lacks " + std::string(name);
            return found;
        };
#define NACRE_HDF5_FIND(name) loaded.name = reinterpret_cast<decltype(loaded.name)>(find(#name));
        NACRE_HDF5_CALLS(NACRE_HDF5_FIND)
#undef NACRE_HDF5_FIND
        if (!loaded.missing.empty() || loaded.H5open() < 0) return loaded;
        if (const void* type = find("H5T_NATIVE_DOUBLE_g")) loaded.nativeDouble = *static_cast<const hid_t*>(type);
        loaded.H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        loaded.H5PLset_loading_state(0);
        return loaded;
    }();
    return library;
}

std::mutex& hdf5Calls() {
    static std::mutex mutex;
    return mutex;
}

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

class H5md : public FileTrajectory {
public:
    explicit H5md(OwnedFile file) : FileTrajectory(std::move(file), "h5md") {
        const std::lock_guard lock(hdf5Calls());
        try {
            open();
        } catch (...) {
            close();  // while the lock is held
            throw;
        }
    }

    ~H5md() override {
        const std::lock_guard lock(hdf5Calls());
        close();
    }

private:
    static constexpr double kNanometre = 10;  // Å

    void open() {
        if (!hdf5().missing.empty()) file_->fail(hdf5().missing);
        h5_ = {hdf5().H5Fopen(name_.c_str(), 0u, H5P_DEFAULT), hdf5().H5Fclose};
        if (!h5_.valid()) file_->fail("it is not HDF5, or damaged");
        std::string group;
        positions_ = dataset("coordinates");
        if (positions_.valid()) {
            scale_ = kNanometre;
            edges_ = dataset("cell_lengths");
            angles_ = dataset("cell_angles");
            times_ = dataset("time");
        } else {
            group = "particles/" + firstOf("particles");
            positions_ = dataset(group + "/position/value");
            if (!positions_.valid()) file_->fail("it has no positions as H5MD or MDTraj write them");
            scale_ = scaleOf(positions_);
            edges_ = dataset(group + "/box/edges/value");
            if (!edges_.valid()) edges_ = dataset(group + "/box/edges");
            if (edges_.valid()) edgeScale_ = scaleOf(edges_);
            times_ = dataset(group + "/position/time");
        }
        const Hdf5Sizes size = sizesOf(positions_);
        if (size.size() != 3 || size[2] != 3 || size[0] == 0) file_->fail("its positions are not (frame, atom, 3)");
        atoms_ = checkedAtoms(*file_, static_cast<std::int64_t>(std::min<hsize_t>(size[1], INT64_MAX)));
        frames_ = static_cast<std::size_t>(size[0]);
        // A frame may be read through a chunk that holds many.
        constexpr hsize_t kMostOfChunk = hsize_t{1} << 30;
        if (chunkBytes() > kMostOfChunk) file_->fail("its chunks are larger than 1 GB");
    }

    void close() {
        for (Hdf5Handle* handle : {&times_, &angles_, &edges_, &positions_, &h5_}) Hdf5Handle(std::move(*handle));
    }

    static herr_t nameFirst(hid_t, const char* name, const H5L_info_t*, void* first) {
        *static_cast<std::string*>(first) = name;
        return 1;
    }
    std::string firstOf(const char* group) const {
        std::string first;
        const Hdf5Handle opened(hdf5().H5Gopen2(h5_, group, H5P_DEFAULT), hdf5().H5Gclose);
        if (opened.valid()) hdf5().H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, nameFirst, &first);
        return first;
    }

    /// A dataset of this file alone; invalid if there is none.
    Hdf5Handle dataset(const std::string& path) const {
        for (std::size_t end = path.find('/');; end = path.find('/', end + 1)) {
            H5L_info_t link;
            const std::string part = path.substr(0, end);
            if (hdf5().H5Lget_info(h5_, part.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return {};
            if (end == std::string::npos) break;
        }
        Hdf5Handle opened(hdf5().H5Dopen2(h5_, path.c_str(), H5P_DEFAULT), hdf5().H5Dclose);
        if (!opened.valid()) return {};
        const Hdf5Handle layout(hdf5().H5Dget_create_plist(opened), hdf5().H5Pclose);
        if (hdf5().H5Pget_layout(layout) == H5D_VIRTUAL || hdf5().H5Pget_external_count(layout) > 0) return {};
        return opened;
    }

    static Hdf5Sizes sizesOf(const Hdf5Handle& set) {
        const Hdf5Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose);
        const int rank = hdf5().H5Sget_simple_extent_ndims(space);
        Hdf5Sizes sizes(static_cast<std::size_t>(std::max(rank, 0)));
        if (rank > 0) hdf5().H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
        return sizes;
    }

    hsize_t chunkBytes() const {
        const Hdf5Handle layout(hdf5().H5Dget_create_plist(positions_), hdf5().H5Pclose);
        hsize_t chunk[3] = {1, 1, 1};
        if (hdf5().H5Pget_layout(layout) != H5D_CHUNKED || hdf5().H5Pget_chunk(layout, 3, chunk) != 3) return 0;
        double bytes = 8;
        for (const hsize_t side : chunk) bytes *= static_cast<double>(side);
        return bytes > 1e18 ? ~hsize_t{0} : static_cast<hsize_t>(bytes);
    }

    /// Å per unit of a dataset, by its attribute "unit".
    static double scaleOf(const Hdf5Handle& set) {
        const Hdf5Handle attribute(hdf5().H5Aopen(set, "unit", H5P_DEFAULT), hdf5().H5Aclose);
        if (!attribute.valid()) return 1;
        const Hdf5Handle type(hdf5().H5Aget_type(attribute), hdf5().H5Tclose);
        std::string unit;
        if (hdf5().H5Tis_variable_str(type) > 0) {
            char* text = nullptr;
            if (hdf5().H5Aread(attribute, type, &text) >= 0 && text) unit = text;
            hdf5().H5free_memory(text);
        } else if (const std::size_t size = hdf5().H5Tget_size(type); size > 0 && size < 100) {
            unit.resize(size);
            hdf5().H5Aread(attribute, type, unit.data());
        }
        unit = unit.substr(0, unit.find('\0'));
        return unit == "nm" ? kNanometre : unit == "pm" ? 0.01 : unit == "fm" ? 1e-5 : unit == "m" ? 1e10 : 1;
    }

    /// One row, as doubles; empty if it is not of this many numbers. Data without frames hold for all of them.
    std::vector<double> rowOf(const Hdf5Handle& set, std::size_t frame, std::size_t count, bool framed) const {
        if (!set.valid()) return {};
        const Hdf5Sizes size = sizesOf(set);
        hsize_t each = 1, start[3] = {}, block[3] = {1, 1, 1};
        if (size.size() > 3 || (framed && (size.empty() || frame >= size[0]))) return {};
        for (std::size_t i = 0; i < size.size(); ++i) {
            const bool first = framed && i == 0;
            start[i] = first ? frame : 0;
            block[i] = first ? 1 : size[i];
            if (block[i] > count) return {};
            each *= block[i];
        }
        if (each != count) return {};
        std::vector<double> values(count);
        const Hdf5Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose);
        const hsize_t total = count;
        const Hdf5Handle memory(hdf5().H5Screate_simple(1, &total, nullptr), hdf5().H5Sclose);
        if (!size.empty()) hdf5().H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, block, nullptr);
        const bool read = hdf5().H5Dread(set, hdf5().nativeDouble, memory, space, H5P_DEFAULT, values.data()) >= 0;
        return read ? values : std::vector<double>();
    }

    void readWhole(std::size_t frame, TrajectoryFrame& result) override {
        const std::lock_guard lock(hdf5Calls());
        const std::vector<double> values = rowOf(positions_, frame, atoms_ * 3, true);
        if (values.empty()) damaged(frame);
        for (std::size_t i = 0; i < values.size(); ++i)
            result.positions[i / 3][static_cast<int>(i % 3)] = static_cast<float>(values[i] * scale_);
        if (const std::vector<double> time = rowOf(times_, frame, 1, true); !time.empty()) result.time = time[0];
        const bool framed = sizesOf(edges_).size() > 1;
        if (const std::vector<double> e = rowOf(edges_, frame, 3, framed); !e.empty()) {
            const std::vector<double> a = rowOf(angles_, frame, 3, true);
            const glm::dvec3 angles = a.empty() ? glm::dvec3(90) : glm::dvec3(a[0], a[1], a[2]);
            result.box = boxOf(glm::dvec3(e[0], e[1], e[2]) * (angles_.valid() ? scale_ : edgeScale_), angles);
        } else if (const std::vector<double> m = rowOf(edges_, frame, 9, sizesOf(edges_).size() > 2); !m.empty()) {
            PeriodicBox box;
            for (std::size_t i = 0; i < 9; ++i)
                box[i / 3][static_cast<int>(i % 3)] = static_cast<float>(m[i] * edgeScale_);
            result.box = box;
        }
    }

    Hdf5Handle h5_, positions_, edges_, angles_, times_;
    double scale_ = 1, edgeScale_ = 1;
};

}  // namespace

std::unique_ptr<Trajectory> openH5md(OwnedFile file) { return std::make_unique<H5md>(std::move(file)); }

}  // namespace nacre

#else

namespace nacre {

std::unique_ptr<Trajectory> openH5md(OwnedFile file) { file->fail("it is HDF5, which this program was built without"); }

}  // namespace nacre

#endif
