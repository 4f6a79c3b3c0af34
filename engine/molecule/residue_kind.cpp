#include "engine/molecule/residue_kind.h"

#include <algorithm>
#include <array>
#include <gemmi/resinfo.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

bool isOneOf(const Name& name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name.view()) != names.end();
}

struct Variant {
    std::string_view name;
    char letter;
};
// Names of simulation programs that gemmi's table lacks.
constexpr Variant kVariants[] = {{"HID", 'H'}, {"HIE", 'H'}, {"HIP", 'H'}, {"HSD", 'H'}, {"HSE", 'H'}, {"HSP", 'H'},
                                 {"CYX", 'C'}, {"CYM", 'C'}, {"ASH", 'D'}, {"GLH", 'E'}, {"LYN", 'K'}};

std::optional<char> variantLetter(const Name& name) {
    for (const Variant& variant : kVariants)
        if (variant.name == name.view()) return variant.letter;
    return std::nullopt;
}

/// The kind that the name alone tells; empty for a name that stands in no table.
std::optional<ResidueKind> kindOfName(const Name& name) {
    if (isWater(name)) return ResidueKind::water;
    if (isOneOf(name, {"ACE", "NME", "NH2", "FOR"}) || variantLetter(name)) return ResidueKind::protein;
    if (isOneOf(name, {"SO4", "SUL", "PO4", "2HP", "PI",  "NO3", "NO2", "CO3", "BCT", "NH4",
                       "SCN", "AZI", "CYN", "CLO", "LCP", "VO4", "WO4", "MOO", "ART", "IPS"}))
        return ResidueKind::ion;
    const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(std::string(name.view()));
    if (info.is_water()) return ResidueKind::water;
    if (info.is_amino_acid()) return ResidueKind::protein;
    if (info.is_nucleic_acid() || residueTemplate(name))
        return ResidueKind::nucleic;  // the amino acids are gone by now
    if (info.found()) return ResidueKind::ligand;
    return std::nullopt;
}

enum Link : std::uint8_t { kPeptideLink = 1, kNucleicLink = 2 };

/// By residue: which kinds of backbone atom are bonded to another residue.
std::vector<std::uint8_t> chainLinks(const Molecule& molecule) {
    std::vector<std::uint8_t> links(molecule.residues.size());
    const auto mark = [&](const Atom& atom) {
        const std::string_view name = atom.name.view();
        if (name == "N" || name == "C") links[atom.residue] |= kPeptideLink;
        if (name == "P" || name == "O3'" || name == "O3*") links[atom.residue] |= kNucleicLink;
    };
    for (const Bond& bond : molecule.bonds) {
        const Atom &a = molecule.atoms[bond.a], &b = molecule.atoms[bond.b];
        if (a.residue == b.residue) continue;
        mark(a);
        mark(b);
    }
    return links;
}

class Classifier {
public:
    explicit Classifier(const Molecule& molecule) : molecule_(molecule), links_(chainLinks(molecule)) {}

    ResidueKind kindOf(std::uint32_t index) {
        const Residue& residue = molecule_.residues[index];
        // Waters come by the hundred thousand, one after another.
        if (!latestKnown_ || residue.name != latestName_) {
            latestName_ = residue.name;
            latestKind_ = kindOfName(residue.name);
            latestKnown_ = true;
        }
        if (latestKind_ && *latestKind_ != ResidueKind::ligand) return *latestKind_;
        if (isSingleIon(residue)) return ResidueKind::ion;
        if (latestKind_) return *latestKind_;
        if ((links_[index] & kPeptideLink) && hasAll(residue, {"N", "CA", "C"})) return ResidueKind::protein;
        if ((links_[index] & kNucleicLink) && hasAll(residue, {"C1'", "C3'", "O3'"})) return ResidueKind::nucleic;
        return ResidueKind::ligand;
    }

private:
    bool hasAll(const Residue& residue, std::initializer_list<std::string_view> names) const {
        return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
            for (std::uint32_t i = 0; i < residue.atomCount; ++i)
                if (currentAtomName(molecule_.atoms[residue.firstAtom + i].name) == Name(name)) return true;
            return false;
        });
    }

    /// One atom, perhaps in several alternate locations.
    bool isSingleIon(const Residue& residue) const {
        if (residue.atomCount == 0 || residue.name == Name()) return false;
        const Atom& first = molecule_.atoms[residue.firstAtom];
        for (std::uint32_t i = 1; i < residue.atomCount; ++i)
            if (molecule_.atoms[residue.firstAtom + i].name != first.name) return false;
        const Element e = first.element;
        return isMetal(e) || e == 9 || e == 17 || e == 35 || e == 53;
    }

    const Molecule& molecule_;
    std::vector<std::uint8_t> links_;
    Name latestName_;
    std::optional<ResidueKind> latestKind_;
    bool latestKnown_ = false;
};

}  // namespace

std::vector<ResidueKind> residueKinds(const Molecule& molecule) {
    Classifier classifier(molecule);
    std::vector<ResidueKind> kinds;
    kinds.reserve(molecule.residues.size());
    for (std::uint32_t i = 0; i < molecule.residues.size(); ++i) kinds.push_back(classifier.kindOf(i));
    return kinds;
}

char aminoAcidLetter(const Name& residueName) {
    if (const auto letter = variantLetter(residueName)) return *letter;
    const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(std::string(residueName.view()));
    if (!info.is_amino_acid() || info.one_letter_code == ' ' || info.one_letter_code == 'X') return '\0';
    return static_cast<char>(info.one_letter_code & ~0x20);
}

char nucleotideLetter(const Name& residueName) {
    const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(std::string(residueName.view()));
    if (!info.is_nucleic_acid() || info.one_letter_code == ' ' || info.one_letter_code == 'X') return '\0';
    return static_cast<char>(info.one_letter_code & ~0x20);
}

bool isBackbone(ResidueKind kind, const Name& atomName) {
    if (kind == ResidueKind::protein)
        return isOneOf(atomName, {"N", "CA", "C", "O", "OXT", "OT1", "OT2", "H", "H1", "H2", "H3", "HN", "HA", "HA2",
                                  "HA3", "HXT"});
    if (kind != ResidueKind::nucleic) return false;
    const Name name = currentAtomName(atomName);
    const std::string_view text = name.view();
    return (!text.empty() && text.back() == '\'') || isOneOf(name, {"P", "OP1", "OP2", "OP3", "HOP2", "HOP3"});
}

}  // namespace nacre
