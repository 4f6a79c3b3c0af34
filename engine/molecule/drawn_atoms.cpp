#include "engine/molecule/drawn_atoms.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "engine/molecule/element.h"

namespace nacre {
namespace {

/// A residue position. Alternative residues (microheterogeneity) share one.
using Position = std::tuple<std::uint32_t, std::int32_t, char>;

Position makePosition(const Residue& residue) { return {residue.chain, residue.number, residue.insertionCode}; }

/// Occupancy of one alternate location at one position.
struct Alternate {
    char letter = '\0';
    double occupancySum = 0;
    std::size_t count = 0;
};

/// The alternate location to draw at each position that has any.
class ChosenAlternates {
public:
    ChosenAlternates(const Molecule& molecule, const Altlocs& altlocs) : all_(altlocs.mode == Altlocs::Mode::all) {
        if (all_) return;
        std::map<Position, std::vector<Alternate>> found;
        for (const Atom& atom : molecule.atoms) {
            if (atom.alternate == '\0') continue;
            std::vector<Alternate>& here = found[makePosition(molecule.residues[atom.residue])];
            auto it = std::find_if(here.begin(), here.end(),
                                   [&](const Alternate& known) { return known.letter == atom.alternate; });
            if (it == here.end()) it = here.insert(here.end(), {atom.alternate, 0, 0});
            it->occupancySum += static_cast<double>(atom.occupancy);
            ++it->count;
        }
        for (const auto& [position, alternates] : found) {
            const auto mean = [](const Alternate& a) { return a.occupancySum / static_cast<double>(a.count); };
            // Means of equal occupancies may differ in the last bits; the first in the file still has to win.
            constexpr double kEqual = 1e-6;
            const Alternate* best = &alternates.front();
            for (const Alternate& candidate : alternates)
                if (mean(candidate) > mean(*best) + kEqual) best = &candidate;
            if (altlocs.mode == Altlocs::Mode::letter)
                for (const Alternate& candidate : alternates)
                    if (candidate.letter == altlocs.letter) best = &candidate;
            chosen_[position] = best->letter;
        }
    }

    bool drawn(const Molecule& molecule, const Atom& atom) const {
        return atom.alternate == '\0' || all_ ||
               chosen_.at(makePosition(molecule.residues[atom.residue])) == atom.alternate;
    }

private:
    bool all_;
    std::map<Position, char> chosen_;
};

}  // namespace

bool isWater(const Name& residueName) {
    static const std::array<Name, 9> kNames = {Name("HOH"), Name("WAT"),  Name("H2O"),  Name("DOD"), Name("SOL"),
                                               Name("TIP"), Name("TIP3"), Name("TIP4"), Name("SPC")};
    return std::find(kNames.begin(), kNames.end(), residueName) != kNames.end();
}

bool isDummy(const Atom& atom) {
    if (atom.element != 0) return false;
    const std::string_view name = atom.name.view();
    return name == "X" || name == "Xx" || name == "XX" || name == "Du" || name == "DU" || name == "LP";
}

std::vector<std::uint32_t> drawnAtoms(const Molecule& molecule, const DrawnAtomsOptions& options) {
    const ChosenAlternates alternates(molecule, options.altlocs);
    std::vector<bool> water(molecule.residues.size());
    if (!options.water)
        for (std::size_t i = 0; i < water.size(); ++i) water[i] = isWater(molecule.residues[i]);
    std::vector<std::uint32_t> drawn;
    drawn.reserve(molecule.atoms.size());
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i) {
        const Atom& atom = molecule.atoms[i];
        if (water[atom.residue] || isDummy(atom)) continue;
        if (!options.hydrogens && isHydrogen(atom.element)) continue;
        if (!alternates.drawn(molecule, atom)) continue;
        drawn.push_back(i);
    }
    return drawn;
}

std::vector<std::vector<std::uint32_t>> conformers(const Molecule& molecule, const DrawnAtomsOptions& options) {
    std::vector<std::vector<std::uint32_t>> found = {drawnAtoms(molecule, options)};
    std::vector<bool> drawn(molecule.atoms.size());
    for (const std::uint32_t atom : found.front()) drawn[atom] = true;
    std::set<char> letters;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (!drawn[i] && molecule.atoms[i].alternate != '\0') letters.insert(molecule.atoms[i].alternate);
    DrawnAtomsOptions other = options;
    for (const char letter : letters) {
        other.altlocs = {Altlocs::Mode::letter, letter};
        found.push_back(drawnAtoms(molecule, other));
    }
    return found;
}

}  // namespace nacre
