#pragma once
// Trajectories: positions of a structure's atoms per frame, read from their file on demand.

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Vectors of a periodic box, Å; zero along directions that do not repeat.
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
    std::size_t atoms() const { return atoms_; }    ///< per frame, at least one
    std::size_t frames() const { return frames_; }  ///< complete ones, at least one
    const char* format() const { return format_; }  ///< "dcd", "xtc", "trr", "netcdf", "h5md", "models"
    bool cutOff() const { return cutOff_; }         ///< the file ends within a frame, which is ignored

    /// @param frame  from 0 @throws Error if there is no such frame, or it is damaged
    TrajectoryFrame read(std::size_t frame);

protected:
    virtual void readFrame(std::size_t frame, TrajectoryFrame& result) = 0;

    std::string name_;  ///< for messages
    const char* format_ = "";
    std::size_t atoms_ = 0, frames_ = 0;
    bool cutOff_ = false;
};

/// Opens a DCD, XTC, TRR, AMBER NetCDF or H5MD file, detected by content: scans it for the positions of its frames, and
/// holds only those. Any other file is read as a structure whose models are the frames. @throws Error
std::unique_ptr<Trajectory> openTrajectory(const std::string& path);

/// A DCD, XTC, TRR or AMBER NetCDF file from its bytes; null for other formats. @param name  for messages @throws Error
std::unique_ptr<Trajectory> openTrajectory(const std::string& name, const std::string& bytes);

/// Whether a file begins as DCD, XTC, TRR or NetCDF, which contain only positions; false if it cannot be read.
bool isTrajectoryFile(const std::string& path);

/// The models of a molecule's file in order, if each has the molecule's own atoms (Molecule::others); else null.
/// @param model  the molecule's own, from 1
/// @param placesAlone  other data of the atoms may differ: B factors, occupancies, secondary structure
std::unique_ptr<Trajectory> trajectoryOfModels(std::shared_ptr<const Molecule> molecule, int model,
                                               bool placesAlone = false);

/// Why there is no such trajectory: "model 3 has 12 atoms, the first 14". @param molecule  the first model
std::string differenceOfModels(const Molecule& molecule);

/// Box vectors from lengths (Å) and angles (degrees) between b and c, a and c, a and b; none if the volume is zero.
std::optional<PeriodicBox> makeBox(const glm::dvec3& lengths, const glm::dvec3& angles);

}  // namespace nacre
