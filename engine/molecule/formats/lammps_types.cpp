#include "engine/molecule/formats/lammps_types.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "engine/molecule/element.h"

namespace nacre {

void LammpsTypes::add(std::string_view type, double mass, std::string_view label) {
    constexpr std::size_t kMostTypes = 100'000;
    if (kinds_.size() < kMostTypes) kinds_[std::string(type)] = {mass, std::string(label)};
}

void LammpsTypes::apply(MoleculeBuilder& builder) const {
    Molecule& molecule = builder.molecule();
    // Grains have masses of 1 in reduced units; hydrogen has 1.008.
    const auto findElement = [](const Kind& kind) { return kind.mass == 1 ? Element{0} : elementFromMass(kind.mass); };
    const bool elements = !kinds_.empty() && std::all_of(kinds_.begin(), kinds_.end(), [&](const auto& kind) {
        return findElement(kind.second) != 0 || kind.second.mass == 0;
    });
    bool masses = !kinds_.empty();
    for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
        const auto kind = kinds_.find(molecule.types[i].view());
        Atom& atom = molecule.atoms[i];
        const bool known = kind != kinds_.end();
        masses = masses && known;
        if (elements && known) atom.element = findElement(kind->second);
        if (masses) molecule.masses.push_back(static_cast<float>(kind->second.mass));
        atom.name = known && !kind->second.label.empty() ? Name(kind->second.label)
                    : atom.element != 0                  ? Name(elementSymbol(atom.element))
                                                         : molecule.types[i];
    }
    if (!masses) molecule.masses.clear();
    if (elements)
        builder.guess("elements", "from masses", static_cast<std::int64_t>(molecule.atoms.size()));
    else
        makeGrains(molecule);
}

void makeGrains(Molecule& molecule) {
    constexpr std::size_t kSamples = 200, kWindow = 20'000;
    const std::size_t count = molecule.atoms.size();
    std::vector<float> lengths;
    for (const Bond& bond : molecule.bonds)
        lengths.push_back(glm::distance(molecule.atoms[bond.a].position, molecule.atoms[bond.b].position));
    const auto distanceToNearest = [&](std::size_t i) {
        float nearest = HUGE_VALF;
        for (std::size_t j = 0; j < std::min(count, kWindow); ++j) {
            const float apart = glm::distance(molecule.atoms[i].position, molecule.atoms[j].position);
            if (apart > 0) nearest = std::min(nearest, apart);
        }
        return nearest;
    };
    // Without bonds: distances to the nearest of many other atoms. Of few atoms, each is sampled several times.
    float nearest = HUGE_VALF;
    for (std::size_t k = 0, before = count; molecule.bonds.empty() && k < kSamples && count > 1; ++k) {
        const std::size_t i = k * count / kSamples;
        if (i != before) nearest = distanceToNearest(i);
        before = i;
        if (nearest < HUGE_VALF) lengths.push_back(nearest);
    }
    float radius = 1;
    if (!lengths.empty()) {
        const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
        std::nth_element(lengths.begin(), middle, lengths.end());
        radius = std::max(*middle / 2, 0.01f);
    }
    std::int64_t grains = 0;
    for (Atom& atom : molecule.atoms) {
        if (atom.element != 0 || atom.radius > 0) continue;
        atom.radius = radius;
        ++grains;
    }
    addNote(molecule.notes, ReadAction::guessed, "radii of grains", "half of the distance between neighbours", grains);
}

}  // namespace nacre
