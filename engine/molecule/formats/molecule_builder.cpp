#include "engine/molecule/formats/molecule_builder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "engine/molecule/element.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

/// A crystal's cell and those around it.
Assembly neighbourCells(const Molecule& molecule) {
    AssemblyPart part;
    for (std::uint32_t i = 0; i < molecule.subchains.size(); ++i) part.subchains.push_back(i);
    const auto& edges = *molecule.file.box;
    const auto& repeats = molecule.file.boxRepeats;
    for (const int a : {0, -1, 1})
        for (const int b : {0, -1, 1})
            for (const int c : {0, -1, 1}) {
                if ((a != 0 && !repeats[0]) || (b != 0 && !repeats[1]) || (c != 0 && !repeats[2])) continue;
                glm::mat4x3 shift(1.0f);
                shift[3] = static_cast<float>(a) * edges[0] + static_cast<float>(b) * edges[1] +
                           static_cast<float>(c) * edges[2];
                part.transforms.push_back(shift);
            }
    const auto times = [&](std::size_t axis) { return repeats[axis] ? "3" : "1"; };
    return {std::string(times(0)) + "x" + times(1) + "x" + times(2), "the cell and its neighbours", {part}};
}

constexpr std::size_t kMaxWarningsOfReader = 20;
// A file may state a name once and refer to it from every atom, and each atom compares it with the previous one's.
constexpr std::size_t kLongestChainName = 64;

}  // namespace

void MoleculeBuilder::addAtom(Atom atom, std::string_view chain, std::int32_t number, char insertionCode,
                              std::string_view residue, std::string_view subchain) {
    if (!subchain.data()) subchain = chain;
    if (molecule_.atoms.size() >= maxAtoms_) throw tooManyAtoms(name_, maxAtoms_);
    if (chain.size() > kLongestChainName || subchain.size() > kLongestChainName)
        cannotRead(name_, "the name of a chain is longer than " + std::to_string(kLongestChainName) + " bytes");
    const Name residueName(residue);
    const auto continues = [&](const Residue& last) {
        return last.number == number && last.insertionCode == insertionCode && last.name == residueName &&
               molecule_.chains[last.chain].name == chain && molecule_.subchains[last.subchain] == subchain;
    };
    if (molecule_.residues.empty() || !continues(molecule_.residues.back())) {
        Residue next;
        next.name = residueName;
        next.number = next.labelNumber = number;
        next.insertionCode = insertionCode;
        next.chain = chainIndex(chain);
        next.subchain = subchainIndex(subchain);
        next.firstAtom = static_cast<std::uint32_t>(molecule_.atoms.size());
        molecule_.residues.push_back(next);
    }
    ++molecule_.residues.back().atomCount;
    atom.residue = static_cast<std::uint32_t>(molecule_.residues.size() - 1);
    molecule_.atoms.push_back(atom);
}

std::uint32_t MoleculeBuilder::chainIndex(std::string_view chain) {
    if (!molecule_.residues.empty()) {
        const std::uint32_t last = molecule_.residues.back().chain;
        if (molecule_.chains[last].name == chain) return last;
    }
    const auto [found, added] = chains_.emplace(chain, static_cast<std::uint32_t>(molecule_.chains.size()));
    if (added) molecule_.chains.push_back({std::string(chain)});
    return found->second;
}

std::uint32_t MoleculeBuilder::subchainIndex(std::string_view subchain) {
    const auto [found, added] = subchains_.emplace(subchain, static_cast<std::uint32_t>(molecule_.subchains.size()));
    if (added) molecule_.subchains.emplace_back(subchain);
    return found->second;
}

std::optional<std::uint32_t> MoleculeBuilder::subchain(std::string_view name) const {
    const auto found = subchains_.find(name);
    return found == subchains_.end() ? std::nullopt : std::optional<std::uint32_t>(found->second);
}

void MoleculeBuilder::addBond(std::int64_t a, std::int64_t b, int order, std::uint64_t line) {
    const auto count = static_cast<std::int64_t>(molecule_.atoms.size());
    if (a < 0 || b < 0 || a >= count || b >= count) return leaveOut("bonds", "of atoms that are not there", line);
    if (a == b) return leaveOut("bonds", "of an atom to itself", line);
    if (molecule_.bonds.size() >= mostBonds()) cannotRead(name_, "it has more bonds than its atoms could form", line);
    Bond bond;
    bond.a = static_cast<std::uint32_t>(std::min(a, b));
    bond.b = static_cast<std::uint32_t>(std::max(a, b));
    bond.order = static_cast<std::uint8_t>(order);
    bond.source = BondSource::file;
    molecule_.bonds.push_back(bond);
}

Element MoleculeBuilder::element(std::string_view symbol, std::uint64_t line) {
    symbol = trim(symbol);
    if (const auto number = parseInteger(symbol); number && *number >= 1 && *number <= 118)
        return static_cast<Element>(*number);
    std::size_t letters = 0;
    while (letters < symbol.size() && isLetter(symbol[letters])) ++letters;
    // A file may append the charge or its own numbering to the letters, but nothing else.
    const bool usual = symbol.find_first_not_of("0123456789+-", letters) == std::string_view::npos;
    const std::string_view bare = symbol.substr(0, letters);
    if (usual && (bare == "T" || bare == "t")) return 1;  // tritium
    const Element known = usual ? elementFromSymbol(bare) : Element{0};
    if (known == 0 && unknownElements_++ == 0) {
        firstUnknown_ = "'" + printable(symbol, 16) + "'";
        if (line > 0) firstUnknown_ += " in line " + std::to_string(line);
    }
    return known;
}

void MoleculeBuilder::warn(const std::string& sentence) {
    if (molecule_.warnings.size() < kMaxWarningsOfReader)
        molecule_.warnings.push_back(sentence);
    else
        ++warningsLeftOut_;
}

std::optional<float> MoleculeBuilder::coordinate(std::string_view text, char axis, std::uint64_t line, double scale) {
    const auto value = parseNumber(text);
    if (value && std::abs(*value * scale) <= kFarthestCoordinate)  // false for NaN
        return static_cast<float>(*value * scale);
    const std::string shown = printable(trim(text));
    std::string why = std::string(shown.empty() ? "missing " : "invalid ") + axis + " coordinate";
    if (!shown.empty()) why += " '" + shown + "'";
    if (value && std::isfinite(*value)) why += ", which is not within 1e9 Å";
    leaveOutAtom(why, line);
    return std::nullopt;
}

std::optional<glm::vec3> MoleculeBuilder::position(const std::array<std::string_view, 3>& axes, std::uint64_t line,
                                                   double scale) {
    glm::vec3 position;
    for (int axis = 0; axis < 3; ++axis) {
        const auto value = coordinate(axes[static_cast<std::size_t>(axis)], "xyz"[axis], line, scale);
        if (!value) return std::nullopt;
        position[axis] = *value;
    }
    return position;
}

std::optional<glm::vec3> MoleculeBuilder::computedPosition(const glm::dvec3& position, std::uint64_t line) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(position[axis]) <= kFarthestCoordinate) continue;  // false for NaN
        leaveOutAtom("the atom is not within 1e9 Å", line);
        return std::nullopt;
    }
    return glm::vec3(position);
}

void MoleculeBuilder::compareCount(const char* what, std::int64_t announced, std::int64_t found, std::uint64_t line) {
    if (announced > found)
        addNote(molecule_.notes, ReadAction::leftOut, what, "announced by the header and not there", announced - found,
                line);
    else if (announced < found)
        warn("the header announces " + std::to_string(announced) + " " + what + ", and the file has " +
             std::to_string(found));
}

void MoleculeBuilder::takeBox(const std::array<glm::vec3, 3>& box, const glm::vec3& origin, std::uint64_t line) {
    constexpr double kLeastVolume = 1e-6;  // Å^3
    const glm::dvec3 a(box[0]), b(box[1]), c(box[2]);
    if (box == std::array<glm::vec3, 3>{}) return;  // there is none
    if (!(std::abs(glm::dot(a, glm::cross(b, c))) > kLeastVolume))
        return leaveOut("periodic boxes", "without volume", line);
    molecule_.file.box = box;
    molecule_.file.boxOrigin = origin;
}

void MoleculeBuilder::leaveOutAtom(const std::string& why, std::uint64_t line) {
    if (unplaced_++ == 0) firstUnplaced_ = why, lineOfUnplaced_ = line;
    leaveOut("atoms", "no usable coordinates", line);
    leftOutRecords_.push_back(static_cast<std::uint32_t>(molecule_.atoms.size() + leftOutRecords_.size()));
}

std::int64_t MoleculeBuilder::atomOfRecord(std::int64_t record) const {
    const auto before = std::lower_bound(leftOutRecords_.begin(), leftOutRecords_.end(), record);
    const std::int64_t atom = record - (before - leftOutRecords_.begin());
    const bool leftOut = before != leftOutRecords_.end() && *before == record;
    return leftOut || atom < 0 || atom >= static_cast<std::int64_t>(molecule_.atoms.size()) ? -1 : atom;
}

Molecule MoleculeBuilder::finish() {
    if (unplaced_ > molecule_.atoms.size()) cannotRead(name_, firstUnplaced_, lineOfUnplaced_);
    if (molecule_.atoms.empty()) cannotRead(name_, "it has no atoms");
    if (repeats_ && molecule_.file.box) molecule_.assemblies.push_back(neighbourCells(molecule_));
    if (unknownElements_ > 0)
        warn("atoms of unknown element: " + std::to_string(unknownElements_) + ", the first " + firstUnknown_);
    auto& bonds = molecule_.bonds;
    const auto before = [](const Bond& x, const Bond& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); };
    const auto same = [](const Bond& x, const Bond& y) { return x.a == y.a && x.b == y.b; };
    std::stable_sort(bonds.begin(), bonds.end(), before);
    const auto end = std::unique(bonds.begin(), bonds.end(), same);
    if (end != bonds.end()) warn("bonds stated more than once: " + std::to_string(bonds.end() - end));
    bonds.erase(end, bonds.end());
    if (bonds.size() > kMostBondsPerAtom * molecule_.atoms.size())
        cannotRead(name_, "it has more bonds than its atoms could form");
    if (warningsLeftOut_ > 0) molecule_.warnings.push_back("and " + std::to_string(warningsLeftOut_) + " more");
    return std::move(molecule_);
}

void requireModel(const std::string& name, std::int64_t wanted, std::int64_t have) {
    if (wanted > have)
        cannotRead(name, "there is no model " + std::to_string(wanted) + "; the file has " + std::to_string(have));
}

}  // namespace nacre
