// Bonds by distance: a sweep over a sorted grid, linear in the number of atoms whatever their geometry.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <utility>

#include "engine/molecule/bonds/bond_steps.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

enum Flag : std::uint8_t { kHydrogen = 1, kWater = 2, kMetal = 4, kTemplated = 8, kSettled = 16 };

/// Data of an atom for the inner loop, in grid order.
struct Site {
    glm::vec3 position;
    float radius;
    std::uint32_t atom;
    std::uint32_t group;
    char alternate;
    std::uint8_t flags;
};

struct Cell {
    std::uint64_t key;
    std::uint32_t begin;
    std::uint32_t end;
};

// The densest matter (diamond) has 0.18 atoms per Å^3; the limit allows eight superposed conformers.
constexpr double kDensestMatter = 1.5;
constexpr double kFewestTooMany = 24;
constexpr std::uint8_t kMostBondsPerAtom = 16;

// Cell coordinates take 21 bits each; the outermost values stay free, so that neighbours never wrap.
constexpr int kAxisBits = 21;
constexpr double kLargestCoordinate = (1 << kAxisBits) - 2;

std::uint64_t makeKey(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    return (x << (2 * kAxisBits)) | (y << kAxisBits) | z;
}

bool isHalogen(Element e) { return e == 9 || e == 17 || e == 35 || e == 53 || e == 85; }
bool isNobleGas(Element e) { return e == 2 || e == 10 || e == 18; }

/// Atoms that are never bonded by distance: coarse grains, noble gases, isolated ions (coordination is not a bond),
/// isolated water oxygens, and hydrogens that already have a bond.
bool neverBonds(const BondWork& work, std::uint32_t i, bool hasBond, bool water) {
    const Atom& atom = work.molecule.atoms[i];
    const bool alone = work.groups[work.atomGroup[i]].atomCount == 1;
    if (alone && (water || isMetal(atom.element) || isHalogen(atom.element))) return true;
    if (atom.radius > 0 || isNobleGas(atom.element) || (hasBond && isHydrogen(atom.element))) return true;
    const glm::vec3 p = atom.position;
    return !(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

std::vector<Site> collectSites(const BondWork& work) {
    const Molecule& molecule = work.molecule;
    std::vector<std::uint8_t> hasBond(molecule.atoms.size());
    for (const Bond& bond : molecule.bonds) hasBond[bond.a] = hasBond[bond.b] = 1;
    std::vector<Site> sites;
    sites.reserve(molecule.atoms.size());
    for (const Residue& residue : molecule.residues) {
        const bool water = isWater(residue.name);
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
            if (neverBonds(work, i, hasBond[i], water)) continue;
            const Atom& atom = molecule.atoms[i];
            int flags = water ? kWater : 0;
            if (isHydrogen(atom.element)) flags |= kHydrogen;
            if (isMetal(atom.element)) flags |= kMetal;
            if (work.templated[i]) flags |= kTemplated;
            if (work.settled[i]) flags |= kSettled;
            sites.push_back({atom.position, covalentRadius(atom.element), i, work.atomGroup[i], atom.alternate,
                             static_cast<std::uint8_t>(flags)});
        }
    }
    return sites;
}

/// Sorts the sites by cell and lists the cells that hold any.
std::vector<Cell> sortIntoCells(std::vector<Site>& sites, double cellSize) {
    glm::vec3 low(std::numeric_limits<float>::max());
    for (const Site& site : sites) low = glm::min(low, site.position);
    const auto coordinate = [&](float value, float origin) {
        const double cell = (static_cast<double>(value) - static_cast<double>(origin)) / cellSize + 1;
        return static_cast<std::uint64_t>(std::min(cell, kLargestCoordinate));
    };
    struct Entry {
        std::uint64_t key;
        std::uint32_t site;
    };
    std::vector<Entry> entries;
    entries.reserve(sites.size());
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        const glm::vec3 p = sites[i].position;
        entries.push_back({makeKey(coordinate(p.x, low.x), coordinate(p.y, low.y), coordinate(p.z, low.z)), i});
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& l, const Entry& r) { return l.key != r.key ? l.key < r.key : l.site < r.site; });
    std::vector<Site> sorted;
    sorted.reserve(sites.size());
    std::vector<Cell> cells;
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
        if (cells.empty() || cells.back().key != entries[i].key) cells.push_back({entries[i].key, i, i});
        cells.back().end = i + 1;
        sorted.push_back(sites[entries[i].site]);
    }
    sites = std::move(sorted);
    return cells;
}

/// Collects the pairs that the rules admit.
class PairCollector {
public:
    explicit PairCollector(const BondWork& work) : bondCount_(work.molecule.atoms.size()) {
        const std::vector<Bond>& bonds = work.molecule.bonds;
        end_.resize(work.molecule.atoms.size() + 1);
        neighbours_.resize(2 * bonds.size());
        for (const Bond& bond : bonds) {
            ++end_[bond.a + 1];
            ++end_[bond.b + 1];
            // Atoms with this many bonds get no more, which keeps their lists short.
            for (const std::uint32_t end : {bond.a, bond.b})
                if (bondCount_[end] < kMostBondsPerAtom) ++bondCount_[end];
        }
        for (std::size_t i = 1; i < end_.size(); ++i) end_[i] += end_[i - 1];
        // While lists are filled, an atom's entry is the place of its next neighbour; afterwards it is the end of its
        // list.
        for (const Bond& bond : bonds) {
            neighbours_[end_[bond.a]++] = bond.b;
            neighbours_[end_[bond.b]++] = bond.a;
        }
    }

    void consider(const Site& a, const Site& b) {
        const glm::vec3 line = a.position - b.position;
        const float squared = glm::dot(line, line);
        const float longest = a.radius + b.radius + kBondTolerance;
        if (squared >= longest * longest) return;
        const bool light = ((a.flags | b.flags) & (kHydrogen | kMetal)) != 0;
        const float shortest = (light ? kShortestLightShare : kShortestShare) * (a.radius + b.radius);
        if (squared <= shortest * shortest) return;
        if (!admitted(a, b)) return;
        const bool full = bondCount_[a.atom] >= kMostBondsPerAtom || bondCount_[b.atom] >= kMostBondsPerAtom;
        if (full) {
            ++refused_;
            return;
        }
        if (bonded(a.atom, b.atom)) return;
        if (a.group != b.group && (a.flags & b.flags & kTemplated) && shareNeighbour(a.atom, b.atom)) return;
        ++bondCount_[a.atom];
        ++bondCount_[b.atom];
        const bool hydrogen = ((a.flags | b.flags) & kHydrogen) != 0;
        if (!hydrogen) {
            bonds_.push_back({std::min(a.atom, b.atom), std::max(a.atom, b.atom), 1, BondSource::distance});
        } else if (a.flags & kHydrogen) {
            hydrogens_.push_back({a.atom, b.atom, squared, b.alternate});
        } else {
            hydrogens_.push_back({b.atom, a.atom, squared, a.alternate});
        }
    }

    /// The bonds found. A hydrogen keeps its nearest neighbour, and farther ones only in conformers without it.
    std::vector<Bond> finish() {
        std::sort(hydrogens_.begin(), hydrogens_.end(), [](const HydrogenPair& l, const HydrogenPair& r) {
            if (l.hydrogen != r.hydrogen) return l.hydrogen < r.hydrogen;
            return l.squared != r.squared ? l.squared < r.squared : l.neighbour < r.neighbour;
        });
        for (std::size_t i = 0; i < hydrogens_.size(); ++i) {
            bool nearest = true;
            for (std::size_t j = i; nearest && j-- > 0 && hydrogens_[j].hydrogen == hydrogens_[i].hydrogen;)
                nearest = !coexist(hydrogens_[j].alternate, hydrogens_[i].alternate);
            if (!nearest) continue;
            const auto [low, high] = std::minmax(hydrogens_[i].hydrogen, hydrogens_[i].neighbour);
            bonds_.push_back({low, high, 1, BondSource::distance});
        }
        return std::move(bonds_);
    }

    std::size_t refused() const { return refused_; }

private:
    struct HydrogenPair {
        std::uint32_t hydrogen;
        std::uint32_t neighbour;
        float squared;
        char alternate;  // of the neighbour
    };

    static bool admitted(const Site& a, const Site& b) {
        if (a.flags & b.flags & kHydrogen) return false;
        if (!coexist(a.alternate, b.alternate)) return false;
        if (a.group == b.group) return (a.flags & b.flags & (kTemplated | kSettled)) == 0;
        return ((a.flags | b.flags) & (kWater | kMetal | kSettled)) == 0;
    }

    std::size_t begin(std::uint32_t atom) const { return atom == 0 ? 0 : end_[atom - 1]; }

    bool bonded(std::uint32_t a, std::uint32_t b) const {
        for (std::size_t i = begin(a); i < end_[a]; ++i)
            if (neighbours_[i] == b) return true;
        return false;
    }

    /// Across a distorted peptide bond such atoms come close; a three-membered ring across two residues is not real.
    bool shareNeighbour(std::uint32_t a, std::uint32_t b) const {
        for (std::size_t i = begin(a); i < end_[a]; ++i)
            if (bonded(neighbours_[i], b)) return true;
        return false;
    }

    std::vector<std::size_t> end_;  // by atom: end of its neighbours, where the next atom's begin
    std::vector<std::uint32_t> neighbours_;
    std::vector<std::uint8_t> bondCount_;
    std::vector<Bond> bonds_;
    std::vector<HydrogenPair> hydrogens_;
    std::size_t refused_ = 0;
};

/// Visits each pair of neighbouring cells once. The cells of a column of three are neighbours in the sorted list as
/// well, and starts of columns only move forward, so that one cursor per column replaces look-ups.
void sweep(const std::vector<Site>& sites, const std::vector<Cell>& cells, std::uint32_t mostAtomsPerCell,
           PairCollector& pairs) {
    constexpr std::array<std::array<int, 2>, 4> kColumns = {{{0, 1}, {1, -1}, {1, 0}, {1, 1}}};
    std::array<std::size_t, 4> cursors{};
    const auto crowded = [=](const Cell& cell) { return cell.end - cell.begin > mostAtomsPerCell; };
    const auto between = [&](const Cell& one, const Cell& other) {
        if (crowded(other)) return;
        for (std::uint32_t i = one.begin; i < one.end; ++i)
            for (std::uint32_t j = other.begin; j < other.end; ++j) pairs.consider(sites[i], sites[j]);
    };
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Cell& cell = cells[c];
        if (crowded(cell)) continue;
        for (std::uint32_t i = cell.begin; i < cell.end; ++i)
            for (std::uint32_t j = i + 1; j < cell.end; ++j) pairs.consider(sites[i], sites[j]);
        if (c + 1 < cells.size() && cells[c + 1].key == cell.key + 1) between(cell, cells[c + 1]);
        for (std::size_t k = 0; k < kColumns.size(); ++k) {
            const auto dx = static_cast<std::uint64_t>(kColumns[k][0]) << (2 * kAxisBits);
            const auto dy = static_cast<std::uint64_t>(kColumns[k][1]) << kAxisBits;  // -1 wraps as intended
            const std::uint64_t middle = cell.key + dx + dy;
            std::size_t& cursor = cursors[k];
            while (cursor < cells.size() && cells[cursor].key < middle - 1) ++cursor;
            for (std::size_t n = cursor; n < cells.size() && cells[n].key <= middle + 1; ++n) between(cell, cells[n]);
        }
    }
}

}  // namespace

void addDistanceBonds(BondWork& work) {
    std::vector<Site> sites = collectSites(work);
    if (sites.empty()) return;
    float largest = 0;
    for (const Site& site : sites) largest = std::max(largest, site.radius);
    const double cellSize = static_cast<double>(2 * largest + kBondTolerance);
    const std::vector<Cell> cells = sortIntoCells(sites, cellSize);
    const double most = std::max(kFewestTooMany, kDensestMatter * cellSize * cellSize * cellSize);
    const auto mostAtomsPerCell = static_cast<std::uint32_t>(most);

    PairCollector pairs(work);
    sweep(sites, cells, mostAtomsPerCell, pairs);
    std::vector<Bond>& bonds = work.molecule.bonds;
    const std::vector<Bond> found = pairs.finish();
    bonds.insert(bonds.end(), found.begin(), found.end());

    std::size_t crowded = 0;
    for (const Cell& cell : cells)
        if (cell.end - cell.begin > mostAtomsPerCell) crowded += cell.end - cell.begin;
    if (crowded > 0)
        work.molecule.warnings.push_back(
            std::to_string(crowded) + " atoms are closer than atoms can be; no bonds by distance are assigned there");
    if (pairs.refused() > 0)
        work.molecule.warnings.push_back("atoms with more than " + std::to_string(kMostBondsPerAtom) +
                                         " neighbours at bonding distance keep that many bonds");
}

}  // namespace nacre
