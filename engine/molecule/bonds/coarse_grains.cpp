#include "engine/molecule/bonds/coarse_grains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string_view>

#include "engine/molecule/bonds/bond_steps.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/molecule/formats/lammps_types.h"
#include "engine/molecule/residue_kind.h"

namespace nacre {
namespace {

// Half of the distance at which Martini's beads repel each other: 0.47, 0.43 and 0.34 nm.
constexpr float kRegularBead = 2.35f, kSmallBead = 2.15f, kTinyBead = 1.7f;
constexpr float kLongestBackboneBond = 5, kLongestChainBond = 6, kLongestRingBond = 3.6f;  // Å
constexpr float kLongestPhosphateBond = 8.5f;                                              // Å
constexpr std::uint32_t kLargestGrainResidue = 64, kMostBeads = 8;  // of a residue; of an amino acid
constexpr std::size_t kFewResidues = 3;

bool isOneOfNames(const Name& name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name.view()) != names.end();
}

/// Number in a name such as "SC1"; 0: not such a name.
int numberAfter(std::string_view name, std::string_view start) {
    const bool fits = name.size() == start.size() + 1 && name.substr(0, start.size()) == start;
    return fits && name.back() >= '1' && name.back() <= '9' ? name.back() - '0' : 0;
}

/// "C3A" and "D2B" are the third and second bead of a lipid's tails A and B. '\0': no tail.
struct TailBead {
    int number = 0;
    char tail = '\0';
};
TailBead parseTail(std::string_view name) {
    const bool fits = name.size() == 3 && (name[0] == 'C' || name[0] == 'D' || name[0] == 'T') && name[1] >= '1' &&
                      name[1] <= '9' && name[2] >= 'A' && name[2] <= 'D';
    return fits ? TailBead{name[1] - '0', name[2]} : TailBead{};
}

enum class GrainKind : std::uint8_t { none, protein, lipid, sterol, water, single };

/// Beads of formats without residues, or of unknown residues, that readers take for boron, scandium and tungsten ("B",
/// "SC1", "W"), or for nothing ("BB"). Atoms of these elements have neighbours; beads have none at bonding distance.
class LoneBeads {
public:
    explicit LoneBeads(const Molecule& molecule) : molecule_(molecule), lone_(molecule.atoms.size()) {
        const std::string& format = molecule.file.format;
        const bool crystal = format == "cif-core" || format == "poscar" || format == "xsf" || format == "cml" ||
                             (format == "xyz" && molecule.file.box);
        std::vector<std::uint32_t> beads;
        for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i)
            if (isCandidate(molecule.atoms[i])) beads.push_back(i);
        if (crystal || molecule.lacksPositions || !molecule.masses.empty() || beads.size() <= kFewResidues) return;
        for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i)
            cubes_[findCube(molecule.atoms[i].position)].push_back(i);
        if (std::any_of(beads.begin(), beads.end(), [&](std::uint32_t bead) { return hasNeighbour(bead); })) return;
        for (const std::uint32_t bead : beads) lone_[bead] = true;
    }
    bool operator[](std::uint32_t atom) const { return lone_[atom]; }

private:
    using Cube = std::array<long, 3>;
    static constexpr double kCube = 4.5;  // Å, longer than any bond with tolerance
    static constexpr std::size_t kMostPerCube = 64;

    static bool isCandidate(const Atom& atom) {
        constexpr Element kBoron = 5, kScandium = 21, kTungsten = 74;
        const std::string_view name = atom.name.view();
        const bool bead = (atom.element == kBoron && name == "B") || (atom.element == kTungsten && name == "W") ||
                          (atom.element == kScandium && name == "Sc") || (atom.element == 0 && name == "BB");
        return bead && atom.radius == 0;
    }
    static Cube findCube(const glm::vec3& p) {
        const auto along = [](float x) { return static_cast<long>(std::floor(static_cast<double>(x) / kCube)); };
        return {along(p.x), along(p.y), along(p.z)};
    }
    /// Also true in a crowd.
    bool hasNeighbour(std::uint32_t atom) const {
        const Cube at = findCube(molecule_.atoms[atom].position);
        for (int i = 0; i < 27; ++i) {
            const auto cube = cubes_.find({at[0] + i % 3 - 1, at[1] + i / 3 % 3 - 1, at[2] + i / 9 - 1});
            if (cube == cubes_.end()) continue;
            if (cube->second.size() > kMostPerCube) return true;
            for (const std::uint32_t other : cube->second) {
                const Atom &a = molecule_.atoms[atom], &b = molecule_.atoms[other];
                const float longest = covalentRadius(a.element) + covalentRadius(b.element) + kBondTolerance;
                if (other != atom && glm::distance(a.position, b.position) < longest) return true;
            }
        }
        return false;
    }

    const Molecule& molecule_;
    std::vector<bool> lone_;
    std::map<Cube, std::vector<std::uint32_t>> cubes_;
};

class GrainFinder {
public:
    explicit GrainFinder(Molecule& molecule) : molecule_(molecule) {}

    void run() {
        std::vector<GrainKind> kinds;
        std::size_t singles = 0, grains = 0;
        for (const Residue& residue : molecule_.residues) {
            kinds.push_back(findKind(residue));
            grains += kinds.back() != GrainKind::none && kinds.back() != GrainKind::water;
            singles += isSingle(residue);
        }
        std::size_t aminoAcids = 0;
        for (std::size_t i = 0; i < molecule_.residues.size() && singles > kFewResidues; ++i)
            aminoAcids += aminoAcidLetter(molecule_.residues[i].name) != '\0';
        const bool manyWaters = hasManyWaters();
        const LoneBeads lone(molecule_);
        const bool onePerResidue = singles > kFewResidues && singles * 10 >= aminoAcids * 9;
        std::int64_t count = 0;
        for (std::size_t r = 0; r < kinds.size(); ++r) {
            Residue& residue = molecule_.residues[r];
            if (kinds[r] == GrainKind::none && onePerResidue && isSingle(residue)) kinds[r] = GrainKind::single;
            // A lone atom W may be tungsten, unless there are other grains or many of them.
            if (kinds[r] == GrainKind::water && grains == 0 && !manyWaters && !lone[residue.firstAtom])
                kinds[r] = GrainKind::none;
            if (kinds[r] == GrainKind::none) continue;
            if (kinds[r] == GrainKind::water) residue.entityKind = EntityKind::water;
            for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
                Atom& atom = molecule_.atoms[i];
                atom.element = 0;
                atom.radius = grainRadius(residue, kinds[r], atom.name);
                ++count;
            }
            if (!molecule_.lacksPositions && molecule_.file.bonds.value_or(0) == 0) bond(r, kinds);
        }
        count += makeBeads(lone);
        joinGuides();
        addNote(molecule_.notes, ReadAction::guessed, "coarse grains", "from the names of atoms and residues", count);
    }

private:
    /// Turns atoms into beads. @returns their number
    std::int64_t makeBeads(const LoneBeads& lone) {
        std::vector<std::uint32_t> beads;
        for (std::uint32_t i = 0; i < molecule_.atoms.size(); ++i) {
            Atom& atom = molecule_.atoms[i];
            if (!lone[i] || atom.radius > 0) continue;
            atom.element = 0;
            beads.push_back(i);
        }
        if (!beads.empty()) makeGrains(molecule_);
        return static_cast<std::int64_t>(beads.size());
    }

    /// Joins chains of only alpha carbons, or only phosphorus.
    void joinGuides() {
        if (molecule_.lacksPositions || molecule_.file.bonds.value_or(0) > 0) return;
        const auto findGuide = [&](const Residue& residue) -> std::string_view {
            if (residue.atomCount != 1) return {};
            const std::string_view name = molecule_.atoms[residue.firstAtom].name.view();
            if (name == "CA" && aminoAcidLetter(residue.name) != '\0') return name;
            return name == "P" && nucleotideLetter(residue.name) != '\0' ? name : std::string_view();
        };
        std::string_view before;
        for (std::size_t r = 0; r < molecule_.residues.size(); ++r) {
            const Residue& residue = molecule_.residues[r];
            const std::string_view guide = findGuide(residue);
            if (!guide.empty() && guide == before && molecule_.residues[r - 1].chain == residue.chain)
                join(molecule_.residues[r - 1].firstAtom, residue.firstAtom,
                     guide == "CA" ? kLongestBackboneBond : kLongestPhosphateBond);
            before = guide;
        }
    }

    std::optional<std::uint32_t> find(const Residue& residue, std::string_view name) const {
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i)
            if (molecule_.atoms[i].name.view() == name) return i;
        return std::nullopt;
    }

    GrainKind findKind(const Residue& residue) const {
        if (residue.atomCount == 0 || residue.atomCount > kLargestGrainResidue) return GrainKind::none;
        const Name& first = molecule_.atoms[residue.firstAtom].name;
        if (isOneOfNames(residue.name, {"W", "WF", "PW", "WN", "SW", "TW"}) &&
            isOneOfNames(first, {"W", "WF", "SW", "TW"}))
            return GrainKind::water;
        if (residue.atomCount <= kMostBeads && find(residue, "BB") && !find(residue, "CA")) return GrainKind::protein;
        if (find(residue, "GL1") || find(residue, "AM1") || (find(residue, "PO4") && find(residue, "C1A")))
            return GrainKind::lipid;
        if (find(residue, "ROH") && find(residue, "R1") && find(residue, "R2")) return GrainKind::sterol;
        return GrainKind::none;
    }

    /// Whether the residue is an amino acid's single bead: an atom that is neither an alpha carbon nor named as any
    /// atom could be, unless the name is the amino acid's letter.
    bool isSingle(const Residue& residue) const {
        if (residue.atomCount != 1) return false;
        const Name& name = molecule_.atoms[residue.firstAtom].name;
        const char letter = aminoAcidLetter(residue.name);
        const bool lettered = name.view() == std::string_view(&letter, 1);
        return letter != '\0' && (lettered || !isOneOfNames(name, {"CA", "N", "C", "O", "P"}));
    }

    bool hasManyWaters() const {
        std::size_t waters = 0;
        for (const Residue& residue : molecule_.residues) waters += residue.name.view() == "W";
        return waters > 20;
    }

    /// Rings have small beads. A single grain has about the volume of its amino acid.
    static float grainRadius(const Residue& residue, GrainKind kind, const Name& atom) {
        if (kind == GrainKind::single) return residue.name.view() == "GLY" ? 2.4f : 3.0f;
        const bool ring = isOneOfNames(residue.name, {"HIS", "HSD", "HSE", "HID", "HIE", "PHE", "TYR", "TRP"});
        if (kind == GrainKind::protein && ring && numberAfter(atom.view(), "SC") > 0) return kSmallBead;
        if (kind == GrainKind::sterol) return kSmallBead;
        return residue.name.view() == "TW" ? kTinyBead : kRegularBead;
    }

    void join(std::uint32_t a, std::uint32_t b, float longest) {
        const float length = glm::distance(molecule_.atoms[a].position, molecule_.atoms[b].position);
        if (a != b && length > 0 && length < longest)
            molecule_.bonds.push_back({std::min(a, b), std::max(a, b), 1, BondSource::residueTemplate});
    }
    void join(const Residue& residue, std::string_view a, std::string_view b) {
        const auto first = find(residue, a), second = find(residue, b);
        if (first && second) join(*first, *second, kLongestChainBond);
    }

    void bond(std::size_t r, const std::vector<GrainKind>& kinds) {
        const Residue& residue = molecule_.residues[r];
        const bool follows = r > 0 && kinds[r - 1] == kinds[r] && molecule_.residues[r - 1].chain == residue.chain;
        switch (kinds[r]) {
            case GrainKind::protein:
                if (const auto before = follows ? find(molecule_.residues[r - 1], "BB") : std::nullopt)
                    join(*before, *find(residue, "BB"), kLongestBackboneBond);
                join(residue, "BB", "SC1");
                bondBeads(residue, "SC");
                break;
            case GrainKind::single:
                if (follows) join(molecule_.residues[r - 1].firstAtom, residue.firstAtom, kLongestBackboneBond);
                break;
            case GrainKind::sterol:
                for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i)
                    for (std::uint32_t k = i + 1; k < residue.firstAtom + residue.atomCount; ++k)
                        join(i, k, kLongestRingBond);
                join(residue, "R5", "C1");
                join(residue, "C1", "C2");
                break;
            case GrainKind::lipid:
                bondLipid(residue);
                break;
            case GrainKind::none:
            case GrainKind::water:
                break;
        }
    }

    /// Bonds SC1, SC2, ... each with the next, and within rings with others as well.
    void bondBeads(const Residue& residue, std::string_view start) {
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i)
            for (std::uint32_t k = i + 1; k < residue.firstAtom + residue.atomCount; ++k) {
                const int a = numberAfter(molecule_.atoms[i].name.view(), start),
                          b = numberAfter(molecule_.atoms[k].name.view(), start);
                if (a > 0 && b > 0) join(i, k, std::abs(a - b) == 1 ? kLongestBackboneBond : kLongestRingBond);
            }
    }

    void bondLipid(const Residue& residue) {
        for (const char* head : {"NC3", "NH3", "CNO", "GL0", "C3", "P1"}) join(residue, head, "PO4");
        for (const auto& [first, second] : {std::pair("GL1", "GL2"), std::pair("AM1", "AM2")}) {
            join(residue, "PO4", first);
            join(residue, first, second);
        }
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
            const TailBead bead = parseTail(molecule_.atoms[i].name.view());
            if (bead.number == 0) continue;
            if (bead.number == 1) {
                const bool isFirst = bead.tail == 'A';
                for (const std::string_view link : {isFirst ? "GL1" : "GL2", isFirst ? "AM1" : "AM2"})
                    if (const auto other = find(residue, link)) join(*other, i, kLongestChainBond);
            }
            for (std::uint32_t k = residue.firstAtom; k < residue.firstAtom + residue.atomCount; ++k) {
                const TailBead next = parseTail(molecule_.atoms[k].name.view());
                if (next.tail == bead.tail && next.number == bead.number + 1) join(i, k, kLongestChainBond);
            }
        }
    }

    Molecule& molecule_;
};

}  // namespace

void findCoarseGrains(Molecule& molecule) { GrainFinder(molecule).run(); }

}  // namespace nacre
