// GROMACS topologies (TOP, ITP): types of molecules with atoms and bonds, and how many molecules of each there are.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "engine/molecule/formats/top_lines.h"
#include "engine/molecule/formats/topology.h"

namespace nacre {

namespace {

/// A row of [ atomtypes ].
struct TopType {
    Element element = 0;  ///< 0: not stated
    double charge = 0;
    std::optional<double> mass = {};
};

struct TopAtom {
    std::string_view name, type, residue;
    std::int32_t number = 0;  ///< of the residue
    char insertion = '\0';
    double charge = 0;
    std::optional<double> mass = {};
    Element element = 0;  ///< 0: not stated
};

struct TopBond {
    std::int64_t a = 0, b = 0;  ///< 0-based
    std::uint64_t line = 0;
};

struct TopMolecule {
    std::vector<TopAtom> atoms;
    std::vector<TopBond> bonds;
    bool isChain = false;  ///< of several residues
};

/// "A" to "Z", "AA", ...
std::string chainName(std::size_t index) {
    std::string name;
    for (++index; index > 0; index = (index - 1) / 26)
        name.insert(name.begin(), "ABCDEFGHIJKLMNOPQRSTUVWXYZ"[(index - 1) % 26]);
    return name;
}

class TopReader {
public:
    TopReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name), lines_(name, text), builder_(name, options.maxAtoms) {}

    Molecule run() {
        for (std::string section; lines_.next();) {
            const std::vector<std::string_view>& words = lines_.words();
            if (words[0].front() == '[') {  // "[ atoms ]" is one word
                const std::string_view heading = words[0].substr(1, words[0].find(']') - 1);
                section = lowerCase(trim(heading));
                // Its atoms are numbered through all molecules, and its bonds are restraints.
                if (section == "intermolecular_interactions") molecule_ = nullptr;
            } else {
                readLine(section, words);
            }
        }
        if (types_.empty()) cannotRead(name_, "it has no [ moleculetype ]" + ofIncludes(), lines_.firstInclude());
        addMolecules();
        builder_.pass("included files", static_cast<std::int64_t>(lines_.includes().size()));
        builder_.molecule().file.bonds = static_cast<std::int64_t>(builder_.molecule().bonds.size());
        return withoutPositions(builder_, "top");
    }

private:
    using Line = std::vector<std::string_view>;

    void readLine(std::string_view section, const Line& words) {
        std::string& title = builder_.molecule().file.title;
        if (section == "atomtypes") readAtomType(words);
        if (section == "moleculetype") beginMolecule(words[0]);
        if (section == "system" && title.empty()) title = printable(lines_.line(), 200);
        if (section == "molecules") {
            const auto count = words.size() > 1 ? parseInteger(words[1]) : std::nullopt;
            if (!count || *count < 0)
                cannotRead(name_, "expected a number of molecules after '" + printable(words[0]) + "'",
                           lines_.number());
            counts_.push_back({words[0], *count, lines_.number()});
        }
        if (!molecule_) return;
        if (section == "atoms") readAtom(words);
        // Bonds of types 6, 9 and 10, and constraints of type 2, are restraints between atoms that are not bonded.
        const std::string_view kind = words.size() > 2 ? words[2] : "1";
        if (section == "bonds" && kind != "6" && kind != "9" && kind != "10") readBond(words);
        if (section == "constraints" && kind != "2") readBond(words);
        if (section == "settles") readWater(words);
        if (section == "angles" || section == "dihedrals") builder_.pass(section);
    }

    /// Name, possibly bonded type and atomic number; mass, charge, particle type, and parameters.
    void readAtomType(const Line& words) {
        std::size_t particle = 3;
        while (particle < words.size() && !(words[particle].size() == 1 && isLetter(words[particle][0]))) ++particle;
        const auto mass = particle < words.size() ? parseNumber(words[particle - 2]) : std::nullopt;
        const auto charge = particle < words.size() ? parseNumber(words[particle - 1]) : std::nullopt;
        if (!mass || !charge) {
            builder_.leaveOut("types of atoms", "neither mass nor charge", lines_.number());
            return;
        }
        const std::int64_t number = particle > 3 ? parseInteger(words[particle - 3]).value_or(0) : 0;
        const bool known = number > 0 && number <= 118;
        atomTypes_[words[0]] = {known ? static_cast<Element>(number) : Element{0}, *charge, *mass};
    }

    void beginMolecule(std::string_view name) {
        const auto [place, isNew] = types_.try_emplace(name);
        if (!isNew) cannotRead(name_, "molecule type '" + printable(name) + "' is defined twice", lines_.number());
        molecule_ = &place->second;
        order_.push_back(name);
    }

    /// Number, type, number and name of the residue, name, charge group; possibly charge and mass.
    void readAtom(const Line& words) {
        std::vector<TopAtom>& atoms = molecule_->atoms;
        const auto expected = static_cast<std::int64_t>(atoms.size()) + 1;
        if (words.size() < 5 || parseInteger(words[0]) != expected)
            cannotRead(name_, "expected atom " + std::to_string(expected) + ", not '" + printable(words[0]) + "'",
                       lines_.number());
        if (atoms.size() == builder_.maxAtoms()) throw tooManyAtoms(name_, builder_.maxAtoms());
        TopAtom atom{.name = words[4], .type = words[1], .residue = words[3]};
        std::tie(atom.number, atom.insertion) = residueNumber(words[2]);
        if (const auto type = atomTypes_.find(words[1]); type != atomTypes_.end()) {
            atom.charge = type->second.charge;
            atom.mass = type->second.mass;
            atom.element = type->second.element;
        }
        const auto number = [&](std::size_t i, std::optional<double> otherwise) {
            if (words.size() <= i) return otherwise;
            const auto value = parseNumber(words[i]);
            if (!value || !std::isfinite(*value))
                cannotRead(name_, "expected an atom with charge and mass, not '" + printable(words[i]) + "'",
                           lines_.number());
            return value;
        };
        atom.charge = *number(6, atom.charge);
        atom.mass = number(7, atom.mass);
        atoms.push_back(atom);
    }

    void addBond(std::string_view a, std::string_view b, std::int64_t afterB = 0) {
        if (molecule_->bonds.size() >= builder_.mostBonds())
            cannotRead(name_, "it has too many bonds", lines_.number());
        molecule_->bonds.push_back(
            {parseInteger(a).value_or(0) - 1, parseInteger(b).value_or(0) - 1 + afterB, lines_.number()});
    }
    void readBond(const Line& words) {
        if (words.size() > 1)
            addBond(words[0], words[1]);
        else
            builder_.leaveOut("bonds", "one atom only", lines_.number());
    }
    /// The oxygen; its hydrogens follow.
    void readWater(const Line& words) {
        addBond(words[0], words[0], 1);
        addBond(words[0], words[0], 2);
    }

    std::string ofIncludes() const {
        if (lines_.includes().empty()) return "";
        return ", and includes '" + printable(lines_.includes()[0]) +
               "'; `gmx grompp -pp FILE.top` writes a topology with all that it includes";
    }

    /// Leaves out bonds that no copy can have.
    void finishMolecule(std::string_view name, TopMolecule& molecule) {
        std::vector<TopBond>& bonds = molecule.bonds;
        const auto count = static_cast<std::int64_t>(molecule.atoms.size());
        std::erase_if(bonds, [&](TopBond& bond) {
            if (bond.a > bond.b) std::swap(bond.a, bond.b);
            const bool exists = bond.a >= 0 && bond.b < count;
            if (exists && bond.a != bond.b) return false;
            builder_.leaveOut("bonds", exists ? "of an atom to itself" : "of atoms that are not there", bond.line);
            return true;
        });
        const auto pair = [](const TopBond& bond) { return std::pair(bond.a, bond.b); };
        std::ranges::stable_sort(bonds, {}, pair);
        bonds.erase(std::ranges::unique(bonds, {}, pair).begin(), bonds.end());
        if (bonds.size() > MoleculeBuilder::kMostBondsPerAtom * molecule.atoms.size())
            cannotRead(name_, "molecule type '" + printable(name) + "' has more bonds than its atoms could form",
                       bonds.back().line);
        for (const TopAtom& atom : molecule.atoms) molecule.isChain |= atom.number != molecule.atoms[0].number;
        if (!molecule.isChain) return;
        for (const TopAtom& atom : molecule.atoms) nextNumber_ = std::max<std::int64_t>(nextNumber_, atom.number + 1LL);
    }

    /// Copies the atoms of each type as often as the file says; once where it says nothing.
    void addMolecules() {
        for (auto& [name, molecule] : types_) finishMolecule(name, molecule);
        if (counts_.empty())
            for (const std::string_view name : order_) counts_.push_back({name, 1, 0});
        std::vector<std::pair<const TopMolecule*, std::size_t>> blocks;
        std::size_t left = builder_.maxAtoms();
        for (const Count& count : counts_) {
            const auto type = types_.find(count.name);
            if (type == types_.end())
                cannotRead(name_, "it does not define molecule type '" + printable(count.name) + "'" + ofIncludes(),
                           count.line);
            const std::size_t atoms = type->second.atoms.size(), copies = static_cast<std::size_t>(count.count);
            if (atoms == 0) continue;
            if (copies > left / atoms) throw tooManyAtoms(name_, builder_.maxAtoms());
            left -= copies * atoms;
            blocks.emplace_back(&type->second, copies);
        }
        for (const auto& [molecule, copies] : blocks)
            for (std::size_t copy = 0; copy < copies; ++copy) addCopy(*molecule);
    }

    /// Each chain has a name of its own. Molecules of one residue are numbered on, as GROMACS does.
    void addCopy(const TopMolecule& molecule) {
        const auto first = static_cast<std::int64_t>(builder_.molecule().atoms.size());
        const std::string chain = molecule.isChain ? chainName(chains_++) : "";
        const std::int64_t number = molecule.isChain ? 0 : nextNumber_++;
        for (const TopAtom& stated : molecule.atoms) {
            const TopologyAtom topology{stated.type, stated.charge, stated.mass};
            Atom atom{.name = Name(stated.name)};
            atom.element =
                stated.element ? stated.element : elementOfTopology(builder_, topology, stated.name, stated.residue);
            builder_.addAtom(atom, chain, molecule.isChain ? stated.number : static_cast<std::int32_t>(number),
                             stated.insertion, stated.residue);
            keepTopology(builder_, topology);
        }
        for (const TopBond& bond : molecule.bonds) builder_.addBond(first + bond.a, first + bond.b, 1, bond.line);
    }

    struct Count {
        std::string_view name;
        std::int64_t count = 0;
        std::uint64_t line = 0;
    };

    const std::string& name_;
    TopLines lines_;
    MoleculeBuilder builder_;
    std::map<std::string_view, TopType, std::less<>> atomTypes_;
    std::map<std::string_view, TopMolecule, std::less<>> types_;
    std::vector<std::string_view> order_;  ///< of types_
    TopMolecule* molecule_ = nullptr;      ///< whose sections are read
    std::vector<Count> counts_;
    std::size_t chains_ = 0;
    std::int64_t nextNumber_ = 1;  ///< of a residue that is a molecule
};

}  // namespace

Molecule readTop(const std::string& name, std::string_view text, const ReadOptions& options) {
    requireModel(name, options.model, 1);
    return TopReader(name, text, options).run();
}

}  // namespace nacre
