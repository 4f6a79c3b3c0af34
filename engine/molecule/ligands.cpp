#include "engine/molecule/ligands.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nacre {
namespace {

/// Sugars of glycans, and crystallisation additives: "the ligand" seldom means these.
constexpr std::string_view kMinorLigands[] = {"NAG", "NDG", "MAN", "BMA", "FUC", "FUL", "GAL", "GLA", "GLC", "BGC",
                                              "XYS", "XYP", "SIA", "SLB", "A2G", "NGA", "GOL", "EDO", "PEG", "PGE",
                                              "1PE", "PG4", "SO4", "PO4", "ACT", "ACY", "DMS", "MPD", "FMT", "CIT",
                                              "TRS", "MES", "EPE", "BME", "IPA", "EOH", "MRD", "NH4", "IMD"};

/// Beginnings and heads of CHARMM's, Slipids', GROMOS' and Martini's names: DPPC, POPE, DOPG, SAPI.
constexpr std::string_view kTails[] = {"DL", "DM", "DP", "DO", "DS", "DA", "PO",
                                       "PL", "PA", "SO", "SL", "SA", "PY", "DY"};
constexpr std::string_view kHeads[] = {"PC", "PE", "PG", "PS", "PA", "PI", "SM"};
/// Sterols, sphingomyelin, and AMBER's heads and tails, which are separate residues.
constexpr std::string_view kLipids[] = {"CHL1", "CHOL", "CLR", "ERG", "PSM", "SSM", "PC",  "PE",  "PGR",
                                        "PH-",  "PA",   "OL",  "MY",  "LAL", "ST",  "AR",  "DHA", "TLCL",
                                        "CDL",  "PCW",  "PEE", "PGV", "LHG", "PTY", "POV", "DLP", "DPP"};

}  // namespace

std::optional<std::uint32_t> findMainLigand(const ResidueFacts& facts) {
    const Molecule& m = facts.molecule();
    std::optional<std::uint32_t> main;
    std::pair<bool, std::uint32_t> rank{false, 0};
    for (std::uint32_t r = 0; r < m.residues.size(); ++r) {
        const Residue& residue = m.residues[r];
        if (facts.kinds()[r] != ResidueKind::ligand) continue;
        const bool major = std::ranges::find(kMinorLigands, residue.name.view()) == std::end(kMinorLigands);
        if (std::pair(major, residue.atomCount) <= rank) continue;
        rank = {major, residue.atomCount};
        main = r;
    }
    return main;
}

bool isLipid(std::string_view name) {
    if (std::ranges::find(kLipids, name) != std::end(kLipids)) return true;
    if (name.size() != 4) return false;
    return std::ranges::find(kTails, name.substr(0, 2)) != std::end(kTails) &&
           std::ranges::find(kHeads, name.substr(2)) != std::end(kHeads);
}

}  // namespace nacre
