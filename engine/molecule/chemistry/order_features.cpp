#include "engine/molecule/chemistry/order_features.h"

namespace nacre {
namespace {

constexpr BondLengths kBondLengths[] = {
    {kCarbon, kCarbon, 1.48f, 1.34f, 1.19f, kPairCC},        {kCarbon, kNitrogen, 1.41f, 1.29f, 1.15f, kPairCN},
    {kCarbon, kOxygen, 1.36f, 1.22f, 1.13f, kPairCO},        {kCarbon, kSulphur, 1.77f, 1.66f, 1.55f, kPairCS},
    {kNitrogen, kNitrogen, 1.39f, 1.24f, 1.12f, kPairNN},    {kNitrogen, kOxygen, 1.39f, 1.22f, 1.13f, kPairNO},
    {kOxygen, kOxygen, 1.46f, 1.21f, 1.1f, kPairOther},      {kCarbon, kSelenium, 1.90f, 1.79f, 1.7f, kPairOther},
    {kCarbon, kPhosphorus, 1.80f, 1.67f, 1.55f, kPairOther}, {kNitrogen, kSulphur, 1.68f, 1.54f, 1.45f, kPairOther},
    {kPhosphorus, kNitrogen, 1.68f, 1.57f, 1.5f, kPairOther}};

float degreesBetween(const glm::vec3& u, const glm::vec3& v) {
    const float length = glm::length(u) * glm::length(v);
    return length > 1e-9f ? std::acos(std::clamp(glm::dot(u, v) / length, -1.0f, 1.0f)) * 57.29578f : 0;
}

}  // namespace

const BondLengths* bondLengths(Element a, Element b) {
    for (const BondLengths& row : kBondLengths)
        if ((row.a == a && row.b == b) || (row.a == b && row.b == a)) return &row;
    return nullptr;
}

OrderFeatures::OrderFeatures(const ChemistryWork& work)
    : work_(work),
      ringOf_(work.molecule.bonds.size()),
      place_(work.molecule.atoms.size()),
      angle_(work.molecule.atoms.size()) {
    const Chemistry& chemistry = work.chemistry;
    for (std::uint32_t i = 0; i < angle_.size(); ++i) {
        if (!chemistry.present[i]) continue;
        const auto around = chemistry.of(i);
        float sum = 0;
        int count = 0;
        for (std::size_t j = 0; j < around.size(); ++j)
            for (std::size_t k = j + 1; k < around.size(); ++k, ++count)
                sum += degreesBetween(work.position(around[j].atom) - work.position(i),
                                      work.position(around[k].atom) - work.position(i));
        if (count > 0) angle_[i] = sum / static_cast<float>(count);
        for (const Neighbour& n : around)
            if (work.inRing[n.bond]) place_[i] = kOtherRing;
    }
    // Flat rings before bent ones, smaller ones first.
    const auto rank = [](std::uint8_t place) {
        return place == kFiveFlat || place == kSixFlat ? 2 : place != kOtherRing;
    };
    for (std::size_t r = 0; r < chemistry.rings.size(); ++r) {
        const std::vector<std::uint32_t>& ring = chemistry.rings[r].atoms;
        const auto size = static_cast<std::uint8_t>(ring.size());
        const float torsion = work.ringTorsion[r];
        const bool flat = torsion <= kFlatTorsion;
        const OrderPlace place = size == 5   ? flat ? kFiveFlat : kFiveBent
                                 : size == 6 ? flat ? kSixFlat : kSixBent
                                             : kOtherRing;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            std::uint8_t& known = place_[ring[i]];
            if (place != kOtherRing && (known == kOtherRing || rank(place) > rank(known))) known = place;
            for (const Neighbour& n : chemistry.of(ring[i])) {
                if (n.atom != ring[(i + 1) % ring.size()]) continue;
                BondRing& of = ringOf_[n.bond];
                const bool better = of.size == 0 || (size == of.size ? torsion < of.torsion : size < of.size);
                if (better || (size == 6 && of.size == 5 && flat && of.torsion > kFlatTorsion)) of = {torsion, size};
            }
        }
    }
}

std::size_t OrderFeatures::hetero(std::uint32_t i, bool sulphur) const {
    std::size_t count = 0;
    for (const Neighbour& n : work_.chemistry.of(i)) {
        const Element e = work_.element(n.atom);
        count += e == kNitrogen || e == kOxygen || (sulphur && e == kSulphur);
    }
    return count;
}

std::size_t OrderFeatures::nitrogensAt(std::uint32_t i) const {
    std::size_t count = 0;
    for (const Neighbour& n : work_.chemistry.of(i)) count += work_.element(n.atom) == kNitrogen;
    return std::min<std::size_t>(count, 2);
}

/// Mean sine of the torsions about a bond; empty if one of its atoms has no other neighbour.
std::optional<float> OrderFeatures::measureTwist(const Bond& bond) const {
    const glm::vec3 a = work_.position(bond.a), b = work_.position(bond.b);
    float sum = 0;
    int count = 0;
    for (const Neighbour& m : work_.chemistry.of(bond.a)) {
        if (m.atom == bond.b) continue;
        const glm::vec3 u = glm::cross(work_.position(m.atom) - a, b - a);
        for (const Neighbour& n : work_.chemistry.of(bond.b)) {
            if (n.atom == bond.a) continue;
            const glm::vec3 v = glm::cross(work_.position(n.atom) - b, b - a);
            const float length = glm::length(u) * glm::length(v);
            if (length < 1e-9f) continue;
            sum += glm::length(glm::cross(u, v)) / length;
            ++count;
        }
    }
    return count > 0 ? std::optional(sum / static_cast<float>(count)) : std::nullopt;
}

}  // namespace nacre
