#pragma once
// A trajectory for display: molecules cut by the periodic box are made whole, frames are fitted to the first, and
// motion is smoothed over neighbouring frames.

#include <deque>

#include "engine/molecule/molecule.h"
#include "engine/molecule/superpose.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

struct MotionOptions {
    bool whole = false;  ///< make molecules whole: bonded atoms lie together across the box's faces
    /// Atoms by which frames are fitted to the first; empty: no fit. Whole molecules with such atoms keep the
    /// arrangement of the first frame, where they are at their nearest images; all others take the image nearest to the
    /// first of these.
    std::vector<std::uint32_t> fitted;
    /// Number of frames averaged, odd; fewer at both ends. In a periodic box each whole molecule, or else each atom, is
    /// tracked by its nearest image between frames, so that no average mixes two sides of the box.
    std::size_t smoothed = 1;
};

class Motion {
public:
    static constexpr std::size_t kMostSmoothed = 101;

    /// @param molecule  its bonds define molecules
    /// @throws Error if the numbers of atoms differ
    Motion(std::unique_ptr<Trajectory> trajectory, const Molecule& molecule, MotionOptions options);

    /// Applies from the next frame on. @param molecule  the same as before
    void change(MotionOptions options, const Molecule& molecule);

    const Trajectory& trajectory() const { return *trajectory_; }
    std::size_t frames() const { return trajectory_->frames(); }
    /// Å. @param frame from 0. Frames in sequence cost one read each. @throws Error
    std::vector<glm::vec3> positions(std::size_t frame);
    /// RMSD of the fitted atoms to the first frame, Å, for the last frame requested.
    double rmsd() const { return rmsd_; }
    /// Time of the last frame requested, ps; none if the file has none.
    std::optional<double> time() const { return time_; }
    /// A frame (from 0) whose fitted atoms have bonds across the periodic box, so that the fit tears molecules.
    std::optional<std::size_t> torn() const { return torn_; }
    /// A frame (from 0) without a periodic box although molecules should be made whole: it stays unchanged.
    std::optional<std::size_t> boxless() const { return boxless_; }

private:
    /// A frame as read, made whole if requested; `onto` is its fit.
    struct Kept {
        std::size_t frame;
        std::vector<glm::vec3> positions;
        std::optional<PeriodicBox> box;
        Superposition onto;
        std::optional<double> time;
    };
    /// An atom reached over a bond from one already positioned.
    struct Step {
        std::uint32_t from, to;
    };

    const Kept& laid(std::size_t frame);
    Kept lay(std::size_t frame);
    void findSteps(const Molecule& molecule);
    void findFitted(const Molecule& molecule);
    void makeWhole(std::vector<glm::vec3>& positions, const PeriodicBox& box) const;
    void gather(std::vector<glm::vec3>& positions, const PeriodicBox& box, bool first);
    bool isTorn(const std::vector<glm::vec3>& positions, const PeriodicBox& box) const;
    std::vector<glm::vec3> follow(const std::vector<glm::vec3>& before, const Kept& kept) const;
    void addLaid(std::vector<glm::dvec3>& sum, const std::vector<glm::vec3>& positions,
                 const Superposition& onto) const;
    std::vector<glm::dvec3> selectFitted(const std::vector<glm::vec3>& positions) const;

    std::unique_ptr<Trajectory> trajectory_;
    MotionOptions options_;
    std::vector<Step> steps_;
    std::vector<std::uint32_t> firstOf_;                         // by atom, if made whole: first atom of its molecule
    std::vector<glm::dvec3> first_;                              // the fitted atoms in the first frame
    std::vector<Step> fittedBonds_;                              // of fitted atoms, if molecules are not made whole
    std::vector<std::vector<std::uint32_t>> fittedOfMolecules_;  // fitted atoms by whole molecule
    std::vector<glm::vec3> ways_;  // vector from the first of these molecules to each, in the first frame
    std::optional<std::size_t> torn_, boxless_;
    std::deque<Kept> kept_;
    double rmsd_ = 0;
    std::optional<double> time_;
};

}  // namespace nacre
