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
    if (molecule->modelsAreInputs || molecule->atoms.empty() || model < 1 ||
        static_cast<std::size_t>(model) > molecule->others.size() + 1 ||
        !molecule->others.allMove(molecule->atoms.size()))
        return nullptr;
    return std::make_unique<ModelTrajectory>(std::move(molecule), static_cast<std::size_t>(model - 1));
}

}  // namespace nacre
