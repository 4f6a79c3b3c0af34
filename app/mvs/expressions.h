#pragma once
// The atoms of a structure that a MolViewSpec selector selects.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/mvs/scene_tree.h"
#include "engine/molecule/residue_facts.h"

namespace nacre::app::mvs {

/// A component expression: all given fields must match. Numbers are inclusive bounds.
struct Expression {
    std::optional<std::string> labelEntity, labelChain, authChain, insertion, labelAtom, authAtom, element, component,
        instance;
    std::optional<std::int64_t> label, auth, fromLabel, toLabel, fromAuth, toAuth, residueIndex, atomId, atomIndex;

    bool empty() const;
    bool ofAtoms() const { return labelAtom || authAtom || element || atomId || atomIndex; }
};

/// Sets a field by its name in the schema. @returns whether the schema has the field
/// @throws std::invalid_argument for an invalid value, with the reason
bool setField(Expression& expression, std::string_view field, const Json& value);

/// The fields of a schema of annotations ("residue_range"); null: no such schema.
const std::vector<std::string_view>* fieldsOfSchema(std::string_view schema);

/// The atoms of one structure, by their names.
class StructureAtoms {
public:
    /// @param molecule  outlives this @param instances  ids of the copies of each group of copies: the molecule has the
    /// atoms of all groups, one group after the other
    explicit StructureAtoms(const Molecule& molecule, std::vector<std::set<std::string>> instances = {{}});

    /// Indices of the structure's drawn atoms (one conformer, with waters), ascending.
    const std::vector<std::uint32_t>& all() const { return drawn_; }
    /// Adds the atoms that match an expression to a set by atom. @throws Error if that takes too much work
    void add(const Expression& expression, std::vector<bool>& atoms);
    /// "polymer", "ligand", ...; empty for an unknown name.
    std::optional<std::vector<bool>> ofKind(std::string_view name) const;
    /// The drawn atoms of a set.
    std::vector<std::uint32_t> selectDrawn(const std::vector<bool>& atoms) const;
    const Molecule& molecule() const { return facts_.molecule(); }
    const ResidueFacts& facts() const { return facts_; }

private:
    bool fits(const Expression& e, const Residue& residue, std::uint32_t index) const;
    bool fits(const Expression& e, std::uint32_t atom) const;
    void addBonded(bool toLigand, std::vector<bool>& atoms) const;

    ResidueFacts facts_;
    std::vector<std::set<std::string>> instances_;
    std::vector<std::uint32_t> drawn_;
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> ofLabelChain_, ofAuthChain_;  ///< residues
    std::uint64_t visits_ = 0;
};

}  // namespace nacre::app::mvs
