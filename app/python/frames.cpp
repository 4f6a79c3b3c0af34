#include "app/python/frames.h"

#include <utility>

#include "app/input/read_input.h"

namespace nacre::python {

std::unique_ptr<Motion> makeMotion(const Structure& structure, const Molecule& now) {
    const app::TrajectoryOptions& frames = structure.reading.trajectory;
    if (!frames.path.empty()) return app::openMotion(frames, now);
    auto models = trajectoryOfModels(structure.molecule, structure.reading.model);
    if (!models) return nullptr;
    return std::make_unique<Motion>(std::move(models), now, app::motionOptions(frames, now));
}

Frames::Frames(const Structure& structure)
    : structure_(structure), motion_(makeMotion(structure, *structure.molecule)) {}

Structure Frames::at(std::uint64_t frame) const {
    if (!motion_) return structure_;
    auto moved = std::make_shared<Molecule>(*structure_.molecule);
    {
        const std::lock_guard lock(turn_);
        app::movePositions(*moved, motion_->positions(frame));
    }
    Structure one = structure_;
    one.molecule = std::move(moved);
    one.kept = std::make_shared<Structure::Kept>();
    return one;
}

}  // namespace nacre::python
