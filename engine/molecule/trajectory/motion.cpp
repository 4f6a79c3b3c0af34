#include "engine/molecule/trajectory/motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/error.h"

namespace nacre {
namespace {

/// The shortest way to an image of where a way leads. Boxes are reduced (c leans by at most half of a and b), so that
/// shifting by c, then b, then a finds that.
glm::vec3 nearestImage(glm::vec3 way, const PeriodicBox& box) {
    for (int k = 2; k >= 0; --k) {
        const glm::vec3& edge = box[static_cast<std::size_t>(k)];
        if (edge[k] > 0) way -= edge * std::round(way[k] / edge[k]);
    }
    return way;
}

}  // namespace

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
    const std::size_t atoms = molecule.atoms.size();
    firstOf_.resize(atoms);
    std::iota(firstOf_.begin(), firstOf_.end(), std::uint32_t{0});
    if (!options_.whole) return;
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
                firstOf_[to] = start;
                steps_.push_back({from, to});
                edge.push_back(to);
            }
        }
    }
}

/// Each atom goes to the image of it that is nearest to its neighbour.
void Motion::makeWhole(std::vector<glm::vec3>& positions, const PeriodicBox& box) const {
    for (const Step& step : steps_)
        positions[step.to] = positions[step.from] + nearestImage(positions[step.to] - positions[step.from], box);
}

/// A frame, with each molecule at the image that is nearest to where it was in the one before.
std::vector<glm::vec3> Motion::follow(const std::vector<glm::vec3>& before, const Kept& kept) const {
    std::vector<glm::vec3> positions = kept.positions;
    if (!kept.box) return positions;
    for (std::size_t atom = 0; atom < positions.size(); ++atom) {
        const std::uint32_t first = firstOf_[atom];
        const glm::vec3 way = kept.positions[first] - before[first];
        positions[atom] += nearestImage(way, *kept.box) - way;
    }
    return positions;
}

void Motion::addLaid(std::vector<glm::dvec3>& sum, const std::vector<glm::vec3>& positions,
                     const Superposition& onto) const {
    for (std::size_t atom = 0; atom < sum.size(); ++atom) sum[atom] += onto(glm::dvec3(positions[atom]));
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
    Kept kept{frame, std::move(read.positions), read.box, {}, read.time};
    if (options_.fitted.empty()) return kept;
    if (first_.empty()) first_ = fittedOf(frame == 0 ? kept.positions : lay(0).positions);
    if (frame > 0) kept.onto = superpose(first_, fittedOf(kept.positions));
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
    const std::size_t half = options_.smoothed / 2, count = trajectory_->atoms();
    std::vector<glm::vec3> middle;  // references to what is kept do not last
    std::vector<glm::dvec3> sum(count, glm::dvec3(0));
    {
        const Kept& kept = laid(frame);
        rmsd_ = kept.onto.rmsd;
        time_ = kept.time;
        if (half == 0 && options_.fitted.empty()) return kept.positions;
        middle = kept.positions;
        addLaid(sum, middle, kept.onto);
    }
    double frames = 1;
    const auto goOn = [&](std::vector<glm::vec3>& before, std::size_t to) {
        const Kept& kept = laid(to);
        before = follow(before, kept);
        addLaid(sum, before, kept.onto);
        ++frames;
    };
    std::vector<glm::vec3> before = middle;
    for (std::size_t i = 1; i <= half && i <= frame; ++i) goOn(before, frame - i);
    for (std::size_t i = 1; i <= half && frame + i < this->frames(); ++i) goOn(middle, frame + i);
    std::vector<glm::vec3> mean(count);
    for (std::size_t atom = 0; atom < count; ++atom) mean[atom] = glm::vec3(sum[atom] / frames);
    return mean;
}

}  // namespace nacre
