// Donors, acceptors, charges and rings by Mol*'s definitions: from valence at neutral pH, without hydrogens.

#include <algorithm>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/chemistry/features.h"
#include "engine/molecule/chemistry/steps.h"

namespace nacre {
namespace {

bool isNamed(const Name& name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name.view()) != names.end();
}

bool isStandardAminoAcid(const Name& name) { return residueTemplate(name) && aminoAcidLetter(name) != '\0'; }

bool isHalogen(Element e) { return e == kFluorine || e == kChlorine || e == kBromine || e == kIodine; }

/// Charge of a monatomic ion; 0 for elements with several charges.
std::int8_t ionCharge(Element e) {
    if (isHalogen(e)) return -1;
    for (const int alkali : {3, 11, 19, 37, 55, 87})
        if (e == alkali) return 1;
    for (const int earth : {4, 12, 20, 38, 56, 88})
        if (e == earth) return 2;
    return 0;
}

class MolstarFeatures {
public:
    MolstarFeatures(const Molecule& molecule, const Chemistry& chemistry)
        : molecule_(molecule), chemistry_(chemistry), features_(sharedFeatures(molecule, chemistry)) {}

    Features run() {
        for (std::uint32_t i = 0; i < chemistry_.present.size(); ++i) {
            if (!chemistry_.present[i]) continue;
            if (donates(i)) features_.donors.push_back({i, 0});
            if (accepts(i)) features_.acceptors.push_back(i);
            if (!features_.metals.empty() && bindsMetal(i)) features_.metalBinders.push_back(i);
        }
        inGroup_.resize(chemistry_.present.size());
        addSideChains();
        for (std::uint32_t i = 0; i < chemistry_.present.size(); ++i)
            if (chemistry_.present[i]) addGroupAround(i);
        for (std::uint32_t i = 0; i < chemistry_.present.size(); ++i)
            if (chemistry_.present[i] && !inGroup_[i]) addSingle(i);
        for (std::uint32_t r = 0; r < chemistry_.rings.size(); ++r)
            if (chemistry_.rings[r].aromatic) features_.rings.push_back(r);
        return std::move(features_);
    }

private:
    Element element(std::uint32_t atom) const { return molecule_.atoms[atom].element; }
    const Name& residueName(std::uint32_t atom) const { return molecule_.residues[molecule_.atoms[atom].residue].name; }

    /// It is seldom known which nitrogen of a histidine has the hydrogen: both donate and accept.
    bool histidineNitrogen(std::uint32_t atom) const {
        return element(atom) == kNitrogen &&
               isNamed(residueName(atom), {"HIS", "HID", "HIE", "HIP", "HSD", "HSE", "HSP"}) &&
               isNamed(molecule_.atoms[atom].name, {"ND1", "NE2"});
    }

    bool donates(std::uint32_t atom) const {
        const Element e = element(atom);
        if (e != kNitrogen && e != kOxygen && e != kSulphur) return false;
        return chemistry_.hydrogens[atom] > 0 || histidineNitrogen(atom);
    }

    bool accepts(std::uint32_t atom) const {
        const Element e = element(atom);
        if (e == kOxygen) return chemistry_.charge[atom] < 1;
        if (e == kSulphur) return isNamed(residueName(atom), {"CYS", "MET"}) || chemistry_.charge[atom] < 0;
        if (e != kNitrogen) return false;
        if (histidineNitrogen(atom)) return true;
        if (chemistry_.charge[atom] > 0) return false;
        const auto bonds = heavyNeighbours(molecule_, chemistry_, atom).size() + chemistry_.hydrogens[atom];
        const std::uint8_t hybrid = chemistry_.hybrid[atom];
        return (hybrid == 3 && bonds < 4) || (hybrid == 2 && bonds < 3) || (hybrid == 1 && bonds < 2);
    }

    bool bindsMetal(std::uint32_t atom) const {
        const Element e = element(atom);
        const Name& residue = residueName(atom);
        const Name& name = molecule_.atoms[atom].name;
        if (isTransitionMetal(e)) return true;
        if (isStandardAminoAcid(residue)) {
            if (e == kOxygen)
                return !isSideChain(molecule_, atom) ||
                       isNamed(residue, {"ASP", "GLU", "SER", "THR", "TYR", "ASN", "GLN"});
            if (e == kSulphur || e == kSelenium) return true;
            return histidineNitrogen(atom);
        }
        if (residueTemplate(residue) && nucleotideLetter(residue) != '\0')
            return isNamed(name, {"N3", "N4", "N7", "O2", "O4", "O6"}) ||
                   (e == kOxygen && isBackbone(ResidueKind::nucleic, name));
        return e == kNitrogen || e == kOxygen || e == kSulphur || e == kSelenium || isHalogen(e);
    }

    void add(std::vector<std::uint32_t> atoms, bool positive) {
        if (atoms.empty()) return;
        for (const std::uint32_t atom : atoms) inGroup_[atom] = 1;
        features_.charged.push_back({atoms, atoms, positive, false});
    }

    void addSideChains() {
        for (std::uint32_t r = 0; r < molecule_.residues.size(); ++r) {
            const Name& name = molecule_.residues[r].name;
            const bool positive = isNamed(name, {"ARG", "LYS", "HIS", "HIP", "HSP"});
            if (!positive && !isNamed(name, {"ASP", "GLU"})) continue;
            add(sideChainAtoms(molecule_, chemistry_, r, positive ? kNitrogen : kOxygen), positive);
        }
    }

    /// Adds the charged group around a centre: carboxylates, phosphates, sulphates, sulphonates; guanidines and
    /// amidines.
    void addGroupAround(std::uint32_t centre) {
        const Element e = element(centre);
        if (e != kCarbon && e != kPhosphorus && e != kSulphur) return;
        std::vector<std::uint32_t> ends, nitrogens;
        bool negative = false, positive = false;
        for (const Neighbour& n : chemistry_.of(centre)) {
            if (!chemistry_.delocalised[n.bond] || inGroup_[n.atom]) continue;
            (element(n.atom) == kNitrogen ? nitrogens : ends).push_back(n.atom);
            negative = negative || chemistry_.charge[n.atom] < 0;
            positive = positive || chemistry_.charge[n.atom] > 0;
        }
        if (negative) add(std::move(ends), false);
        if (positive) add(std::move(nitrogens), true);
    }

    void addSingle(std::uint32_t atom) {
        std::int8_t charge = chemistry_.charge[atom];
        if (charge == 0 && chemistry_.of(atom).empty()) charge = ionCharge(element(atom));
        if (charge == 0) return;
        // Formal charges that a neighbour cancels (nitro groups, N-oxides) do not count.
        for (const Neighbour& n : chemistry_.of(atom))
            if (chemistry_.charge[n.atom] * charge < 0) return;
        add({atom}, charge > 0);
    }

    const Molecule& molecule_;
    const Chemistry& chemistry_;
    Features features_;
    std::vector<std::uint8_t> inGroup_;  // by atom
};

}  // namespace

Features molstarFeatures(const Molecule& molecule, const Chemistry& chemistry) {
    return MolstarFeatures(molecule, chemistry).run();
}

}  // namespace nacre
