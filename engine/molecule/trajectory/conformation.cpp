// Positions of a molecule's atoms at their counterparts in another molecule.

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "engine/error.h"
#include "engine/molecule/disjoint_sets.h"
#include "engine/molecule/join_models.h"
#include "engine/molecule/matched_atoms.h"
#include "engine/molecule/read.h"
#include "engine/molecule/superpose.h"
#include "engine/molecule/trajectory/morph.h"

namespace nacre {
namespace {

constexpr std::uint32_t kUnmatched = 0xffffffff;

bool sameAtoms(const Molecule& a, const Molecule& b) {
    if (a.atoms.size() != b.atoms.size()) return false;
    for (std::size_t i = 0; i < a.atoms.size(); ++i) {
        const Atom &x = a.atoms[i], &y = b.atoms[i];
        if (x.name != y.name || x.element != y.element || a.residues[x.residue].name != b.residues[y.residue].name)
            return false;
    }
    return true;
}

/// For each atom its counterpart in the other molecule, or kUnmatched.
std::vector<std::uint32_t> counterparts(const Molecule& molecule, const Molecule& other) {
    const std::size_t count = molecule.atoms.size();
    std::vector<std::uint32_t> pairs(count, kUnmatched);
    if (sameAtoms(molecule, other)) {
        for (std::uint32_t i = 0; i < count; ++i) pairs[i] = i;
        return pairs;
    }
    std::vector<Molecule> both{molecule, other};
    for (int i = 0; i < 2; ++i)
        for (Chain& chain : both[static_cast<std::size_t>(i)].chains) chain.model = i + 1;
    Molecule joined = joinModels("morph", std::move(both), kMaxAtoms);
    joined.modelsAreInputs = true;
    std::vector<bool> first(joined.atoms.size()), second(joined.atoms.size());
    for (std::size_t i = 0; i < joined.atoms.size(); ++i) (i < count ? first : second)[i] = true;
    const AtomPairs matched = matchAtoms(joined, first, second);
    for (std::size_t i = 0; i < matched.first.size(); ++i)
        pairs[matched.first[i]] = matched.second[i] - static_cast<std::uint32_t>(count);
    // Other atoms are paired by chain, residue number and name.
    using Key = std::tuple<std::string, std::int32_t, char, std::string, std::string>;
    const auto makeKey = [](const Molecule& m, const Atom& atom) {
        const Residue& r = m.residues[atom.residue];
        return Key{m.chains[r.chain].name, r.number, r.insertionCode, std::string(r.name.view()),
                   std::string(atom.name.view())};
    };
    std::map<Key, std::uint32_t> others;
    for (std::uint32_t i = 0; i < other.atoms.size(); ++i) others.emplace(makeKey(other, other.atoms[i]), i);
    const ResidueFacts facts(molecule);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto found = facts.isPolymer(molecule.atoms[i].residue) || pairs[i] != kUnmatched
                               ? others.end()
                               : others.find(makeKey(molecule, molecule.atoms[i]));
        if (found != others.end()) pairs[i] = found->second;
    }
    return pairs;
}

/// Groups of bonded atoms without a counterpart.
std::vector<std::vector<std::uint32_t>> looseGroups(const Molecule& molecule, const std::vector<std::uint32_t>& pairs) {
    DisjointSets sets(pairs.size());
    for (const Bond& bond : molecule.bonds)
        if (pairs[bond.a] == kUnmatched && pairs[bond.b] == kUnmatched) sets.join(bond.a, bond.b);
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        if (pairs[i] == kUnmatched) groups[sets.findRoot(i)].push_back(i);
    std::vector<std::vector<std::uint32_t>> all;
    for (auto& [root, group] : groups) all.push_back(std::move(group));
    return all;
}

/// Moves a group rigidly with the matched atoms around it.
void carry(const Molecule& molecule, const std::vector<std::uint32_t>& group, std::vector<std::uint32_t> matched,
           std::vector<glm::vec3>& positions) {
    constexpr std::size_t kAround = 12;
    glm::vec3 middle(0);
    for (const std::uint32_t atom : group) middle += molecule.atoms[atom].position / static_cast<float>(group.size());
    const std::size_t count = std::min(std::max(kAround, group.size()), matched.size());
    const auto distance = [&](std::uint32_t atom) { return glm::distance(molecule.atoms[atom].position, middle); };
    std::partial_sort(matched.begin(), matched.begin() + static_cast<std::ptrdiff_t>(count), matched.end(),
                      [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); });
    std::vector<glm::dvec3> fixed, moving;
    for (std::size_t i = 0; i < count; ++i) {
        fixed.emplace_back(positions[matched[i]]);
        moving.emplace_back(molecule.atoms[matched[i]].position);
    }
    const Superposition onto = superpose(fixed, moving);
    for (const std::uint32_t atom : group) positions[atom] = glm::vec3(onto(glm::dvec3(molecule.atoms[atom].position)));
}

}  // namespace

Conformation fitConformation(const Molecule& molecule, const Molecule& other, const std::string& name) {
    const std::vector<std::uint32_t> pairs = counterparts(molecule, other);
    std::vector<glm::dvec3> fixed, moving;
    std::vector<std::uint32_t> matched;
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i] == kUnmatched) continue;
        matched.push_back(i);
        fixed.emplace_back(molecule.atoms[i].position);
        moving.emplace_back(other.atoms[pairs[i]].position);
    }
    constexpr std::size_t kFewest = 3, kLeastShare = 3;
    if (matched.size() < kFewest || kLeastShare * matched.size() < molecule.atoms.size())
        throw Error("cannot take as a conformation", name,
                    "only " + std::to_string(matched.size()) + " of " + std::to_string(molecule.atoms.size()) +
                        " atoms have a counterpart of the same residue and name");
    const Superposition onto = superposePruned(fixed, moving).motion;
    Conformation end{std::vector<glm::vec3>(pairs.size()), matched.size()};
    for (std::size_t i = 0; i < pairs.size(); ++i) end.positions[i] = molecule.atoms[i].position;
    for (std::size_t i = 0; i < matched.size(); ++i) end.positions[matched[i]] = glm::vec3(onto(moving[i]));
    // Further groups stay: each group searches all matched atoms.
    constexpr std::size_t kMostCarried = 2000;
    const std::vector<std::vector<std::uint32_t>> groups = looseGroups(molecule, pairs);
    for (std::size_t i = 0; i < std::min(groups.size(), kMostCarried); ++i)
        carry(molecule, groups[i], matched, end.positions);
    return end;
}

}  // namespace nacre
