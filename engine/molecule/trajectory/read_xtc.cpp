// XTC of GROMACS: XDR, nm, positions on a grid and compressed, "xdr3dfcoord": neighbouring ones as small differences,
// in mixed radix with as many bits as their ranges need. After F. van Hoesel (Europort-D, 1995) and the format's
// description in the GROMACS manual. Frames differ in size: the file is scanned once for where they begin.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "engine/molecule/trajectory/trajectory_file.h"

namespace nacre {
namespace {

/// Header before the packed bits of a frame.
struct XtcPacking {
    float precision = 1000;  ///< grid points per nm
    std::array<std::int32_t, 3> lowest{}, highest{};
    std::int32_t smallIndex = 0;  ///< of the first range of differences
};

using GridPoint = std::array<std::int64_t, 3>;

/// Ranges of differences, from index 9 on: each about a third of a bit wider than the one before, so that three of
/// them take one bit more. The numbers are part of the format.
constexpr int kFirstXtcRange = 9;
constexpr std::array<std::uint32_t, 73> kXtcRanges = {
    0,       0,       0,       0,       0,        0,        0,       0,       0,       8,       10,
    12,      16,      20,      25,      32,       40,       50,      64,      80,      101,     128,
    161,     203,     256,     322,     406,      512,      645,     812,     1024,    1290,    1625,
    2048,    2580,    3250,    4096,    5060,     6501,     8192,    10321,   13003,   16384,   20642,
    26007,   32768,   41285,   52015,   65536,    82570,    104031,  131072,  165140,  208063,  262144,
    330280,  416127,  524287,  660561,  832255,   1048576,  1321122, 1664510, 2097152, 2642245, 3329021,
    4194304, 5284491, 6658042, 8388607, 10568983, 13316085, 16777216};

/// Reads bits from the highest of the first byte on. Bits beyond the end read as 0, and are noted.
class BitReader {
public:
    explicit BitReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::uint32_t take(unsigned count) {  // at most 32
        while (held_ < count) {
            buffer_ = buffer_ << 8 | (next_ < bytes_.size() ? static_cast<std::uint64_t>(bytes_[next_]) : 0);
            over_ = over_ || next_ >= bytes_.size();
            ++next_;
            held_ += 8;
        }
        held_ -= count;
        return static_cast<std::uint32_t>(buffer_ >> held_ & ((std::uint64_t{1} << count) - 1));
    }
    bool over() const { return over_; }

private:
    std::span<const std::byte> bytes_;
    std::uint64_t buffer_ = 0;
    unsigned held_ = 0;
    std::size_t next_ = 0;
    bool over_ = false;
};

/// Wide enough for the product of three 24-bit numbers.
__extension__ using WideNumber = unsigned __int128;

unsigned countBits(const std::array<std::uint32_t, 3>& sizes) {
    unsigned width = 0;
    for (WideNumber product = WideNumber{sizes[0]} * sizes[1] * sizes[2]; product > 0; product >>= 1) ++width;
    return width;
}

template <typename Number>
GridPoint takePacked(BitReader& bits, unsigned width, const std::array<std::uint32_t, 3>& sizes) {
    Number value = 0;
    for (unsigned shift = 0; shift < width; shift += 8)
        value |= Number{bits.take(std::min(8u, width - shift))} << shift;
    const auto z = static_cast<std::int64_t>(value % sizes[2]);
    value /= sizes[2];
    return {static_cast<std::int64_t>(value / sizes[1]), static_cast<std::int64_t>(value % sizes[1]), z};
}

/// Unpacks three numbers below their sizes: bytes from the lowest on, the last one partial.
GridPoint takeThreeNumbers(BitReader& bits, unsigned width, const std::array<std::uint32_t, 3>& sizes) {
    return width <= 64 ? takePacked<std::uint64_t>(bits, width, sizes) : takePacked<WideNumber>(bits, width, sizes);
}

class XtcUnpacker {
public:
    /// @param positions  receives nm times 10, Å; its length is the number of atoms
    XtcUnpacker(const XtcPacking& packing, std::span<const std::byte> bytes, std::span<glm::vec3> positions)
        : packing_(packing), bits_(bytes), positions_(positions), index_(packing.smallIndex) {}

    /// @returns false if the bits end early or are invalid
    bool run() {
        if (!begin()) return false;
        int run = 0;
        while (done_ < positions_.size()) {
            GridPoint point = takeWhole();
            int step = 0;
            if (bits_.take(1)) {
                const int coded = static_cast<int>(bits_.take(5));
                step = coded % 3;
                run = coded - step;
                --step;
            }
            if (!(run > 0 ? takeRun(point, run / 3) : put(point)) || !move(step) || bits_.over()) return false;
        }
        return true;
    }

private:
    bool begin() {
        if (index_ < kFirstXtcRange || index_ >= static_cast<int>(kXtcRanges.size())) return false;
        bool wide = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t size = std::int64_t{packing_.highest[k]} - packing_.lowest[k] + 1;
            if (size < 1 || size > INT64_C(0xffffffff)) return false;
            sizes_[k] = static_cast<std::uint32_t>(size);
            wide = wide || sizes_[k] > 0xffffff;
        }
        width_ = wide ? 0 : countBits(sizes_);
        return true;
    }

    GridPoint takeWhole() {
        GridPoint point{};
        if (width_)
            point = takeThreeNumbers(bits_, width_, sizes_);
        else
            for (std::size_t k = 0; k < 3; ++k) point[k] = bits_.take(static_cast<unsigned>(std::bit_width(sizes_[k])));
        for (std::size_t k = 0; k < 3; ++k) point[k] += packing_.lowest[k];
        return point;
    }

    /// Points as differences, each from the previous one. The first is stored before the point that it follows: for
    /// water, the oxygen.
    bool takeRun(const GridPoint& first, int count) {
        const std::uint32_t range = kXtcRanges[static_cast<std::size_t>(index_)];
        const std::array<std::uint32_t, 3> sizes{range, range, range};
        GridPoint before = first;
        for (int i = 0; i < count; ++i) {
            GridPoint point = takeThreeNumbers(bits_, static_cast<unsigned>(index_), sizes);
            for (std::size_t k = 0; k < 3; ++k) point[k] += before[k] - range / 2;
            if (!put(point) || (i == 0 && !put(first))) return false;
            before = point;
        }
        return true;
    }

    bool put(const GridPoint& point) {
        if (done_ >= positions_.size()) return false;
        const float share = 1.0f / packing_.precision;
        for (std::size_t k = 0; k < 3; ++k)
            positions_[done_][static_cast<int>(k)] = static_cast<float>(point[k]) * share * 10;
        ++done_;
        return true;
    }

    /// Moves to the next wider or narrower range.
    bool move(int step) {
        index_ += step;
        return index_ >= kFirstXtcRange && index_ < static_cast<int>(kXtcRanges.size());
    }

    const XtcPacking& packing_;
    BitReader bits_;
    std::span<glm::vec3> positions_;
    std::size_t done_ = 0;
    int index_;
    std::array<std::uint32_t, 3> sizes_{};
    unsigned width_ = 0;
};

constexpr std::size_t kFewAtoms = 9;  ///< up to this number, positions are not compressed
constexpr std::uint64_t kTimeAt = 12, kCountAt = 52, kDataAt = 56;

struct XtcHead {
    std::size_t atoms = 0;
    XtcPacking packing;
    std::uint64_t begin = 0, count = 0;  ///< of the data
    std::uint64_t end() const { return begin + (count + 3) / 4 * 4; }
};

XtcHead xtcHeadAt(const TrajectoryFile& file, std::uint64_t at) {
    NumberReader numbers(file, at, kBigEndianSwapped);
    const auto magic = numbers.next<std::int32_t>();
    if (magic != 1995 && magic != 2023) file.fail("a frame has no valid header (byte " + std::to_string(at) + ")");
    XtcHead head;
    head.atoms = checkedAtoms(file, numbers.next<std::int32_t>());
    NumberReader packed(file, at + kCountAt, kBigEndianSwapped);
    if (packed.next<std::int32_t>() != static_cast<std::int32_t>(head.atoms))
        file.fail("a frame gives two numbers of atoms (byte " + std::to_string(at) + ")");
    head.begin = at + kDataAt;
    head.count = head.atoms * 12;
    if (head.atoms <= kFewAtoms) return head;
    head.packing.precision = packed.next<float>();
    for (std::int32_t& value : head.packing.lowest) value = packed.next<std::int32_t>();
    for (std::int32_t& value : head.packing.highest) value = packed.next<std::int32_t>();
    head.packing.smallIndex = packed.next<std::int32_t>();
    head.count = magic == 2023 ? packed.next<std::uint64_t>() : packed.next<std::uint32_t>();
    head.begin = packed.offset();
    // At least three bits per atom, and at most a little over 12 bytes.
    if (head.count < head.atoms / 8 || head.count > 16 * head.atoms + 64)
        file.fail("a frame of " + std::to_string(head.atoms) + " atoms takes " + std::to_string(head.count) +
                  " bytes (byte " + std::to_string(at) + ")");
    return head;
}

class Xtc : public FileTrajectory {
public:
    explicit Xtc(OwnedFile file) : FileTrajectory(std::move(file), "xtc") {
        std::uint64_t at = 0;
        while (file_->holds(at, kDataAt + 40) || (file_->holds(at, kDataAt) && atoms_ && atoms_ <= kFewAtoms)) {
            const XtcHead head = xtcHeadAt(*file_, at);
            if (!file_->holds(head.begin, head.count)) break;
            if (atoms_ && head.atoms != atoms_) file_->fail("its frames have different numbers of atoms");
            atoms_ = head.atoms;
            places_.push_back(at);
            at = head.end();
        }
        cutOff_ = at < file_->size();
        frames_ = places_.size();
        if (!frames_) file_->fail("it has no whole frame");
    }

private:
    void readWhole(std::size_t frame, TrajectoryFrame& result) override {
        const XtcHead head = xtcHeadAt(*file_, places_[frame]);
        NumberReader numbers = numbersAt(places_[frame] + kTimeAt);
        result.time = numbers.next<float>();
        PeriodicBox box;
        for (glm::vec3& row : box)
            for (int k = 0; k < 3; ++k) row[k] = numbers.next<float>() * 10;
        if (box[0].x > 0 && box[1].y > 0 && box[2].z > 0) result.box = box;
        if (atoms_ <= kFewAtoms) return readPositions(head.begin, false, 10, result);
        buffer_.resize(head.count);
        file_->read(head.begin, buffer_);
        if (!(head.packing.precision > 0) || !std::isfinite(head.packing.precision) ||
            !XtcUnpacker(head.packing, buffer_, result.positions).run())
            damaged(frame);
    }

    std::vector<std::uint64_t> places_;
};

}  // namespace

std::unique_ptr<Trajectory> openXtc(OwnedFile file) { return std::make_unique<Xtc>(std::move(file)); }

}  // namespace nacre
