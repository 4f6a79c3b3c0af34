#include "engine/molecule/trajectory/morph.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>

#include "engine/error.h"
#include "engine/molecule/superpose.h"

namespace nacre {
namespace {

constexpr double kContact = 5;  // Å, at one key ...
constexpr double kStays = 6.5;  // ... and at the next: these stay together
constexpr double kAngleWeight = 0.5, kContactWeight = 0.01;
constexpr int kHydrogen = 1;

/// Two atoms whose difference rotates with both of them.
struct Edge {
    std::uint32_t a, b;
    double weight;
};

using Places = std::vector<glm::dvec3>;

Places toPlaces(const std::vector<glm::vec3>& positions) { return {positions.begin(), positions.end()}; }

/// Bonds, and the ends of each angle.
std::vector<Edge> bondedEdges(const Molecule& molecule) {
    std::vector<std::vector<std::uint32_t>> bonded(molecule.atoms.size());
    std::vector<Edge> edges;
    for (const Bond& bond : molecule.bonds) {
        edges.push_back({bond.a, bond.b, 1});
        bonded[bond.a].push_back(bond.b);
        bonded[bond.b].push_back(bond.a);
    }
    constexpr std::size_t kMostEnds = 16;  // per atom; real atoms have at most 8
    for (const std::vector<std::uint32_t>& ends : bonded)
        for (std::size_t i = 0; i < std::min(ends.size(), kMostEnds); ++i)
            for (std::size_t k = 0; k < i; ++k) edges.push_back({ends[i], ends[k], kAngleWeight});
    return edges;
}

/// Adds pairs of atoms that are near each other at both keys. @param counts  atoms to consider: not hydrogens
void addContacts(const std::vector<bool>& counts, const Places& from, const Places& to, std::vector<Edge>& edges) {
    constexpr std::size_t kMostInCell = 64;  // per 125 Å³, where real structures have 15; more are a crowd
    std::map<std::array<int, 3>, std::vector<std::uint32_t>> cells;
    const auto findCell = [](const glm::dvec3& p) {
        const glm::ivec3 cell(glm::floor(p / kContact));
        return std::array<int, 3>{cell.x, cell.y, cell.z};
    };
    for (std::uint32_t i = 0; i < from.size(); ++i) {
        if (!counts[i]) continue;
        const std::array<int, 3> own = findCell(from[i]);
        for (int n = 0; n < 27; ++n) {
            const auto near = cells.find({own[0] + n % 3 - 1, own[1] + n / 3 % 3 - 1, own[2] + n / 9 - 1});
            if (near == cells.end()) continue;
            for (const std::uint32_t k : near->second)
                if (glm::distance(from[i], from[k]) < kContact && glm::distance(to[i], to[k]) < kStays)
                    edges.push_back({i, k, kContactWeight});
        }
        if (std::vector<std::uint32_t>& cell = cells[own]; cell.size() < kMostInCell) cell.push_back(i);
    }
}

/// The rotation of each atom's surroundings from one key to the next.
std::vector<glm::dquat> turns(const Places& from, const Places& to, const std::vector<Edge>& edges) {
    std::vector<std::vector<std::uint32_t>> around(from.size());
    const auto add = [&](const Edge& edge) {
        around[edge.a].push_back(edge.b);
        around[edge.b].push_back(edge.a);
    };
    for (const Edge& edge : edges)
        if (edge.weight != kContactWeight) add(edge);
    // Fewer than three directions determine no rotation.
    constexpr std::size_t kFewest = 3;
    std::vector<bool> few(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) few[i] = around[i].size() < kFewest;
    for (const Edge& edge : edges)
        if (edge.weight == kContactWeight && few[edge.a] && few[edge.b]) add(edge);
    std::vector<glm::dquat> turned(from.size(), glm::dquat(1, 0, 0, 0));
    Places fixed, moving;
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (around[i].empty()) continue;
        fixed = {to[i]}, moving = {from[i]};
        for (const std::uint32_t k : around[i]) fixed.push_back(to[k]), moving.push_back(from[k]);
        turned[i] = glm::normalize(glm::quat_cast(superpose(fixed, moving).rotation));
    }
    return turned;
}

/// From one key to the next.
class Step {
public:
    Step(const std::vector<bool>& counts, std::vector<Edge> bonded, Places from, Places to)
        : from_(std::move(from)), to_(std::move(to)), edges_(std::move(bonded)) {
        addContacts(counts, from_, to_, edges_);
        turns_ = turns(from_, to_, edges_);
        diagonal_.assign(from_.size(), 0);
        for (const Edge& edge : edges_) diagonal_[edge.a] += edge.weight, diagonal_[edge.b] += edge.weight;
    }

    /// @param share  0 to 1
    Places at(double share) const {
        if (share <= 0) return from_;
        if (share >= 1) return to_;
        std::vector<glm::dquat> turned(turns_.size());
        for (std::size_t i = 0; i < turned.size(); ++i)
            turned[i] = glm::slerp(glm::dquat(1, 0, 0, 0), turns_[i], share);
        Places wanted(from_.size(), glm::dvec3(0)), start(from_.size());
        for (const Edge& edge : edges_) {
            const glm::dvec3 before = from_[edge.a] - from_[edge.b], after = to_[edge.a] - to_[edge.b];
            const auto seenBy = [&](std::uint32_t atom) {
                return turned[atom] * glm::mix(before, glm::inverse(turns_[atom]) * after, share);
            };
            const glm::dvec3 difference = edge.weight / 2 * (seenBy(edge.a) + seenBy(edge.b));
            wanted[edge.a] += difference;
            wanted[edge.b] -= difference;
        }
        for (std::size_t i = 0; i < start.size(); ++i) start[i] = glm::mix(from_[i], to_[i], share);
        Places placed = solved(std::move(start), wanted);
        keepLengths(placed, share);
        return placed;
    }

private:
    /// Interpolates lengths of bonds and angles between the keys, one after the other: where a side chain turns against
    /// its neighbour, least squares shorten the bonds between them.
    void keepLengths(Places& x, double share) const {
        constexpr int kRounds = 50;
        for (int round = 0; round < kRounds; ++round)
            for (const Edge& edge : edges_) {
                if (edge.weight == kContactWeight) continue;
                const double wanted = glm::mix(glm::distance(from_[edge.a], from_[edge.b]),
                                               glm::distance(to_[edge.a], to_[edge.b]), share);
                const glm::dvec3 way = x[edge.a] - x[edge.b];
                const double length = glm::length(way);
                if (length < 1e-6) continue;
                const glm::dvec3 half = edge.weight * (length - wanted) / (2 * length) * way;
                x[edge.a] -= half;
                x[edge.b] += half;
            }
    }

    /// The product with the matrix of the least-squares problem, a graph Laplacian.
    void multiply(const Places& x, Places& product) const {
        for (std::size_t i = 0; i < x.size(); ++i) product[i] = diagonal_[i] * x[i];
        for (const Edge& edge : edges_) {
            product[edge.a] -= edge.weight * x[edge.b];
            product[edge.b] -= edge.weight * x[edge.a];
        }
    }

    /// Solves by conjugate gradients with a diagonal preconditioner. The mean of each connected part stays fixed.
    Places solved(Places x, const Places& wanted) const {
        constexpr int kMostRounds = 2000;
        constexpr double kClose = 1e-8;  // of the first residual's square
        const std::size_t count = x.size();
        Places residual(count), way(count), product(count);
        const auto scaled = [&](std::size_t i) {
            return diagonal_[i] > 0 ? residual[i] / diagonal_[i] : glm::dvec3(0);
        };
        multiply(x, product);
        double size = 0;
        for (std::size_t i = 0; i < count; ++i) {
            residual[i] = diagonal_[i] > 0 ? wanted[i] - product[i] : glm::dvec3(0);
            way[i] = scaled(i);
            size += glm::dot(residual[i], way[i]);
        }
        const double enough = kClose * size;
        for (int round = 0; round < kMostRounds && size > enough && size > 0; ++round) {
            multiply(way, product);
            double curve = 0;
            for (std::size_t i = 0; i < count; ++i) curve += glm::dot(way[i], product[i]);
            const double length = size / curve;
            double next = 0;
            for (std::size_t i = 0; i < count; ++i) {
                x[i] += length * way[i];
                residual[i] -= length * product[i];
                next += glm::dot(residual[i], scaled(i));
            }
            for (std::size_t i = 0; i < count; ++i) way[i] = scaled(i) + next / size * way[i];
            size = next;
        }
        return x;
    }

    Places from_, to_;
    std::vector<Edge> edges_;
    std::vector<glm::dquat> turns_;
    std::vector<double> diagonal_;
};

class Morph : public Trajectory {
public:
    Morph(const Molecule& molecule, std::vector<std::vector<glm::vec3>> keys, std::vector<double> places)
        : bonded_(bondedEdges(molecule)), keys_(std::move(keys)), places_(std::move(places)) {
        for (const Atom& atom : molecule.atoms) counts_.push_back(atom.element != kHydrogen);
        name_ = "morph";
        format_ = "morph";
        atoms_ = keys_.front().size();
        frames_ = places_.size();
    }

private:
    void readFrame(std::size_t frame, TrajectoryFrame& result) override {
        const double place = std::clamp(places_[frame], 0.0, static_cast<double>(keys_.size() - 1));
        const auto key = std::min(static_cast<std::size_t>(place), keys_.size() - 2);
        if (!step_ || key != stepOf_)
            step_ = std::make_unique<Step>(counts_, bonded_, toPlaces(keys_[key]), toPlaces(keys_[key + 1]));
        stepOf_ = key;
        const Places placed = step_->at(place - static_cast<double>(key));
        std::ranges::copy(placed, result.positions.begin());
    }

    std::vector<bool> counts_;  // for contacts
    std::vector<Edge> bonded_;
    std::vector<std::vector<glm::vec3>> keys_;
    std::vector<double> places_;
    std::unique_ptr<Step> step_;
    std::size_t stepOf_ = 0;
};

}  // namespace

std::unique_ptr<Trajectory> morphThrough(const Molecule& molecule, std::vector<std::vector<glm::vec3>> keys,
                                         std::vector<double> places) {
    const auto refuse = [](std::size_t count, const char* what, std::size_t most) {
        if (count > most)
            throw Error("cannot morph", "", std::to_string(count) + what + ", at most " + std::to_string(most));
    };
    refuse(molecule.atoms.size(), " atoms", kMostMorphAtoms);
    refuse(keys.size() * molecule.atoms.size(), " atoms in all conformations", kMostMorphPositions);
    return std::make_unique<Morph>(molecule, std::move(keys), std::move(places));
}

std::unique_ptr<Trajectory> morphOfModels(const std::shared_ptr<const Molecule>& molecule, int model,
                                          std::vector<double> places, bool back, const std::string& name) {
    const std::string cannot = "cannot morph", &missing = molecule->othersMissing;
    if (std::max(molecule->file.models.value_or(1), molecule->file.records.value_or(1)) == 1)
        throw Error(cannot, name, "it has one model: name another INPUT");
    const auto models = trajectoryOfModels(molecule, model, true);
    if (!models) throw Error(cannot, name, missing.empty() ? differenceOfModels(*molecule) : missing);
    if (models->frames() > kMostMorphPositions / molecule->atoms.size())
        throw Error(cannot, name,
                    "its models have more than " + std::to_string(kMostMorphPositions) + " atoms together");
    std::vector<std::vector<glm::vec3>> keys;
    for (std::size_t i = 0; i < models->frames(); ++i) keys.push_back(models->read(i).positions);
    if (back) keys.push_back(keys.front());
    return morphThrough(*molecule, std::move(keys), std::move(places));
}

}  // namespace nacre
