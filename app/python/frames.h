#pragma once
// The models of a structure, or the frames of the trajectory that it was opened with, as structures.

#include <memory>
#include <mutex>

#include "app/python/drawing.h"
#include "engine/molecule/trajectory/motion.h"

namespace nacre::python {

/// Null if there is only one model. @param now  the molecule whose positions change @throws Error
std::unique_ptr<Motion> makeMotion(const Structure& structure, const Molecule& now);

/// Reads frames one by one. Threads may share it.
class Frames {
public:
    /// @throws Error
    explicit Frames(const Structure& structure);
    /// Number of frames; 1 without a trajectory or further models.
    std::uint64_t count() const { return motion_ ? motion_->frames() : 1; }
    /// @param frame  from 0 @throws Error
    Structure at(std::uint64_t frame) const;

private:
    Structure structure_;
    mutable std::mutex turn_;  // guards motion_, which holds one frame at a time
    std::unique_ptr<Motion> motion_;
};

}  // namespace nacre::python
