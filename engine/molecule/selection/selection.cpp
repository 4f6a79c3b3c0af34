#include "engine/molecule/selection/selection.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "engine/molecule/disjoint_sets.h"
#include "engine/molecule/element.h"
#include "engine/molecule/ligands.h"
#include "engine/molecule/near_atoms.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

using Set = std::vector<bool>;

/// Whether a text matches a pattern with * for any characters.
/// @param foldCase  ignores the text's case; the pattern is in capitals
bool matches(std::string_view pattern, std::string_view text, bool foldCase) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, resume = 0;
    while (t < text.size()) {
        const char c = foldCase ? upperCase(text[t]) : text[t];
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (p < pattern.size() && pattern[p] == c) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

bool anyMatches(const std::vector<std::string>& patterns, std::string_view text, bool foldCase = true) {
    return std::any_of(patterns.begin(), patterns.end(),
                       [&](const std::string& pattern) { return matches(pattern, text, foldCase); });
}

bool anyHolds(const std::vector<NumberRange>& ranges, std::int32_t number, char code) {
    const auto place = std::tuple(number, upperCase(code));
    return std::any_of(ranges.begin(), ranges.end(), [&](const NumberRange& range) {
        return std::tuple(range.first, range.firstCode) <= place && place <= std::tuple(range.last, range.lastCode);
    });
}

class Evaluator {
public:
    explicit Evaluator(const ResidueFacts& facts) : facts_(facts), molecule_(facts.molecule()) {}

    Set run(const Selection& selection) {
        for (const SelectionStep& step : selection.steps) apply(step);
        return pop();
    }

private:
    void apply(const SelectionStep& step) {
        switch (step.test) {
            case SelectionTest::negation:
                stack_.back().flip();
                break;
            case SelectionTest::conjunction:
                combine([](bool a, bool b) { return a && b; });
                break;
            case SelectionTest::disjunction:
                combine([](bool a, bool b) { return a || b; });
                break;
            case SelectionTest::within:
                stack_.back() = atomsNear(molecule_, stack_.back(), step.distance);
                break;
            case SelectionTest::around: {
                const Set inner = stack_.back();
                Set& near = stack_.back() = atomsNear(molecule_, inner, step.distance);
                for (std::size_t i = 0; i < near.size(); ++i) near[i] = near[i] && !inner[i];
                break;
            }
            case SelectionTest::expand:
                stack_.back() = atomsNear(molecule_, stack_.back(), step.distance);
                break;
            case SelectionTest::extend:
                for (int i = 0; i < static_cast<int>(step.distance); ++i) stack_.back() = withBonded(stack_.back());
                break;
            case SelectionTest::neighbor: {
                const Set inner = stack_.back();
                Set& outer = stack_.back() = withBonded(inner);
                for (std::size_t i = 0; i < outer.size(); ++i) outer[i] = outer[i] && !inner[i];
                break;
            }
            case SelectionTest::byResidue:
                stack_.back() = wholeResidues(stack_.back());
                break;
            case SelectionTest::byChain:
                stack_.back() = wholeChains(stack_.back());
                break;
            case SelectionTest::byMolecule:
                stack_.back() = wholeMolecules(stack_.back());
                break;
            default:
                stack_.push_back(leaf(step));
        }
    }

    Set leaf(const SelectionStep& step) {
        switch (step.test) {
            case SelectionTest::none:
                return Set(molecule_.atoms.size(), false);
            case SelectionTest::model:
                return whereResidue([&](std::size_t i) {
                    return anyHolds(step.numbers, molecule_.chains[molecule_.residues[i].chain].model, '\0');
                });
            case SelectionTest::atomNumber:
                return ofNumbers(step.numbers);
            case SelectionTest::protein:
                return ofKind({ResidueKind::protein});
            case SelectionTest::nucleic:
                return ofKind({ResidueKind::nucleic});
            case SelectionTest::polymer:
                return ofKind({ResidueKind::protein, ResidueKind::nucleic});
            case SelectionTest::ligand:
                if (!step.words.empty())  // the main chain identifier
                    return whereResidue([main = findMainLigand(facts_)](std::size_t i) { return main == i; });
                return ofKind({ResidueKind::ligand});
            case SelectionTest::water:
                return ofKind({ResidueKind::water});
            case SelectionTest::ion:
                return ofKind({ResidueKind::ion});
            case SelectionTest::backbone:
            case SelectionTest::sidechain:
                return ofPolymer(step.test == SelectionTest::backbone);
            case SelectionTest::chain:
            case SelectionTest::segment:
            case SelectionTest::entity:
            case SelectionTest::residueName:
            case SelectionTest::residueNumber:
                return ofResidues(step);
            case SelectionTest::secondary:
                return ofFolds(step);
            case SelectionTest::sequence:
                return ofSequences(step);
            default:
                return ofAtoms(step);
        }
    }

    /// Atoms of the residues for which `holds` is true.
    template <typename Holds>
    Set whereResidue(const Holds& holds) const {
        std::vector<bool> residues(molecule_.residues.size());
        for (std::size_t i = 0; i < residues.size(); ++i) residues[i] = holds(i);
        return whereAtom([&](const Atom& atom) { return residues[atom.residue]; });
    }

    template <typename Holds>
    Set whereAtom(const Holds& holds) const {
        Set set(molecule_.atoms.size());
        for (std::size_t i = 0; i < set.size(); ++i) set[i] = holds(molecule_.atoms[i]);
        return set;
    }

    Set ofNumbers(const std::vector<NumberRange>& ranges) const {
        Set set(molecule_.atoms.size());
        for (std::size_t i = 0; i < set.size(); ++i) set[i] = anyHolds(ranges, static_cast<std::int32_t>(i) + 1, '\0');
        return set;
    }

    Set ofKind(std::initializer_list<ResidueKind> wanted) {
        const std::vector<ResidueKind>& known = facts_.kinds();
        return whereResidue([&](std::size_t i) { return std::ranges::find(wanted, known[i]) != wanted.end(); });
    }

    Set ofPolymer(bool backbone) {
        const std::vector<ResidueKind>& known = facts_.kinds();
        return whereAtom([&](const Atom& atom) {
            const ResidueKind kind = known[atom.residue];
            const bool polymer = kind == ResidueKind::protein || kind == ResidueKind::nucleic;
            return polymer && isBackbone(kind, atom.name) == backbone;
        });
    }

    /// The segment that the file states, or else mmCIF's label_asym_id, as in PyMOL.
    std::string_view segmentName(const Residue& residue) const {
        const std::string_view stated = residue.segment.view();
        return stated.empty() && residue.subchain < molecule_.subchains.size() ? molecule_.subchains[residue.subchain]
                                                                               : stated;
    }

    Set ofResidues(const SelectionStep& step) const {
        if (step.test == SelectionTest::chain) {
            std::vector<bool> chains(molecule_.chains.size());
            for (std::size_t i = 0; i < chains.size(); ++i)
                chains[i] = anyMatches(step.words, molecule_.chains[i].name, false);
            return whereResidue([&](std::size_t i) { return chains[molecule_.residues[i].chain]; });
        }
        if (step.test == SelectionTest::entity) {
            std::vector<bool> entities{false};  // 0: no entity
            for (const std::string& id : molecule_.entities) {
                const auto name = molecule_.file.entityNames.find(id);
                entities.push_back(anyMatches(step.words, id) ||
                                   (name != molecule_.file.entityNames.end() && anyMatches(step.words, name->second)));
            }
            return whereResidue([&](std::size_t i) { return entities[molecule_.residues[i].entity]; });
        }
        return whereResidue([&](std::size_t i) {
            const Residue& residue = molecule_.residues[i];
            if (step.test == SelectionTest::segment) return anyMatches(step.words, segmentName(residue), false);
            return step.test == SelectionTest::residueName
                       ? anyMatches(step.words, residue.name.view())
                       : anyHolds(step.numbers, residue.number, residue.insertionCode);
        });
    }

    Set ofFolds(const SelectionStep& step) {
        const std::vector<ResidueKind>& known = facts_.kinds();
        return whereResidue([&](std::size_t i) {
            const SecondaryStructure fold = facts_.folds()[i];
            const char* name = fold == SecondaryStructure::helix    ? "HELIX"
                               : fold == SecondaryStructure::strand ? "STRAND"
                                                                    : "LOOP";
            const bool wanted = std::find(step.words.begin(), step.words.end(), name) != step.words.end();
            return wanted && known[i] == ResidueKind::protein;
        });
    }

    /// Runs of polymer residues that match a pattern.
    Set ofSequences(const SelectionStep& step) {
        const std::vector<ResidueKind>& known = facts_.kinds();
        std::vector<std::string> letters(molecule_.chains.size());
        std::vector<std::vector<std::uint32_t>> places(molecule_.chains.size());
        for (std::uint32_t i = 0; i < molecule_.residues.size(); ++i) {
            if (known[i] != ResidueKind::protein && known[i] != ResidueKind::nucleic) continue;
            const Residue& residue = molecule_.residues[i];
            const char letter =
                known[i] == ResidueKind::protein ? aminoAcidLetter(residue.name) : nucleotideLetter(residue.name);
            letters[residue.chain] += letter == '\0' ? 'X' : letter;
            places[residue.chain].push_back(i);
        }
        std::vector<bool> wanted(molecule_.residues.size());
        for (const std::string& pattern : step.words)
            for (std::size_t chain = 0; chain < letters.size(); ++chain)
                for (std::size_t at = 0; at + pattern.size() <= letters[chain].size(); ++at) {
                    const auto fits = [](char p, char letter) { return p == '?' || p == letter; };
                    if (!std::equal(pattern.begin(), pattern.end(),
                                    letters[chain].begin() + static_cast<std::ptrdiff_t>(at), fits))
                        continue;
                    for (std::size_t k = 0; k < pattern.size(); ++k) wanted[places[chain][at + k]] = true;
                }
        return whereResidue([&](std::size_t i) { return wanted[i]; });
    }

    static bool holds(Comparison comparison, float a, float b) {
        return (static_cast<unsigned>(comparison) & (a < b ? 1u : a > b ? 4u : 2u)) != 0;
    }

    Set ofAtoms(const SelectionStep& step) const {
        switch (step.test) {
            case SelectionTest::hydrogen:
                return whereAtom([](const Atom& atom) { return isHydrogen(atom.element); });
            case SelectionTest::hetatm:
                return whereAtom([](const Atom& atom) { return atom.hetero; });
            case SelectionTest::atomName:
                return whereAtom([&](const Atom& atom) { return anyMatches(step.words, atom.name.view()); });
            case SelectionTest::alternate:
                return whereAtom([&](const Atom& atom) {
                    const std::string_view location(&atom.alternate, atom.alternate ? 1 : 0);
                    return anyMatches(step.words, location);
                });
            case SelectionTest::element: {
                std::vector<bool> wanted(256);
                for (const std::string& word : step.words) wanted[elementFromSymbol(word)] = true;
                return whereAtom([&](const Atom& atom) { return wanted[atom.element]; });
            }
            // The file's number is a float; so is the compared number, or 0.3 would not equal 0.3.
            case SelectionTest::temperatureFactor:
                return whereAtom([&](const Atom& atom) {
                    return holds(step.comparison, atom.temperatureFactor, static_cast<float>(step.value));
                });
            case SelectionTest::occupancy:
                return whereAtom([&](const Atom& atom) {
                    return holds(step.comparison, atom.occupancy, static_cast<float>(step.value));
                });
            default:
                return Set(molecule_.atoms.size(), true);
        }
    }

    /// A residue's atoms may be separated in the file, where conformers of different names alternate.
    Set wholeResidues(const Set& set) const {
        using Key = std::tuple<std::uint32_t, std::int32_t, char, std::array<char, 8>>;
        const auto key = [&](const Residue& r) { return Key(r.chain, r.number, r.insertionCode, r.name.bytes); };
        std::map<Key, bool> touched;
        std::uint32_t latest = static_cast<std::uint32_t>(molecule_.residues.size());
        for (std::size_t i = 0; i < set.size(); ++i) {
            if (!set[i] || molecule_.atoms[i].residue == latest) continue;
            latest = molecule_.atoms[i].residue;
            touched[key(molecule_.residues[latest])] = true;
        }
        return whereResidue([&](std::size_t i) { return touched.count(key(molecule_.residues[i])) > 0; });
    }

    Set wholeChains(const Set& set) const {
        std::vector<bool> touched(molecule_.chains.size());
        for (std::size_t i = 0; i < set.size(); ++i)
            if (set[i]) touched[molecule_.residues[molecule_.atoms[i].residue].chain] = true;
        return whereResidue([&](std::size_t i) { return touched[molecule_.residues[i].chain]; });
    }

    /// The given atoms, and those bonded to them.
    Set withBonded(const Set& set) const {
        Set more = set;
        for (const Bond& bond : molecule_.bonds) {
            if (set[bond.a]) more[bond.b] = true;
            if (set[bond.b]) more[bond.a] = true;
        }
        return more;
    }

    /// All atoms connected to the given ones by bonds.
    Set wholeMolecules(const Set& set) const {
        DisjointSets connected(molecule_.atoms.size());
        for (const Bond& bond : molecule_.bonds) connected.join(bond.a, bond.b);
        Set touched(set.size());
        for (std::uint32_t i = 0; i < set.size(); ++i)
            if (set[i]) touched[connected.findRoot(i)] = true;
        Set whole(set.size());
        for (std::uint32_t i = 0; i < set.size(); ++i) whole[i] = touched[connected.findRoot(i)];
        return whole;
    }

    Set pop() {
        Set top = std::move(stack_.back());
        stack_.pop_back();
        return top;
    }

    template <typename Operation>
    void combine(const Operation& operation) {
        const Set right = pop();
        Set& left = stack_.back();
        for (std::size_t i = 0; i < left.size(); ++i) left[i] = operation(left[i], right[i]);
    }

    ResidueFacts facts_;
    const Molecule& molecule_;
    std::vector<Set> stack_;
};

}  // namespace

std::vector<bool> selectAtoms(const ResidueFacts& facts, const Selection& selection) {
    return Evaluator(facts).run(selection);
}

}  // namespace nacre
