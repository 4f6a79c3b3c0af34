// The models of one file as a trajectory, where all of them have the same atoms.

#include <algorithm>

#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {
namespace {

class ModelTrajectory : public Trajectory {
public:
    ModelTrajectory(std::shared_ptr<const Molecule> molecule, std::size_t own)
        : molecule_(std::move(molecule)), own_(own) {
        format_ = "models";
        atoms_ = molecule_->atoms.size();
        frames_ = molecule_->others.size() + 1;
    }

private:
    void readFrame(std::size_t frame, TrajectoryFrame& result) override {
        if (frame == own_)
            std::transform(molecule_->atoms.begin(), molecule_->atoms.end(), result.positions.begin(),
                           [](const Atom& atom) { return atom.position; });
        else
            result.positions = molecule_->others[frame < own_ ? frame : frame - 1].positions;
    }

    std::shared_ptr<const Molecule> molecule_;
    std::size_t own_;
};

}  // namespace

std::unique_ptr<Trajectory> trajectoryOfModels(std::shared_ptr<const Molecule> molecule, int model) {
    const std::vector<OtherModel>& others = molecule->others;
    const auto moved = [&](const OtherModel& other) {
        return !other.whole && other.positions.size() == molecule->atoms.size();
    };
    if (molecule->modelsAreInputs || others.empty() || molecule->atoms.empty() || model < 1 ||
        static_cast<std::size_t>(model) > others.size() + 1 || !std::all_of(others.begin(), others.end(), moved))
        return nullptr;
    return std::make_unique<ModelTrajectory>(std::move(molecule), static_cast<std::size_t>(model - 1));
}

}  // namespace nacre
