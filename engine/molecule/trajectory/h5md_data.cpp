#ifdef NACRE_HDF5
#include "engine/molecule/trajectory/h5md_data.h"

#include <dlfcn.h>

#include <algorithm>

#include "engine/molecule/byte_file.h"
#include "engine/molecule/read.h"

namespace nacre {
namespace {

// clang-format off
#define NACRE_HDF5_CALLS(CALL) \
    CALL(H5open) CALL(H5Eset_auto2) CALL(H5Eget_auto2) CALL(H5PLset_loading_state) CALL(H5Fopen) \
    CALL(H5Fclose) CALL(H5Gopen2) CALL(H5Gclose) CALL(H5Literate) \
    CALL(H5Lget_info) CALL(H5Dopen2) CALL(H5Dclose) CALL(H5Dget_create_plist) CALL(H5Dget_type) \
    CALL(H5Pget_layout) CALL(H5Pget_external_count) CALL(H5Pget_chunk) CALL(H5Pclose) \
    CALL(H5Pcreate) CALL(H5Pset_fapl_core) CALL(H5Pset_file_image) \
    CALL(H5Dget_space) CALL(H5Sget_simple_extent_ndims) CALL(H5Sget_simple_extent_dims) CALL(H5Screate_simple) \
    CALL(H5Sselect_hyperslab) CALL(H5Sclose) CALL(H5Dread) CALL(H5Aopen) CALL(H5Oopen) CALL(H5Oclose) \
    CALL(H5Aread) CALL(H5Aget_type) CALL(H5Aclose) CALL(H5Aget_space) CALL(H5Tis_variable_str) CALL(H5Tget_class) \
    CALL(H5Tget_nmembers) CALL(H5Tget_member_name) CALL(H5Tget_member_value) CALL(H5Tconvert) CALL(H5Tget_super) \
    CALL(H5Tget_size) CALL(H5Tclose) CALL(H5free_memory)
// clang-format on

/// The library's functions. NACRE_HDF5 is its file's name.
struct Hdf5Library {
#define NACRE_HDF5_MEMBER(call) decltype(&::call) call = nullptr;
    NACRE_HDF5_CALLS(NACRE_HDF5_MEMBER)
#undef NACRE_HDF5_MEMBER
    hid_t nativeDouble = -1, fileAccess = -1;
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
        const auto value = [&](const char* name) {
            const void* const found = find(name);
            return found ? *static_cast<const hid_t*>(found) : hid_t{-1};
        };
        loaded.nativeDouble = value("H5T_NATIVE_DOUBLE_g");
        loaded.fileAccess = value("H5P_CLS_FILE_ACCESS_ID_g");
        loaded.H5PLset_loading_state(0);
        return loaded;
    }();
    return library;
}

constexpr unsigned kReadOnly = 0;  // H5F_ACC_RDONLY calls the library by its names
constexpr double kNanometre = 10;  // Å

void requireLibrary() {
    if (!hdf5().missing.empty()) throw Hdf5Fault(hdf5().missing);
}

herr_t nameFirst(hid_t, const char* name, const H5L_info_t*, void* first) {
    *static_cast<std::string*>(first) = name;
    return 1;
}

/// Into memory that is asked for once the sizes are known to be these.
template <typename Allocate>
bool readRow(const Hdf5Handle& set, std::size_t frame, std::size_t count, bool framed, hid_t type,
             const Allocate& allocate) {
    const Hdf5Sizes size = H5mdData::sizesOf(set);
    hsize_t each = 1, start[3] = {}, block[3] = {1, 1, 1};
    if (size.size() > 3 || (framed && (size.empty() || frame >= size[0]))) return false;
    for (std::size_t i = 0; i < size.size(); ++i) {
        const bool first = framed && i == 0;
        start[i] = first ? frame : 0;
        block[i] = first ? 1 : size[i];
        if (block[i] > count) return false;
        each *= block[i];
    }
    if (each != count || count == 0) return false;
    const Hdf5Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose);
    const hsize_t total = count;
    const Hdf5Handle memory(hdf5().H5Screate_simple(1, &total, nullptr), hdf5().H5Sclose);
    if (!size.empty()) hdf5().H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, block, nullptr);
    return hdf5().H5Dread(set, type, memory, space, H5P_DEFAULT, allocate()) >= 0;
}

std::mutex& hdf5Calls() {
    static std::mutex mutex;
    return mutex;
}

/// Texts of an attribute that has so many strings, of either kind; none of any other attribute.
std::vector<std::string> attributeTexts(hid_t attribute, std::size_t count) {
    constexpr std::size_t kLongest = 100;
    const Hdf5Handle type(hdf5().H5Aget_type(attribute), hdf5().H5Tclose);
    const Hdf5Handle space(hdf5().H5Aget_space(attribute), hdf5().H5Sclose);
    const int rank = hdf5().H5Sget_simple_extent_ndims(space);
    hsize_t there = 1;
    if (hdf5().H5Tget_class(type) != H5T_STRING || rank < 0 || rank > 1) return {};
    if (rank == 1) hdf5().H5Sget_simple_extent_dims(space, &there, nullptr);
    if (there != count) return {};
    std::vector<std::string> texts;
    if (hdf5().H5Tis_variable_str(type) > 0) {
        std::vector<char*> own(count);
        if (hdf5().H5Aread(attribute, type, own.data()) < 0) return {};
        for (char* const text : own) {
            texts.emplace_back(text ? text : "");
            hdf5().H5free_memory(text);
        }
        return texts;
    }
    const std::size_t size = hdf5().H5Tget_size(type);
    if (size == 0 || size > kLongest) return {};
    std::string bytes(count * size, '\0');
    if (hdf5().H5Aread(attribute, type, bytes.data()) < 0) return {};
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view text = std::string_view(bytes).substr(i * size, size);
        texts.emplace_back(text.substr(0, text.find('\0')));
    }
    return texts;
}

/// The library reads texts of any length from heaps, and never ends in one that has a free object of no bytes.
/// @throws Hdf5Fault
void checkHeaps(std::string_view bytes) {
    constexpr std::size_t kHead = 16;  // of a heap, and of each of its objects: number, uses, 4 bytes, size
    const auto numberIn = [](std::string_view text, std::uint64_t at, std::size_t count) {
        std::uint64_t value = 0;
        while (count-- > 0) value = value << 8 | static_cast<unsigned char>(text[at + count]);
        return value;
    };
    std::size_t steps = 0;  // heaps that overlap would be walked again and again
    constexpr std::string_view kHeap("GCOL\1\0\0\0", 8);
    for (std::size_t heap = 0; (heap = bytes.find(kHeap, heap)) != std::string_view::npos; ++heap) {
        const std::string_view rest = bytes.substr(heap);
        if (rest.size() < kHead) return;
        const std::uint64_t whole = numberIn(rest, 8, 8);
        for (std::uint64_t at = kHead; at + kHead <= std::min<std::uint64_t>(whole, rest.size());) {
            const std::uint64_t size = numberIn(rest, at + 8, 8);
            const bool isFree = numberIn(rest, at, 2) == 0;
            if (++steps > bytes.size() || size > whole - at || (isFree && size == 0))
                throw Hdf5Fault("it is damaged: a heap that does not end");
            at += isFree ? size : kHead + (size + 7) / 8 * 8;
        }
    }
}

}  // namespace

Hdf5Lock::Hdf5Lock() : lock_(hdf5Calls()) {
    if (!hdf5().missing.empty()) return;
    hdf5().H5Eget_auto2(H5E_DEFAULT, &print_, &printTo_);
    hdf5().H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Lock::~Hdf5Lock() {
    if (hdf5().missing.empty()) hdf5().H5Eset_auto2(H5E_DEFAULT, print_, printTo_);
}

H5mdData H5mdData::ofFile(const std::string& path) {
    requireLibrary();
    constexpr std::uint64_t kMostChecked = std::uint64_t{16} << 20;  // of a trajectory that may be huge
    if (const std::shared_ptr<ByteFile> file = ByteFile::open(path)) {
        std::string begin(static_cast<std::size_t>(std::min(file->size(), kMostChecked)), '\0');
        file->read(0, begin.data(), begin.size());
        checkHeaps(begin);
    }
    return H5mdData(hdf5().H5Fopen(path.c_str(), kReadOnly, H5P_DEFAULT));
}

H5mdData H5mdData::ofBytes(std::string_view bytes) {
    requireLibrary();
    checkHeaps(bytes);
    constexpr std::size_t kIncrement = std::size_t{1} << 20;
    const Hdf5Handle access(hdf5().H5Pcreate(hdf5().fileAccess), hdf5().H5Pclose);
    if (hdf5().H5Pset_fapl_core(access, kIncrement, 0) < 0 ||
        hdf5().H5Pset_file_image(access, const_cast<char*>(bytes.data()), bytes.size()) < 0)
        throw Hdf5Fault("libhdf5 does not read from memory");
    return H5mdData(hdf5().H5Fopen("memory", kReadOnly, access));
}

bool H5mdData::read(std::size_t frame, TrajectoryFrame& result) const {
    const std::vector<double> values = rowOf(positions_, frame, atoms() * 3, true);
    if (values.empty()) return false;
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
        for (std::size_t i = 0; i < 9; ++i) box[i / 3][static_cast<int>(i % 3)] = static_cast<float>(m[i] * edgeScale_);
        result.box = box;
    }
    return true;
}

Hdf5Handle H5mdData::dataset(const std::string& path) const {
    for (std::size_t end = path.find('/');; end = path.find('/', end + 1)) {
        H5L_info_t link;
        const std::string part = path.substr(0, end);
        if (hdf5().H5Lget_info(file_, part.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return {};
        if (end == std::string::npos) break;
    }
    Hdf5Handle opened(hdf5().H5Dopen2(file_, path.c_str(), H5P_DEFAULT), hdf5().H5Dclose);
    if (!opened.valid()) return {};
    const Hdf5Handle layout(hdf5().H5Dget_create_plist(opened), hdf5().H5Pclose);
    if (hdf5().H5Pget_layout(layout) == H5D_VIRTUAL || hdf5().H5Pget_external_count(layout) > 0) return {};
    return opened;
}

Hdf5Handle H5mdData::element(const std::string& path) const {
    Hdf5Handle varying = dataset(path + "/value");
    return varying.valid() ? std::move(varying) : dataset(path);
}

Hdf5Sizes H5mdData::sizesOf(const Hdf5Handle& set) {
    const Hdf5Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose);
    const int rank = hdf5().H5Sget_simple_extent_ndims(space);
    Hdf5Sizes sizes(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) hdf5().H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
    return sizes;
}

std::vector<double> H5mdData::rowOf(const Hdf5Handle& set, std::size_t frame, std::size_t count, bool framed) {
    std::vector<double> values;
    const bool read = set.valid() && readRow(set, frame, count, framed, hdf5().nativeDouble, [&] {
                          values.resize(count);
                          return values.data();
                      });
    return read ? values : std::vector<double>();
}

std::vector<double> H5mdData::valuesOf(const Hdf5Handle& set, std::size_t frame, std::size_t count) {
    return set.valid() ? rowOf(set, frame, count, sizesOf(set).size() > 1) : std::vector<double>();
}

std::vector<std::string> H5mdData::textsOf(const Hdf5Handle& set, std::size_t count, std::size_t mostBytes) {
    std::vector<std::string> texts;
    if (!set.valid()) return texts;
    const Hdf5Handle type(hdf5().H5Dget_type(set), hdf5().H5Tclose);
    if (hdf5().H5Tget_class(type) != H5T_STRING) return texts;
    const std::size_t size = hdf5().H5Tget_size(type);
    if (size == 0 || count > mostBytes / size) return texts;
    const bool framed = sizesOf(set).size() > 1;
    if (hdf5().H5Tis_variable_str(type) > 0) {
        std::vector<char*> pointers;
        const bool read = readRow(set, 0, count, framed, type, [&] {
            pointers.resize(count);
            return pointers.data();
        });
        for (char* const text : pointers) {
            texts.emplace_back(read && text ? text : "");
            hdf5().H5free_memory(text);
        }
        return read ? texts : std::vector<std::string>();
    }
    std::string bytes;
    const bool read = readRow(set, 0, count, framed, type, [&] {
        bytes.resize(count * size);
        return bytes.data();
    });
    for (std::size_t i = 0; read && i < count; ++i) {
        const std::string_view text = std::string_view(bytes).substr(i * size, size);
        texts.emplace_back(text.substr(0, text.find('\0')));
    }
    return texts;
}

std::map<double, std::string> H5mdData::enumerationOf(const Hdf5Handle& set) {
    std::map<double, std::string> names;
    if (!set.valid()) return names;
    const Hdf5Handle type(hdf5().H5Dget_type(set), hdf5().H5Tclose);
    if (hdf5().H5Tget_class(type) != H5T_ENUM) return names;
    const Hdf5Handle base(hdf5().H5Tget_super(type), hdf5().H5Tclose);
    const int count = hdf5().H5Tget_nmembers(type);
    for (int i = 0; i < count && hdf5().H5Tget_size(base) <= sizeof(double); ++i) {
        double value = 0;
        char* const name = hdf5().H5Tget_member_name(type, static_cast<unsigned>(i));
        if (name && hdf5().H5Tget_member_value(type, static_cast<unsigned>(i), &value) >= 0 &&
            hdf5().H5Tconvert(base, hdf5().nativeDouble, 1, &value, nullptr, H5P_DEFAULT) >= 0)
            names.emplace(value, name);
        hdf5().H5free_memory(name);
    }
    return names;
}

double H5mdData::scaleOf(const Hdf5Handle& set) {
    const Hdf5Handle attribute(hdf5().H5Aopen(set, "unit", H5P_DEFAULT), hdf5().H5Aclose);
    if (!attribute.valid()) return 1;
    const std::vector<std::string> texts = attributeTexts(attribute, 1);
    const std::string unit = texts.empty() ? "" : texts[0];
    return unit == "nm" ? kNanometre : unit == "pm" ? 0.01 : unit == "fm" ? 1e-5 : unit == "m" ? 1e10 : 1;
}

H5mdData::H5mdData(hid_t opened) : file_(opened, hdf5().H5Fclose) {
    if (!file_.valid()) throw Hdf5Fault("it is not HDF5, or damaged");
    positions_ = dataset("coordinates");
    if (positions_.valid()) {
        scale_ = kNanometre;
        edges_ = dataset("cell_lengths");
        angles_ = dataset("cell_angles");
        times_ = dataset("time");
    } else {
        group_ = "particles/" + firstOf("particles");
        positions_ = dataset(group_ + "/position/value");
        if (!positions_.valid()) throw Hdf5Fault("it has no positions as H5MD or MDTraj write them");
        scale_ = scaleOf(positions_);
        edges_ = element(group_ + "/box/edges");
        if (edges_.valid()) edgeScale_ = scaleOf(edges_);
        readBoundary();
        times_ = dataset(group_ + "/position/time");
    }
    sizes_ = sizesOf(positions_);
    if (sizes_.size() != 3 || sizes_[2] != 3 || sizes_[0] == 0)
        throw Hdf5Fault("its positions are not (frame, atom, 3)");
    if (sizes_[1] > kMaxAtoms) throw Hdf5Fault("it has more than " + std::to_string(kMaxAtoms) + " atoms");
    // A frame may be read through a chunk that holds many.
    constexpr hsize_t kMostOfChunk = hsize_t{1} << 30;
    if (chunkBytes() > kMostOfChunk) throw Hdf5Fault("its chunks are larger than 1 GB");
}

std::string H5mdData::firstOf(const char* group) const {
    std::string first;
    const Hdf5Handle opened(hdf5().H5Gopen2(file_, group, H5P_DEFAULT), hdf5().H5Gclose);
    if (opened.valid()) hdf5().H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, nameFirst, &first);
    return first;
}

hsize_t H5mdData::chunkBytes() const {
    const Hdf5Handle layout(hdf5().H5Dget_create_plist(positions_), hdf5().H5Pclose);
    hsize_t chunk[3] = {1, 1, 1};
    if (hdf5().H5Pget_layout(layout) != H5D_CHUNKED || hdf5().H5Pget_chunk(layout, 3, chunk) != 3) return 0;
    double bytes = 8;
    for (const hsize_t side : chunk) bytes *= static_cast<double>(side);
    return bytes > 1e18 ? ~hsize_t{0} : static_cast<hsize_t>(bytes);
}

/// H5MD's box has an attribute: "periodic" or "none" for each axis; some programs state one for all.
void H5mdData::readBoundary() {
    H5L_info_t link;
    const std::string path = group_ + "/box";
    if (hdf5().H5Lget_info(file_, path.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return;
    const Hdf5Handle box(hdf5().H5Oopen(file_, path.c_str(), H5P_DEFAULT), hdf5().H5Oclose);
    if (!box.valid()) return;
    const Hdf5Handle attribute(hdf5().H5Aopen(box, "boundary", H5P_DEFAULT), hdf5().H5Aclose);
    if (!attribute.valid()) return;
    std::vector<std::string> texts = attributeTexts(attribute, repeats_.size());
    if (texts.empty()) texts = attributeTexts(attribute, 1);
    for (std::size_t i = 0; i < repeats_.size() && !texts.empty(); ++i)
        repeats_[i] = !texts[std::min(i, texts.size() - 1)].starts_with("none");
}

}  // namespace nacre
#endif
