#include "app/mvs/expressions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/molecule/near_atoms.h"
#include "engine/molecule/text.h"
#include "engine/scene/build/carbohydrates.h"

namespace nacre::app::mvs {
namespace {

using GetText = std::optional<std::string> Expression::*;
using IntegerField = std::optional<std::int64_t> Expression::*;

struct TextField {
    std::string_view name;
    GetText field;
};
struct NumberField {
    std::string_view name;
    IntegerField field;
};
constexpr TextField kTexts[] = {
    {"label_entity_id", &Expression::labelEntity}, {"label_asym_id", &Expression::labelChain},
    {"auth_asym_id", &Expression::authChain},      {"pdbx_PDB_ins_code", &Expression::insertion},
    {"label_atom_id", &Expression::labelAtom},     {"auth_atom_id", &Expression::authAtom},
    {"type_symbol", &Expression::element},         {"label_comp_id", &Expression::component},
    {"auth_comp_id", &Expression::component},      {"instance_id", &Expression::instance}};
constexpr NumberField kNumbers[] = {
    {"label_seq_id", &Expression::label},         {"auth_seq_id", &Expression::auth},
    {"beg_label_seq_id", &Expression::fromLabel}, {"end_label_seq_id", &Expression::toLabel},
    {"beg_auth_seq_id", &Expression::fromAuth},   {"end_auth_seq_id", &Expression::toAuth},
    {"residue_index", &Expression::residueIndex}, {"atom_id", &Expression::atomId},
    {"atom_index", &Expression::atomIndex}};

std::int64_t readWholeNumber(const Json& value) {
    if (value.is_number_integer()) return value.get<std::int64_t>();
    if (value.is_number() && std::abs(value.get<double>()) < 1e15 &&
        std::trunc(value.get<double>()) == value.get<double>())
        return static_cast<std::int64_t>(value.get<double>());
    if (value.is_string())
        if (const auto number = parseInteger(value.get<std::string>())) return *number;
    throw std::invalid_argument("a whole number is needed, not " + nacre::printable(value.dump(-1, ' ', true)));
}

bool equal(const std::optional<std::int64_t>& wanted, std::int64_t value) { return !wanted || *wanted == value; }
bool within(const std::optional<std::int64_t>& from, const std::optional<std::int64_t>& to, std::int64_t value) {
    return (!from || *from <= value) && (!to || value <= *to);
}

}  // namespace

bool Expression::empty() const {
    const auto given = [&](const auto& field) { return (this->*field.field).has_value(); };
    return std::ranges::none_of(kTexts, given) && std::ranges::none_of(kNumbers, given);
}

bool setField(Expression& expression, std::string_view field, const Json& value) {
    for (const TextField& text : kTexts) {
        if (text.name != field) continue;
        if (value.is_null()) return true;
        if (!value.is_string() && !value.is_number_integer()) throw std::invalid_argument("a text is needed");
        expression.*text.field = value.is_string() ? value.get<std::string>() : value.dump();
        return true;
    }
    for (const NumberField& number : kNumbers) {
        if (number.name != field) continue;
        if (!value.is_null()) expression.*number.field = readWholeNumber(value);
        return true;
    }
    return false;
}

const std::vector<std::string_view>* fieldsOfSchema(std::string_view schema) {
    using Fields = std::vector<std::string_view>;
    static const std::map<std::string_view, Fields> kSchemas{
        {"whole_structure", {}},
        {"entity", {"label_entity_id"}},
        {"chain", {"label_entity_id", "label_asym_id"}},
        {"auth_chain", {"auth_asym_id"}},
        {"residue", {"label_entity_id", "label_asym_id", "label_seq_id", "residue_index"}},
        {"auth_residue", {"auth_asym_id", "auth_seq_id", "pdbx_PDB_ins_code", "residue_index"}},
        {"residue_range", {"label_entity_id", "label_asym_id", "beg_label_seq_id", "end_label_seq_id"}},
        {"auth_residue_range", {"auth_asym_id", "beg_auth_seq_id", "end_auth_seq_id"}},
        {"atom",
         {"label_entity_id", "label_asym_id", "label_seq_id", "residue_index", "label_atom_id", "type_symbol",
          "atom_id", "atom_index"}},
        {"auth_atom",
         {"auth_asym_id", "auth_seq_id", "pdbx_PDB_ins_code", "residue_index", "auth_atom_id", "type_symbol", "atom_id",
          "atom_index"}},
        {"all_atomic",
         {"label_entity_id", "label_asym_id", "auth_asym_id", "label_seq_id", "auth_seq_id", "pdbx_PDB_ins_code",
          "beg_label_seq_id", "end_label_seq_id", "beg_auth_seq_id", "end_auth_seq_id", "residue_index",
          "label_comp_id", "auth_comp_id", "label_atom_id", "auth_atom_id", "type_symbol", "atom_id", "atom_index",
          "instance_id"}}};
    const auto found = kSchemas.find(schema);
    return found == kSchemas.end() ? nullptr : &found->second;
}

StructureAtoms::StructureAtoms(const Molecule& molecule, std::vector<std::set<std::string>> instances)
    : facts_(molecule),
      instances_(std::move(instances)),
      drawn_(drawnAtoms(molecule, {.water = true, .hydrogens = true})) {
    for (std::uint32_t i = 0; i < molecule.residues.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        ofAuthChain_[molecule.chains[residue.chain].name].push_back(i);
        const bool named = residue.subchain < molecule.subchains.size();
        ofLabelChain_[named ? molecule.subchains[residue.subchain] : molecule.chains[residue.chain].name].push_back(i);
    }
}

bool StructureAtoms::fits(const Expression& e, const Residue& residue, std::uint32_t index) const {
    const Molecule& m = molecule();
    const std::size_t ofGroup = m.residues.size() / instances_.size();
    if (e.instance && !instances_[index / ofGroup].contains(*e.instance)) return false;
    if (e.labelChain && e.authChain && m.chains[residue.chain].name != *e.authChain) return false;
    if (e.labelEntity && (residue.entity == 0 || m.entities[residue.entity - 1] != *e.labelEntity)) return false;
    if (e.component && residue.name.view() != *e.component) return false;
    // If the file states no sequence numbers, the authors' numbers are used instead, as in Mol*.
    const bool places = m.file.chainsLabel.has_value();
    if (e.label || e.fromLabel || e.toLabel) {
        if (places && residue.labelNumber == kNoLabelNumber) return false;
        const std::int64_t place = places ? residue.labelNumber : residue.number;
        if (!equal(e.label, place) || !within(e.fromLabel, e.toLabel, place)) return false;
    }
    if (!equal(e.auth, residue.number) || !within(e.fromAuth, e.toAuth, residue.number)) return false;
    if (e.insertion && *e.insertion != (residue.insertionCode ? std::string(1, residue.insertionCode) : ""))
        return false;
    return equal(e.residueIndex, static_cast<std::int64_t>(index % ofGroup));
}

bool StructureAtoms::fits(const Expression& e, std::uint32_t index) const {
    const Atom& atom = molecule().atoms[index];
    if (e.labelAtom && atom.name.view() != *e.labelAtom) return false;
    if (e.authAtom && atom.name.view() != *e.authAtom) return false;
    if (e.element && upperCase(elementSymbol(atom.element)) != upperCase(*e.element)) return false;
    const std::size_t inFile = index % (molecule().atoms.size() / instances_.size());
    if (!equal(e.atomIndex, static_cast<std::int64_t>(inFile))) return false;
    if (!e.atomId) return true;
    const std::vector<std::int32_t>& serials = molecule().serials;
    return *e.atomId == (serials.empty() ? static_cast<std::int64_t>(inFile) + 1 : serials[inFile]);
}

void StructureAtoms::add(const Expression& e, std::vector<bool>& atoms) {
    constexpr std::uint64_t kMostVisits = 2'000'000'000;
    const Molecule& m = molecule();
    const auto visit = [&](std::uint32_t i) {
        const Residue& residue = m.residues[i];
        if (!fits(e, residue, i)) return;
        const bool whole = !e.ofAtoms();
        for (std::uint32_t k = residue.firstAtom; k < residue.firstAtom + residue.atomCount; ++k)
            if (whole || fits(e, k)) atoms[k] = true;
        visits_ += residue.atomCount;
    };
    const auto* chains = e.labelChain ? &ofLabelChain_ : e.authChain ? &ofAuthChain_ : nullptr;
    if (chains) {
        const auto found = chains->find(e.labelChain ? *e.labelChain : *e.authChain);
        if (found == chains->end()) return;
        visits_ += found->second.size();
        for (const std::uint32_t i : found->second) visit(i);
    } else {
        visits_ += m.residues.size();
        for (std::uint32_t i = 0; i < m.residues.size(); ++i) visit(i);
    }
    if (visits_ > kMostVisits)
        throw Error("cannot draw scene", m.file.title, "its selectors and annotations name too many residues");
}

namespace {

/// Non-polymers that are sugars count: old files and PDB files state no branched entities.
bool isBranched(const Residue& residue) {
    const bool free = residue.entityKind == EntityKind::unknown || residue.entityKind == EntityKind::nonPolymer;
    return residue.entityKind == EntityKind::branched || (free && sugarSymbol(residue.name));
}

}  // namespace

/// Adds the residues that are bonded to atoms of a set: to a ligand also by metals, and no sugars.
void StructureAtoms::addBonded(bool toLigand, std::vector<bool>& atoms) const {
    constexpr double kCoordination = 2.7;  // Å
    const Molecule& m = molecule();
    std::set<std::uint32_t> bonded;
    const auto add = [&](std::uint32_t atom) {
        const std::uint32_t residue = m.atoms[atom].residue;
        if (!atoms[atom] && !(toLigand && isBranched(m.residues[residue]))) bonded.insert(residue);
    };
    const auto isMetalAtom = [&](std::size_t atom) { return isMetal(m.atoms[atom].element); };
    const auto isDonor = [&](std::size_t atom) {
        const Element e = m.atoms[atom].element;
        return e == 7 || e == 8 || e == 16;
    };
    for (const Bond& bond : m.bonds)
        if (atoms[bond.a] != atoms[bond.b] && (toLigand || (!isMetalAtom(bond.a) && !isMetalAtom(bond.b))))
            add(atoms[bond.a] ? bond.b : bond.a);
    const auto addNear = [&](const auto& isOne, const auto& isOther) {
        std::vector<bool> ones(atoms.size());
        for (std::size_t i = 0; i < ones.size(); ++i) ones[i] = atoms[i] && isOne(i);
        if (std::find(ones.begin(), ones.end(), true) == ones.end()) return;
        const std::vector<bool> near = atomsNear(m, ones, kCoordination);
        for (std::uint32_t i = 0; i < near.size(); ++i)
            if (near[i] && isOther(i)) add(i);
    };
    if (toLigand) {
        addNear(isMetalAtom, isDonor);
        addNear(isDonor, isMetalAtom);
    }
    for (const std::uint32_t residue : bonded) {
        const auto first = atoms.begin() + m.residues[residue].firstAtom;
        std::fill(first, first + m.residues[residue].atomCount, true);
    }
}

std::optional<std::vector<bool>> StructureAtoms::ofKind(std::string_view name) const {
    const Molecule& m = molecule();
    const auto& kinds = facts_.kinds();
    const auto is = [&](const Residue& residue, ResidueKind kind) {
        const bool branched = isBranched(residue);
        if (name == "all") return true;
        if (name == "polymer") return kind == ResidueKind::protein || kind == ResidueKind::nucleic;
        if (name == "protein") return kind == ResidueKind::protein;
        if (name == "nucleic") return kind == ResidueKind::nucleic;
        if (name == "branched") return branched;
        if (name == "ligand") return kind == ResidueKind::ligand && !branched;
        if (name == "ion") return kind == ResidueKind::ion;
        return name == "water" && kind == ResidueKind::water;
    };
    static constexpr std::string_view kNames[] = {"all",    "polymer", "protein", "nucleic", "branched",
                                                  "ligand", "ion",     "water",   "coarse"};
    if (std::find(std::begin(kNames), std::end(kNames), name) == std::end(kNames)) return std::nullopt;
    std::vector<bool> atoms(m.atoms.size());
    for (std::size_t i = 0; i < m.residues.size(); ++i) {
        const Residue& residue = m.residues[i];
        if (!is(residue, kinds[i])) continue;
        for (std::uint32_t k = residue.firstAtom; k < residue.firstAtom + residue.atomCount; ++k) atoms[k] = true;
    }
    if (name == "ligand" || name == "branched") addBonded(name == "ligand", atoms);
    return atoms;
}

std::vector<std::uint32_t> StructureAtoms::selectDrawn(const std::vector<bool>& atoms) const {
    std::vector<std::uint32_t> chosen;
    std::copy_if(drawn_.begin(), drawn_.end(), std::back_inserter(chosen), [&](std::uint32_t i) { return atoms[i]; });
    return chosen;
}

}  // namespace nacre::app::mvs
