#include "engine/scene/instances/copies.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>

#include "engine/error.h"
#include "engine/molecule/assemblies.h"

namespace nacre {
namespace {

constexpr std::size_t kMostNamed = 20;  // in a message
// Bounds the sum over all lists of copies: with a list per chain, each may be as long as all transforms.
constexpr std::size_t kMostListedCopies = std::size_t{1} << 23;

const Assembly& findAssembly(const Molecule& molecule, const std::string& id) {
    for (const Assembly& assembly : molecule.assemblies)
        if (assembly.id == id) return assembly;
    if (const std::string why = findLeftOutWarning(molecule, id); !why.empty())
        throw Error("cannot draw assembly", id, why);
    if (molecule.assemblies.empty()) throw Error("cannot draw assembly", id, "the file states no assemblies");
    std::string names;
    for (std::size_t i = 0; i < std::min(molecule.assemblies.size(), kMostNamed); ++i)
        names += (i ? ", " : "") + molecule.assemblies[i].id;
    if (molecule.assemblies.size() > kMostNamed)
        names += " and " + std::to_string(molecule.assemblies.size() - kMostNamed) + " more";
    throw Error("cannot draw assembly", id, "the file has no such assembly; it has " + names);
}

/// The different transforms of all parts, in order of first use, and their indices by part.
std::vector<std::vector<std::uint32_t>> numberTransforms(const Assembly& assembly,
                                                         std::vector<glm::dmat4x3>& transforms) {
    std::vector<const glm::mat4x3*> all;
    for (const AssemblyPart& part : assembly.parts)
        for (const glm::mat4x3& transform : part.transforms) all.push_back(&transform);
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const float *l = &(*all[a])[0][0], *r = &(*all[b])[0][0];
        return std::lexicographical_compare(l, l + 12, r, r + 12);
    };
    std::vector<std::uint32_t> order(all.size()), numbers(all.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return before(a, b) || (!before(b, a) && a < b);  // stable without a stable sort's memory
    });
    std::size_t different = 0;
    for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
        if (i == 0 || before(order[first], order[i])) first = i, ++different;
        numbers[order[i]] = order[first];
    }
    transforms.reserve(different);
    std::vector<std::vector<std::uint32_t>> byPart;
    std::uint32_t i = 0;
    for (const AssemblyPart& part : assembly.parts) {
        byPart.emplace_back();
        byPart.back().reserve(part.transforms.size());
        for (const glm::mat4x3& transform : part.transforms) {
            const std::uint32_t first = numbers[i];
            numbers[i] = first < i ? numbers[first] : static_cast<std::uint32_t>(transforms.size());
            if (first == i) transforms.emplace_back(transform);
            byPart.back().push_back(numbers[i++]);
        }
    }
    return byPart;
}

}  // namespace

bool isRigid(const glm::dmat4x3& motion) {
    const glm::dmat3 turn(motion), square = glm::transpose(turn) * turn;
    for (int i = 0; i < 9; ++i)
        if (!(std::abs(square[i / 3][i % 3] - (i % 4 == 0 ? 1.0 : 0.0)) <= 0.01)) return false;
    return true;
}

void CopyLists::index() {
    order_.clear();
    for (std::uint32_t i = 0; i < lists_.size(); ++i) order_.insert(i);
}

std::uint32_t CopyLists::add(std::vector<std::uint32_t> list) {
    lists_.push_back(std::move(list));
    const auto [found, added] = order_.insert(static_cast<std::uint32_t>(lists_.size() - 1));
    if (!added) lists_.pop_back();
    return *found;
}

std::uint32_t CopyLists::common(std::uint32_t a, std::uint32_t b) {
    if (a == b) return a;
    std::vector<std::uint32_t> both;
    std::set_intersection(lists_[a].begin(), lists_[a].end(), lists_[b].begin(), lists_[b].end(),
                          std::back_inserter(both));
    if (both.empty()) return Placement::kNowhere;
    const std::size_t places = both.size(), before = lists_.size();
    const std::uint32_t list = add(std::move(both));
    if (lists_.size() > before && (added_ += places) > kMostListedCopies)
        throw Error("cannot draw assembly", "",
                    "its bonds have more than " + std::to_string(kMostListedCopies) + " places together");
    return list;
}

Placement placeAssembly(const Molecule& molecule, const std::string& id) {
    const Assembly& assembly = findAssembly(molecule, id);
    for (const AssemblyPart& part : assembly.parts)
        if (!std::ranges::all_of(part.transforms, isRigid))
            throw Error("cannot draw assembly", id, "one of its transforms stretches or skews");
    Placement placement;
    const std::vector<std::vector<std::uint32_t>> copiesOfPart = numberTransforms(assembly, placement.transforms);
    // Subchains that occur in the same parts have the same copies.
    std::vector<std::vector<std::uint32_t>> subchainParts(molecule.subchains.size());
    for (std::uint32_t part = 0; part < assembly.parts.size(); ++part)
        for (const std::uint32_t subchain : assembly.parts[part].subchains) subchainParts[subchain].push_back(part);
    std::size_t listed = 0;
    std::map<std::vector<std::uint32_t>, std::uint32_t> listOfParts{{{}, Placement::kNowhere}};
    CopyLists lists(placement.lists);
    for (const std::vector<std::uint32_t>& parts : subchainParts) {
        const auto [known, added] = listOfParts.emplace(parts, 0);
        if (added) {
            const std::size_t before = listed;
            for (const std::uint32_t part : parts) listed += copiesOfPart[part].size();
            if (listed > kMostListedCopies)
                throw Error("cannot draw assembly", id,
                            "its chains have more than " + std::to_string(kMostListedCopies) + " places together");
            std::vector<std::uint32_t> list;
            list.reserve(listed - before);
            for (const std::uint32_t part : parts)
                list.insert(list.end(), copiesOfPart[part].begin(), copiesOfPart[part].end());
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
            known->second = lists.add(std::move(list));
        }
        placement.listOfSubchain.push_back(known->second);
    }
    return placement;
}

namespace {

/// Orders copies along a space-filling curve (G. M. Morton, 1966): neighbours mostly get different colours.
std::vector<std::uint32_t> alongCurve(const std::vector<glm::dvec3>& centers) {
    constexpr int kBits = 10;
    Box box;
    for (const glm::dvec3& center : centers) box.add(center);
    const glm::dvec3 size = box.high - box.low;
    const double side = std::max({size.x, size.y, size.z, 1e-3});
    std::vector<std::pair<std::uint32_t, std::uint32_t>> keys;  // code, number
    keys.reserve(centers.size());
    for (const glm::dvec3& center : centers) {
        const glm::uvec3 cell((center - box.low) / side * double{(1 << kBits) - 1});
        std::uint32_t code = 0;
        for (int bit = kBits; bit-- > 0;)
            for (int axis = 0; axis < 3; ++axis) code = code << 1 | (cell[axis] >> bit & 1);
        keys.emplace_back(code, static_cast<std::uint32_t>(keys.size()));
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const auto& [code, number] : keys) order.push_back(number);
    return order;
}

}  // namespace

std::vector<std::uint32_t> spreadCopies(const std::vector<glm::dvec3>& centers, std::size_t colors) {
    constexpr std::size_t kMostCompared = std::size_t{1} << 16;  // all pairs
    const std::size_t count = centers.size();
    if (count > kMostCompared) return alongCurve(centers);
    std::vector<std::uint32_t> order;
    std::vector<bool> used(count);
    // Squared distance from each copy to the nearest one that already has each colour.
    std::vector<double> apart(count * colors, std::numeric_limits<double>::infinity());
    for (std::size_t turn = 0; turn < count; ++turn) {
        const std::size_t color = turn % colors;
        std::size_t best = count;
        for (std::size_t i = 0; i < count; ++i)
            if (!used[i] && (best == count || apart[i * colors + color] > apart[best * colors + color])) best = i;
        used[best] = true;
        order.push_back(static_cast<std::uint32_t>(best));
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 way = centers[i] - centers[best];
            apart[i * colors + color] = std::min(apart[i * colors + color], glm::dot(way, way));
        }
    }
    return order;
}

}  // namespace nacre
