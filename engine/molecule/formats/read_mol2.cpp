// MOL2 (Tripos): records of sections that begin with "@<TRIPOS>NAME"; fields between blanks.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/formats/id_index.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/read.h"
#include "engine/molecule/residue_kind.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::string_view kMark = "@<TRIPOS>";

/// Iterates over the lines of a file with their section; a backslash joins a line to the next.
class Mol2Lines {
public:
    explicit Mol2Lines(std::string_view text, std::uint64_t firstLine = 1) : lines_(text, firstLine) {}

    /// Steps to the next line that is neither blank nor a comment, or, in the section MOLECULE, to any.
    bool next() {
        while (lines_.next()) {
            number_ = lines_.number();
            line_ = lines_.line();
            if (startsWith(line_, kMark)) {
                section_ = trim(line_.substr(kMark.size()));
                lineOfSection_ = 0;
                return true;
            }
            ++lineOfSection_;
            if (section_ == "MOLECULE") return true;
            const std::string_view text = trim(line_);
            if (text.empty() || text.front() == '#') continue;
            if (text.back() == '\\') join();
            return true;
        }
        return false;
    }
    std::string_view line() const { return line_; }
    std::string_view section() const { return section_; }
    std::size_t lineOfSection() const { return lineOfSection_; }  ///< 0 on the line that begins it
    bool inside(std::string_view section) const { return lineOfSection_ > 0 && section_ == section; }
    std::uint64_t number() const { return number_; }
    std::string_view rest() const { return lines_.rest(); }

private:
    void join() {
        joined_.clear();
        for (std::string_view text = trim(line_); !text.empty() && text.back() == '\\'; text = trim(lines_.line())) {
            joined_ += text.substr(0, text.size() - 1);
            joined_ += ' ';
            if (!lines_.next()) break;
        }
        if (const std::string_view last = trim(lines_.line()); last.empty() || last.back() != '\\') joined_ += last;
        line_ = joined_;
    }

    LineReader lines_;
    std::string_view line_, section_;
    std::string joined_;
    std::size_t lineOfSection_ = 0;
    std::uint64_t number_ = 0;
};

/// Position of a record, and numbers of lines in its sections.
struct Mol2Record {
    std::string_view text;  ///< begins with "@<TRIPOS>MOLECULE"
    std::uint64_t line = 0;
    std::int64_t atoms = 0, bonds = 0;
};

/// SUBSTRUCTURE data of one residue.
struct Substructure {
    std::string name, chain;
};

struct Mol2Bond {
    std::int64_t a, b;  ///< as written
    std::uint32_t line;
    std::uint8_t order;
};

std::uint8_t parseOrder(std::string_view type) {
    if (type == "2" || type == "3") return static_cast<std::uint8_t>(type[0] - '0');
    return type == "ar" ? 4 : 1;  // single, amide, dummy, unknown
}

class Mol2Reader {
public:
    Mol2Reader(const std::string& name, std::size_t maxAtoms)
        : name_(name), maxAtoms_(maxAtoms), builder_(name, maxAtoms) {}

    Molecule run(std::string_view text, int model) {
        std::int64_t records = 0, atoms = 0, bonds = 0;
        Mol2Record wanted;
        Mol2Lines lines(text);
        while (lines.next()) {
            const bool begins = lines.lineOfSection() == 0 && lines.section() == "MOLECULE";
            if (begins && ++records == model)
                wanted = {text.substr(static_cast<std::size_t>(lines.line().data() - text.data())), lines.number()};
            if (records == model) {
                wanted.atoms += lines.inside("ATOM");
                wanted.bonds += lines.inside("BOND");
            }
            atoms += lines.inside("ATOM");
            bonds += lines.inside("BOND");
        }
        if (model > records)
            fail("there is no record " + std::to_string(model) + "; the file has " + std::to_string(records), 0);
        readRecord(wanted);
        FileSummary& file = builder_.molecule().file;
        file.format = "mol2";
        file.records = records;
        file.totalAtomsAllRecords = atoms;
        file.totalBondsAllRecords = bonds;
        file.bonds = wanted.bonds;
        return builder_.finish();
    }

private:
    [[noreturn]] void fail(const std::string& why, std::uint64_t line) const { cannotRead(name_, why, line); }

    void readRecord(const Mol2Record& record) {
        eachLine(record, [&](const Mol2Lines& lines) {
            if (lines.inside("MOLECULE") && lines.lineOfSection() == 1) title(trim(lines.line()));
            if (lines.inside("MOLECULE") && lines.lineOfSection() == 2) counts(lines, record);
            if (lines.inside("SUBSTRUCTURE")) addSubstructure(splitWords(lines.line()));
            if (lines.inside("CRYSIN") && lines.lineOfSection() == 1)
                takeCell(splitWords(lines.line()), lines.number());
            static constexpr std::string_view kUsed[] = {"MOLECULE", "ATOM", "BOND", "SUBSTRUCTURE", "CRYSIN"};
            const bool begins = lines.lineOfSection() == 0;
            if (begins && std::find(std::begin(kUsed), std::end(kUsed), lines.section()) == std::end(kUsed))
                builder_.pass("further sections");
        });
        eachLine(record, [&](const Mol2Lines& lines) {
            if (lines.inside("ATOM")) addAtom(lines);
            if (lines.inside("BOND")) addBond(lines);
        });
        resolveBonds();
    }

    /// Calls `visit` with each line of the record, until the next one begins.
    template <typename Visit>
    static void eachLine(const Mol2Record& record, Visit visit) {
        Mol2Lines lines(record.text, record.line);
        for (bool first = true; lines.next(); first = false) {
            if (!first && lines.lineOfSection() == 0 && lines.section() == "MOLECULE") return;
            visit(lines);
        }
    }

    void title(std::string_view text) {
        if (text != "****") builder_.molecule().file.title = printable(text, 200);
    }

    void counts(const Mol2Lines& lines, const Mol2Record& record) {
        const Words words = splitWords(lines.line());
        const auto atoms = parseInteger(words[0]), bonds = parseInteger(words[1]);
        if (!atoms) fail("expected a number of atoms, not '" + printable(words[0]) + "'", lines.number());
        if (*atoms > record.atoms)
            fail("it states " + std::to_string(*atoms) + " atoms and has " + std::to_string(record.atoms),
                 lines.number());
        if (*atoms != record.atoms || (bonds && *bonds != record.bonds))
            builder_.warn("it states " + std::to_string(*atoms) + " atoms and " + printable(words[1]) +
                          " bonds, and has " + std::to_string(record.atoms) + " and " + std::to_string(record.bonds));
    }

    /// a b c alpha beta gamma space_group setting
    void takeCell(const Words& words, std::uint64_t line) {
        std::array<double, 6> cell{};
        for (std::size_t i = 0; i < cell.size(); ++i) {
            cell[i] = parseNumber(words[i]).value_or(0);
            if (!(cell[i] > 0 && cell[i] < (i < 3 ? 1e6 : 180)))
                return builder_.leaveOut("unit cells", "no usable lengths and angles", line);
        }
        builder_.molecule().file.cell = cell;
    }

    /// id name root_atom [type dictionary_type chain sub_type inter_bonds status]; LEaP writes the status earlier.
    void addSubstructure(const Words& words) {
        const auto stated = [](std::string_view word) {
            const bool status = startsWith(word, "ROOT") || startsWith(word, "LEAF");
            return std::string(word == "****" || status ? std::string_view() : word);
        };
        if (substructures_.size() == maxAtoms_) return;  // each has at least one atom
        if (const auto id = parseInteger(words[0])) substructures_[*id] = {stated(words[6]), stated(words[5])};
    }

    /// id name x y z type [residue_id [residue_name [charge [status]]]]
    void addAtom(const Mol2Lines& lines) {
        std::string apart;
        const Words words = splitWordsApart(lines.line(), 2, apart);
        ids_.push_back(parseInteger(words[0]).value_or(-1));
        if (words.count < 6)
            return builder_.leaveOutAtom(
                "an atom line needs a number, a name, three coordinates and a type: '" + printable(lines.line()) + "'",
                lines.number());
        const auto position = builder_.position({words[2], words[3], words[4]}, lines.number());
        if (!position) return;
        Atom atom{.position = *position, .name = Name(words[1]), .element = guessElement(words, lines.number())};
        addToResidue(atom, parseInteger(words[6]).value_or(1), words[7]);
        const auto charge = parseNumber(words[8]);
        const bool usable = charge && std::abs(*charge) <= 1000;
        if (!usable && words.count > 8) builder_.leaveOut("partial charges", "not usable, read as 0", lines.number());
        builder_.molecule().partialCharges.push_back(usable ? static_cast<float>(*charge) : 0.0f);
    }

    /// "C.ar" is carbon; all lower-case types ("ca", "c3", "hn") are GAFF's, which names the element by the first
    /// letter except for chlorine and bromine. Types of AMBER's and CHARMM's proteins ("CA", "NH1", "OS", "N*") look
    /// like other elements, so that the atom's name decides.
    Element guessElement(const Words& words, std::uint64_t line) {
        const std::string_view symbol = words[5].substr(0, words[5].find('.'));
        const bool gaff = !symbol.empty() && symbol[0] >= 'a' && symbol[0] <= 'z';
        if (gaff && symbol != "cl" && symbol != "br") return builder_.element(symbol.substr(0, 1), line);
        const char second = symbol.size() > 1 ? symbol[1] : '\0';
        const bool forceField = symbol != "LP" && (second == '*' || (second >= 'A' && second <= 'Z'));
        const Element named = forceField ? pdb::elementByLooseName(words[1], Name(words[7])) : Element{0};
        if (named != 0) return named;
        return builder_.element(symbol, line);
    }

    void addToResidue(const Atom& atom, std::int64_t id, std::string_view stated) {
        std::string_view residue = stated;
        auto number = static_cast<std::int32_t>(id);
        const auto found = substructures_.find(id);
        const std::string_view type =
            found == substructures_.end() ? std::string_view() : std::string_view(found->second.name);
        // "GLY402": the residue's name and its number in the chain.
        const std::size_t letters = stated.find_last_not_of("0123456789") + 1;
        const auto digits = parseInteger(stated.substr(letters));
        const std::string_view start = type.empty() ? stated.substr(0, letters) : type;
        // AMBER's names of a strand's ends are DA5 and DA3, whatever their numbers.
        const bool end = digits && (*digits == 3 || *digits == 5) && *digits != id && nucleotideLetter(Name(start));
        const bool splits = digits && !end && *digits <= 1'000'000 && startsWith(stated, start) &&
                            (!type.empty() || residueTemplate(Name(start)) || isWater(Name(start)));
        if (!type.empty()) residue = type;
        if (splits) {
            residue = start;
            number = static_cast<std::int32_t>(*digits);
        }
        builder_.addAtom(atom,
                         found == substructures_.end() ? std::string_view() : std::string_view(found->second.chain),
                         number, '\0', residue);
    }

    /// id origin target type [status]
    void addBond(const Mol2Lines& lines) {
        const Words words = splitWords(lines.line());
        const auto a = parseInteger(words[1]), b = parseInteger(words[2]);
        if (!a || !b || words.count < 4)
            fail("a bond line needs a number, two atoms and a type: '" + printable(lines.line()) + "'", lines.number());
        if (pending_.size() >= builder_.mostBonds())
            fail("it has more bonds than its atoms could form", lines.number());
        if (words[3] != "nc")  // "not connected"
            pending_.push_back({*a, *b, static_cast<std::uint32_t>(lines.number()), parseOrder(words[3])});
    }

    /// Bonds name atoms by the ids of their lines. PyMOL numbers lines through all records but bonds by position, so
    /// the position counts if ids do not resolve.
    void resolveBonds() {
        const IdIndex index(ids_);
        const auto findRecord = [&](std::int64_t id) -> std::int64_t {
            std::uint32_t record = 0;
            return index.find(id, record) == IdIndex::Found::one ? std::int64_t{record} : -1;
        };
        const bool usable = !index.repeats() && std::ranges::none_of(ids_, [](std::int64_t id) { return id < 0; });
        const bool byId = usable && std::ranges::all_of(pending_, [&](const Mol2Bond& bond) {
                              return findRecord(bond.a) >= 0 && findRecord(bond.b) >= 0;
                          });
        const auto findAtom = [&](std::int64_t id) { return builder_.atomOfRecord(byId ? findRecord(id) : id - 1); };
        for (const Mol2Bond& bond : pending_)
            builder_.addBond(findAtom(bond.a), findAtom(bond.b), bond.order, bond.line);
    }

    const std::string& name_;
    std::size_t maxAtoms_;
    MoleculeBuilder builder_;
    std::map<std::int64_t, Substructure> substructures_;  // no hash that a file could aim at
    std::vector<std::int64_t> ids_;                       ///< of the atom lines; -1: not a number
    std::vector<Mol2Bond> pending_;
};

}  // namespace

Molecule readMol2(const std::string& name, std::string_view text, const ReadOptions& options) {
    return Mol2Reader(name, options.maxAtoms).run(text, options.model);
}

}  // namespace nacre
