// PDB files, by columns (wwPDB format 3.3), lenient with old or hand-made files; and AutoDock's PDBQT, which has the
// same columns up to 66, then a partial charge (71-76) and an atom type (78-80).

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/displacement.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/formats/id_index.h"
#include "engine/molecule/formats/pdb_assemblies.h"
#include "engine/molecule/formats/pdb_conect.h"
#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/formats/pdb_header.h"
#include "engine/molecule/read.h"
#include "engine/molecule/secondary_structure.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::size_t kLongestJoinedTitle = 4096;

/// Text for messages: replaces everything but printable ASCII by question marks.
std::string asciiOnly(std::string_view text) {
    std::string clean(text);
    for (char& c : clean)
        if (c < ' ' || c > '~') c = '?';
    return clean;
}

enum class Flavour { pdb, pdbqt };

/// Records that are counted but not used, with the reason.
struct UnusedItem {
    std::string_view record, items, why = "not used";
};

const UnusedItem* unusedItem(std::string_view line) {
    static constexpr UnusedItem kItems[] = {{"SIGATM", "standard deviations"},
                                            {"SIGUIJ", "standard deviations"},
                                            {"LINK  ", "links", "distances tell as well"},
                                            {"SSBOND", "disulphide bridges", "distances tell as well"},
                                            {"HYDBND", "hydrogen bonds"},
                                            {"SLTBRG", "salt bridges"},
                                            {"CISPEP", "cis peptides"},
                                            {"SITE  ", "lines of sites"},
                                            {"MODRES", "modified residues"},
                                            {"SEQRES", "lines of sequences"},
                                            {"SEQADV", "differences of sequences"},
                                            {"MTRIX1", "operators of non-crystallographic symmetry"}};
    const auto* found = std::find_if(std::begin(kItems), std::end(kItems),
                                     [&](const UnusedItem& item) { return startsWith(line, item.record); });
    return found == std::end(kItems) ? nullptr : found;
}

class PdbReader {
public:
    PdbReader(const std::string& name, std::string_view text, const ReadOptions& options, Flavour flavour)
        : name_(name),
          text_(text),
          lines_(text),
          wanted_(options.model),
          maxAtoms_(options.maxAtoms),
          flavour_(flavour),
          conect_(options.maxAtoms),
          remark350_(options.maxAtoms) {
        chainIndex_.fill(-1);
        lastOfPolymer_.fill(INT32_MIN);
    }

    Molecule read() {
        if (wanted_ < 1) cannotRead(name_, "models count from 1");
        molecule_.file.format = flavour_ == Flavour::pdb ? "pdb" : "pdbqt";
        // Limited by the text's size: no header can demand more.
        molecule_.atoms.reserve(std::min(text_.size() / 81 + 1, maxAtoms_));
        while (lines_.next()) record(lines_.line());
        endModel();
        return finish();
    }

private:
    void record(std::string_view line) {
        if (startsWith(line, "ATOM ") || startsWith(line, "HETATM") || startsWith(line, "ATOM\t")) {
            if (modelInProgress() == wanted_)
                atom(line);
            else if (modelInProgress() == 1 && sawModelRecord_ && firstModel_.size() < maxAtoms_)
                firstModel_.emplace_back(pdb::serial(line).value_or(-1), hashAtom(line));
            ++atomsInModel_;
        } else if (startsWith(line, "ANISOU")) {
            if (modelInProgress() == wanted_) displacement(line);
        } else if (const UnusedItem* unused = unusedItem(line)) {
            if (modelInProgress() == wanted_ || atomsInModel_ == 0)
                addNote(molecule_.notes, ReadAction::unused, unused->items, unused->why);
        } else if (startsWith(line, "CONECT")) {
            conectInModel_ = conectInModel_ || conectBefore_ || !sawModelRecord_;
            conect_.add(line, lines_.number());
        } else if (startsWith(line, "MODEL ") || line == "MODEL") {
            sawModelRecord_ = true;
            endModel();
            conectBefore_ = conect_.size();
        } else if (startsWith(line, "ENDMDL")) {
            // Some programs number each model's atoms from 1 and state bonds inside the model: these belong to that
            // model only.
            if (conectBefore_ && modelInProgress() != wanted_) conect_.shrink(*conectBefore_);
            conectBefore_.reset();
            endModel();
        } else if (startsWith(line, "END") && pdb::trim(line) == "END") {
            if (!sawModelRecord_) endStructure();
        } else if (startsWith(line, "TITLE ")) {
            title(line);
            noteConfidence(line);
        } else if (const auto range = secondaryOfPdbLine(line)) {
            if (secondary_.size() < maxAtoms_) {  // a residue has at least one atom
                secondary_.push_back(*range);
                secondary_.back().line = lines_.number();
            }
        } else if (startsWith(line, "REMARK   2 RESOLUTION.")) {
            const std::string_view value = pdb::trim(pdb::columns(line, 23, 40));  // a number, or NOT APPLICABLE
            if (const auto stated = pdb::number(value.substr(0, value.find(' '))); stated && *stated > 0)
                molecule_.file.resolution = *stated;
        } else if (startsWith(line, "REMARK 350")) {
            remark350_.add(line);
        } else if (!sawModelRecord_ && atomsInModel_ == 0 && molecule_.atoms.empty()) {
            header_.add(line, lines_.number());  // header of the file; within a model it applies to that model only
        }
    }

    /// Title of prediction databases: "TITLE     ALPHAFOLD MONOMER V2.0 PREDICTION FOR ...". Titles of crystal
    /// structures may mention AlphaFold, but elsewhere.
    void noteConfidence(std::string_view line) {
        const std::string text = lowerCase(pdb::trim(pdb::columns(line, 11, 80)));
        const bool program = startsWith(text, "alphafold") || startsWith(text, "esmfold");
        if (program && text.find("prediction") != std::string::npos) molecule_.file.confidence = true;
    }

    /// In files of consecutive structures, the part between two ENDs is one structure, with its CONECT records.
    void endStructure() {
        if (atomsInModel_ > 0 && modelInProgress() != wanted_) conect_.shrink(conectOfStructure_);
        if (atomsInModel_ > 0) conectOfStructure_ = conect_.size();
        endModel();
    }

    int modelInProgress() const { return models_ + 1; }

    void endModel() {
        if (atomsInModel_ == 0) return;
        ++models_;
        totalAtoms_ += atomsInModel_;
        atomsInModel_ = 0;
    }

    void title(std::string_view line) {
        const std::string_view part = pdb::trim(pdb::columns(line, 11, 80));
        std::string& text = molecule_.file.title;
        if (part.empty() || text.size() + part.size() > kLongestJoinedTitle) return;
        if (!text.empty()) text += ' ';
        text += asciiOnly(part);
    }

    /// Empty, with a note, if it is not a coordinate.
    std::optional<float> coordinate(std::string_view field, char axis) {
        const auto value = pdb::number(field);
        if (value && std::abs(*value) <= kFarthestCoordinate) return static_cast<float>(*value);
        addNote(molecule_.notes, ReadAction::leftOut, "atoms", "no usable coordinates", 1, lines_.number());
        if (leftOut_++ > 0) return std::nullopt;
        lineOfFault_ = lines_.number();
        const std::string shown = asciiOnly(pdb::trim(field));
        fault_ = std::string(shown.empty() ? "missing " : "invalid ") + axis + " coordinate" +
                 (shown.empty() ? "" : " '" + shown + "'");
        if (value) fault_ += " within 1e9 Å";
        return std::nullopt;
    }

    /// An optional number; unreadable ones count as missing, with a warning.
    float optionalNumber(std::string_view line, std::size_t first, float missing) {
        const std::string_view field = pdb::trim(pdb::columns(line, first, first + 5));
        if (field.empty()) return missing;
        if (const auto value = pdb::number(field); value && std::abs(*value) <= 1e9) return static_cast<float>(*value);
        if (unreadableNumbers_++ == 0) firstUnreadableNumber_ = lines_.number();
        return missing;
    }

    void atom(std::string_view line) {
        pdb::Coordinates where = pdb::coordinates(line);
        if (pdb::isOutOfColumns(line, where)) {
            if (auto text = pdb::inColumns(line, where)) {
                line = inColumns_ = std::move(*text);
                where = pdb::coordinates(line);
            }
        }
        latestAtom_.clear();
        Atom atom;
        for (int axis = 0; axis < 3; ++axis) {
            const auto value = coordinate(where.fields[static_cast<std::size_t>(axis)], "xyz"[axis]);
            if (!value) return;
            atom.position[axis] = *value;
        }
        const std::string_view after = line.substr(where.shift);  // columns from 55 on
        if (flavour_ == Flavour::pdbqt && pdb::isAutoDockGlue(pdb::columns(after, 78, 80)))
            return addNote(molecule_.notes, ReadAction::leftOut, "atoms", "points that hold broken rings together", 1,
                           lines_.number());
        const std::string_view before = line.substr(pdb::pushOfSerial(line, where.shift));  // columns 13 to 27
        atom.occupancy = optionalNumber(after, 55, 1);
        atom.temperatureFactor = optionalNumber(after, 61, 0);
        atom.name = pdb::trim(pdb::columns(before, 13, 16));
        atom.hetero = line[0] == 'H';
        const char alternate = pdb::column(before, 17);
        atom.alternate = alternate == ' ' ? '\0' : alternate;
        // PDBQT has charges in those columns.
        atom.residue = findResidue(before, flavour_ == Flavour::pdb ? pdb::segment(after) : std::string_view());
        elementAndCharge(before, after, atom);
        ++molecule_.residues.back().atomCount;
        if (molecule_.atoms.size() >= maxAtoms_) throw tooManyAtoms(name_, maxAtoms_);
        molecule_.atoms.push_back(atom);
        serials_.push_back(pdb::serial(line).value_or(-1));
        latestAtom_ = pdb::columns(line, 13, 27);
        if (!firstModel_.empty()) identities_.push_back(hashAtom(line));
    }

    /// A record follows its atom's: U(1,1), U(2,2), U(3,3), U(1,2), U(1,3), U(2,3) in 1e-4 Å^2.
    void displacement(std::string_view line) {
        const auto leaveOut = [&](const char* why) {
            addNote(molecule_.notes, ReadAction::leftOut, "anisotropic displacements", why, 1, lines_.number());
        };
        if (pdb::columns(line, 13, 27) != latestAtom_) return leaveOut("not behind their atoms");
        std::array<float, 6> u{};
        for (std::size_t i = 0; i < u.size(); ++i) {
            const auto value = pdb::number(pdb::columns(line, 29 + 7 * i, 35 + 7 * i));
            if (!value || std::abs(*value * 1e-4) > kLargestDisplacement) return leaveOut("not six usable numbers");
            u[i] = static_cast<float>(*value * 1e-4);
        }
        molecule_.displacements.resize(molecule_.atoms.size());
        molecule_.displacements.back() = {u[0], u[1], u[2], u[3], u[4], u[5]};
    }

    void elementAndCharge(std::string_view before, std::string_view after, Atom& atom) {
        const Name& residue = molecule_.residues.back().name;
        if (flavour_ == Flavour::pdb) {
            atom.element = stated_ = pdb::statedElement(after);
            atom.charge = pdb::charge(after);
        } else {
            atom.element = stated_ = pdb::elementByAutoDockType(pdb::columns(after, 78, 80));
            molecule_.partialCharges.push_back(optionalNumber(after, 71, 0));
        }
        if (stated_ != 0) return;
        atom.element = pdb::elementByName(pdb::columns(before, 13, 16), residue);
        ++guessedElements_;
    }

    /// Ions are residues of one atom, so they are recognised when the residue is complete. Programs that do not number
    /// them write residues of many.
    void endResidue() {
        if (molecule_.residues.empty()) return;
        const Residue& residue = molecule_.residues.back();
        const auto begin = molecule_.atoms.begin() + residue.firstAtom;
        const auto isAlike = [&](const Atom& atom) { return atom.name == begin->name && atom.alternate == '\0'; };
        if (residue.atomCount > 1 && !std::all_of(begin, molecule_.atoms.end(), isAlike)) return;
        const Element ion = pdb::elementOfIon(begin->name, residue.name, stated_);
        for (auto atom = begin; ion != 0 && atom != molecule_.atoms.end(); ++atom) {
            guessedElements_ += stated_ != 0 && ion != atom->element;
            atom->element = ion;
        }
    }

    /// Index of the residue that the line belongs to: the latest, or a new one.
    std::uint32_t findResidue(std::string_view line, std::string_view segment) {
        // Column 21 is blank by the format; simulation programs put the fourth letter of "TIP3" there.
        const std::string_view columns18to28 = pdb::columns(line, 18, 28);
        if (molecule_.residues.empty() || columns18to28 != latestResidue_ ||
            molecule_.residues.back().segment != Name(segment) || repeatsWithoutNumber(line))
            startResidue(line, columns18to28, segment);
        return static_cast<std::uint32_t>(molecule_.residues.size() - 1);
    }

    /// Numbers too large for their columns are stars; then a repeated atom name marks the next residue.
    bool repeatsWithoutNumber(std::string_view line) const {
        return pdb::column(line, 26) == '*' &&
               molecule_.atoms[molecule_.residues.back().firstAtom].name == Name(pdb::trim(pdb::columns(line, 13, 16)));
    }

    void startResidue(std::string_view line, std::string_view columns18to28, std::string_view segment) {
        endResidue();
        latestResidue_ = columns18to28;
        Residue residue;
        residue.name = pdb::trim(pdb::columns(line, 18, 21));
        // Five digits run into the column of the insertion code.
        const char code = pdb::column(line, 27);
        const bool wide = code >= '0' && code <= '9' && pdb::column(line, 23) != ' ';
        const bool wider = wide && isDigit(pdb::column(line, 28));
        const std::string_view written = pdb::columns(line, 23, wider ? 28 : wide ? 27 : 26);
        residue.number = static_cast<std::int32_t>(pdb::integer(written, 4).value_or(0));
        if (pdb::column(line, 22) == latestLetter_) residue.number = continued(residue.number, pdb::trim(written));
        residue.insertionCode = wide || code == ' ' ? '\0' : code;
        residue.segment = segment;
        const char letter = pdb::column(line, 22);
        const bool polymer = line[0] == 'A' && residueTemplate(residue.name) && !isWater(residue.name);
        std::int32_t& last = lastOfPolymer_[static_cast<unsigned char>(letter)];
        // Programs with more chains than letters begin with A again; then residue numbers repeat.
        if (polymer && letter != ' ' && letter != latestLetter_ && residue.number <= last)
            chainIndex_[static_cast<unsigned char>(letter)] = -1;
        residue.chain = residue.subchain = chooseChain(letter, segment);
        if (polymer) last = residue.number;
        latestLetter_ = letter;
        residue.firstAtom = static_cast<std::uint32_t>(molecule_.atoms.size());
        molecule_.residues.push_back(residue);
    }

    /// VMD writes numbers beyond 9999 in base 16.
    std::int32_t continued(std::int32_t number, std::string_view written) const {
        constexpr std::int32_t kMostDecimal = 9999, kLargestGap = 1000;
        const std::int32_t before = molecule_.residues.empty() ? 0 : molecule_.residues.back().number;
        std::int32_t value = 0;
        const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), value, 16);
        const bool whole = error == std::errc() && end == written.data() + written.size();
        const bool follows = before >= kMostDecimal && number < before && value > before;
        return whole && follows && value - before < kLargestGap ? value : number;
    }

    /// Without a letter, the segment is the chain.
    std::uint32_t chooseChain(char letter, std::string_view segment) {
        const bool bySegment = letter == ' ' && !segment.empty();
        int& index = bySegment ? chainOfSegment_.try_emplace(std::string(segment), -1).first->second
                               : chainIndex_[static_cast<unsigned char>(letter)];
        if (index < 0) {
            lastOfPolymer_[static_cast<unsigned char>(letter)] = INT32_MIN;
            index = static_cast<int>(molecule_.chains.size());
            molecule_.chains.push_back({bySegment       ? asciiOnly(segment)
                                        : letter == ' ' ? std::string()
                                                        : asciiOnly({&letter, 1})});
            molecule_.subchains.push_back(molecule_.chains.back().name);
        }
        return static_cast<std::uint32_t>(index);
    }

    [[noreturn]] void refuseEmpty() const {
        if (text_.empty()) cannotRead(name_, "the file is empty");
        const std::string_view head = text_.substr(0, 4096);
        const auto control = [](char c) {
            return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t';
        };
        if (std::ranges::count_if(head, control) > 0) cannotRead(name_, "it is not text, so not a PDB file");
        cannotRead(name_, "it has no ATOM or HETATM records");
    }

    Molecule finish() {
        if (models_ == 0) refuseEmpty();
        if (wanted_ > models_) {
            const std::string have =
                models_ == 1 ? "there is 1 model" : "there are " + std::to_string(models_) + " models";
            cannotRead(name_, "no model " + std::to_string(wanted_) + ": " + have);
        }
        if (leftOut_ > molecule_.atoms.size()) cannotRead(name_, fault_, lineOfFault_);
        if (molecule_.atoms.empty()) cannotRead(name_, "it has no atoms");
        endResidue();
        if (!molecule_.displacements.empty()) molecule_.displacements.resize(molecule_.atoms.size());
        addNote(molecule_.notes, ReadAction::guessed, "elements", "from atom names", guessedElements_);
        forgetOtherAtoms();
        FileSummary& file = molecule_.file;
        file.models = models_;
        file.totalAtomsAllModels = totalAtoms_;
        std::set<std::string_view> letters;
        for (const Chain& chain : molecule_.chains) letters.insert(chain.name);
        file.chains = static_cast<std::int64_t>(letters.size());
        if (remark350_.operators() > 0) file.biomtOperators = remark350_.operators();
        addNote(molecule_.notes, ReadAction::leftOut, "numbers",
                "occupancies, B factors or charges that are not numbers", unreadableNumbers_, firstUnreadableNumber_);
        conect_.resolve(serials_, molecule_);
        applySecondaryStructure(molecule_, secondary_);
        remark350_.resolve(molecule_);
        header_.resolve(molecule_);
        return std::move(molecule_);
    }

    /// CONECT records after all models name atoms of the first. A model in which such a number is a different atom gets
    /// none of their bonds.
    void forgetOtherAtoms() {
        if (firstModel_.empty() || conectInModel_) return;
        std::vector<std::int64_t> numbers;
        for (const auto& [number, identity] : firstModel_) numbers.push_back(number);
        const IdIndex index(numbers);
        for (std::size_t i = 0; i < serials_.size(); ++i) {
            std::uint32_t first = 0;
            if (index.find(serials_[i], first) != IdIndex::Found::one || firstModel_[first].second != identities_[i])
                serials_[i] = -1;
        }
    }

    static std::size_t hashAtom(std::string_view line) {
        return std::hash<std::string_view>()(pdb::columns(line, 13, 27));
    }

    const std::string& name_;
    std::string_view text_;
    LineReader lines_;
    int wanted_;
    std::size_t maxAtoms_;
    Flavour flavour_;
    pdb::ConectTable conect_;
    Molecule molecule_;
    pdb::Remark350 remark350_;
    pdb::Header header_;
    std::vector<std::int64_t> serials_;
    std::vector<std::pair<std::int64_t, std::size_t>> firstModel_;  ///< numbers and identities, if another model is
                                                                    ///< wanted
    std::vector<std::size_t> identities_;                           ///< identities of the current model's atoms
    bool conectInModel_ = false;
    std::vector<SecondaryRange> secondary_;
    std::array<int, 256> chainIndex_{};
    std::array<std::int32_t, 256> lastOfPolymer_{};  ///< number of the latest polymer residue, by the chain's letter
    char latestLetter_ = '\0';
    std::map<std::string, int> chainOfSegment_;
    Element stated_ = 0;  ///< element stated for the latest atom; 0: none
    std::int64_t guessedElements_ = 0;
    std::size_t leftOut_ = 0;  ///< number of left-out atoms; the first has this fault
    std::string fault_;
    std::uint64_t lineOfFault_ = 0;
    std::string latestResidue_;  ///< its columns 18 to 28
    std::string latestAtom_;     ///< its columns 13 to 27; empty if it was left out
    std::string inColumns_;      ///< holds the current line after a correction of columns
    bool sawModelRecord_ = false;
    std::optional<std::size_t> conectBefore_;  ///< size of conect_ at the start of the open model
    std::size_t conectOfStructure_ = 0;        ///< likewise at the start of a structure, where END separates them
    int models_ = 0;
    std::int64_t atomsInModel_ = 0;
    std::int64_t totalAtoms_ = 0;
    std::int64_t unreadableNumbers_ = 0;
    std::uint64_t firstUnreadableNumber_ = 0;
};

}  // namespace

Molecule readPdb(const std::string& name, std::string_view text, const ReadOptions& options) {
    return PdbReader(name, text, options, Flavour::pdb).read();
}

Molecule readPdbqt(const std::string& name, std::string_view text, const ReadOptions& options) {
    return PdbReader(name, text, options, Flavour::pdbqt).read();
}

}  // namespace nacre
