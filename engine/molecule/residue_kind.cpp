#include "engine/molecule/residue_kind.h"

#include <algorithm>
#include <gemmi/resinfo.hpp>
#include <initializer_list>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

/// The kind that the name implies; empty for an unknown name.
std::optional<ResidueKind> kindOfName(const Name& given) {
    const Name name = threeLetterName(given);
    if (isWater(name)) return ResidueKind::water;
    if (isOneOf(name, {"ACE", "NME", "NH2", "FOR"}) || variantLetter(name)) return ResidueKind::protein;
    if (isOneOf(name, {"SO4", "SUL", "PO4", "2HP", "PI",  "NO3", "NO2", "CO3", "BCT", "NH4",
                       "SCN", "AZI", "CYN", "CLO", "LCP", "VO4", "WO4", "MOO", "ART", "IPS"}))
        return ResidueKind::ion;
    const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(std::string(name.view()));
    if (info.is_water()) return ResidueKind::water;
    if (info.is_amino_acid()) return ResidueKind::protein;
    if (info.is_nucleic_acid() || residueTemplate(name)) return ResidueKind::nucleic;  // amino acids were handled above
    if (info.found()) return ResidueKind::ligand;
    return std::nullopt;
}

enum Link : std::uint8_t {
    kPeptideLink = 1,
    kNucleicLink = 2,
    kAfterPeptide = 4,  ///< a nitrogen, whatever its name, bonded to another residue's C
    kBeforePeptide = 8  ///< a carbon bonded to another residue's N
};

/// Kind of backbone bond that an atom of this name can have to another residue; 0: none.
std::uint8_t classifyLink(const Name& atom) {
    const std::string_view name = atom.view();
    if (name == "N" || name == "C") return kPeptideLink;
    return name == "P" || name == "O3'" || name == "O3*" ? kNucleicLink : 0;
}

/// An atom's place in a chain, by the atom of another residue that it is bonded to.
std::uint8_t classifyChainLink(const Atom& atom, const Atom& other) {
    constexpr Element kCarbon = 6, kNitrogen = 7;
    if (atom.element == kNitrogen && other.name == Name("C")) return kAfterPeptide;
    return atom.element == kCarbon && other.name == Name("N") ? kBeforePeptide : 0;
}

using Links = std::vector<std::pair<const Atom*, const Atom*>>;

/// Bonds between two residues.
Links findLinks(const Molecule& molecule) {
    Links links;
    for (const Bond& bond : molecule.bonds) {
        const Atom &a = molecule.atoms[bond.a], &b = molecule.atoms[bond.b];
        if (a.residue != b.residue) links.emplace_back(&a, &b);
    }
    return links;
}

bool isPolymer(ResidueKind kind) { return kind == ResidueKind::protein || kind == ResidueKind::nucleic; }

class Classifier {
public:
    Classifier(const Molecule& molecule, const Links& links) : molecule_(molecule), links_(molecule.residues.size()) {
        for (const auto& [a, b] : links) {
            links_[a->residue] |= classifyLink(a->name);
            links_[a->residue] |= classifyChainLink(*a, *b);
            links_[b->residue] |= classifyLink(b->name);
            links_[b->residue] |= classifyChainLink(*b, *a);
        }
    }

    ResidueKind findKind(std::uint32_t index) {
        const Residue& residue = molecule_.residues[index];
        if (residue.entityKind == EntityKind::protein) return ResidueKind::protein;
        if (residue.entityKind == EntityKind::nucleic) return ResidueKind::nucleic;
        if (residue.entityKind == EntityKind::water) return ResidueKind::water;
        const ResidueKind kind = kindByName(index);
        const bool small = residue.entityKind == EntityKind::nonPolymer || residue.entityKind == EntityKind::branched;
        return small && isPolymer(kind) ? ResidueKind::ligand : kind;
    }

    bool hasAll(const Residue& residue, std::initializer_list<std::string_view> names) const {
        return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
            for (std::uint32_t i = 0; i < residue.atomCount; ++i)
                if (currentAtomName(molecule_.atoms[residue.firstAtom + i].name) == Name(name)) return true;
            return false;
        });
    }

private:
    ResidueKind kindByName(std::uint32_t index) {
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
        constexpr std::uint8_t kWithinPeptide = kAfterPeptide | kBeforePeptide;
        if ((links_[index] & kWithinPeptide) == kWithinPeptide) return ResidueKind::protein;
        if ((links_[index] & kNucleicLink) && hasAll(residue, {"C1'", "C3'", "O3'"})) return ResidueKind::nucleic;
        return ResidueKind::ligand;
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
    std::vector<std::uint8_t> links_;  ///< by residue: kinds of backbone atoms bonded to another residue
    Name latestName_;
    std::optional<ResidueKind> latestKind_;
    bool latestKnown_ = false;
};

/// Runs of HETATM residues that are bonded to each other, where the file states no entities.
class HeteroGroups {
public:
    HeteroGroups(const Molecule& molecule, const Links& links, const Classifier& classifier,
                 const std::vector<ResidueKind>& kinds)
        : molecule_(molecule), group_(molecule.residues.size()), chained_(molecule.residues.size()) {
        std::iota(group_.begin(), group_.end(), 0u);
        for (const auto& [a, b] : links)
            if (isOpen(a->residue) && isOpen(b->residue)) group_[findRoot(a->residue)] = findRoot(b->residue);
        for (const auto& [a, b] : links) {
            if (classifyLink(a->name) == 0 || classifyLink(a->name) != classifyLink(b->name)) continue;
            if (isOpen(a->residue) && !isOpen(b->residue)) chained_[findRoot(a->residue)] = true;
            if (isOpen(b->residue) && !isOpen(a->residue)) chained_[findRoot(b->residue)] = true;
        }
        std::map<std::uint32_t, std::size_t> members, polymers;  // by the last of each group
        for (std::uint32_t i = 0; i < group_.size(); ++i)
            if (group_[i] != i) ++members[findRoot(i)];  // in addition to the group's last
        for (std::uint32_t i = 0; i < group_.size(); ++i) {
            if (!isOpen(i) || !isPolymer(kinds[i])) continue;
            const Residue& residue = molecule.residues[i];
            // With incomplete backbones, as in alpha carbon models, bonds prove nothing. A modified residue may be
            // isolated between gaps of its chain.
            const bool whole =
                classifier.hasAll(residue, {"N", "CA", "C"}) || classifier.hasAll(residue, {"C3'", "O3'"});
            const bool modified = !residueTemplate(residue.name) || residue.name == Name("MSE");
            const bool alone = members.count(findRoot(i)) == 0 && modified;
            if (!whole || alone || ++polymers[findRoot(i)] > kMostOfInhibitor) chained_[findRoot(i)] = true;
        }
    }

    /// Whether a residue is part of a group that no backbone joins to a polymer.
    bool isApart(std::uint32_t residue) { return isOpen(residue) && !chained_[findRoot(residue)]; }

private:
    static constexpr std::size_t kMostOfInhibitor = 8;

    bool isOpen(std::uint32_t residue) const {
        const Residue& r = molecule_.residues[residue];
        return r.entityKind == EntityKind::unknown && r.atomCount > 0 && molecule_.atoms[r.firstAtom].hetero;
    }
    std::uint32_t findRoot(std::uint32_t residue) {
        while (group_[residue] != residue) residue = group_[residue] = group_[group_[residue]];
        return residue;
    }

    const Molecule& molecule_;
    std::vector<std::uint32_t> group_;  ///< another residue of the group, or itself
    std::vector<bool> chained_;         ///< by the last of each group
};

void makeInhibitorsLigands(const Molecule& molecule, const Links& links, const Classifier& classifier,
                           std::vector<ResidueKind>& kinds) {
    bool chain = false, hetero = false;
    for (std::uint32_t i = 0; i < kinds.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        const bool open = isPolymer(kinds[i]) && residue.entityKind == EntityKind::unknown && residue.atomCount > 0;
        hetero = hetero || (open && molecule.atoms[residue.firstAtom].hetero);
        chain = chain || (open && !molecule.atoms[residue.firstAtom].hetero);
    }
    if (!chain || !hetero) return;
    HeteroGroups groups(molecule, links, classifier, kinds);
    for (std::uint32_t i = 0; i < kinds.size(); ++i)
        if (isPolymer(kinds[i]) && groups.isApart(i)) kinds[i] = ResidueKind::ligand;
}

}  // namespace

std::vector<ResidueKind> residueKinds(const Molecule& molecule) {
    const Links links = findLinks(molecule);
    Classifier classifier(molecule, links);
    std::vector<ResidueKind> kinds;
    kinds.reserve(molecule.residues.size());
    for (std::uint32_t i = 0; i < molecule.residues.size(); ++i) kinds.push_back(classifier.findKind(i));
    makeInhibitorsLigands(molecule, links, classifier, kinds);
    return kinds;
}

char aminoAcidLetter(const Name& residueName) {
    const Name name = threeLetterName(residueName);
    if (const auto letter = variantLetter(name)) return *letter;
    const gemmi::ResidueInfo info = gemmi::find_tabulated_residue(std::string(name.view()));
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
