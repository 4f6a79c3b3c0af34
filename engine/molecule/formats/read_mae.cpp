// Maestro files: blocks in braces, each with the names of its columns, then ":::", then values. A block f_m_ct is a
// structure; its blocks m_atom[N] and m_bond[N] are tables.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "engine/molecule/element.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

/// Words between blanks or in quotes; skips comments between number signs.
class MaeWords {
public:
    explicit MaeWords(std::string_view text) : text_(text) {}

    /// Empty at the end. An empty value in quotes is `""`.
    std::string_view next() {
        for (;;) {
            while (at_ < text_.size() && isBlank(text_[at_])) line_ += text_[at_++] == '\n';
            if (at_ >= text_.size()) return {};
            if (text_[at_] != '#') break;
            at_ = std::min(text_.find_first_of("#\n", at_ + 1), text_.size());
            if (at_ < text_.size() && text_[at_] == '#') ++at_;
        }
        const std::size_t begin = at_;
        if (text_[at_] == '"') {
            for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\';
            at_ = std::min(at_ + 1, text_.size());
        } else {
            while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
        }
        return text_.substr(begin, at_ - begin);
    }
    std::uint64_t line() const { return line_; }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::uint64_t line_ = 1;
};

std::string_view unquoted(std::string_view word) {
    if (word == "<>") return {};
    return word.size() >= 2 && word.front() == '"' ? trim(word.substr(1, word.size() - 2)) : word;
}

/// A row of a table, by the names of its columns.
class MaeRow {
public:
    MaeRow(const std::vector<std::string_view>& names, const std::vector<std::string_view>& values)
        : names_(names), values_(values) {}
    std::string_view operator[](std::string_view name) const {
        for (std::size_t i = 0; i < names_.size() && i < values_.size(); ++i)
            if (names_[i] == name) return unquoted(values_[i]);
        return {};
    }
    std::int64_t integer(std::string_view name) const { return parseInteger((*this)[name]).value_or(0); }
    std::optional<double> number(std::string_view name) const {
        const auto value = parseNumber((*this)[name]);
        return value && std::abs(*value) <= kFarthestCoordinate ? value : std::nullopt;
    }

private:
    const std::vector<std::string_view>&names_, &values_;
};

class MaeReader {
public:
    MaeReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name), words_(text), model_(options.model), builder_(name, options.maxAtoms) {}

    Molecule run() {
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            if (word == "{") {
                readBlock("", 0);
                continue;
            }
            const bool structure = word == "f_m_ct";
            records_ += structure;
            inWanted_ = structure && records_ == model_;
            if (words_.next() != "{")
                cannotRead(name_, "expected a block after '" + printable(word) + "'", words_.line());
            readBlock(word, 0);
        }
        if (records_ == 0) cannotRead(name_, "it has no f_m_ct block");
        if (model_ > records_)
            cannotRead(name_,
                       "there is no record " + std::to_string(model_) + "; the file has " + std::to_string(records_));
        FileSummary& file = builder_.molecule().file;
        file.format = "mae";
        file.records = records_;
        file.totalAtomsAllRecords = atoms_;
        file.bonds = static_cast<std::int64_t>(builder_.molecule().bonds.size());
        return builder_.finish();
    }

private:
    static constexpr int kDeepest = 20;
    static constexpr std::size_t kMostColumns = 10'000;

    std::string_view needed() {
        const std::string_view word = words_.next();
        if (word.empty()) cannotRead(name_, "it ends within a block", words_.line());
        return word;
    }

    /// Reads a block after its opening brace. @param name  with the number of rows: "m_atom[12]"
    void readBlock(std::string_view name, int depth) {
        if (depth > kDeepest) cannotRead(name_, "its blocks are nested too deep", words_.line());
        std::vector<std::string_view> names, values;
        for (std::string_view word = needed(); word != ":::"; word = needed()) {
            if (word == "}") return;
            if (names.size() == kMostColumns) cannotRead(name_, "a block has too many columns", words_.line());
            names.push_back(word);
        }
        const std::size_t bracket = name.find('[');
        if (bracket == std::string_view::npos) {
            for (std::size_t i = 0; i < names.size(); ++i) values.push_back(needed());
            if (name == "f_m_ct" && inWanted_) readStructure(MaeRow(names, values));
        } else {
            readTable(name.substr(0, bracket), std::move(names),
                      parseInteger(name.substr(bracket + 1, name.find(']') - bracket - 1)));
        }
        for (std::string_view word = needed(); word != "}"; word = needed()) {
            if (word == ":::") continue;
            if (needed() != "{") cannotRead(name_, "expected a block after '" + printable(word) + "'", words_.line());
            readBlock(word, depth + 1);
        }
    }

    /// Rows of an index and the values, up to ":::". @param announced  rows
    void readTable(std::string_view name, std::vector<std::string_view> names, std::optional<std::int64_t> announced) {
        const std::uint64_t line = words_.line();
        std::int64_t rows = 0;
        std::vector<std::string_view> values;
        for (std::string_view index = needed(); index != ":::"; index = needed()) {
            values.clear();
            for (std::size_t i = 0; i < names.size(); ++i) values.push_back(needed());
            atoms_ += name == "m_atom";
            if (!inWanted_) continue;
            if (name == "m_atom") addAtom(MaeRow(names, values));
            if (name == "m_bond") addBond(MaeRow(names, values));
            ++rows;
        }
        if (!inWanted_) return;
        const bool used = name == "m_atom" || name == "m_bond";
        if (!used) builder_.pass("further tables");
        builder_.pass("further columns", used ? std::count_if(names.begin(), names.end(), isUnused) : 0);
        if (!announced || !used) return;
        builder_.compareCount(name == "m_atom" ? "atoms" : "bonds", *announced, rows, line);
    }

    static bool isUnused(std::string_view column) {
        static constexpr std::string_view kUsed[] = {"r_m_x_coord",
                                                     "r_m_y_coord",
                                                     "r_m_z_coord",
                                                     "i_m_atomic_number",
                                                     "s_m_pdb_atom_name",
                                                     "s_m_atom_name",
                                                     "i_m_formal_charge",
                                                     "r_m_pdb_occupancy",
                                                     "r_m_pdb_tfactor",
                                                     "s_m_insertion_code",
                                                     "s_m_chain_name",
                                                     "i_m_residue_number",
                                                     "s_m_pdb_residue_name",
                                                     "r_m_charge1",
                                                     "i_m_secondary_structure",
                                                     "i_m_from",
                                                     "i_m_to",
                                                     "i_m_order"};
        return std::find(std::begin(kUsed), std::end(kUsed), column) == std::end(kUsed);
    }

    void readStructure(const MaeRow& row) {
        builder_.molecule().file.title = printable(row["s_m_title"], 200);
        std::array<glm::vec3, 3> box{};
        for (std::size_t i = 0; i < 9; ++i) {
            const std::string key = std::string("r_chorus_box_") + "abc"[i / 3] + "xyz"[i % 3];
            box[i / 3][static_cast<int>(i % 3)] = static_cast<float>(row.number(key).value_or(0));
        }
        builder_.takeBox(box);
    }

    void addAtom(const MaeRow& row) {
        const auto position =
            builder_.position({row["r_m_x_coord"], row["r_m_y_coord"], row["r_m_z_coord"]}, words_.line());
        if (!position) return;
        Atom atom;
        atom.position = *position;
        const std::int64_t number = row.integer("i_m_atomic_number");
        atom.element = number >= 1 && number <= 118 ? static_cast<Element>(number) : Element{0};
        std::string_view name = row["s_m_pdb_atom_name"];
        if (name.empty()) name = row["s_m_atom_name"];
        atom.name = Name(name.empty() ? elementSymbol(atom.element) : name);
        atom.charge = static_cast<std::int8_t>(std::clamp<std::int64_t>(row.integer("i_m_formal_charge"), -20, 20));
        atom.occupancy = static_cast<float>(row.number("r_m_pdb_occupancy").value_or(1));
        atom.temperatureFactor = static_cast<float>(row.number("r_m_pdb_tfactor").value_or(0));
        const std::string_view code = row["s_m_insertion_code"];
        builder_.addAtom(atom, row["s_m_chain_name"], static_cast<std::int32_t>(row.integer("i_m_residue_number")),
                         code.empty() ? '\0' : code[0], row["s_m_pdb_residue_name"]);
        Molecule& molecule = builder_.molecule();
        auto charge = row.number("r_m_charge1");
        if (!charge && !row["r_m_charge1"].empty()) {
            builder_.leaveOut("partial charges", "not usable, read as 0", words_.line());
            charge = 0;
        }
        if (charge && molecule.partialCharges.size() + 1 == molecule.atoms.size())
            molecule.partialCharges.push_back(static_cast<float>(*charge));
        const std::int64_t fold = row.integer("i_m_secondary_structure");
        if (fold != 1 && fold != 2) return;
        molecule.residues.back().secondary = fold == 1 ? SecondaryStructure::helix : SecondaryStructure::strand;
        molecule.statesSecondaryStructure = true;
    }

    void addBond(const MaeRow& row) {
        // Some programs list each bond twice, once from each of its atoms.
        const std::int64_t from = row.integer("i_m_from"), to = row.integer("i_m_to"), order = row.integer("i_m_order");
        if (!bonds_.emplace(std::min(from, to), std::max(from, to)).second) return;
        if (bonds_.size() > builder_.mostBonds()) cannotRead(name_, "it has more bonds than its atoms could form");
        builder_.addBond(builder_.atomOfRecord(from - 1), builder_.atomOfRecord(to - 1),
                         order >= 1 && order <= 3 ? static_cast<int>(order) : 1, words_.line());
    }

    const std::string& name_;
    MaeWords words_;
    std::int64_t model_, records_ = 0, atoms_ = 0;
    bool inWanted_ = false;
    std::set<std::pair<std::int64_t, std::int64_t>> bonds_;
    MoleculeBuilder builder_;
};

}  // namespace

Molecule readMae(const std::string& name, std::string_view text, const ReadOptions& options) {
    return MaeReader(name, text, options).run();
}

}  // namespace nacre
