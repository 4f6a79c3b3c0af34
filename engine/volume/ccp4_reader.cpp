#include "engine/volume/ccp4_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace nacre {
namespace {

// Words of the header, numbered from 1 as in the format's description.
constexpr int kMode = 4, kStartWord = 5, kIntervals = 8, kLengths = 11, kAngles = 14, kAxes = 17, kMax = 21,
              kGroup = 23, kExtended = 24, kImodStamp = 39, kImodFlags = 40, kOrigin = 50, kStamp = 54;
constexpr std::size_t kMapWord = 208;
constexpr std::int32_t kImod = 1146047817;  // IMOD: bytes are unsigned unless a flag says otherwise
constexpr std::size_t kRecord = 80;         // bytes of a symmetry record
constexpr int kMostGroup = 230;

std::uint32_t bitsAt(const char* at, bool swapped) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, at, 4);
    if (!swapped) return bits;
    return bits << 24 | (bits & 0xff00u) << 8 | (bits >> 8 & 0xff00u) | bits >> 24;
}
std::uint16_t swappedHalf(std::uint16_t bits) { return static_cast<std::uint16_t>(bits << 8 | bits >> 8); }

float fromHalf(std::uint16_t half) {
    const int exponent = half >> 10 & 31, fraction = half & 1023;
    const float sign = half & 0x8000 ? -1.0f : 1.0f;
    if (exponent == 31) return kUnknownDensity;
    if (exponent == 0) return sign * std::ldexp(static_cast<float>(fraction), -24);
    return sign * std::ldexp(static_cast<float>(1024 + fraction), exponent - 25);
}

bool isMode(std::int32_t mode) { return mode >= 0 && mode <= 127; }
bool areAxes(std::int32_t a, std::int32_t b, std::int32_t c) {
    if (a == 0 && b == 0 && c == 0) return true;  // old files
    return a >= 1 && a <= 3 && b >= 1 && b <= 3 && c >= 1 && c <= 3 && a != b && b != c && c != a;
}
/// Whether a header is plausible in a byte order.
bool makesSense(std::string_view header, bool swapped) {
    const auto word = [&](int i) { return static_cast<std::int32_t>(bitsAt(header.data() + 4 * (i - 1), swapped)); };
    return isMode(word(kMode)) && areAxes(word(kAxes), word(kAxes + 1), word(kAxes + 2));
}

std::size_t bytesPerValue(int mode) {
    switch (mode) {
        case 0:
            return 1;
        case 1:
        case 6:
        case 12:
            return 2;
        case 2:
            return 4;
        default:
            return 0;
    }
}

}  // namespace

bool Ccp4Reader::recognises(std::string_view start) {
    return start.size() >= kMapWord + 4 && start.substr(kMapWord, 4) == "MAP ";
}

std::int32_t Ccp4Reader::integer(int word) const {
    return static_cast<std::int32_t>(bitsAt(header_.data() + 4 * (word - 1), swapped_));
}
float Ccp4Reader::real(int word) const {
    return std::bit_cast<float>(bitsAt(header_.data() + 4 * (word - 1), swapped_));
}

/// Decides by plausibility, since the machine stamp is wrong in some files.
void Ccp4Reader::findByteOrder() {
    constexpr bool kHostIsBig = std::endian::native == std::endian::big;
    const char stamp = header_[4 * (kStamp - 1)];
    const bool big = stamp == 0x11, little = stamp == 0x44;
    const bool asHost = makesSense(header_, false), asOther = makesSense(header_, true);
    if (!asHost && !asOther)
        cannotReadMap(name_, "its header has no mode and axes in either byte order: damaged, or not a CCP4 or MRC map");
    swapped_ = asHost && asOther ? (big && !kHostIsBig) || (little && kHostIsBig) : asOther;
    const bool isBig = swapped_ != kHostIsBig;
    if ((big || little) && big != isBig)
        warnings_.push_back("the map's machine stamp is wrong: its values are read in the byte order of its header");
}

void Ccp4Reader::readGeometry() {
    for (int i = 0; i < 3; ++i) {
        const std::int32_t axis = integer(kAxes + i);
        box_.axes[static_cast<std::size_t>(i)] = axis == 0 ? i + 1 : axis;
    }
    const auto axisIndex = [&](int i) {
        return box_.axes[static_cast<std::size_t>(i)] - 1;
    };  // columns, rows, sections
    for (int i = 0; i < 3; ++i) {
        files_[i] = integer(1 + i);
        box_.size[axisIndex(i)] = files_[i];
        box_.start[axisIndex(i)] = integer(kStartWord + i);
    }
    checkedNodes(name_, box_.size, limits_);
    for (int i = 0; i < 3; ++i) {
        const std::int32_t intervals = integer(kIntervals + i);
        box_.intervals[i] = intervals > 0 ? intervals : box_.size[i];
        box_.cell.lengths[i] = static_cast<double>(real(kLengths + i));
        const auto angle = static_cast<double>(real(kAngles + i));
        box_.cell.angles[i] = angle == 0 ? 90 : angle;
        constexpr std::int32_t kFarthest = 1 << 24;
        if (std::abs(std::int64_t{box_.start[i]}) > kFarthest || box_.intervals[i] > kFarthest)
            cannotReadMap(name_, "its grid starts or ends more than 16,777,216 nodes from the cell's origin");
    }
    if (box_.cell.lengths == glm::dvec3(0, 0, 0)) {
        box_.cell = {glm::dvec3(box_.intervals), {90, 90, 90}};
        warnings_.push_back("the map has no cell: its nodes are taken to be 1 Å apart");
    }
    if (!box_.cell.isValid()) cannotReadMap(name_, "its cell has no volume: damaged, or not a CCP4 or MRC map");
    box_.spaceGroup = integer(kGroup);
    if (box_.spaceGroup < 0 || box_.spaceGroup > kMostGroup) box_.spaceGroup = 0;  // stacks of images and volumes
    bool beyond = false;                                                           // the box is larger than a cell
    for (int i = 0; i < 3; ++i) beyond |= box_.size[i] > box_.intervals[i];
    // Space group 1 may also mean a volume in a rectangular box.
    box_.crystal = box_.spaceGroup > 1 || (box_.spaceGroup == 1 && (beyond || !box_.cell.isRectangular()));
    for (int i = 0; i < 3; ++i) place_[i] = static_cast<double>(real(kOrigin + i));
    const bool finite = std::isfinite(place_.x) && std::isfinite(place_.y) && std::isfinite(place_.z);
    checkCell(name_, box_, limits_);
    placed_ = !box_.crystal && finite && place_ != glm::dvec3(0, 0, 0) && glm::length(place_) < 1e6;
}

void Ccp4Reader::readOperations() {
    if (!box_.crystal) return;
    for (std::size_t at = kHeader; at + kRecord <= header_.size(); at += kRecord) {
        const std::string_view record = trim(std::string_view(header_).substr(at, kRecord));
        if (record.empty()) continue;
        const auto operation = parseOperation(record);
        if (!operation) return box_.operations.clear();  // other programs store other data there
        box_.operations.push_back(*operation);
    }
    if (box_.operations.size() < findOperations(box_.spaceGroup, box_.cell).size()) box_.operations.clear();
}

void Ccp4Reader::readHeader() {
    findByteOrder();
    mode_ = integer(kMode);
    valueBytes_ = bytesPerValue(mode_);
    if (valueBytes_ == 0)
        cannotReadMap(name_, "its values are of mode " + std::to_string(mode_) + "; read are 0, 1, 2, 6 and 12");
    unsignedBytes_ =
        mode_ == 0 && ((integer(kImodStamp) == kImod && (integer(kImodFlags) & 1) == 0) || real(kMax) > 127);
    const std::int32_t extended = integer(kExtended);
    if (extended < 0) cannotReadMap(name_, "an extended header of " + std::to_string(extended) + " bytes");
    extended_ = static_cast<std::size_t>(extended);
    readGeometry();
    const std::uint64_t needed =
        kHeader + extended_ + std::uint64_t{valueBytes_} * box_.size.x * box_.size.y * box_.size.z;
    if (needed > mostBytes_)
        cannotReadMap(name_, "it is cut short: its header announces " + std::to_string(needed) +
                                 " bytes, and it can hold " + std::to_string(mostBytes_));
    known_ = true;
}

void Ccp4Reader::take(std::string_view bytes) {
    const auto fill = [&](std::size_t until) {
        const std::size_t part = std::min(bytes.size(), until - std::min(until, header_.size()));
        header_.append(bytes.substr(0, part));
        bytes.remove_prefix(part);
        return header_.size() >= until;
    };
    if (!known_) {
        if (!fill(kHeader)) return;
        readHeader();
    }
    if (header_.size() < kHeader + extended_ || box_.values.empty()) {
        if (!fill(kHeader + extended_)) return;
        readOperations();
        box_.values.resize(checkedNodes(name_, box_.size, limits_));
        const std::array<std::size_t, 3> inBox{1, static_cast<std::size_t>(box_.size.x),
                                               static_cast<std::size_t>(box_.size.x) * box_.size.y};
        for (std::size_t i = 0; i < 3; ++i) strides_[i] = inBox[static_cast<std::size_t>(box_.axes[i] - 1)];
    }
    if (!rest_.empty()) {
        const std::size_t part = std::min(bytes.size(), valueBytes_ - rest_.size());
        rest_.append(bytes.substr(0, part));
        bytes.remove_prefix(part);
        if (rest_.size() < valueBytes_) return;
        std::string whole;
        whole.swap(rest_);
        std::string_view one = whole;
        takeValues(one);
    }
    takeValues(bytes);
    rest_.assign(taken_ < box_.values.size() ? bytes : std::string_view());
}

/// @param convert  stored value to float
template <typename Stored, typename Convert>
void Ccp4Reader::convert(std::string_view bytes, const Convert& convert) {
    for (std::size_t i = 0; i + sizeof(Stored) <= bytes.size(); i += sizeof(Stored)) {
        Stored stored;
        std::memcpy(&stored, bytes.data() + i, sizeof(Stored));
        box_.values[static_cast<std::size_t>(at_.x) * strides_[0] + static_cast<std::size_t>(at_.y) * strides_[1] +
                    static_cast<std::size_t>(at_.z) * strides_[2]] = convert(stored);
        if (++at_.x < files_.x) continue;
        at_.x = 0;
        if (++at_.y < files_.y) continue;
        at_.y = 0;
        ++at_.z;
    }
}

/// Removes the complete values at the front.
void Ccp4Reader::takeValues(std::string_view& bytes) {
    const auto count =
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size() / valueBytes_, box_.values.size() - taken_));
    const std::string_view some = bytes.substr(0, count * valueBytes_);
    bytes.remove_prefix(some.size());
    taken_ += count;
    const bool swapped = swapped_;
    const auto half = [swapped](std::uint16_t bits) { return swapped ? swappedHalf(bits) : bits; };
    if (mode_ == 0 && unsignedBytes_)
        convert<std::uint8_t>(some, [](std::uint8_t v) { return static_cast<float>(v); });
    else if (mode_ == 0)
        convert<std::int8_t>(some, [](std::int8_t v) { return static_cast<float>(v); });
    else if (mode_ == 1)
        convert<std::uint16_t>(some,
                               [&](std::uint16_t v) { return static_cast<float>(static_cast<std::int16_t>(half(v))); });
    else if (mode_ == 6)
        convert<std::uint16_t>(some, [&](std::uint16_t v) { return static_cast<float>(half(v)); });
    else if (mode_ == 12)
        convert<std::uint16_t>(some, [&](std::uint16_t v) { return fromHalf(half(v)); });
    else
        convert<std::uint32_t>(some, [swapped](std::uint32_t v) {
            return std::bit_cast<float>(bitsAt(reinterpret_cast<const char*>(&v), swapped));
        });
}

DensityMap Ccp4Reader::finish() {
    if (!known_) cannotReadMap(name_, "it is cut short in its header, or not a map");
    const std::uint64_t wanted = std::uint64_t{static_cast<std::uint32_t>(box_.size.x)} * box_.size.y * box_.size.z;
    if (taken_ < wanted)
        cannotReadMap(name_, "it is cut short: " + std::to_string(taken_) + " of its " + std::to_string(wanted) +
                                 " values are there");
    DensityMap map = completed(name_, "ccp4", std::move(box_), limits_, placed_ ? &place_ : nullptr);
    map.warnings.insert(map.warnings.begin(), warnings_.begin(), warnings_.end());
    return map;
}

}  // namespace nacre
