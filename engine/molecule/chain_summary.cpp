#include "engine/molecule/chain_summary.h"

#include <gemmi/resinfo.hpp>

#include "engine/molecule/drawn_atoms.h"

namespace nacre {
namespace {

enum class SummaryKind { aminoAcid, nucleotide, water, ion, ligand };

struct NamedKind {
    SummaryKind kind;
    char letter;  ///< upper case; 'X' where none is known
};

/// Names that simulation programs give to protonation states, and the letters they stand for.
char protonationState(std::string_view name) {
    struct State {
        std::string_view name;
        char letter;
    };
    static constexpr State kStates[] = {{"HID", 'H'}, {"HIE", 'H'}, {"HIP", 'H'}, {"HSD", 'H'},
                                        {"HSE", 'H'}, {"HSP", 'H'}, {"CYX", 'C'}, {"CYM", 'C'},
                                        {"ASH", 'D'}, {"GLH", 'E'}, {"LYN", 'K'}};
    for (const State& state : kStates)
        if (name == state.name) return state.letter;
    return '\0';
}

bool hasAtom(const Molecule& molecule, const Residue& residue, std::string_view name) {
    for (std::uint32_t i = 0; i < residue.atomCount; ++i)
        if (molecule.atoms[residue.firstAtom + i].name.view() == name) return true;
    return false;
}

NamedKind kindOf(const Molecule& molecule, const Residue& residue) {
    const std::string_view name = residue.name.view();
    if (isWater(residue.name)) return {SummaryKind::water, 'X'};
    if (const char letter = protonationState(name)) return {SummaryKind::aminoAcid, letter};
    const gemmi::ResidueInfo known = gemmi::find_tabulated_residue(std::string(name));
    const char code = known.one_letter_code;
    const char letter = code >= 'a' && code <= 'z' ? static_cast<char>(code - 'a' + 'A') : code == ' ' ? 'X' : code;
    if (known.is_water()) return {SummaryKind::water, 'X'};
    if (known.is_amino_acid()) return {SummaryKind::aminoAcid, letter};
    if (known.is_nucleic_acid()) return {SummaryKind::nucleotide, letter};
    const bool polymer = !known.found() && !molecule.atoms[residue.firstAtom].hetero;
    if (polymer && hasAtom(molecule, residue, "CA") && hasAtom(molecule, residue, "N") &&
        hasAtom(molecule, residue, "C"))
        return {SummaryKind::aminoAcid, 'X'};
    if (polymer && hasAtom(molecule, residue, "C4'") && hasAtom(molecule, residue, "O3'"))
        return {SummaryKind::nucleotide, 'X'};
    return {residue.atomCount == 1 ? SummaryKind::ion : SummaryKind::ligand, 'X'};
}

}  // namespace

std::vector<ChainSummary> summariseChains(const Molecule& molecule) {
    std::vector<ChainSummary> chains(molecule.chains.size());
    for (std::size_t i = 0; i < chains.size(); ++i) chains[i].name = molecule.chains[i].name;
    const Residue* before = nullptr;
    for (const Residue& residue : molecule.residues) {
        const bool alternates = before && before->chain == residue.chain && before->number == residue.number &&
                                before->insertionCode == residue.insertionCode;
        const NamedKind named = kindOf(molecule, residue);
        const bool polymer = named.kind == SummaryKind::aminoAcid || named.kind == SummaryKind::nucleotide;
        before = &residue;
        if (alternates && polymer) continue;
        ChainSummary& chain = chains[residue.chain];
        if (polymer) chain.sequence += named.letter;
        chain.aminoAcids += named.kind == SummaryKind::aminoAcid;
        chain.nucleotides += named.kind == SummaryKind::nucleotide;
        chain.waters += named.kind == SummaryKind::water;
        const std::string name(residue.name.view());
        if (named.kind == SummaryKind::ligand) ++chain.ligands[name];
        if (named.kind == SummaryKind::ion) ++chain.ions[name];
    }
    return chains;
}

}  // namespace nacre
