#pragma once
// A trajectory as it is to be seen: molecules that the periodic box cut are made whole, each frame is laid onto
// the first, and shaking is smoothed over neighbouring frames.

#include <deque>

#include "engine/molecule/molecule.h"
#include "engine/molecule/superpose.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

struct MotionOptions {
    bool whole = false;  ///< bonded atoms stand together, wherever the box's faces lie
    /// Atoms by which frames are laid onto the first; none: they stay. Molecules with such atoms that are made whole
    /// stand to each other as in the first frame, there at their nearest images, and all others at the image that is
    /// nearest to the first of these.
    std::vector<std::uint32_t> fitted;
    /// Frames that a position is the mean of, odd; fewer at both ends. In a periodic box each molecule that is made
    /// whole, else each atom, is followed from frame to frame by its nearest image, so that nothing is the mean of two
    /// sides.
    std::size_t smoothed = 1;
};

class Motion {
public:
    static constexpr std::size_t kMostSmoothed = 101;

    /// @param molecule  whose atoms these are: its bonds tell what belongs together
    /// @throws Error if the numbers of atoms differ
    Motion(std::unique_ptr<Trajectory> trajectory, const Molecule& molecule, MotionOptions options);

    /// From the next frame on. @param molecule  as at first
    void change(MotionOptions options, const Molecule& molecule);

    const Trajectory& trajectory() const { return *trajectory_; }
    std::size_t frames() const { return trajectory_->frames(); }
    /// Å. @param frame from 0. One after the other, each costs one frame read. @throws Error
    std::vector<glm::vec3> positions(std::size_t frame);
    /// Of the frame asked for last: how far the fitted atoms are from their places in the first frame, Å.
    double rmsd() const { return rmsd_; }
    /// Of the same, ps; none if the file has none.
    std::optional<double> time() const { return time_; }
    /// A frame that was read, from 0, whose fitted atoms have bonds across the periodic box: what is laid is torn.
    std::optional<std::size_t> torn() const { return torn_; }
    /// A frame that was read, from 0, that has no periodic box though molecules are to be made whole: it stays as it
    /// is.
    std::optional<std::size_t> boxless() const { return boxless_; }

private:
    /// A frame as it was read, and whole if that is wanted; where it is to be laid is `onto`.
    struct Kept {
        std::size_t frame;
        std::vector<glm::vec3> positions;
        std::optional<PeriodicBox> box;
        Superposition onto;
        std::optional<double> time;
    };
    /// An atom that is reached over a bond from one that stands already.
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
    std::vector<glm::dvec3> fittedOf(const std::vector<glm::vec3>& positions) const;

    std::unique_ptr<Trajectory> trajectory_;
    MotionOptions options_;
    std::vector<Step> steps_;
    std::vector<std::uint32_t> firstOf_;  // of each atom that is made whole: the one that its molecule begins with
    std::vector<glm::dvec3> first_;       // the fitted atoms in the first frame
    std::vector<Step> fittedBonds_;       // of fitted atoms, where nothing is made whole
    std::vector<std::vector<std::uint32_t>> fittedOfMolecules_;  // fitted atoms by the molecule that is made whole
    std::vector<glm::vec3> ways_;  // from the first of these molecules to each, in the first frame
    std::optional<std::size_t> torn_, boxless_;
    std::deque<Kept> kept_;
    double rmsd_ = 0;
    std::optional<double> time_;
};

}  // namespace nacre
