#include "app/mvs/split_copies.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/join_models.h"

namespace nacre::app::mvs {

void foldInstances(const Node& node, Structure& s) {
    if (s.instances.empty()) return;
    const auto times = static_cast<std::uint32_t>(s.instances.size());
    if (s.transforms.empty()) s.transforms = {glm::dmat4x3(1.0)}, s.lists = {{0}};
    if (s.transforms.size() * times > kMostCopies)
        throw Error("cannot draw scene", node.place,
                    "its structure has more than " + std::to_string(kMostCopies) + " copies");
    std::vector<glm::dmat4x3> all;
    for (const glm::dmat4x3& copy : s.transforms) std::ranges::copy(listMotions(s, copy), std::back_inserter(all));
    for (std::vector<std::uint32_t>& list : s.lists) {
        std::vector<std::uint32_t> longer;
        for (const std::uint32_t copy : list)
            for (std::uint32_t i = 0; i < times; ++i) longer.push_back(copy * times + i);
        list = std::move(longer);
    }
    s.transforms = std::move(all);
    s.moved = glm::dmat4x3(1.0);
    s.instances.clear();
}

void splitCopies(const std::vector<std::uint32_t>& groups, std::uint32_t count, Structure& s) {
    const auto residues = static_cast<std::uint32_t>(s.molecule->residues.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;  // by list and group
    std::vector<std::vector<std::uint32_t>> lists;
    std::vector<std::uint32_t> listOfResidue;
    const auto listIn = [&](std::uint32_t group, std::uint32_t list) {
        if (list == UINT32_MAX) return list;
        const auto [place, added] = known.emplace(std::pair(list, group), UINT32_MAX);
        if (!added) return place->second;
        std::vector<std::uint32_t> own;
        std::ranges::copy_if(s.lists[list], std::back_inserter(own),
                             [&](std::uint32_t copy) { return groups[copy] == group; });
        if (own.empty()) return UINT32_MAX;
        lists.push_back(std::move(own));
        return place->second = static_cast<std::uint32_t>(lists.size() - 1);
    };
    for (std::uint32_t group = 0; group < count; ++group)
        for (std::uint32_t i = 0; i < residues; ++i) listOfResidue.push_back(listIn(group, listOfCopies(s, i)));
    const std::vector<std::set<std::string>> ids = s.instanceIds;
    std::vector<Molecule> all(1, std::move(*s.molecule));
    Molecule further = all.front();
    further.notes.clear();  // joining adds up what was read
    further.file.bonds.reset();
    all.resize(count, further);
    for (std::uint32_t group = 0; group < count; ++group) {
        if (group > 0) s.instanceIds.insert(s.instanceIds.end(), ids.begin(), ids.end());
        for (Chain& chain : all[group].chains)
            chain.model = static_cast<int>(group * ids.size()) + (ids.size() > 1 ? chain.model : 0);
    }
    *s.molecule = joinModels(s.uri, std::move(all), std::numeric_limits<std::size_t>::max());
    s.lists = std::move(lists);
    s.listOfResidue = std::move(listOfResidue);
    s.atoms = std::make_unique<StructureAtoms>(*s.molecule, s.instanceIds);
}

}  // namespace nacre::app::mvs
