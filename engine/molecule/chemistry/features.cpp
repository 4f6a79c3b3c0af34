#include "engine/molecule/chemistry/features.h"

#include <algorithm>
#include <glm/common.hpp>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

bool anyOf(Element e, std::initializer_list<Element> list) { return std::ranges::find(list, e) != list.end(); }

/// A carbon that has only carbon and hydrogen neighbours.
bool hydrophobicCarbon(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t atom) {
    if (molecule.atoms[atom].element != kCarbon) return false;
    for (const Neighbour& n : chemistry.of(atom))
        if (!anyOf(molecule.atoms[n.atom].element, {kCarbon, kHydrogenAtom, 119})) return false;
    return true;
}

void addHalogenEnds(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t atom, Features& features) {
    const Element e = molecule.atoms[atom].element;
    const std::vector<std::uint32_t> around = heavyNeighbours(molecule, chemistry, atom);
    if (anyOf(e, {kFluorine, kChlorine, kBromine, kIodine})) {
        if (around.size() == 1 && molecule.atoms[around[0]].element == kCarbon)
            features.halogens.push_back({atom, around[0]});
        return;
    }
    if (!anyOf(e, {kNitrogen, kOxygen, kSulphur})) return;
    std::vector<std::uint32_t> bases;
    for (const std::uint32_t n : around)
        if (anyOf(molecule.atoms[n].element, {kCarbon, kNitrogen, kPhosphorus, kSulphur})) bases.push_back(n);
    if (!bases.empty()) features.halogenAcceptors.push_back({atom, bases[0], bases.size()});
}

}  // namespace

std::vector<std::uint32_t> heavyNeighbours(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t atom) {
    std::vector<std::uint32_t> heavy;
    for (const Neighbour& n : chemistry.of(atom))
        if (!isHydrogen(molecule.atoms[n.atom].element)) heavy.push_back(n.atom);
    return heavy;
}

bool isSideChain(const Molecule& molecule, std::uint32_t atom) {
    return !isBackbone(ResidueKind::protein, molecule.atoms[atom].name);
}

bool isTransitionMetal(Element element) {
    return (element >= 22 && element <= 30) || (element >= 39 && element <= 48) || (element >= 72 && element <= 79);
}

std::vector<std::uint32_t> sideChainAtoms(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t residue,
                                          Element element) {
    std::vector<std::uint32_t> atoms;
    const std::uint32_t begin = molecule.residues[residue].firstAtom, count = molecule.residues[residue].atomCount;
    if (count > kLargestAminoAcid) return atoms;
    for (std::uint32_t i = begin; i < begin + count; ++i)
        if (chemistry.present[i] && molecule.atoms[i].element == element && isSideChain(molecule, i))
            atoms.push_back(i);
    return atoms;
}

/// Whether a residue belongs to the receptor, by Open Babel's table of amino acids. Modified residues are ligands.
bool isAminoAcidOfPlip(const Name& residue, bool hetero) {
    const std::string_view name = residue.view();
    if (name == "PCA" || name == "HYP") return true;
    const bool modified = name == "MSE" || name == "SEC" || name == "PYL";
    return !hetero && !modified && (residueTemplate(residue) || name == "ASX" || name == "GLX");
}

Features sharedFeatures(const Molecule& molecule, const Chemistry& chemistry) {
    Features features;
    const std::vector<ResidueKind> kinds = residueKinds(molecule);
    features.receptor.resize(kinds.size());
    features.waterOxygen.resize(molecule.atoms.size());
    for (std::size_t r = 0; r < kinds.size(); ++r) {
        const Residue& residue = molecule.residues[r];
        const bool hetero = residue.atomCount > 0 && molecule.atoms[residue.firstAtom].hetero;
        features.receptor[r] = kinds[r] == ResidueKind::protein && isAminoAcidOfPlip(residue.name, hetero);
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
            if (!chemistry.present[i]) continue;
            const Element e = molecule.atoms[i].element;
            if (kinds[r] == ResidueKind::water) {
                if (e != kOxygen) continue;
                features.waters.push_back(i);
                features.waterOxygen[i] = 1;
                continue;
            }
            if (isMetal(e)) features.metals.push_back(i);
            if (hydrophobicCarbon(molecule, chemistry, i)) features.hydrophobic.push_back(i);
            addHalogenEnds(molecule, chemistry, i, features);
        }
    }
    return features;
}

void AtomBox::add(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
}

void AtomBox::cut(const AtomBox& other) {
    low = glm::max(low, other.low);
    high = glm::min(high, other.high);
}

AtomBox boundingBox(const Molecule& molecule, const std::vector<bool>& atoms) {
    AtomBox box;
    for (std::size_t i = 0; i < atoms.size(); ++i)
        if (atoms[i]) box.add(molecule.atoms[i].position);
    return box;
}

Features featuresAround(const Features& features, const Molecule& molecule, const Chemistry& chemistry,
                        const AtomBox& box) {
    const auto inside = [&](std::uint32_t atom) { return box.holds(molecule.atoms[atom].position); };
    const auto keep = [&](const auto& from, auto& to, const auto& getAtom) {
        for (const auto& feature : from)
            if (inside(getAtom(feature))) to.push_back(feature);
    };
    const auto itself = [](std::uint32_t atom) { return atom; };
    const auto named = [](const auto& feature) { return feature.atom; };
    Features near;
    keep(features.donors, near.donors, named);
    keep(features.acceptors, near.acceptors, itself);
    keep(features.hydrophobic, near.hydrophobic, itself);
    keep(features.charged, near.charged, [](const ChargedGroup& group) { return group.atoms.front(); });
    keep(features.rings, near.rings, [&](std::uint32_t ring) { return chemistry.rings[ring].atoms.front(); });
    keep(features.halogens, near.halogens, named);
    keep(features.halogenAcceptors, near.halogenAcceptors, named);
    keep(features.metals, near.metals, itself);
    keep(features.metalBinders, near.metalBinders, itself);
    keep(features.waters, near.waters, itself);
    near.waterOxygen = features.waterOxygen;
    near.unit = features.unit;
    near.receptor = features.receptor;
    return near;
}

}  // namespace nacre
