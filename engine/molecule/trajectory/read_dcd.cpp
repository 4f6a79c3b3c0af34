// DCD of CHARMM, NAMD and X-PLOR: Fortran records, each between two copies of its length, in either byte order. All
// frames have one size, except that with fixed atoms only the first frame has all atoms.

#include <cmath>

#include "engine/molecule/trajectory/trajectory_file.h"

namespace nacre {
namespace {

class Dcd : public FileTrajectory {
public:
    Dcd(OwnedFile file, bool swapped) : FileTrajectory(std::move(file), "dcd", swapped) { readHeader(); }

private:
    /// A number of the header's control block, by index from 0.
    std::int32_t control(std::uint64_t i) const { return numbersAt(8 + 4 * i).next<std::int32_t>(); }

    void readHeader() {
        constexpr std::uint64_t kHeader = 84 + 8;
        const bool charmm = control(19) != 0;
        hasCell_ = charmm && control(10) != 0;
        hasFourth_ = charmm && control(11) != 0;
        const std::int32_t fixed = control(8);
        // X-PLOR's step is a double instead of two numbers.
        const double units = numbersAt(8 + 4 * 9).next(!charmm);
        constexpr double kAkmaPicoseconds = 0.0488882129;  // sqrt(g/mol Å^2 / (kcal/mol)) in ps
        firstStep_ = control(1);
        perFrame_ = control(2);
        // Programs that do not know the step write 1, which would be 49 fs.
        if (units > 0 && units < 1e6 && units != 1 && perFrame_ > 0) stepPicoseconds_ = units * kAkmaPicoseconds;
        std::uint64_t at = kHeader;
        at += record(at);  // the title
        if (record(at) != 4 + 8) file_->fail("its header has no number of atoms");
        atoms_ = checkedAtoms(*file_, numbersAt(at + 4).next<std::int32_t>());
        at += 4 + 8;
        if (fixed < 0 || static_cast<std::size_t>(fixed) >= atoms_)
            file_->fail("its header has " + std::to_string(fixed) + " fixed atoms of " + std::to_string(atoms_));
        if (fixed > 0) at += readFree(at, atoms_ - static_cast<std::size_t>(fixed));
        first_ = at;
        const std::uint64_t lists = hasFourth_ ? 4 : 3, cell = hasCell_ ? 48 + 8 : 0;
        firstSize_ = cell + lists * (atoms_ * 4 + 8);
        frameSize_ = cell + lists * ((free_.empty() ? atoms_ : free_.size()) * 4 + 8);
        if (!file_->holds(first_, firstSize_)) file_->fail("it has no whole frame");
        const std::uint64_t rest = file_->size() - first_ - firstSize_;
        frames_ = 1 + rest / frameSize_;
        cutOff_ = rest % frameSize_ != 0;
    }

    std::uint64_t readFree(std::uint64_t at, std::size_t count) {
        if (record(at) != count * 4 + 8) file_->fail("its list of free atoms has another length than its header says");
        NumberReader numbers = numbersAt(at + 4);
        for (std::size_t i = 0; i < count; ++i) {
            const auto atom = numbers.next<std::int32_t>();
            if (atom < 1 || static_cast<std::size_t>(atom) > atoms_) file_->fail("its list of free atoms names none");
            free_.push_back(static_cast<std::uint32_t>(atom - 1));
        }
        return count * 4 + 8;
    }

    /// Size of a record including both its lengths, bytes. @throws Error if those differ
    std::uint64_t record(std::uint64_t at) const {
        const auto length = numbersAt(at).next<std::uint32_t>();
        if (!file_->holds(at, std::uint64_t{length} + 8) || numbersAt(at + 4 + length).next<std::uint32_t>() != length)
            file_->fail("a record has no end (byte " + std::to_string(at) + ")");
        return std::uint64_t{length} + 8;
    }

    void readWhole(std::size_t frame, TrajectoryFrame& result) override {
        std::uint64_t at = frame == 0 ? first_ : first_ + firstSize_ + (frame - 1) * frameSize_;
        if (stepPicoseconds_ > 0)
            result.time = stepPicoseconds_ * (firstStep_ + static_cast<double>(frame) * perFrame_);
        if (hasCell_) {
            if (record(at) != 48 + 8) damaged(frame);
            result.box = cellAt(at + 4);
            at += 48 + 8;
        }
        const bool part = frame > 0 && !free_.empty();
        if (part) {
            if (fixedPositions_.empty()) {
                TrajectoryFrame whole;
                whole.positions.resize(atoms_);
                readWhole(0, whole);
                fixedPositions_ = std::move(whole.positions);
            }
            result.positions = fixedPositions_;
        }
        const std::size_t count = part ? free_.size() : atoms_;
        buffer_.resize(count * 4);
        for (int axis = 0; axis < 3; ++axis) {
            if (record(at) != count * 4 + 8) damaged(frame);
            file_->read(at + 4, buffer_);
            for (std::size_t i = 0; i < count; ++i)
                result.positions[part ? free_[i] : i][axis] = numberAt<float>(buffer_.data() + 4 * i, swapped_);
            at += count * 4 + 8;
        }
    }

    /// A, gamma, B, beta, alpha, C; angles in degrees, or their cosines (NAMD).
    std::optional<PeriodicBox> cellAt(std::uint64_t at) const {
        NumberReader numbers = numbersAt(at);
        std::array<double, 6> v{};
        for (double& value : v) value = numbers.next<double>();
        glm::dvec3 angles(v[4], v[3], v[1]);
        if (std::abs(angles.x) <= 1 && std::abs(angles.y) <= 1 && std::abs(angles.z) <= 1)
            for (int k = 0; k < 3; ++k) angles[k] = std::acos(angles[k]) * 57.29577951308232;
        return makeBox({v[0], v[2], v[5]}, angles);
    }

    bool hasCell_ = false, hasFourth_ = false;
    std::vector<std::uint32_t> free_;  // mobile atoms; empty: all
    std::vector<glm::vec3> fixedPositions_;
    std::uint64_t first_ = 0, firstSize_ = 0, frameSize_ = 0;
    double stepPicoseconds_ = 0, firstStep_ = 0, perFrame_ = 0;  // of the simulation; 0: unknown
};

}  // namespace

std::unique_ptr<Trajectory> openDcd(OwnedFile file, bool swapped) {
    return std::make_unique<Dcd>(std::move(file), swapped);
}

}  // namespace nacre
