#include "engine/molecule/chemistry/hydrogens.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

constexpr double kTetrahedral = 1.9106332362490186;  // 109.47 degrees
constexpr double kSine60 = 0.8660254037844386;

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 1e-6 ? v / length : otherwise;
}

glm::dvec3 anyAcross(const glm::dvec3& along) {
    const glm::dvec3 axis = std::abs(along.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(along, axis));
}

/// Unit vectors towards an atom's further neighbours.
class Directions {
public:
    Directions(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t atom, bool asOpenBabel)
        : molecule_(molecule), chemistry_(chemistry), atom_(atom), asOpenBabel_(asOpenBabel) {
        for (const Neighbour& n : chemistry.of(atom)) taken_.push_back(unitOr(at(n.atom) - at(atom), {0, 0, 1}));
    }

    std::vector<glm::dvec3> free(std::size_t count) {
        const std::uint8_t hybrid = chemistry_.hybrid[atom_];
        std::vector<glm::dvec3> found;
        while (found.size() < count) {
            const glm::dvec3 next = hybrid == 1 ? linear() : hybrid == 2 ? planar() : tetrahedral();
            found.push_back(next);
            taken_.push_back(next);
        }
        return found;
    }

private:
    glm::dvec3 at(std::uint32_t atom) const { return molecule_.atoms[atom].position; }

    /// Perpendicular to the bond of the only neighbour, away from the decisive neighbour of that one.
    glm::dvec3 away() const {
        const std::uint32_t other = chemistry_.of(atom_).front().atom;
        const glm::dvec3 along = taken_.front();
        const Neighbour* best = nullptr;
        for (const Neighbour& n : chemistry_.of(other)) {
            if (n.atom == atom_ || isHydrogen(molecule_.atoms[n.atom].element)) continue;
            if (asOpenBabel_ && otherAcidOxygen(other, n)) {
                best = &n;
                break;
            }
            if (!best || (asOpenBabel_ && comesLater(molecule_, n, *best))) best = &n;
        }
        if (!best) return anyAcross(along);
        const glm::dvec3 side = at(best->atom) - at(other);
        return unitOr(glm::dot(side, along) * along - side, anyAcross(along));
    }

    /// Whether `n` is the acid's doubly bonded oxygen; this atom is its hydroxyl.
    bool otherAcidOxygen(std::uint32_t carbon, const Neighbour& n) const {
        const auto end = [&](std::uint32_t atom) {
            std::size_t heavy = 0;
            for (const Neighbour& m : chemistry_.of(atom)) heavy += !isHydrogen(molecule_.atoms[m.atom].element);
            return molecule_.atoms[atom].element == kOxygen && heavy == 1;
        };
        return molecule_.atoms[carbon].element == kCarbon && end(atom_) && end(n.atom);
    }

    glm::dvec3 linear() const { return taken_.empty() ? glm::dvec3(0, 0, 1) : -taken_.front(); }

    glm::dvec3 planar() const {
        if (taken_.empty()) return {0, 0, 1};
        if (taken_.size() == 1) return taken_[0] * -0.5 + away() * kSine60;
        glm::dvec3 sum(0);
        for (const glm::dvec3& v : taken_) sum += v;
        return unitOr(-sum, anyAcross(taken_[0]));
    }

    glm::dvec3 tetrahedral() const {
        if (taken_.empty()) return {0, 0, 1};
        const glm::dvec3& u = taken_[0];
        if (taken_.size() == 1) {
            const glm::dvec3 side = chemistry_.of(atom_).empty() ? anyAcross(u) : away();
            return u * std::cos(kTetrahedral) + side * std::sin(kTetrahedral);
        }
        if (taken_.size() == 2) {
            const glm::dvec3 back = unitOr(-(u + taken_[1]), anyAcross(u));
            const glm::dvec3 up = unitOr(glm::cross(u, taken_[1]), anyAcross(u));
            return back * std::cos(kTetrahedral / 2) + up * std::sin(kTetrahedral / 2);
        }
        glm::dvec3 sum(0);
        for (const glm::dvec3& v : taken_) sum += v;
        return unitOr(-sum, anyAcross(u));
    }

    const Molecule& molecule_;
    const Chemistry& chemistry_;
    std::uint32_t atom_;
    bool asOpenBabel_;
    std::vector<glm::dvec3> taken_;
};

float hydrogenLength(Element element, bool flat, const HydrogenPlacing& placing) {
    switch (element) {
        case kNitrogen:
            return flat ? placing.flatNitrogen : placing.nitrogen;
        case kOxygen:
            return flat ? placing.flatOxygen : placing.oxygen;
        case kSulphur:
            return placing.sulphur;
        default:
            return placing.carbon;
    }
}

}  // namespace

bool comesLater(const Molecule& molecule, const Neighbour& l, const Neighbour& r) {
    const bool lStated = molecule.bonds[l.bond].source == BondSource::file;
    const bool rStated = molecule.bonds[r.bond].source == BondSource::file;
    if (lStated != rStated) return rStated;
    if (lStated) return l.atom > r.atom;
    return molecule.atoms[l.atom].position.z > molecule.atoms[r.atom].position.z;
}

std::vector<glm::vec3> hydrogenPositions(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t atom,
                                         std::size_t count, const HydrogenPlacing& placing) {
    const glm::dvec3 centre = molecule.atoms[atom].position;
    const double length = hydrogenLength(molecule.atoms[atom].element, chemistry.hybrid[atom] == 2, placing);
    std::vector<glm::vec3> positions;
    for (const glm::dvec3& direction : Directions(molecule, chemistry, atom, placing.asOpenBabel).free(count))
        positions.push_back(centre + length * direction);
    return positions;
}

namespace {

/// Hydrogens of standard residues as the PDB's third version names them: HA, HB2 and HB3 of two, HB1 to HB3 of three,
/// HD21 and HD22, H5' and H5'', HO2'.
std::string standardName(std::string_view parent, Element element, std::size_t index, std::size_t count) {
    const bool prime = !parent.empty() && parent.back() == '\'';
    if (prime && element == kOxygen) return "H" + std::string(parent);
    std::string text = "H" + std::string(parent.substr(std::min<std::size_t>(parent.size(), 1)));
    if (prime && count == 2) return index == 0 ? text : text + "'";
    if (count == 1) return text;
    const bool pair = count == 2 && element == kCarbon;
    return text + std::to_string(index + (pair ? 2 : 1));
}

/// Names of the hydrogens added to one residue. Non-standard residues number them: H1, H2, ...
class HydrogenNames {
public:
    HydrogenNames(const Molecule& molecule, const Residue& residue)
        : molecule_(molecule), residue_(residue), standard_(residueTemplate(residue.name) != nullptr) {}

    Name next(const Atom& parent, std::size_t index, std::size_t count) {
        if (standard_) return Name(standardName(currentAtomName(parent.name).view(), parent.element, index, count));
        Name name;
        do name = Name("H" + std::to_string(++number_));
        while (taken(name));
        return name;
    }

private:
    bool taken(const Name& name) const {
        if (residue_.atomCount > kLargestNamed) return false;
        for (std::uint32_t i = residue_.firstAtom; i < residue_.firstAtom + residue_.atomCount; ++i)
            if (molecule_.atoms[i].name == name) return true;
        return false;
    }

    static constexpr std::uint32_t kLargestNamed = 1000;  // beyond it names repeat anyway
    const Molecule& molecule_;
    const Residue residue_;
    bool standard_;
    std::size_t number_ = 0;
};

}  // namespace

Molecule withHydrogens(const Molecule& molecule, const Chemistry& chemistry) {
    Molecule result = molecule;
    result.atoms.clear();
    result.bonds.clear();
    result.partialCharges.clear();
    result.radii.clear();
    result.masses.clear();
    result.displacements.clear();
    result.types.clear();
    std::vector<std::uint32_t> moved(molecule.atoms.size());
    for (Residue& residue : result.residues) {
        HydrogenNames names(molecule, residue);
        const std::uint32_t begin = residue.firstAtom, end = begin + residue.atomCount;
        residue.firstAtom = static_cast<std::uint32_t>(result.atoms.size());
        for (std::uint32_t i = begin; i < end; ++i) {
            moved[i] = static_cast<std::uint32_t>(result.atoms.size());
            result.atoms.push_back(molecule.atoms[i]);
        }
        for (std::uint32_t i = begin; i < end; ++i) {
            if (!chemistry.present[i] || chemistry.hybrid[i] == 0) continue;
            std::size_t there = 0;
            for (const Neighbour& n : chemistry.of(i)) there += isHydrogen(molecule.atoms[n.atom].element);
            if (chemistry.hydrogens[i] <= there) continue;
            const std::size_t missing = chemistry.hydrogens[i] - there;
            const std::vector<glm::vec3> positions = hydrogenPositions(molecule, chemistry, i, missing);
            for (std::size_t h = 0; h < missing; ++h) {
                Atom atom = molecule.atoms[i];
                atom.position = positions[h];
                atom.element = kHydrogenAtom;
                atom.charge = 0;
                atom.name = names.next(molecule.atoms[i], h, missing);
                const auto index = static_cast<std::uint32_t>(result.atoms.size());
                result.bonds.push_back({moved[i], index, 1, BondSource::residueTemplate});
                result.atoms.push_back(atom);
            }
        }
        residue.atomCount = static_cast<std::uint32_t>(result.atoms.size()) - residue.firstAtom;
    }
    if (!molecule.displacements.empty()) {
        result.displacements.resize(result.atoms.size());
        for (std::size_t i = 0; i < moved.size(); ++i) result.displacements[moved[i]] = molecule.displacements[i];
    }
    for (const Bond& bond : molecule.bonds)
        result.bonds.push_back({moved[bond.a], moved[bond.b], bond.order, bond.source});
    for (Bond& bond : result.bonds)
        if (bond.a > bond.b) std::swap(bond.a, bond.b);
    std::sort(result.bonds.begin(), result.bonds.end(),
              [](const Bond& l, const Bond& r) { return l.a != r.a ? l.a < r.a : l.b < r.b; });
    return result;
}

Molecule withMissingHydrogens(const Molecule& molecule) {
    const std::vector<std::uint32_t> drawn = drawnAtoms(molecule, {.water = true, .hydrogens = true});
    Molecule result = withHydrogens(molecule, perceiveChemistry(molecule, drawn));
    if (!result.others.empty()) result.othersMissing = "hydrogens were added";
    result.others.clear();
    return result;
}

}  // namespace nacre
