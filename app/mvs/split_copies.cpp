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
    for (std::uint32_t list = 0; list < s.lists.size(); ++list)
        for (const std::uint32_t copy : s.lists[list]) {
            if (groups[copy] == kNoGroup) continue;
            const auto next = static_cast<std::uint32_t>(lists.size());
            const auto [place, added] = known.emplace(std::pair(list, groups[copy]), next);
            if (added) lists.emplace_back();
            lists[place->second].push_back(copy);
        }
    const auto listIn = [&](std::uint32_t group, std::uint32_t list) {
        const auto place = known.find({list, group});
        return place == known.end() ? UINT32_MAX : place->second;
    };
    std::vector<std::uint32_t> listOfResidue;
    for (std::uint32_t group = 0; group < count; ++group)
        for (std::uint32_t i = 0; i < residues; ++i) listOfResidue.push_back(listIn(group, listOfCopies(s, i)));
    const std::vector<std::set<std::string>> ids = s.instanceIds;
    std::vector<Molecule> all(count);
    all[0] = std::move(*s.molecule);
    if (count > 1) all[0].assemblies.clear();  // as the whole scene does, where it has several parts
    for (std::uint32_t group = 1; group < count; ++group) {
        all[group] = all[group - 1];
        all[group].file = {};
        all[group].notes.clear();  // joining adds up what was read
        all[group].warnings.clear();
        all[group].serials.clear();
        s.instanceIds.insert(s.instanceIds.end(), ids.begin(), ids.end());
    }
    for (std::uint32_t group = 0; group < count && count > 1; ++group)
        for (Chain& chain : all[group].chains)
            chain.model = static_cast<int>(group * ids.size()) + (ids.size() > 1 ? chain.model : 0);
    *s.molecule = joinModels(s.uri, std::move(all), std::numeric_limits<std::size_t>::max());
    s.lists = std::move(lists);
    s.listOfResidue = std::move(listOfResidue);
    s.atoms = std::make_unique<StructureAtoms>(*s.molecule, s.instanceIds);
}

}  // namespace nacre::app::mvs
