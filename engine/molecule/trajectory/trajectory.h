#pragma once
// Trajectories: the positions of a structure's atoms in frame after frame, read from their file as they are needed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Vectors of a periodic box, Å.
using PeriodicBox = std::array<glm::vec3, 3>;

struct TrajectoryFrame {
    std::vector<glm::vec3> positions;  ///< Å, in the order of the structure's atoms
    std::optional<PeriodicBox> box;    ///< none if the file has none, or an empty one
    std::optional<double> time;        ///< ps; none if the file has none
};

/// An open trajectory. Frames may be read in any order; one at a time.
class Trajectory {
public:
    virtual ~Trajectory() = default;
    std::size_t atoms() const { return atoms_; }    ///< in each frame, at least one
    std::size_t frames() const { return frames_; }  ///< whole ones, at least one
    const char* format() const { return format_; }  ///< "dcd", "xtc", "trr", "netcdf", "models"
    bool cutOff() const { return cutOff_; }         ///< the file ends within a frame, which is left out

    /// @param frame  from 0 @throws Error if there is no such frame, or it is damaged
    TrajectoryFrame read(std::size_t frame);

protected:
    virtual void readFrame(std::size_t frame, TrajectoryFrame& result) = 0;

    std::string name_;  ///< for messages
    const char* format_ = "";
    std::size_t atoms_ = 0, frames_ = 0;
    bool cutOff_ = false;
};

/// Opens a DCD, XTC, TRR or AMBER NetCDF file, told apart by its content. Scans it for where its frames begin, and
/// holds no more than that. @throws Error
std::unique_ptr<Trajectory> openTrajectory(const std::string& path);

/// The models of a molecule's file one after the other, if each has the molecule's own atoms (Molecule::others); else
/// null. @param model  that the molecule is, counted from 1 @param placesAlone  models may differ in what else is
/// stated of the same atoms: B factors, occupancies, folds
std::unique_ptr<Trajectory> trajectoryOfModels(std::shared_ptr<const Molecule> molecule, int model,
                                               bool placesAlone = false);

/// Why there is no such trajectory: "model 3 has 12 atoms, the first 14". @param molecule  the first model
std::string differenceOfModels(const Molecule& molecule);

/// Box vectors from lengths (Å) and angles (degrees) between b and c, a and c, a and b; none if they enclose nothing.
std::optional<PeriodicBox> boxOf(const glm::dvec3& lengths, const glm::dvec3& angles);

}  // namespace nacre
