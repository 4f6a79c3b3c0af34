// AMBER's topologies (PRMTOP, PARM7): sections of %FLAG and %FORMAT, such as 20a4 or 5E16.8.
#include <cmath>
#include <map>
#include <vector>

#include "engine/molecule/formats/topology.h"
#include "engine/molecule/text.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

namespace {

constexpr double kAmberCharge = 18.2223;  // of an elementary charge

/// Fields of one section, in their columns.
struct PrmtopSection {
    std::string_view text;
    std::uint64_t line = 0;
    std::size_t perLine = 0, width = 0;
};

class PrmtopReader {
public:
    PrmtopReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name), builder_(name, options.maxAtoms) {
        findSections(text);
    }

    Molecule run() {
        const std::vector<std::int64_t> pointers = integers("POINTERS");
        const std::int64_t atoms = pointers.empty() ? 0 : pointers[0];
        const std::vector<std::string_view> names = fields("ATOM_NAME"), types = fields("AMBER_ATOM_TYPE"),
                                            labels = fields("RESIDUE_LABEL"), chains = fields("RESIDUE_CHAINID");
        const std::vector<std::int64_t> starts = integers("RESIDUE_POINTER"), elements = integers("ATOMIC_NUMBER"),
                                        residueNumbers = integers("RESIDUE_NUMBER");
        const std::vector<double> charges = numbers("CHARGE"), masses = numbers("MASS");
        const auto count = static_cast<std::size_t>(std::max<std::int64_t>(atoms, 0));
        if (count == 0 || names.size() < count || charges.size() < count || masses.size() < count || starts.empty() ||
            labels.size() < starts.size() || starts[0] != 1)
            cannotRead(name_, "its sections do not describe " + std::to_string(atoms) + " atoms in residues");
        std::size_t residue = 0;
        for (std::size_t i = 0; i < count; ++i) {
            while (residue + 1 < starts.size() && starts[residue + 1] <= static_cast<std::int64_t>(i) + 1) ++residue;
            const TopologyAtom stated{i < types.size() ? types[i] : std::string_view(), charges[i] / kAmberCharge,
                                      masses[i]};
            Atom atom;
            atom.name = Name(names[i]);
            const bool known = i < elements.size() && elements[i] >= 0 && elements[i] <= 118;
            atom.element = known ? static_cast<Element>(elements[i])
                                 : elementOfTopology(builder_, stated, names[i], labels[residue]);
            const std::int64_t number =
                residue < residueNumbers.size() ? residueNumbers[residue] : static_cast<std::int64_t>(residue) + 1;
            builder_.addAtom(atom, residue < chains.size() ? chains[residue] : std::string_view(),
                             static_cast<std::int32_t>(number), '\0', labels[residue]);
            keepTopology(builder_, stated);
        }
        addBonds("BONDS_INC_HYDROGEN");
        addBonds("BONDS_WITHOUT_HYDROGEN");
        builder_.molecule().file.bonds = static_cast<std::int64_t>(builder_.molecule().bonds.size());
        const std::vector<double> box = numbers("BOX_DIMENSIONS");
        if (box.size() >= 4)
            if (const auto vectors = boxOf({box[1], box[2], box[3]}, {box[0], box[0], box[0]}))
                builder_.takeBox(*vectors);
        if (const auto title = sections_.find("TITLE"); title != sections_.end())
            builder_.molecule().file.title = printable(trim(title->second.text), 200);
        return withoutPositions(builder_, "prmtop");
    }

private:
    void findSections(std::string_view text) {
        PrmtopSection* section = nullptr;
        for (LineReader lines(text); lines.next();) {
            const std::string_view line = lines.line();
            if (startsWith(line, "%FLAG ")) {
                section = &sections_[std::string(trim(line.substr(6)))];
                *section = {};
            } else if (startsWith(line, "%FORMAT") && section) {
                // "(10I8)", "(5E16.8)", "(20a4)"
                const std::size_t open = line.find('('), letter = line.find_first_of("aAiIeEfF", open);
                if (open == std::string_view::npos || letter == std::string_view::npos) continue;
                const std::string_view width = line.substr(letter + 1);
                section->perLine = countOf(line.substr(open + 1, letter - open - 1));
                section->width = countOf(width.substr(0, width.find_first_of(".)")));
                section->line = lines.number() + 1;
                section->text = lines.rest().substr(0, 0);
            } else if (section && section->width > 0 && !startsWith(line, "%")) {
                const char* begin = section->text.data();
                section->text = {begin, static_cast<std::size_t>(line.data() + line.size() - begin)};
            }
        }
    }
    static std::size_t countOf(std::string_view text) {
        return static_cast<std::size_t>(std::clamp<std::int64_t>(parseInteger(text).value_or(0), 0, 1000));
    }

    template <typename Take>
    void each(const char* flag, const Take& take) const {
        const auto section = sections_.find(flag);
        if (section == sections_.end()) return;
        const PrmtopSection& s = section->second;
        for (LineReader lines(s.text, s.line); lines.next();) {
            const std::string_view line = lines.line();
            for (std::size_t i = 0; i < s.perLine && i * s.width < line.size(); ++i) {
                take(trim(line.substr(i * s.width, s.width)), lines.number());
            }
        }
    }
    std::vector<std::string_view> fields(const char* flag) const {
        std::vector<std::string_view> all;
        each(flag, [&](std::string_view field, std::uint64_t) { all.push_back(field); });
        return all;
    }
    template <typename Number, typename Parse>
    std::vector<Number> parsed(const char* flag, const Parse& parse) const {
        std::vector<Number> all;
        each(flag, [&](std::string_view field, std::uint64_t line) {
            if (field.empty()) return;
            const auto value = parse(field);
            if (!value) cannotRead(name_, "expected a number, not '" + printable(field) + "'", line);
            all.push_back(*value);
        });
        return all;
    }
    std::vector<std::int64_t> integers(const char* flag) const { return parsed<std::int64_t>(flag, parseInteger); }
    std::vector<double> numbers(const char* flag) const { return parsed<double>(flag, parseNumber); }

    /// Triples: both atoms' numbers times three, from 0, and the bond's type.
    void addBonds(const char* flag) {
        const std::vector<std::int64_t> triples = integers(flag);
        const auto line = sections_.find(flag);
        for (std::size_t i = 0; i + 2 < triples.size(); i += 3)
            builder_.addBond(triples[i] / 3, triples[i + 1] / 3, 1, line->second.line);
    }

    const std::string& name_;
    MoleculeBuilder builder_;
    std::map<std::string, PrmtopSection, std::less<>> sections_;
};

}  // namespace

Molecule readPrmtop(const std::string& name, std::string_view text, const ReadOptions& options) {
    requireModel(name, options.model, 1);
    return PrmtopReader(name, text, options).run();
}

}  // namespace nacre
