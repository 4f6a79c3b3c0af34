// AMBER's topologies (PRMTOP, PARM7): sections of %FLAG and %FORMAT, such as 20a4 or 5E16.8.
#include <map>
#include <vector>

#include "engine/molecule/formats/topology.h"
#include "engine/molecule/text.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

namespace {

constexpr double kAmberCharge = 18.2223;  // per elementary charge

/// Fields of one section, by columns.
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
        const std::vector<std::int64_t> pointers = integers("POINTERS", kPointers);
        const std::int64_t atoms = pointers.empty() ? 0 : pointers[0];
        if (atoms > static_cast<std::int64_t>(builder_.maxAtoms())) throw tooManyAtoms(name_, builder_.maxAtoms());
        const auto count = static_cast<std::size_t>(std::max<std::int64_t>(atoms, 0));
        const auto texts = [&](const char* flag) { return fields(flag, count); };
        const std::vector<std::string_view> names = texts("ATOM_NAME"), types = texts("AMBER_ATOM_TYPE"),
                                            labels = texts("RESIDUE_LABEL"), chains = texts("RESIDUE_CHAINID");
        const std::vector<std::int64_t> starts = integers("RESIDUE_POINTER", count),
                                        elements = integers("ATOMIC_NUMBER", count),
                                        residueNumbers = integers("RESIDUE_NUMBER", count);
        const std::vector<double> charges = numbers("CHARGE", count), masses = numbers("MASS", count);
        if (count == 0 || names.size() < count || charges.size() < count || masses.size() < count || starts.empty() ||
            labels.size() < starts.size() || starts[0] != 1)
            cannotRead(name_, "its sections do not describe " + std::to_string(atoms) + " atoms in residues");
        std::size_t residue = 0;
        for (std::size_t i = 0; i < count; ++i) {
            while (residue + 1 < starts.size() && starts[residue + 1] <= static_cast<std::int64_t>(i) + 1) ++residue;
            const TopologyAtom stated{i < types.size() ? types[i] : std::string_view(), charges[i] / kAmberCharge,
                                      masses[i]};
            Atom atom{.name = Name(names[i])};
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
        if (pointers.size() == kPointers) {  // with hydrogen and without
            builder_.pass("angles", std::max<std::int64_t>(pointers[4] + pointers[5], 0));
            builder_.pass("dihedrals", std::max<std::int64_t>(pointers[6] + pointers[7], 0));
        }
        builder_.pass("radii of implicit solvents", static_cast<std::int64_t>(fields("RADII", count).size()));
        const std::vector<double> box = numbers("BOX_DIMENSIONS", 4);
        if (box.size() >= 4)
            if (const auto vectors = makeBox({box[1], box[2], box[3]}, {box[0], box[0], box[0]}))
                builder_.takeBox(*vectors);
        if (const auto title = sections_.find("TITLE"); title != sections_.end())
            builder_.molecule().file.title = printable(trim(title->second.text), 200);
        return withoutPositions(builder_, "prmtop");
    }

private:
    static constexpr std::size_t kPointers = 8;  // the first ones

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
                section->perLine = parseCount(line.substr(open + 1, letter - open - 1));
                section->width = parseCount(width.substr(0, width.find_first_of(".)")));
                section->line = lines.number() + 1;
                section->text = lines.rest().substr(0, 0);
            } else if (section && section->width > 0 && !startsWith(line, "%")) {
                const char* begin = section->text.data();
                section->text = {begin, static_cast<std::size_t>(line.data() + line.size() - begin)};
            }
        }
    }
    static std::size_t parseCount(std::string_view text) {
        return static_cast<std::size_t>(std::clamp<std::int64_t>(parseInteger(text).value_or(0), 0, 1000));
    }

    /// @param most  fields to visit
    template <typename Take>
    void each(const char* flag, std::size_t most, const Take& take) const {
        const auto section = sections_.find(flag);
        if (section == sections_.end()) return;
        const PrmtopSection& s = section->second;
        for (LineReader lines(s.text, s.line); lines.next();) {
            const std::string_view line = lines.line();
            for (std::size_t i = 0; i < s.perLine && i * s.width < line.size(); ++i) {
                if (most-- == 0) return;
                take(trim(line.substr(i * s.width, s.width)), lines.number());
            }
        }
    }
    std::vector<std::string_view> fields(const char* flag, std::size_t most) const {
        std::vector<std::string_view> all;
        each(flag, most, [&](std::string_view field, std::uint64_t) { all.push_back(field); });
        return all;
    }
    template <typename Number, typename Parse>
    std::vector<Number> parsed(const char* flag, std::size_t most, const Parse& parse, Number otherwise) {
        std::vector<Number> all;
        each(flag, most, [&](std::string_view field, std::uint64_t line) {
            if (field.empty()) return;
            const auto value = parse(field);
            if (!value) builder_.leaveOut("numbers", "not usable", line);
            all.push_back(value.value_or(otherwise));
        });
        return all;
    }
    static constexpr std::int64_t kNoInteger = -3;  // marks no atom
    std::vector<std::int64_t> integers(const char* flag, std::size_t most) {
        return parsed(flag, most, parseInteger, kNoInteger);
    }
    std::vector<double> numbers(const char* flag, std::size_t most) { return parsed(flag, most, parseNumber, 0.0); }

    /// Triples: three times the index of each atom, and the bond's type.
    void addBonds(const char* flag) {
        constexpr std::size_t kMostOfAtom = 3 * MoleculeBuilder::kMostBondsPerAtom;
        const std::vector<std::int64_t> triples = integers(flag, kMostOfAtom * builder_.molecule().atoms.size());
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
