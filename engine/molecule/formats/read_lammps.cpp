// LAMMPS data files: counts, a box, and sections such as Masses, Atoms and Bonds.
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/molecule/formats/id_index.h"
#include "engine/molecule/formats/lammps_types.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

/// Columns of an atom line; kNoColumn: it has none.
struct LammpsColumns {
    std::size_t molecule, type, charge, x, diameter = ~std::size_t{0};
};
constexpr std::size_t kNoColumn = ~std::size_t{0};

struct LammpsStyle {
    std::string_view name;
    LammpsColumns columns;
};
constexpr LammpsStyle kStyles[] = {{"atomic", {kNoColumn, 1, kNoColumn, 2}},
                                   {"charge", {kNoColumn, 1, 2, 3}},
                                   {"bond", {1, 2, kNoColumn, 3}},
                                   {"angle", {1, 2, kNoColumn, 3}},
                                   {"molecular", {1, 2, kNoColumn, 3}},
                                   {"full", {1, 2, 3, 4}},
                                   {"sphere", {kNoColumn, 1, kNoColumn, 4, 2}}};

class LammpsReader {
public:
    LammpsReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name), lines_(text), builder_(name, options.maxAtoms) {}

    Molecule run() {
        lines_.next();
        builder_.molecule().file.title = printable(trim(lines_.line()), 200);
        std::string_view section;
        while (lines_.next()) {
            const std::string_view whole = lines_.line(), line = trim(whole.substr(0, whole.find('#')));
            if (line.empty()) continue;
            // A row of masses may begin with its type's label.
            if (isLetter(line[0]) && !parseNumber(splitWords(line)[1])) {
                section = line;
                if (section == "Atoms") chooseStyle(trim(whole.substr(std::min(whole.find('#') + 1, whole.size()))));
                continue;
            }
            if (section.empty())
                header(line);
            else if (section == "Atom Type Labels")
                readLabel(splitWords(line));
            else if (section == "Masses")
                readMass(line, whole);
            else if (section == "Atoms")
                readAtom(line);
            else if (section == "Bonds")
                readBond(line);
            else if (const std::string name = lowerCase(section);
                     name == "velocities" || name == "angles" || name == "dihedrals" || name == "impropers")
                builder_.pass(name);
        }
        compareCounts();
        addAtoms();
        FileSummary& file = builder_.molecule().file;
        file.format = "lammps";
        file.models = 1;
        file.totalAtomsAllModels = static_cast<std::int64_t>(builder_.molecule().atoms.size());
        addBonds();
        types_.apply(builder_);
        builder_.takeBox(box_, low_, lineOfBox_);
        return builder_.finish();
    }

private:
    /// Warns if the header announces other counts than the sections have.
    void compareCounts() {
        const auto compare = [&](const char* what, const Announced& announced, std::int64_t found) {
            if (announced.line > 0) builder_.compareCount(what, announced.count, found, announced.line);
        };
        compare("atoms", atoms_, atomLines_);
        compare("bonds", bondsAnnounced_, bondLines_);
    }

    /// "12 atoms", "0.0 10.0 xlo xhi", "1.0 0.0 0.0 xy xz yz".
    void header(std::string_view line) {
        const Words words = splitWords(line);
        if (words[1] == "atoms") atoms_ = {parseInteger(words[0]).value_or(0), lines_.number()};
        if (words[1] == "bonds") bondsAnnounced_ = {parseInteger(words[0]).value_or(0), lines_.number()};
        const auto number = [&](std::size_t i) {
            const auto value = parseNumber(words[i]);
            return value && std::abs(*value) <= kFarthestCoordinate ? static_cast<float>(*value) : 0.0f;
        };
        for (int axis = 0; axis < 3; ++axis)
            if (words[2] == std::string(1, "xyz"[axis]) + "lo") {
                lineOfBox_ = lines_.number();
                low_[axis] = number(0);
                box_[static_cast<std::size_t>(axis)][axis] = number(1) - number(0);
            }
        if (words[3] == "xy") {
            box_[1].x = number(0);
            box_[2].x = number(1);
            box_[2].y = number(2);
        }
    }

    void readLabel(const Words& words) {
        constexpr std::size_t kMostLabels = 100'000;
        if (labels_.size() < kMostLabels) labels_[std::string(words[0])] = words[1];
    }
    /// A type by its label, if it has one: rows may state either.
    std::string_view resolveType(std::string_view stated) const {
        const auto label = labels_.find(stated);
        return label == labels_.end() ? stated : label->second;
    }

    void readMass(std::string_view line, std::string_view whole) {
        const Words words = splitWords(line);
        const std::size_t comment = whole.find('#');
        const std::string_view type = resolveType(words[0]);
        if (const auto mass = parseNumber(words[1]); mass && std::isfinite(*mass))
            types_.add(type, *mass,
                       comment != std::string_view::npos ? splitWords(whole.substr(comment + 1))[0]
                       : labels_.empty()                 ? std::string_view()
                                                         : type);
    }

    void chooseStyle(std::string_view hint) {
        for (const LammpsStyle& style : kStyles)
            if (hint == style.name) columns_ = style.columns;
    }

    /// Without a style name, the number of columns determines the style, minus three image flags; a charge has a
    /// decimal point.
    void guessStyle(const Words& words) {
        const auto isWhole = [&](std::size_t i) { return parseInteger(words[i]).has_value(); };
        std::size_t count = words.count;
        if (count >= 8 && isWhole(count - 1) && isWhole(count - 2) && isWhole(count - 3)) count -= 3;
        const char* style = count >= 7 ? "full" : count == 5 ? "atomic" : isWhole(2) ? "molecular" : "charge";
        chooseStyle(style);
        builder_.guess("atom styles", "from the number of columns");
    }

    void readAtom(std::string_view line) {
        std::string apart;
        const Words words = splitWordsApart(line, columns_ ? columns_->x : 2, apart);
        ++atomLines_;
        if (!columns_) guessStyle(words);
        const LammpsColumns& at = *columns_;
        const auto id = parseInteger(words[0]);
        if (!id)
            return builder_.leaveOutAtom("expected an atom's number, not '" + printable(words[0]) + "'",
                                         lines_.number());
        Atom atom;
        const auto position = builder_.position({words[at.x], words[at.x + 1], words[at.x + 2]}, lines_.number());
        if (!position) return;
        atom.position = *position;
        if (rows_.size() >= builder_.maxAtoms()) throw tooManyAtoms(name_, builder_.maxAtoms());
        const auto number = [&](std::size_t column, const char* what, double least, double most) {
            const auto value = column == kNoColumn ? std::optional<double>(0) : parseNumber(words[column]);
            if (value && *value >= least && *value <= most) return static_cast<float>(*value);
            builder_.leaveOut(what, "not usable, read as 0", lines_.number());
            return 0.0f;
        };
        const float charge = number(at.charge, "partial charges", -1000, 1000);
        atom.radius = number(at.diameter, "radii", 0, 1e6) / 2;
        if (atom.radius > 0) builder_.state("radii");
        const auto molecule = at.molecule == kNoColumn ? 1 : parseInteger(words[at.molecule]).value_or(0);
        rows_.push_back({*id, atom, Name(resolveType(words[at.type])), static_cast<std::int32_t>(molecule), charge});
    }

    /// By number: the file and trajectories have atoms in any order.
    void addAtoms() {
        std::stable_sort(rows_.begin(), rows_.end(),
                         [](const LammpsAtom& a, const LammpsAtom& b) { return a.id < b.id; });
        for (const LammpsAtom& row : rows_) {
            builder_.addAtom(row.atom, "", row.molecule, '\0', "");
            builder_.molecule().types.push_back(row.type);
            if (columns_->charge != kNoColumn) builder_.molecule().partialCharges.push_back(row.charge);
            ids_.push_back(row.id);
        }
        rows_.clear();
    }

    void readBond(std::string_view line) {
        const Words words = splitWords(line);
        const auto a = parseInteger(words[2]), b = parseInteger(words[3]);
        ++bondLines_;
        if (!a || !b) return builder_.leaveOut("bonds", "not two atoms' numbers", lines_.number());
        if (bonds_.size() < builder_.mostBonds()) bonds_.push_back({*a, *b, lines_.number()});
    }

    void addBonds() {
        const IdIndex index(ids_);
        const auto findAtom = [&](std::int64_t id) -> std::int64_t {
            std::uint32_t atom = 0;
            return index.find(id, atom) == IdIndex::Found::one ? std::int64_t{atom} : -1;
        };
        for (const LammpsBond& bond : bonds_) builder_.addBond(findAtom(bond.a), findAtom(bond.b), 1, bond.line);
        if (!bonds_.empty()) builder_.molecule().file.bonds = static_cast<std::int64_t>(bonds_.size());
    }

    struct Announced {
        std::int64_t count = 0;
        std::uint64_t line = 0;  ///< 0: the header does not announce it
    };
    struct LammpsAtom {
        std::int64_t id;
        Atom atom;
        Name type;
        std::int32_t molecule;
        float charge;
    };
    struct LammpsBond {
        std::int64_t a, b;
        std::uint64_t line;
    };
    const std::string& name_;
    LineReader lines_;
    MoleculeBuilder builder_;
    std::optional<LammpsColumns> columns_;
    LammpsTypes types_;
    std::map<std::string, std::string_view, std::less<>> labels_;  ///< of types, by their numbers
    std::array<glm::vec3, 3> box_{};
    glm::vec3 low_{};  ///< the box's corner
    std::uint64_t lineOfBox_ = 0;
    Announced atoms_, bondsAnnounced_;
    std::int64_t atomLines_ = 0, bondLines_ = 0;
    std::vector<LammpsAtom> rows_;
    std::vector<std::int64_t> ids_;
    std::vector<LammpsBond> bonds_;
};

}  // namespace

Molecule readLammps(const std::string& name, std::string_view text, const ReadOptions& options) {
    requireModel(name, options.model, 1);
    return LammpsReader(name, text, options).run();
}

}  // namespace nacre
