#include "engine/molecule/trajectory/motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "engine/error.h"

namespace nacre {
namespace {

/// The shortest vector to an image of a vector's end. Boxes are reduced (c leans by at most half of a and b), so that
/// shifting by c, then b, then a finds it.
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
    ways_.clear();
    torn_.reset();
    boxless_.reset();
    firstOf_.resize(molecule.atoms.size());
    std::iota(firstOf_.begin(), firstOf_.end(), std::uint32_t{0});
    if (options_.whole) findSteps(molecule);
    findFitted(molecule);
}

void Motion::findSteps(const Molecule& molecule) {
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
                firstOf_[to] = start;
                steps_.push_back({from, to});
                edge.push_back(to);
            }
        }
    }
}

void Motion::findFitted(const Molecule& molecule) {
    fittedBonds_.clear();
    fittedOfMolecules_.clear();
    std::vector<bool> fitted(molecule.atoms.size());
    std::map<std::uint32_t, std::size_t> places;  // by the molecule's first atom
    for (const std::uint32_t atom : options_.fitted) {
        fitted[atom] = true;
        if (!options_.whole) continue;
        const auto [place, isNew] = places.emplace(firstOf_[atom], places.size());
        if (isNew) fittedOfMolecules_.emplace_back();
        fittedOfMolecules_[place->second].push_back(atom);
    }
    for (const Bond& bond : molecule.bonds)
        if (!options_.whole && (fitted[bond.a] || fitted[bond.b])) fittedBonds_.push_back({bond.a, bond.b});
}

/// Moves whole molecules to the images that belong together.
void Motion::gather(std::vector<glm::vec3>& positions, const PeriodicBox& box, bool first) {
    std::vector<glm::vec3> shifts(positions.size(), glm::vec3(0));  // by the molecule's first atom
    std::vector<bool> settled(positions.size());
    glm::vec3 origin(0);
    if (first) ways_.assign(fittedOfMolecules_.size(), glm::vec3(0));
    for (std::size_t i = 0; i < fittedOfMolecules_.size(); ++i) {
        const std::vector<std::uint32_t>& atoms = fittedOfMolecules_[i];
        glm::dvec3 sum(0);
        for (const std::uint32_t atom : atoms) sum += glm::dvec3(positions[atom]);
        const glm::vec3 middle(sum / static_cast<double>(atoms.size()));
        if (i == 0) origin = middle;
        const glm::vec3 way = middle - origin, image = ways_[i] + nearestImage(way - ways_[i], box);
        shifts[firstOf_[atoms[0]]] = image - way;
        settled[firstOf_[atoms[0]]] = true;
        if (first) ways_[i] = image;
    }
    for (std::size_t atom = 0; atom < positions.size(); ++atom) {
        const std::uint32_t molecule = firstOf_[atom];  // at or before the atom: not moved yet, or its shift is known
        if (!settled[molecule]) {
            const glm::vec3 way = positions[molecule] - origin;
            shifts[molecule] = nearestImage(way, box) - way;
            settled[molecule] = true;
        }
        positions[atom] += shifts[molecule];
    }
}

bool Motion::isTorn(const std::vector<glm::vec3>& positions, const PeriodicBox& box) const {
    return std::any_of(fittedBonds_.begin(), fittedBonds_.end(), [&](const Step& bond) {
        const glm::vec3 way = positions[bond.to] - positions[bond.from];
        const float longest = std::max({glm::length(box[0]), glm::length(box[1]), glm::length(box[2])});
        return glm::distance(way, nearestImage(way, box)) > 1e-3f * longest;
    });
}

/// Moves each atom to its image nearest to its neighbour.
void Motion::makeWhole(std::vector<glm::vec3>& positions, const PeriodicBox& box) const {
    for (const Step& step : steps_)
        positions[step.to] = positions[step.from] + nearestImage(positions[step.to] - positions[step.from], box);
}

/// A frame with each molecule at the image nearest to its place in the previous frame.
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

std::vector<glm::dvec3> Motion::selectFitted(const std::vector<glm::vec3>& positions) const {
    std::vector<glm::dvec3> points;
    points.reserve(options_.fitted.size());
    for (const std::uint32_t atom : options_.fitted) points.emplace_back(positions[atom]);
    return points;
}

Motion::Kept Motion::lay(std::size_t frame) {
    TrajectoryFrame read = trajectory_->read(frame);
    if (options_.whole && read.box) makeWhole(read.positions, *read.box);
    if (options_.whole && !read.box && !boxless_) boxless_ = frame;
    if (frame > 0 && !options_.fitted.empty() && first_.empty()) first_ = selectFitted(lay(0).positions);
    // Without a box, the first frame defines no arrangement of molecules for the others.
    if (!fittedOfMolecules_.empty() && read.box && (frame == 0 || !ways_.empty()))
        gather(read.positions, *read.box, frame == 0);
    if (!torn_ && read.box && isTorn(read.positions, *read.box)) torn_ = frame;
    Kept kept{frame, std::move(read.positions), read.box, {}, read.time};
    if (options_.fitted.empty()) return kept;
    if (frame == 0) first_ = selectFitted(kept.positions);
    if (frame > 0) kept.onto = superpose(first_, selectFitted(kept.positions));
    return kept;
}

const Motion::Kept& Motion::laid(std::size_t frame) {
    for (const Kept& kept : kept_)
        if (kept.frame == frame) return kept;
    if (kept_.size() >= options_.smoothed) {
        // The farthest frame is needed last.
        const auto apart = [&](const Kept& k) { return k.frame > frame ? k.frame - frame : frame - k.frame; };
        kept_.erase(std::max_element(kept_.begin(), kept_.end(),
                                     [&](const Kept& a, const Kept& b) { return apart(a) < apart(b); }));
    }
    kept_.push_back(lay(frame));
    return kept_.back();
}

std::vector<glm::vec3> Motion::positions(std::size_t frame) {
    const std::size_t half = options_.smoothed / 2, count = trajectory_->atoms();
    std::vector<glm::vec3> middle;  // references to kept frames become invalid
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
