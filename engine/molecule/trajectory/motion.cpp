#include "engine/molecule/trajectory/motion.h"

#include <algorithm>
#include <cmath>

#include "engine/error.h"

namespace nacre {

Motion::Motion(std::unique_ptr<Trajectory> trajectory, const Molecule& molecule, MotionOptions options)
    : trajectory_(std::move(trajectory)) {
    const std::size_t atoms = molecule.atoms.size();
    if (trajectory_->atoms() != atoms)
        throw Error("cannot join structure and trajectory", "",
                    "the trajectory has " + std::to_string(trajectory_->atoms()) + " atoms, the structure " +
                        std::to_string(atoms));
    change(std::move(options), molecule);
}

void Motion::change(MotionOptions options, const Molecule& molecule) {
    options_ = std::move(options);
    kept_.clear();
    first_.clear();
    steps_.clear();
    if (!options_.whole) return;
    const std::size_t atoms = molecule.atoms.size();
    std::vector<std::vector<std::uint32_t>> bonded(atoms);
    for (const Bond& bond : molecule.bonds) {
        bonded[bond.a].push_back(bond.b);
        bonded[bond.b].push_back(bond.a);
    }
    std::vector<bool> reached(atoms);
    for (std::uint32_t start = 0; start < atoms; ++start) {
        if (reached[start]) continue;
        reached[start] = true;
        std::vector<std::uint32_t> edge{start};
        while (!edge.empty()) {
            const std::uint32_t from = edge.back();
            edge.pop_back();
            for (const std::uint32_t to : bonded[from]) {
                if (reached[to]) continue;
                reached[to] = true;
                steps_.push_back({from, to});
                edge.push_back(to);
            }
        }
    }
}

/// Each atom goes to the image of it that is nearest to its neighbour. Boxes are reduced (c leans by at most half of
/// a and b), so that shifting by c, then b, then a finds that.
void Motion::makeWhole(std::vector<glm::vec3>& positions, const PeriodicBox& box) const {
    for (const Step& step : steps_) {
        glm::vec3 way = positions[step.to] - positions[step.from];
        for (int k = 2; k >= 0; --k) {
            const glm::vec3& edge = box[static_cast<std::size_t>(k)];
            if (edge[k] > 0) way -= edge * std::round(way[k] / edge[k]);
        }
        positions[step.to] = positions[step.from] + way;
    }
}

std::vector<glm::dvec3> Motion::fittedOf(const std::vector<glm::vec3>& positions) const {
    std::vector<glm::dvec3> points;
    points.reserve(options_.fitted.size());
    for (const std::uint32_t atom : options_.fitted) points.emplace_back(positions[atom]);
    return points;
}

Motion::Kept Motion::lay(std::size_t frame) {
    TrajectoryFrame read = trajectory_->read(frame);
    if (options_.whole && read.box) makeWhole(read.positions, *read.box);
    Kept kept{frame, std::move(read.positions), 0, read.time};
    if (options_.fitted.empty()) return kept;
    if (first_.empty() && frame == 0) first_ = fittedOf(kept.positions);
    if (first_.empty()) first_ = fittedOf(lay(0).positions);
    if (frame == 0) return kept;
    const Superposition onto = superpose(first_, fittedOf(kept.positions));
    for (glm::vec3& p : kept.positions) p = glm::vec3(onto(glm::dvec3(p)));
    kept.rmsd = onto.rmsd;
    return kept;
}

const Motion::Kept& Motion::laid(std::size_t frame) {
    for (const Kept& kept : kept_)
        if (kept.frame == frame) return kept;
    if (kept_.size() >= options_.smoothed) {
        // The one that is farthest away is wanted last.
        const auto apart = [&](const Kept& k) { return k.frame > frame ? k.frame - frame : frame - k.frame; };
        kept_.erase(std::max_element(kept_.begin(), kept_.end(),
                                     [&](const Kept& a, const Kept& b) { return apart(a) < apart(b); }));
    }
    kept_.push_back(lay(frame));
    return kept_.back();
}

std::vector<glm::vec3> Motion::positions(std::size_t frame) {
    if (options_.smoothed <= 1) {
        const Kept& kept = laid(frame);
        rmsd_ = kept.rmsd;
        time_ = kept.time;
        return kept.positions;
    }
    const std::size_t half = options_.smoothed / 2;
    const std::size_t begin = frame - std::min(half, frame), end = std::min(frame + half + 1, frames());
    rmsd_ = laid(frame).rmsd;
    time_ = laid(frame).time;
    std::vector<glm::dvec3> sum(trajectory_->atoms(), glm::dvec3(0));
    for (std::size_t i = begin; i < end; ++i) {
        const Kept& kept = laid(i);
        for (std::size_t atom = 0; atom < sum.size(); ++atom) sum[atom] += glm::dvec3(kept.positions[atom]);
    }
    std::vector<glm::vec3> mean(sum.size());
    for (std::size_t atom = 0; atom < sum.size(); ++atom)
        mean[atom] = glm::vec3(sum[atom] / static_cast<double>(end - begin));
    return mean;
}

}  // namespace nacre
