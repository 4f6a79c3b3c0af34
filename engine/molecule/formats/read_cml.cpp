// CML (Chemical Markup Language, schema 2 and 3): <molecule> elements with an atomArray and a bondArray. All molecules
// of a file form one model; each outermost one is a residue. Expat reads the XML as a stream, so that memory is
// proportional to the atoms; entities are refused, so that text cannot multiply itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "engine/molecule/element.h"
#include "engine/molecule/expat_parser.h"
#include "engine/molecule/formats/cell_sites.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/read.h"
#include "engine/molecule/space_group.h"
#include "engine/molecule/text.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

namespace {

constexpr int kDeepestElement = 256;
constexpr std::size_t kLongestTitle = 200;

/// Attributes in expat's form: alternating names and values.
class Attributes {
public:
    explicit Attributes(const XML_Char** list) : list_(list) {}

    /// Empty if missing.
    std::string_view operator[](std::string_view name) const {
        for (const XML_Char** at = list_; *at; at += 2)
            if (name == *at) return at[1];
        return {};
    }

private:
    const XML_Char** list_;
};

/// Cuts the first word off.
std::string_view nextWord(std::string_view& text) {
    text = trim(text);
    const std::string_view word = text.substr(0, text.find_first_of(" \t\n\r"));
    text.remove_prefix(word.size());
    return word;
}

struct CmlAtom {
    std::string_view id, element, x, y, z, charge;
    bool fractional = false;
};

/// An atom that waits for its crystal's cell and symmetry, which may follow it.
struct PendingAtom {
    Atom atom;  ///< its position may be fractional
    bool fractional;
};

struct CmlBond {
    std::uint32_t a, b;  ///< indices into CmlReader::atomOfId_
    std::uint8_t order;
    std::uint32_t line;
};

class CmlReader {
public:
    CmlReader(const std::string& name, std::size_t maxAtoms)
        : name_(name), maxAtoms_(maxAtoms), builder_(name, maxAtoms), parser_(this) {
        XML_SetElementHandler(parser_.get(), onStart, onEnd);
        XML_SetCharacterDataHandler(parser_.get(), onText);
        XML_SetEntityDeclHandler(parser_.get(), onEntity);
    }

    Molecule run(std::string_view text) {
        if (const std::string why = parser_.parse(text, true); !why.empty()) fail("not valid XML: " + why);
        FileSummary& file = builder_.molecule().file;
        file.format = "cml";
        file.records = molecules_;
        file.bonds = bondCount_;
        if (flat_ > 0) builder_.warn("atoms with coordinates in two dimensions only: " + std::to_string(flat_));
        if (oddOrders_ > 0) builder_.warn("bonds of unknown order, read as single: " + std::to_string(oddOrders_));
        return builder_.finish();
    }

private:
    [[noreturn]] void fail(const std::string& why) const { cannotRead(name_, why, parser_.line()); }

    template <typename Work>
    static void guarded(void* user, Work work) {
        CmlReader& reader = *static_cast<CmlReader*>(user);
        reader.parser_.guard([&] { work(reader); });
    }
    static void XMLCALL onStart(void* user, const XML_Char* name, const XML_Char** attributes) {
        guarded(user, [&](CmlReader& reader) { reader.start(name, Attributes(attributes)); });
    }
    static void XMLCALL onEnd(void* user, const XML_Char* name) {
        guarded(user, [&](CmlReader& reader) { reader.end(name); });
    }
    static void XMLCALL onText(void* user, const XML_Char* text, int length) {
        guarded(user, [&](CmlReader& reader) { reader.text({text, static_cast<std::size_t>(length)}); });
    }
    static void XMLCALL onEntity(void* user, const XML_Char*, int, const XML_Char*, int, const XML_Char*,
                                 const XML_Char*, const XML_Char*, const XML_Char*) {
        guarded(user, [](CmlReader& reader) { reader.fail("it declares XML entities, which are not supported"); });
    }

    static std::string_view withoutPrefix(std::string_view name) { return name.substr(name.find(':') + 1); }

    void start(std::string_view qualified, const Attributes& attributes) {
        const std::string_view name = withoutPrefix(qualified);
        if (++depth_ > kDeepestElement)
            fail("its elements are nested more than " + std::to_string(kDeepestElement) + " deep");
        inName_ = name == "name" && moleculeDepth_ > 0 && nameText_.empty();
        inParameter_ = name == "cellParameter";
        cellScalar_ = name == "scalar"                         ? findCellScalar(attributes)
                      : !inParameter_                          ? kNoScalar
                      : attributes["parameterType"] == "angle" ? 3
                                                               : 0;
        if (cellScalar_ != kNoScalar) cell_[cellScalar_].clear();         // of an earlier crystal
        if (name == "crystal") spaceGroup_.clear(), operations_.clear();  // of an earlier crystal
        if (name == "symmetry") {
            spaceGroup_ = attributes["spaceGroup"].substr(0, kLongestScalar);
            operations_.clear();
        }
        inOperation_ = name == "transform3";
        if (inOperation_) operation_.clear();
        if (name == "molecule") {
            ++molecules_;
            if (++moleculeDepth_ == 1) ++outermost_;
            if (title_.empty()) title_ = attributes["title"].substr(0, kLongestTitle);
        } else if (moleculeDepth_ == 0) {
            if (name == "cml") title_ = attributes["title"].substr(0, kLongestTitle);
        } else if (name == "atom") {
            const bool fractional = attributes["x3"].empty() && !attributes["xFract"].empty();
            const auto at = [&](const char* solid, const char* flat, const char* fraction) {
                return fractional ? attributes[fraction] : coordinate(attributes, solid, flat);
            };
            addAtom({attributes["id"], attributes["elementType"], at("x3", "x2", "xFract"), at("y3", "y2", "yFract"),
                     at("z3", "", "zFract"), attributes["formalCharge"], fractional});
        } else if (name == "atomArray" && !attributes["atomID"].empty()) {
            addAtomArray(attributes);
        } else if (name == "bond") {
            addBond(attributes);
        } else if (name == "bondArray" && !bondEnds(attributes, 1).empty()) {
            addBondArray(attributes);
        }
    }

    void end(std::string_view qualified) {
        --depth_;
        if (std::exchange(inParameter_, false)) divideParameter();
        cellScalar_ = kNoScalar;
        if (std::exchange(inOperation_, false)) addOperation();
        inName_ = false;
        if (withoutPrefix(qualified) == "molecule" && --moleculeDepth_ == 0) finishMolecule();
    }

    /// Which cell parameter a scalar of <crystal> is; in "cml:a" or "iucr:_cell_angle_alpha" the end decides.
    static std::size_t findCellScalar(const Attributes& attributes) {
        static constexpr std::string_view kScalars[] = {"a", "b", "c", "alpha", "beta", "gamma"};
        std::string_view name = attributes["title"].empty() ? attributes["dictRef"] : attributes["title"];
        name = name.substr(name.find_last_of(":_") + 1);
        return static_cast<std::size_t>(std::ranges::find(kScalars, name) - std::begin(kScalars));
    }

    /// "<cellParameter parameterType="length">4 5 6</cellParameter>" is three numbers.
    void divideParameter() {
        const std::string text = cell_[cellScalar_];
        const Words words = splitWords(text);
        for (std::size_t i = 0; i < 3; ++i) cell_[cellScalar_ + i] = words[i];
    }

    /// Three rows of a rotation and a shift, in fractional coordinates; possibly a fourth row.
    void addOperation() {
        const std::vector<std::string_view> words = splitAllWords(operation_);
        gemmi::Op operation{};
        bool usable = (words.size() == 12 || words.size() == 16) && operations_.size() < kMostOperations;
        for (std::size_t i = 0; usable && i < 12; ++i) {
            constexpr double kLargest = 10, kTolerance = 0.02;  // 0.333 is a third
            const double value = parseNumber(words[i]).value_or(HUGE_VAL) * gemmi::Op::DEN;
            usable = std::abs(value) <= kLargest * gemmi::Op::DEN && std::abs(value - std::round(value)) <= kTolerance;
            if (!usable) break;
            const int whole = static_cast<int>(std::lround(value));
            (i % 4 == 3 ? operation.tran[i / 4] : operation.rot[i / 4][i % 4]) = whole;
        }
        if (usable)
            operations_.push_back(operation);
        else
            builder_.leaveOut("symmetry operations", "not of a space group", parser_.line());
    }

    /// The crystal's operations: those that it lists, or its space group's; empty if it states neither.
    std::vector<gemmi::Op> symmetry() {
        std::vector<gemmi::Op> operations = operations_;
        const gemmi::SpaceGroup* group = spaceGroup_.empty() ? nullptr : findSpaceGroup(spaceGroup_);
        if (operations.empty() && group)
            for (const gemmi::Op operation : group->operations()) operations.push_back(operation);
        if (operations.empty() && !spaceGroup_.empty())
            builder_.leaveOut("space groups", "the name is not known", parser_.line());
        const gemmi::Op identity = gemmi::parse_triplet("x,y,z");
        if (!operations.empty() && std::find(operations.begin(), operations.end(), identity) == operations.end())
            operations.insert(operations.begin(), identity);
        return operations;
    }

    /// Prefix of a later molecule's subchains: the symmetry of an earlier crystal does not apply to it.
    std::string subchainPrefix(bool symmetric) {
        const bool apart = outermost_ > 1 && (symmetric || builder_.molecule().file.cell);
        return apart ? std::to_string(outermost_) + " " : std::string();
    }

    /// Places atoms of a molecule, whose cell and symmetry may follow them.
    void placeAtoms() {
        if (std::none_of(atoms_.begin(), atoms_.end(), [](const PendingAtom& a) { return a.fractional; })) {
            const std::string prefix = subchainPrefix(false);
            for (const PendingAtom& pending : atoms_) builder_.addAtom(pending.atom, "", outermost_, '\0', "", prefix);
            atoms_.clear();
            return;
        }
        std::array<double, 6> cell{};
        for (std::size_t i = 0; i < cell.size(); ++i) cell[i] = parseNumber(cell_[i]).value_or(0);
        const auto box = makeBox({cell[0], cell[1], cell[2]}, {cell[3], cell[4], cell[5]});
        if (!box) fail("it has fractional coordinates and no unit cell");
        const std::vector<gemmi::Op> operations = symmetry();
        const std::string prefix = subchainPrefix(operations.size() > 1);
        CellSites sites({cell[0], cell[1], cell[2], cell[3], cell[4], cell[5]}, operations, prefix);
        for (PendingAtom& pending : atoms_) {
            glm::vec3& p = pending.atom.position;
            const glm::dvec3 at(p);
            if (pending.fractional) p = (*box)[0] * p.x + (*box)[1] * p.y + (*box)[2] * p.z;
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::abs(static_cast<double>(p[axis])) <= kFarthestCoordinate))
                    fail("an atom is not within 1e9 Å");
            const std::string site =
                pending.fractional && operations.size() > 1 ? sites.add({at.x, at.y, at.z}) : prefix;
            builder_.addAtom(pending.atom, "", outermost_, '\0', "", site);
        }
        atoms_.clear();
        if (operations.size() < 2) return builder_.takeCell(*box);
        builder_.molecule().file.cell = cell;
        builder_.molecule().file.spaceGroup = printable(spaceGroup_);
        sites.addUnitCell(builder_);
    }

    void text(std::string_view piece) {
        if (cellScalar_ != kNoScalar && cell_[cellScalar_].size() < kLongestScalar)
            cell_[cellScalar_] += piece.substr(0, kLongestScalar);
        if (inOperation_ && operation_.size() < kLongestOperation) operation_ += piece.substr(0, kLongestOperation);
        if (inName_ && title_.size() < kLongestTitle) nameText_ += piece.substr(0, kLongestTitle);
        if (nameText_.size() > kLongestTitle) inName_ = false;
    }

    /// The attribute of three dimensions, else that of two.
    static std::string_view coordinate(const Attributes& attributes, std::string_view solid, std::string_view flat) {
        const bool isSolid = !attributes["x3"].empty();
        return isSolid ? attributes[solid] : flat.empty() ? std::string_view() : attributes[flat];
    }

    void addAtom(const CmlAtom& given) {
        if (given.x.empty()) {
            idIndex(given.id);  // its bonds are left out as well
            return builder_.leaveOutAtom("atom '" + printable(given.id) + "' has no coordinates", parser_.line());
        }
        const bool flat = given.z.empty();
        const auto position = builder_.position({given.x, given.y, flat ? "0" : given.z}, parser_.line());
        if (!position) {
            idIndex(given.id);
            return;
        }
        flat_ += flat;
        Atom atom;
        atom.position = *position;
        atom.element = builder_.element(given.element, parser_.line());
        atom.name = Name(atom.element != 0 ? elementSymbol(atom.element) : given.element);
        if (!given.charge.empty()) {
            const auto charge = parseInteger(given.charge);
            if (charge && *charge >= -20 && *charge <= 20)
                atom.charge = static_cast<std::int8_t>(*charge);
            else
                builder_.leaveOut("formal charges", "not usable", parser_.line());
        }
        const std::size_t index = builder_.molecule().atoms.size() + atoms_.size();
        if (index >= maxAtoms_) throw tooManyAtoms(name_, maxAtoms_);
        atoms_.push_back({atom, given.fractional});
        if (given.id.empty()) return;
        std::uint32_t& known = atomOfId_[idIndex(given.id)];
        if (known != kNoAtom) fail("two atoms are called '" + printable(given.id) + "'");
        known = static_cast<std::uint32_t>(index);
    }

    /// Adds atoms given as lists of words in the array's own attributes.
    void addAtomArray(const Attributes& attributes) {
        const bool solid = !attributes["x3"].empty(), fractional = !solid && !attributes["xFract"].empty();
        std::string_view ids = attributes["atomID"], elements = attributes["elementType"];
        std::string_view xs = attributes[solid        ? "x3"
                                         : fractional ? "xFract"
                                                      : "x2"],
                         ys = attributes[solid        ? "y3"
                                         : fractional ? "yFract"
                                                      : "y2"];
        std::string_view zs = attributes[solid ? "z3" : "zFract"], charges = attributes["formalCharge"];
        while (!trim(ids).empty()) {
            const std::string_view id = nextWord(ids), element = nextWord(elements);
            const std::string_view x = nextWord(xs), y = nextWord(ys);
            addAtom({id, element, x, y, nextWord(zs), nextWord(charges), fractional});
        }
    }

    void addBond(const Attributes& attributes) {
        std::string_view pair;
        for (const char* name :
             {"atomRefs2", "atomsRefs2", "atomRefs"})  // the first is CML's; the others occur as well
            if (pair.empty()) pair = attributes[name];
        std::string_view a = nextWord(pair), b = nextWord(pair);
        if (b.empty()) {  // one attribute per atom
            a = bondEnds(attributes, 1);
            b = bondEnds(attributes, 2);
        }
        addBond(a, b, attributes["order"]);
    }

    /// The first or second atoms of bonds. Some programs use the plural name for a single one.
    static std::string_view bondEnds(const Attributes& attributes, int which) {
        const std::string_view one = attributes[which == 1 ? "atomRef1" : "atomRef2"];
        return one.empty() ? attributes[which == 1 ? "atomRefs1" : "atomRefs2"] : one;
    }

    void addBondArray(const Attributes& attributes) {
        std::string_view as = bondEnds(attributes, 1), bs = bondEnds(attributes, 2), orders = attributes["order"];
        while (!trim(as).empty()) {
            const std::string_view a = nextWord(as), b = nextWord(bs);
            addBond(a, b, nextWord(orders));
        }
    }

    void addBond(std::string_view a, std::string_view b, std::string_view order) {
        if (a.empty() || b.empty()) fail("a bond needs two atoms");
        ++bondCount_;
        if (pending_.size() >= builder_.mostBonds()) fail("it has more bonds than its atoms could form");
        pending_.push_back({idIndex(a), idIndex(b), static_cast<std::uint8_t>(parseOrder(order)),
                            static_cast<std::uint32_t>(parser_.line())});
    }

    /// Names are stored once, whether an atom or a bond mentions them first.
    std::uint32_t idIndex(std::string_view id) {
        const auto known = indexOfId_.find(id);
        if (known != indexOfId_.end()) return known->second;
        if (indexOfId_.size() == maxAtoms_) throw tooManyAtoms(name_, maxAtoms_);
        atomOfId_.push_back(kNoAtom);
        return indexOfId_.emplace(id, static_cast<std::uint32_t>(indexOfId_.size())).first->second;
    }

    int parseOrder(std::string_view order) {
        if (order.empty() || order == "1" || order == "S") return 1;
        if (order == "2" || order == "D") return 2;
        if (order == "3" || order == "T") return 3;
        if (order == "A" || order == "1.5") return 4;
        ++oddOrders_;
        return 1;
    }

    /// Bonds may precede their atoms, so they wait for the end of the molecule.
    void finishMolecule() {
        placeAtoms();
        for (const CmlBond& bond : pending_) {
            const std::uint32_t a = atomOfId_[bond.a], b = atomOfId_[bond.b];
            if (a == kNoAtom || b == kNoAtom)
                builder_.leaveOut("bonds", "of atoms that are not there", bond.line);
            else
                builder_.addBond(a, b, bond.order, bond.line);
        }
        pending_.clear();
        indexOfId_.clear();
        atomOfId_.clear();
        std::string& title = builder_.molecule().file.title;
        if (title.empty()) title = printable(trim(title_.empty() ? nameText_ : title_), kLongestTitle);
    }

    const std::string& name_;
    std::size_t maxAtoms_;
    MoleculeBuilder builder_;
    ExpatParser parser_;
    int depth_ = 0, moleculeDepth_ = 0;
    std::int64_t molecules_ = 0, bondCount_ = 0;
    std::int32_t outermost_ = 0;
    bool inName_ = false;
    std::string title_, nameText_;
    static constexpr std::uint32_t kNoAtom = ~0u;
    std::map<std::string, std::uint32_t, std::less<>> indexOfId_;  // no hash that a file could aim at
    std::vector<std::uint32_t> atomOfId_;                          ///< kNoAtom until the atom comes
    std::vector<CmlBond> pending_;
    static constexpr std::size_t kNoScalar = 6, kLongestScalar = 120, kLongestOperation = 1000, kMostOperations = 192;
    std::size_t cellScalar_ = kNoScalar;  ///< index of the scalar being read
    std::array<std::string, 6> cell_;     ///< three lengths, Å, and three angles, degrees
    std::string spaceGroup_, operation_;
    std::vector<gemmi::Op> operations_;  ///< of the crystal
    bool inOperation_ = false, inParameter_ = false;
    std::vector<PendingAtom> atoms_;  ///< of the outermost molecule
    std::size_t flat_ = 0, oddOrders_ = 0;
};

}  // namespace

Molecule readCml(const std::string& name, std::string_view text, const ReadOptions& options) {
    if (options.model > 1)
        cannotRead(name, "there is no model " + std::to_string(options.model) +
                             "; the molecules of a CML file are read as one");
    return CmlReader(name, options.maxAtoms).run(text);
}

}  // namespace nacre
