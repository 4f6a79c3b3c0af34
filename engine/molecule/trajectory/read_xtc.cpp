// XTC of GROMACS: XDR, nm, positions on a grid and compressed (xtc_bits.h). Frames differ in size: the file is scanned
// once for where they begin.

#include <cmath>

#include "engine/molecule/trajectory/trajectory_file.h"
#include "engine/molecule/trajectory/xtc_bits.h"

namespace nacre {
namespace {

constexpr std::size_t kFewAtoms = 9;  ///< so many are not compressed
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
    // Three bits an atom are the least; 12 bytes and a little the most.
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
            !unpackXtc(head.packing, buffer_, result.positions))
            damaged(frame);
    }

    std::vector<std::uint64_t> places_;
};

}  // namespace

std::unique_ptr<Trajectory> openXtc(OwnedFile file) { return std::make_unique<Xtc>(std::move(file)); }

}  // namespace nacre
