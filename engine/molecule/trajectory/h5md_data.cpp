#ifdef NACRE_HDF5
#include "engine/molecule/trajectory/h5md_data.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <functional>

#include "engine/molecule/byte_file.h"
#include "engine/molecule/read.h"

namespace nacre {
namespace {

// clang-format off
#define NACRE_HDF5_CALLS(CALL) \
    CALL(H5open) CALL(H5set_free_list_limits) CALL(H5Eset_auto2) CALL(H5Eget_auto2) CALL(H5PLset_loading_state) CALL(H5Fopen) \
    CALL(H5Fclose) CALL(H5Gopen2) CALL(H5Gclose) CALL(H5Literate) \
    CALL(H5Lget_info) CALL(H5Dopen2) CALL(H5Dclose) CALL(H5Dget_create_plist) CALL(H5Dget_type) \
    CALL(H5Pget_layout) CALL(H5Pget_external_count) CALL(H5Pget_chunk) CALL(H5Pclose) \
    CALL(H5Pcreate) CALL(H5Pset_fapl_core) CALL(H5Pset_file_image) CALL(H5Pset_buffer) \
    CALL(H5Dget_space) CALL(H5Sget_simple_extent_ndims) CALL(H5Sget_simple_extent_dims) CALL(H5Screate_simple) \
    CALL(H5Sselect_hyperslab) CALL(H5Sclose) CALL(H5Dread) CALL(H5Aopen) CALL(H5Oopen) CALL(H5Oclose) \
    CALL(H5Aread) CALL(H5Aget_type) CALL(H5Aclose) CALL(H5Aget_space) CALL(H5Tis_variable_str) CALL(H5Tget_class) \
    CALL(H5Tget_nmembers) CALL(H5Tget_member_name) CALL(H5Tget_member_value) CALL(H5Tconvert) CALL(H5Tget_super) \
    CALL(H5Tget_size) CALL(H5Tget_offset) CALL(H5Tget_precision) CALL(H5Tget_fields) CALL(H5Tclose) \
    CALL(H5free_memory) CALL(H5Dget_storage_size) CALL(H5Sget_simple_extent_npoints) \
    CALL(H5Tcreate) CALL(H5Tregister) CALL(H5Tunregister) CALL(H5Fget_create_plist) CALL(H5Pget_userblock)
// clang-format on

/// The library's functions. NACRE_HDF5 is its file's name.
struct Hdf5Library {
#define NACRE_HDF5_MEMBER(call) decltype(&::call) call = nullptr;
    NACRE_HDF5_CALLS(NACRE_HDF5_MEMBER)
#undef NACRE_HDF5_MEMBER
    hid_t nativeDouble = -1, fileAccess = -1, transfer = -1;
    std::string missing;  ///< why it cannot be used; empty if it can
};

/// Each open file has a cache of 0.5 MB. The library returns that to the system unless its free lists may hold more
/// than their default of 64 kB.
void keepFileCaches(const Hdf5Library& library) {
    constexpr int kRegular = 4 << 20, kRegularList = 1 << 20;
    constexpr int kArrays = 4 << 20, kArrayList = 256 << 10, kBlocks = 16 << 20, kBlockList = 1 << 20;  // the defaults
    library.H5set_free_list_limits(kRegular, kRegularList, kArrays, kArrayList, kBlocks, kBlockList);
}

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
        loaded.transfer = value("H5P_CLS_DATASET_XFER_ID_g");
        loaded.H5PLset_loading_state(0);
        keepFileCaches(loaded);
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

/// How numbers are converted: the library clears a buffer before each reading, by default of 1 MB.
Hdf5Handle makeTransfer(std::size_t count) {
    constexpr std::size_t kMostOfElement = 16, kLeast = 4096, kMost = std::size_t{1} << 20;
    Hdf5Handle transfer(hdf5().H5Pcreate(hdf5().transfer), hdf5().H5Pclose);
    hdf5().H5Pset_buffer(transfer, std::clamp(std::min(count, kMost) * kMostOfElement, kLeast, kMost), nullptr,
                         nullptr);
    return transfer;
}

/// Reads into memory that is allocated once the sizes are checked.
template <typename Allocate>
bool readRow(const Hdf5Handle& set, std::size_t frame, std::size_t count, bool framed, hid_t type,
             const Allocate& allocate) {
    const Hdf5Sizes size = H5mdData::readSizes(set);
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
    return hdf5().H5Dread(set, type, memory, space, makeTransfer(count), allocate()) >= 0;
}

std::mutex& hdf5Calls() {
    static std::mutex mutex;
    return mutex;
}

herr_t keepReferences(hid_t from, hid_t, H5T_cdata_t* path, std::size_t, std::size_t, std::size_t, void*, void*,
                      hid_t) {
    if (path->command != H5T_CONV_INIT) return 0;
    path->need_bkg = H5T_BKG_NO;
    return hdf5().H5Tis_variable_str(from) > 0 && hdf5().H5Tget_size(from) == Hdf5Heaps::kReferenceBytes ? 0 : -1;
}

/// While it exists, the library converts variable-length texts to this type by copying their references.
class ReferenceType {
public:
    explicit ReferenceType(hid_t text)
        : type_(hdf5().H5Tcreate(H5T_OPAQUE, Hdf5Heaps::kReferenceBytes), hdf5().H5Tclose) {
        hdf5().H5Tregister(H5T_PERS_SOFT, kName, text, type_, keepReferences);
    }
    ~ReferenceType() { hdf5().H5Tunregister(H5T_PERS_SOFT, kName, -1, -1, keepReferences); }
    ReferenceType(const ReferenceType&) = delete;
    ReferenceType& operator=(const ReferenceType&) = delete;
    operator hid_t() const { return type_; }

private:
    static constexpr const char* kName = "nacre references";
    Hdf5Handle type_;
};

/// Fixed-size strings in a row, each up to its first NUL.
std::vector<std::string> cutTexts(std::string_view bytes, std::size_t size) {
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < bytes.size(); at += size) {
        const std::string_view text = bytes.substr(at, size);
        texts.emplace_back(text.substr(0, text.find('\0')));
    }
    return texts;
}

/// Texts by their references. @param most  total bytes; further texts are empty
std::vector<std::string> heapTexts(Hdf5Heaps& heaps, std::string_view references, std::size_t most) {
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < references.size(); at += Hdf5Heaps::kReferenceBytes) {
        texts.push_back(heaps.text(references.substr(at, Hdf5Heaps::kReferenceBytes), most));
        most -= texts.back().size();
    }
    return texts;
}

/// Texts of an attribute with this many strings, of either kind; empty for any other attribute.
std::vector<std::string> attributeTexts(hid_t attribute, std::size_t count, Hdf5Heaps& heaps) {
    constexpr std::size_t kLongest = 100;
    const Hdf5Handle type(hdf5().H5Aget_type(attribute), hdf5().H5Tclose);
    const Hdf5Handle space(hdf5().H5Aget_space(attribute), hdf5().H5Sclose);
    const int rank = hdf5().H5Sget_simple_extent_ndims(space);
    hsize_t there = 1;
    if (hdf5().H5Tget_class(type) != H5T_STRING || rank < 0 || rank > 1) return {};
    if (rank == 1) hdf5().H5Sget_simple_extent_dims(space, &there, nullptr);
    if (there != count) return {};
    if (hdf5().H5Tis_variable_str(type) > 0) {
        const ReferenceType references(type);
        std::string bytes(count * Hdf5Heaps::kReferenceBytes, '\0');
        return hdf5().H5Aread(attribute, references, bytes.data()) < 0 ? std::vector<std::string>()
                                                                       : heapTexts(heaps, bytes, count * kLongest);
    }
    const std::size_t size = hdf5().H5Tget_size(type);
    if (size == 0 || size > kLongest) return {};
    std::string bytes(count * size, '\0');
    return hdf5().H5Aread(attribute, type, bytes.data()) < 0 ? std::vector<std::string>() : cutTexts(bytes, size);
}

/// Whether a number's bits lie within its bytes: the library converts without checking.
bool isSoundNumber(hid_t type) {
    constexpr std::size_t kMostBytes = 16;
    const H5T_class_t kind = hdf5().H5Tget_class(type);
    if (kind == H5T_ENUM) {
        const Hdf5Handle base(hdf5().H5Tget_super(type), hdf5().H5Tclose);
        return hdf5().H5Tget_class(base) == H5T_INTEGER && isSoundNumber(base);
    }
    const std::size_t size = hdf5().H5Tget_size(type), bits = hdf5().H5Tget_precision(type);
    const int offset = hdf5().H5Tget_offset(type);
    if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || size == 0 || size > kMostBytes || offset < 0 || bits == 0 ||
        bits > 8 * size || static_cast<std::size_t>(offset) > 8 * size - bits)
        return false;
    if (kind == H5T_INTEGER) return true;
    std::size_t sign = 0, exponent = 0, exponentBits = 0, mantissa = 0, mantissaBits = 0;
    if (hdf5().H5Tget_fields(type, &sign, &exponent, &exponentBits, &mantissa, &mantissaBits) < 0) return false;
    const auto holds = [&](std::size_t first, std::size_t count) {
        return count > 0 && count <= bits && first <= bits - count;
    };
    constexpr std::size_t kMostExponentBits = 32;
    return holds(sign, 1) && holds(exponent, exponentBits) && holds(mantissa, mantissaBits) &&
           exponentBits <= kMostExponentBits;
}

/// Whether a dataset in this file itself has room for its elements: the library reads without checking.
bool isWhole(hid_t set) {
    const Hdf5Handle layout(hdf5().H5Dget_create_plist(set), hdf5().H5Pclose);
    const Hdf5Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose);
    const H5D_layout_t kind = hdf5().H5Pget_layout(layout);
    if (kind == H5D_CHUNKED) {
        std::array<hsize_t, H5S_MAX_RANK> chunk{}, most{};
        const int rank = hdf5().H5Sget_simple_extent_dims(space, nullptr, most.data());
        return rank > 0 && hdf5().H5Pget_chunk(layout, H5S_MAX_RANK, chunk.data()) == rank &&
               std::equal(chunk.begin(), chunk.begin() + rank, most.begin(), std::less_equal<>());
    }
    if ((kind != H5D_COMPACT && kind != H5D_CONTIGUOUS) || hdf5().H5Pget_external_count(layout) > 0) return false;
    const hsize_t stored = hdf5().H5Dget_storage_size(set);
    if (kind == H5D_CONTIGUOUS && stored == 0) return true;  // not written yet: zeros
    const Hdf5Handle type(hdf5().H5Dget_type(set), hdf5().H5Tclose);
    const hssize_t count = hdf5().H5Sget_simple_extent_npoints(space);
    const std::size_t size =
        hdf5().H5Tis_variable_str(type) > 0 ? Hdf5Heaps::kReferenceBytes : hdf5().H5Tget_size(type);
    return count >= 0 && size > 0 && static_cast<hsize_t>(count) <= stored / size;
}

std::uint64_t userBlock(hid_t file) {
    const Hdf5Handle made(hdf5().H5Fget_create_plist(file), hdf5().H5Pclose);
    hsize_t bytes = 0;
    hdf5().H5Pget_userblock(made, &bytes);
    return bytes;
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
    constexpr std::size_t kMostChecked = std::size_t{16} << 20;  // of a trajectory, which may be huge
    const std::shared_ptr<ByteFile> file = ByteFile::open(path);
    if (!file) throw Hdf5Fault(ByteFile::whyNotOpened(path));
    const auto read = [file](std::uint64_t at, std::size_t most) {
        std::string bytes(
            at < file->size() ? static_cast<std::size_t>(std::min<std::uint64_t>(file->size() - at, most)) : 0, '\0');
        file->read(at, bytes.data(), bytes.size());
        return bytes;
    };
    Hdf5Heaps::check(read(0, kMostChecked));
    return H5mdData(hdf5().H5Fopen(path.c_str(), kReadOnly, H5P_DEFAULT), read, file->size());
}

H5mdData H5mdData::ofBytes(std::string_view bytes) {
    requireLibrary();
    Hdf5Heaps::check(bytes);
    constexpr std::size_t kIncrement = std::size_t{1} << 20;
    const Hdf5Handle access(hdf5().H5Pcreate(hdf5().fileAccess), hdf5().H5Pclose);
    if (hdf5().H5Pset_fapl_core(access, kIncrement, 0) < 0 ||
        hdf5().H5Pset_file_image(access, const_cast<char*>(bytes.data()), bytes.size()) < 0)
        throw Hdf5Fault("libhdf5 does not read from memory");
    const auto read = [bytes](std::uint64_t at, std::size_t most) {
        return std::string(at < bytes.size() ? bytes.substr(static_cast<std::size_t>(at), most) : std::string_view());
    };
    return H5mdData(hdf5().H5Fopen("memory", kReadOnly, access), read, bytes.size());
}

bool H5mdData::read(std::size_t frame, TrajectoryFrame& result) const {
    const std::vector<double> values = readNumbers(positions_, frame, atoms() * 3, true);
    if (values.empty()) return false;
    for (std::size_t i = 0; i < values.size(); ++i)
        result.positions[i / 3][static_cast<int>(i % 3)] = static_cast<float>(values[i] * scale_);
    if (const std::vector<double> time = readNumbers(times_, frame, 1, true); !time.empty()) result.time = time[0];
    const bool framed = readSizes(edges_).size() > 1;
    if (const std::vector<double> e = readNumbers(edges_, frame, 3, framed); !e.empty()) {
        const std::vector<double> a = readNumbers(angles_, frame, 3, true);
        const glm::dvec3 angles = a.empty() ? glm::dvec3(90) : glm::dvec3(a[0], a[1], a[2]);
        result.box = makeBox(glm::dvec3(e[0], e[1], e[2]) * (angles_.valid() ? scale_ : edgeScale_), angles);
    } else if (const std::vector<double> m = readNumbers(edges_, frame, 9, readSizes(edges_).size() > 2); !m.empty()) {
        PeriodicBox box;
        for (std::size_t i = 0; i < 9; ++i) box[i / 3][static_cast<int>(i % 3)] = static_cast<float>(m[i] * edgeScale_);
        result.box = box;
    }
    return true;
}

Hdf5Handle H5mdData::dataset(const std::string& path) const {
    for (std::size_t end = path.find('/');; end = path.find('/', end + 1)) {
        if (!isHardLink(path.substr(0, end))) return {};
        if (end == std::string::npos) break;
    }
    Hdf5Handle opened(hdf5().H5Dopen2(file_, path.c_str(), H5P_DEFAULT), hdf5().H5Dclose);
    return opened.valid() && isWhole(opened) ? std::move(opened) : Hdf5Handle();
}

bool H5mdData::isHardLink(const std::string& path) const {
    if (hardLinks_.contains(path)) return true;
    H5L_info_t link;
    if (hdf5().H5Lget_info(file_, path.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return false;
    hardLinks_.insert(path);
    return true;
}

Hdf5Handle H5mdData::element(const std::string& path) const {
    Hdf5Handle varying = dataset(path + "/value");
    return varying.valid() ? std::move(varying) : dataset(path);
}

Hdf5Sizes H5mdData::readSizes(const Hdf5Handle& set) {
    const Hdf5Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose);
    const int rank = hdf5().H5Sget_simple_extent_ndims(space);
    Hdf5Sizes sizes(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) hdf5().H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
    return sizes;
}

std::vector<double> H5mdData::readNumbers(const Hdf5Handle& set, std::size_t frame, std::size_t count, bool framed) {
    std::vector<double> values;
    if (!set.valid()) return values;
    const Hdf5Handle type(hdf5().H5Dget_type(set), hdf5().H5Tclose);
    const bool read = isSoundNumber(type) && readRow(set, frame, count, framed, hdf5().nativeDouble, [&] {
                          values.resize(count);
                          return values.data();
                      });
    return read ? values : std::vector<double>();
}

std::vector<double> H5mdData::readValues(const Hdf5Handle& set, std::size_t frame, std::size_t count) {
    return set.valid() ? readNumbers(set, frame, count, readSizes(set).size() > 1) : std::vector<double>();
}

std::vector<std::string> H5mdData::readTexts(const Hdf5Handle& set, std::size_t count, std::size_t mostBytes) {
    std::vector<std::string> texts;
    if (!set.valid()) return texts;
    const Hdf5Handle type(hdf5().H5Dget_type(set), hdf5().H5Tclose);
    if (hdf5().H5Tget_class(type) != H5T_STRING) return texts;
    const std::size_t size = hdf5().H5Tget_size(type);
    if (size == 0 || count > mostBytes / size) return texts;
    const bool framed = readSizes(set).size() > 1;
    std::string bytes;
    const auto read = [&](hid_t as, std::size_t each) {
        return readRow(set, 0, count, framed, as, [&] {
            bytes.resize(count * each);
            return bytes.data();
        });
    };
    if (hdf5().H5Tis_variable_str(type) <= 0) return read(type, size) ? cutTexts(bytes, size) : texts;
    const ReferenceType references(type);
    return read(references, Hdf5Heaps::kReferenceBytes) ? heapTexts(heaps_, bytes, mostBytes) : texts;
}

std::map<double, std::string> H5mdData::readEnumeration(const Hdf5Handle& set) {
    std::map<double, std::string> names;
    if (!set.valid()) return names;
    const Hdf5Handle type(hdf5().H5Dget_type(set), hdf5().H5Tclose);
    if (hdf5().H5Tget_class(type) != H5T_ENUM) return names;
    const Hdf5Handle base(hdf5().H5Tget_super(type), hdf5().H5Tclose);
    const int count = isSoundNumber(type) ? hdf5().H5Tget_nmembers(type) : 0;
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

double H5mdData::readScale(const Hdf5Handle& set) {
    const Hdf5Handle attribute(hdf5().H5Aopen(set, "unit", H5P_DEFAULT), hdf5().H5Aclose);
    if (!attribute.valid()) return 1;
    const std::vector<std::string> texts = attributeTexts(attribute, 1, heaps_);
    const std::string unit = texts.empty() ? "" : texts[0];
    return unit == "nm" ? kNanometre : unit == "pm" ? 0.01 : unit == "fm" ? 1e-5 : unit == "m" ? 1e10 : 1;
}

H5mdData::H5mdData(hid_t opened, Hdf5Heaps::Read read, std::uint64_t fileBytes)
    : file_(opened, hdf5().H5Fclose), heaps_(std::move(read), fileBytes, file_.valid() ? userBlock(file_) : 0) {
    if (!file_.valid()) throw Hdf5Fault("it is not HDF5, or damaged");
    positions_ = dataset("coordinates");
    if (positions_.valid()) {
        scale_ = kNanometre;
        edges_ = dataset("cell_lengths");
        angles_ = dataset("cell_angles");
        times_ = dataset("time");
    } else {
        group_ = "particles/" + readFirstName("particles");
        positions_ = dataset(group_ + "/position/value");
        if (!positions_.valid()) throw Hdf5Fault("it has no positions as H5MD or MDTraj write them");
        scale_ = readScale(positions_);
        edges_ = element(group_ + "/box/edges");
        if (edges_.valid()) edgeScale_ = readScale(edges_);
        readBoundary();
        times_ = dataset(group_ + "/position/time");
    }
    sizes_ = readSizes(positions_);
    if (sizes_.size() != 3 || sizes_[2] != 3 || sizes_[0] == 0)
        throw Hdf5Fault("its positions are not (frame, atom, 3)");
    if (sizes_[1] > kMaxAtoms) throw Hdf5Fault("it has more than " + std::to_string(kMaxAtoms) + " atoms");
    // Reading a frame may require a chunk of many frames.
    constexpr hsize_t kMostOfChunk = hsize_t{1} << 30;
    if (chunkBytes() > kMostOfChunk) throw Hdf5Fault("its chunks are larger than 1 GB");
}

std::string H5mdData::readFirstName(const char* group) const {
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

/// H5MD's box has an attribute: "periodic" or "none" per axis; some programs state one for all.
void H5mdData::readBoundary() {
    const std::string path = group_ + "/box";
    if (!isHardLink(path)) return;
    const Hdf5Handle box(hdf5().H5Oopen(file_, path.c_str(), H5P_DEFAULT), hdf5().H5Oclose);
    if (!box.valid()) return;
    const Hdf5Handle attribute(hdf5().H5Aopen(box, "boundary", H5P_DEFAULT), hdf5().H5Aclose);
    if (!attribute.valid()) return;
    std::vector<std::string> texts = attributeTexts(attribute, repeats_.size(), heaps_);
    if (texts.empty()) texts = attributeTexts(attribute, 1, heaps_);
    for (std::size_t i = 0; i < repeats_.size() && !texts.empty(); ++i)
        repeats_[i] = !texts[std::min(i, texts.size() - 1)].starts_with("none");
}

}  // namespace nacre
#endif
