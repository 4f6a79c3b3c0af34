#include "engine/molecule/join_models.h"

#include <algorithm>
#include <map>

#include "engine/molecule/text.h"

namespace nacre {
namespace {

/// Joins lists of names, and maps indices of the added list.
class Names {
public:
    explicit Names(std::vector<std::string>& names) : names_(names) {
        for (std::uint32_t i = 0; i < names.size(); ++i) places_.emplace(names[i], i);
    }
    std::vector<std::uint32_t> join(const std::vector<std::string>& more) {
        std::vector<std::uint32_t> places;
        for (const std::string& name : more) {
            const auto [found, added] = places_.emplace(name, static_cast<std::uint32_t>(names_.size()));
            if (added) names_.push_back(name);
            places.push_back(found->second);
        }
        return places;
    }

private:
    std::vector<std::string>& names_;
    std::map<std::string, std::uint32_t> places_;
};

class Joined {
public:
    explicit Joined(Molecule first)
        : whole_(std::move(first)), subchains_(whole_.subchains), entities_(whole_.entities) {}

    void add(const Molecule& model) {
        const auto atoms = static_cast<std::uint32_t>(whole_.atoms.size());
        const auto residues = static_cast<std::uint32_t>(whole_.residues.size());
        addResidues(model, atoms);
        for (Atom atom : model.atoms) {
            atom.residue += residues;
            whole_.atoms.push_back(atom);
        }
        for (Bond bond : model.bonds) {
            bond.a += atoms;
            bond.b += atoms;
            whole_.bonds.push_back(bond);
        }
        addValues(whole_.partialCharges, model.partialCharges, atoms);
        addValues(whole_.radii, model.radii, atoms);
        addValues(whole_.masses, model.masses, atoms);
        addValues(whole_.types, model.types, atoms);
        addDisplacements(model.displacements, atoms);
        for (const ReadNote& note : model.notes)
            addNote(whole_.notes, note.action, note.what, note.why, note.count, note.line);
        for (const std::string& warning : model.warnings)
            if (std::find(whole_.warnings.begin(), whole_.warnings.end(), warning) == whole_.warnings.end())
                whole_.warnings.push_back(warning);
        whole_.statesSecondaryStructure = whole_.statesSecondaryStructure || model.statesSecondaryStructure;
        if (whole_.file.bonds && model.file.bonds) *whole_.file.bonds += *model.file.bonds;
    }
    Molecule finish() { return std::move(whole_); }

private:
    void addResidues(const Molecule& model, std::uint32_t atoms) {
        const auto chains = static_cast<std::uint32_t>(whole_.chains.size());
        const std::vector<std::uint32_t> subchains = subchains_.join(model.subchains);
        const std::vector<std::uint32_t> entities = entities_.join(model.entities);
        whole_.chains.insert(whole_.chains.end(), model.chains.begin(), model.chains.end());
        for (Residue residue : model.residues) {
            residue.firstAtom += atoms;
            residue.chain += chains;
            if (!subchains.empty()) residue.subchain = subchains[residue.subchain];
            if (residue.entity > 0) residue.entity = entities[residue.entity - 1] + 1;
            whole_.residues.push_back(residue);
        }
    }

    /// If the first file states no displacements, the joined molecule has none.
    void addDisplacements(const std::vector<Displacement>& more, std::size_t atoms) {
        std::vector<Displacement>& all = whole_.displacements;
        if (all.empty() && more.empty()) return;
        all.resize(atoms);
        all.insert(all.end(), more.begin(), more.end());
        all.resize(whole_.atoms.size());
    }

    /// One value per atom, if both molecules have such values.
    template <typename Value>
    void addValues(std::vector<Value>& values, const std::vector<Value>& more, std::size_t atoms) {
        if (values.size() == atoms && values.size() + more.size() == whole_.atoms.size())
            values.insert(values.end(), more.begin(), more.end());
        else
            values.clear();
    }

    Molecule whole_;
    Names subchains_, entities_;
};

}  // namespace

Molecule joinModels(const std::string& name, std::vector<Molecule> models, std::size_t maxAtoms) {
    std::size_t atoms = 0;
    for (const Molecule& model : models) atoms += model.atoms.size();
    if (atoms > maxAtoms) throw tooManyAtoms(name + ", all models", maxAtoms);
    Joined joined(std::move(models.front()));
    for (std::size_t i = 1; i < models.size(); ++i) {
        joined.add(models[i]);
        models[i] = Molecule();
    }
    return joined.finish();
}

}  // namespace nacre
