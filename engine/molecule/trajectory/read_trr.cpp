// TRR of GROMACS: XDR, nm, in single or double precision; frames without positions are skipped.

#include "engine/molecule/trajectory/trajectory_file.h"

namespace nacre {
namespace {

/// TrrHead of a frame: the sizes of the following parts, in bytes.
struct TrrHead {
    std::uint64_t begin = 0, size = 0;  ///< of the data
    std::uint64_t box = 0, beforePositions = 0, positions = 0;
    std::int64_t atoms = 0;
    double time = 0;     ///< ps
    bool twice = false;  ///< double precision
};

TrrHead trrHeadAt(const TrajectoryFile& file, std::uint64_t at) {
    NumberReader numbers(file, at, kBigEndianSwapped);
    const auto size = [&]() -> std::uint64_t {
        const auto value = numbers.next<std::int32_t>();
        if (value < 0) file.fail("a frame's header is damaged (byte " + std::to_string(at) + ")");
        return static_cast<std::uint64_t>(value);
    };
    if (numbers.next<std::int32_t>() != 1993)
        file.fail("a frame has no valid header (byte " + std::to_string(at) + ")");
    numbers.skip(4);  // length of the name, with its terminator
    numbers.skip((size() + 3) / 4 * 4);
    TrrHead head;
    const std::uint64_t records = size() + size();
    head.box = size();
    const std::uint64_t tensors = size() + size(), others = size() + size();
    head.positions = size();
    const std::uint64_t rest = size() + size();
    head.atoms = numbers.next<std::int32_t>();
    numbers.skip(8);  // step, energies
    head.twice = head.positions ? head.positions == static_cast<std::uint64_t>(head.atoms) * 24 : head.box == 72;
    head.time = numbers.next(head.twice);
    numbers.skip(head.twice ? 8 : 4);  // lambda
    if (records + others != 0 || (head.box != 0 && head.box != (head.twice ? 72u : 36u)) ||
        (head.positions != 0 && head.positions != static_cast<std::uint64_t>(head.atoms) * (head.twice ? 24 : 12)))
        file.fail("a frame's header is damaged (byte " + std::to_string(at) + ")");
    head.begin = numbers.offset();
    head.beforePositions = head.box + tensors;
    head.size = head.beforePositions + head.positions + rest;
    return head;
}

class Trr : public FileTrajectory {
public:
    explicit Trr(OwnedFile file) : FileTrajectory(std::move(file), "trr") {
        constexpr std::uint64_t kLongestHead = 200;
        std::uint64_t at = 0;
        while (at < file_->size()) {
            if (!file_->holds(at, kLongestHead) && !places_.empty() && !wholeHead(at)) break;
            const TrrHead head = trrHeadAt(*file_, at);
            if (!file_->holds(head.begin, head.size)) break;
            if (head.positions) {
                const std::size_t atoms = checkedAtoms(*file_, head.atoms);
                if (atoms_ && atoms != atoms_) file_->fail("its frames have different numbers of atoms");
                atoms_ = atoms;
                places_.push_back(at);
            }
            at = head.begin + head.size;
        }
        cutOff_ = at < file_->size();
        frames_ = places_.size();
        if (!frames_) file_->fail("it has no whole frame with positions");
    }

private:
    bool wholeHead(std::uint64_t at) const {
        try {
            trrHeadAt(*file_, at);
            return true;
        } catch (const Error&) {
            return false;
        }
    }

    void readWhole(std::size_t frame, TrajectoryFrame& result) override {
        const TrrHead head = trrHeadAt(*file_, places_[frame]);
        result.time = head.time;
        if (head.box) {
            PeriodicBox box;
            NumberReader numbers = numbersAt(head.begin);
            for (glm::vec3& row : box)
                for (int k = 0; k < 3; ++k) row[k] = static_cast<float>(numbers.next(head.twice)) * kAngstrom;
            if (box[0].x > 0 && box[1].y > 0 && box[2].z > 0) result.box = box;
        }
        readPositions(head.begin + head.beforePositions, head.twice, kAngstrom, result);
    }

    static constexpr float kAngstrom = 10;  // per nm
    std::vector<std::uint64_t> places_;
};

}  // namespace

std::unique_ptr<Trajectory> openTrr(OwnedFile file) { return std::make_unique<Trr>(std::move(file)); }

}  // namespace nacre
