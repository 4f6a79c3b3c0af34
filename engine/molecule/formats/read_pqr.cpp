// PQR (PDB2PQR, APBS): PDB records with fields separated by blanks, and charge and radius at the end. If numbers run
// into each other, uses the PDB columns that most writers keep.
#include <algorithm>
#include <utility>

#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/formats/pdb_conect.h"
#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/read.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

/// The fields of one atom line as written.
struct PqrFields {
    std::string_view serial, name, residue, chain, number;
    std::array<std::string_view, 3> position;
    std::string_view charge, radius;

    /// Whether the position's words have decimal points, as all writers have them.
    bool hasPoints() const {
        return std::all_of(position.begin(), position.end(),
                           [](std::string_view word) { return word.find('.') != std::string_view::npos; });
    }
};

class PqrReader {
public:
    PqrReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name),
          lines_(text),
          model_(options.model),
          builder_(name, options.maxAtoms),
          conect_(options.maxAtoms) {}

    Molecule run() {
        while (lines_.next()) record(lines_.line());
        endModel();
        if (models_ == 0) cannotRead(name_, "it has no ATOM or HETATM records");
        requireModel(name_, model_, models_);
        builder_.guess("elements", "from atom names", static_cast<std::int64_t>(builder_.molecule().atoms.size()));
        Molecule& molecule = builder_.molecule();
        molecule.file.format = "pqr";
        molecule.file.models = models_;
        molecule.file.totalAtomsAllModels = totalAtoms_;
        molecule.file.chains = static_cast<std::int64_t>(molecule.chains.size());
        conect_.resolve(serials_, molecule);
        return builder_.finish();
    }

private:
    void record(std::string_view line) {
        if (startsWith(line, "ATOM") || startsWith(line, "HETATM")) {
            if (models_ + 1 == model_) addAtom(line);
            ++atomsInModel_;
        } else if (startsWith(line, "CONECT")) {
            conect_.add(line, lines_.number());
        } else if (startsWith(line, "MODEL")) {
            endModel();
            conectBefore_ = conect_.size();
        } else if (startsWith(line, "ENDMDL")) {
            // Bonds stated inside a model belong to that model only.
            if (conectBefore_ && models_ + 1 != model_) conect_.shrink(*conectBefore_);
            conectBefore_.reset();
            endModel();
        }
    }

    void endModel() {
        if (atomsInModel_ == 0) return;
        ++models_;
        totalAtoms_ += std::exchange(atomsInModel_, 0);
    }

    /// ATOM serial name residue [chain] number x y z charge radius; empty if the line is not of that kind.
    /// @param least  how many of x, y, z, charge and radius have to be numbers
    static std::optional<PqrFields> fieldsByWords(std::string_view line, std::size_t least) {
        const Words words = splitWords(line.substr(line[0] == 'H' ? 6 : 4));
        if (words.count != 9 && words.count != 10) return std::nullopt;
        const std::size_t numbers = words.count - 5;
        for (std::size_t i = numbers; i < numbers + least; ++i)
            if (!parseNumber(words[i])) return std::nullopt;
        // A name of four letters touches the chain or the next name: columns separate them.
        if (words.count == 9 && words[2].size() > 4) return std::nullopt;
        PqrFields fields;
        fields.serial = words[0];
        fields.name = words[1];
        fields.residue = words[2];
        fields.chain = words.count == 10 ? words[3] : std::string_view();
        fields.number = words[numbers - 1];
        // "A1000": chain and number touch.
        const bool joined = fields.chain.empty() && fields.number.size() > 1 &&
                            !parseInteger(fields.number.substr(0, 1)) && parseInteger(fields.number.substr(1)) &&
                            fields.number[0] != '-' && fields.number[0] != '+';
        if (joined) {
            fields.chain = fields.number.substr(0, 1);
            fields.number.remove_prefix(1);
        }
        if (fields.number.find_first_of("0123456789") == std::string_view::npos) return std::nullopt;
        fields.position = {words[numbers], words[numbers + 1], words[numbers + 2]};
        fields.charge = words[numbers + 3];
        fields.radius = words[numbers + 4];
        return fields;
    }

    /// By blanks, or else by columns. Words that touch are divided at signs, or by decimal points in the usual columns.
    /// @param apart  holds the text of divided words
    static PqrFields splitFields(std::string_view line, std::string& apart) {
        if (const auto fields = fieldsByWords(line, 5)) return *fields;
        const PqrFields columned = fieldsByColumns(line);
        if (!columned.residue.empty() && !columned.radius.empty()) return columned;
        apart = numbersApart(line);
        if (const auto fields = fieldsByWords(apart, 5)) return *fields;
        PqrFields fields = fieldsByWords(line, 0).value_or(PqrFields{});
        // Without a chain, one of the words before may be it: "A 1 2.0 3.0" has no z.
        if (fields.chain.empty() && !fields.hasPoints()) fields.position = {};
        return fields;
    }

    static PqrFields fieldsByColumns(std::string_view line) {
        using pdb::columns;
        PqrFields fields;
        fields.serial = columns(line, 7, 11);
        fields.name = pdb::trim(columns(line, 13, 16));
        fields.residue = pdb::trim(columns(line, 18, 21));
        fields.chain = pdb::trim(columns(line, 22, 22));
        fields.number = pdb::trim(columns(line, 23, 27));
        const pdb::Coordinates where = pdb::coordinates(line);
        if (!where.pointed) return {};
        fields.position = where.fields;
        const Words last = splitWords(columns(line, 55 + where.shift, line.size()));
        fields.charge = last[0];
        fields.radius = last[1];
        return fields;
    }

    void addAtom(std::string_view line) {
        std::string apart;
        const PqrFields fields = splitFields(line, apart);
        if (fields.name.empty())
            return builder_.leaveOutAtom("an atom line needs nine fields: '" + printable(line) + "'", lines_.number());
        const auto position = builder_.position(fields.position, lines_.number());
        if (!position) return;
        Atom atom{.position = *position, .name = Name(fields.name), .hetero = line[0] == 'H'};
        const std::string_view field = pdb::columns(line, 13, 16);
        const Name residue(fields.residue);
        atom.element = pdb::trim(field) == fields.name ? pdb::elementByName(field, residue)
                                                       : pdb::elementByLooseName(fields.name, residue);
        Molecule& molecule = builder_.molecule();
        molecule.partialCharges.push_back(property(fields.charge, "charges", -1000));
        molecule.radii.push_back(property(fields.radius, "radii", 0));
        std::string_view number = fields.number;
        char insertionCode = '\0';
        if (!number.empty() && (number.back() < '0' || number.back() > '9')) {
            insertionCode = number.back();
            number.remove_suffix(1);
        }
        builder_.addAtom(atom, fields.chain, static_cast<std::int32_t>(parseInteger(number).value_or(0)), insertionCode,
                         fields.residue);
        serials_.push_back(pdb::integer(fields.serial, 5).value_or(-1));
    }

    float property(std::string_view text, const char* what, double least) {
        const auto value = parseNumber(text);
        if (value && *value >= least && *value <= 1000) return static_cast<float>(*value);
        builder_.leaveOut(what, "not usable numbers, read as 0", lines_.number());
        return 0;
    }

    const std::string& name_;
    LineReader lines_;
    int model_;
    MoleculeBuilder builder_;
    pdb::ConectTable conect_;
    std::vector<std::int64_t> serials_;
    std::optional<std::size_t> conectBefore_;  ///< size of conect_ at the start of the open model
    std::int64_t models_ = 0, atomsInModel_ = 0, totalAtoms_ = 0;
};

}  // namespace

Molecule readPqr(const std::string& name, std::string_view text, const ReadOptions& options) {
    return PqrReader(name, text, options).run();
}

}  // namespace nacre
