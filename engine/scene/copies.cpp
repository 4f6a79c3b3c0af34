#include "engine/scene/copies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <utility>

#include "engine/error.h"
#include "engine/scene/bounds.h"

namespace nacre {
namespace {

constexpr std::size_t kMostNamed = 20;  // in a message
// Of all lists of copies together: one for each chain may be as long as all transforms.
constexpr std::size_t kMostListedCopies = std::size_t{1} << 23;

const Assembly& assemblyOf(const Molecule& molecule, const std::string& id) {
    for (const Assembly& assembly : molecule.assemblies)
        if (assembly.id == id) return assembly;
    if (molecule.assemblies.empty()) throw Error("cannot draw assembly", id, "the file states no assemblies");
    std::string names;
    for (std::size_t i = 0; i < std::min(molecule.assemblies.size(), kMostNamed); ++i)
        names += (i ? ", " : "") + molecule.assemblies[i].id;
    if (molecule.assemblies.size() > kMostNamed)
        names += " and " + std::to_string(molecule.assemblies.size() - kMostNamed) + " more";
    throw Error("cannot draw assembly", id, "the file has no such assembly; it has " + names);
}

/// Numbers transforms, equal ones alike.
class TransformSet {
public:
    explicit TransformSet(std::vector<glm::dmat4x3>& transforms) : transforms_(transforms) {}
    std::uint32_t add(const glm::mat4x3& transform) {
        std::array<float, 12> key{};
        for (int i = 0; i < 12; ++i) key[static_cast<std::size_t>(i)] = transform[i / 3][i % 3];
        const auto next = static_cast<std::uint32_t>(transforms_.size());
        const auto [found, added] = known_.emplace(key, next);
        if (added) transforms_.emplace_back(transform);
        return found->second;
    }

private:
    std::vector<glm::dmat4x3>& transforms_;
    std::map<std::array<float, 12>, std::uint32_t> known_;
};

/// Shape and size must stay: a radius has no direction in which it could be stretched.
void checkRigid(const Assembly& assembly) {
    constexpr float kLargest = 0.01f;
    for (const AssemblyPart& part : assembly.parts)
        for (const glm::mat4x3& transform : part.transforms) {
            const glm::mat3 turn(transform[0], transform[1], transform[2]);
            const glm::mat3 square = glm::transpose(turn) * turn;
            for (int i = 0; i < 9; ++i)
                if (!(std::abs(square[i / 3][i % 3] - (i % 4 == 0 ? 1.0f : 0.0f)) <= kLargest))
                    throw Error("cannot draw assembly", assembly.id, "one of its transforms stretches or skews");
        }
}

}  // namespace

std::uint32_t listIndex(std::vector<std::vector<std::uint32_t>>& lists, std::vector<std::uint32_t> list) {
    const auto found = std::find(lists.begin(), lists.end(), list);
    const auto index = static_cast<std::uint32_t>(found - lists.begin());
    if (found == lists.end()) lists.push_back(std::move(list));
    return index;
}

Placement placeAssembly(const Molecule& molecule, const std::string& id) {
    const Assembly& assembly = assemblyOf(molecule, id);
    checkRigid(assembly);
    Placement placement;
    TransformSet set(placement.transforms);
    // Subchains that the same parts mention have the same copies.
    std::vector<std::vector<std::uint32_t>> partsOf(molecule.subchains.size());
    std::vector<std::vector<std::uint32_t>> copiesOfPart;
    for (std::uint32_t part = 0; part < assembly.parts.size(); ++part) {
        copiesOfPart.emplace_back();
        for (const glm::mat4x3& transform : assembly.parts[part].transforms)
            copiesOfPart.back().push_back(set.add(transform));
        for (const std::uint32_t subchain : assembly.parts[part].subchains) partsOf[subchain].push_back(part);
    }
    std::size_t listed = 0;
    std::map<std::vector<std::uint32_t>, std::uint32_t> listOfParts{{{}, Placement::kNowhere}}, indices;
    for (const std::vector<std::uint32_t>& parts : partsOf) {
        const auto [known, added] = listOfParts.emplace(parts, 0);
        if (added) {
            std::vector<std::uint32_t> list;
            for (const std::uint32_t part : parts) listed += copiesOfPart[part].size();
            if (listed > kMostListedCopies)
                throw Error("cannot draw assembly", id,
                            "its chains have more than " + std::to_string(kMostListedCopies) + " places together");
            for (const std::uint32_t part : parts)
                list.insert(list.end(), copiesOfPart[part].begin(), copiesOfPart[part].end());
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
            const auto [same, first] =
                indices.emplace(std::move(list), static_cast<std::uint32_t>(placement.lists.size()));
            if (first) placement.lists.push_back(same->first);
            known->second = same->second;
        }
        placement.listOfSubchain.push_back(known->second);
    }
    return placement;
}

std::uint32_t commonList(std::vector<std::vector<std::uint32_t>>& lists, std::uint32_t a, std::uint32_t b) {
    if (a == b) return a;
    std::vector<std::uint32_t> common;
    std::set_intersection(lists[a].begin(), lists[a].end(), lists[b].begin(), lists[b].end(),
                          std::back_inserter(common));
    return common.empty() ? Placement::kNowhere : listIndex(lists, std::move(common));
}

namespace {

/// Along a curve through space (G. M. Morton, 1966): neighbours mostly follow each other, in different colours.
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
    constexpr std::size_t kMostCompared = std::size_t{1} << 16;  // each with each other
    const std::size_t count = centers.size();
    if (count > kMostCompared) return alongCurve(centers);
    std::vector<std::uint32_t> order;
    std::vector<bool> used(count);
    // Squared distance from each copy to the nearest that has a colour already.
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
