#pragma once
// Features that predict pi bonds from lengths, angles and rings where a file has no hydrogens. Each is a point on a
// curve of weights. Internal to this folder.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/molecule/chemistry/steps.h"

namespace nacre {

/// Lengths (Å) of a single bond between planar atoms, a double and a triple bond: Allen et al. (1987), J. Chem. Soc.
/// Perkin Trans. 2, S1, means over the Cambridge Structural Database.
struct BondLengths {
    Element a, b;
    float single, twofold, threefold;
    std::uint8_t pair;  ///< selects the curves: OrderPair
};
const BondLengths* bondLengths(Element a, Element b);

enum OrderPair : std::uint8_t { kPairCC, kPairCN, kPairCO, kPairCS, kPairNN, kPairNO, kPairOther, kOrderPairs };

/// Positions of weights on a curve, which is linear between them.
template <std::size_t N>
using Knots = std::array<float, N>;
constexpr Knots<8> kLengthKnots{-0.6f, -0.2f, 0.2f, 0.5f, 0.8f, 1.1f, 1.5f, 2.2f};  // 0: double, 1: single
constexpr Knots<5> kTripleKnots{-0.5f, 0, 0.5f, 1, 1.5f};                           // 0: triple, 1: double
constexpr Knots<6> kTorsionKnots{0, 5, 10, 15, 25, 40};                             // degrees, mean in a ring
constexpr Knots<5> kTwistKnots{0, 0.2f, 0.45f, 0.7f, 1};                            // sine of the torsion of a bond
constexpr Knots<7> kThreeAngleKnots{109, 112, 114, 116, 118, 119, 120};             // degrees, mean of three
constexpr Knots<8> kTwoAngleKnots{105, 110, 114, 118, 122, 126, 135, 150};          // degrees
constexpr Knots<4> kLinearKnots{140, 155, 165, 175};

/// Place of a bond or an atom: outside rings, in a ring of five or six that is flat or bent, in another ring.
enum OrderPlace : std::uint8_t { kAcyclic, kFiveFlat, kFiveBent, kSixFlat, kSixBent, kOtherRing, kOrderPlaces };

/// First weights of the curves. Each comment names what selects a weight.
enum OrderFeature : std::uint16_t {
    kByLength = 0,                                            // pair; length
    kInFive = kByLength + kOrderPairs * kLengthKnots.size(),  // CC, CN, other; torsion of the ring
    kInSix = kInFive + 3 * kTorsionKnots.size(),              // the same
    kInOther = kInSix + 3 * kTorsionKnots.size(),             // CC, CN, other; size: up to 4, up to 9, larger
    kLeadsOut = kInOther + 9,                                 // CC, CN, CO, other; number of ends in flat rings
    kTwisted = kLeadsOut + 12,                                // CC, CN, other; twist
    kUntwisted = kTwisted + 3 * kTwistKnots.size(),           // CC, CN, other: no torsion
    kCarbonyl = kUntwisted + 3,                               // N and O beside a terminal oxygen's carbon
    kImine = kCarbonyl + 4,                                   // degree of N; N and O at its carbon
    kTriple = kImine + 12,                                    // CC, CN, other; length
    kCarbonThree = kTriple + 3 * kTripleKnots.size(),         // place, or where rings meet; mean angle
    kCarbonHetero = kCarbonThree + (kOrderPlaces + 1) * kThreeAngleKnots.size(),  // N, O and S at a carbon of three
    kCarbonTwo = kCarbonHetero + 4,                                               // place; angle
    kCarbonEnd = kCarbonTwo + kOrderPlaces * kTwoAngleKnots.size(),
    kCarbonLinear = kCarbonEnd + 1,                                          // angle
    kNitrogenThree = kCarbonLinear + kLinearKnots.size(),                    // place; mean angle: of a pi bond
    kNitrogenTwo = kNitrogenThree + kOrderPlaces * kThreeAngleKnots.size(),  // place; angle
    kNitrogenBesideN = kNitrogenTwo + kOrderPlaces * kTwoAngleKnots.size(),  // number of N neighbours
    kNitrogenLinear = kNitrogenBesideN + 3,                                  // angle
    kNitrogenEnd = kNitrogenLinear + kLinearKnots.size(),                    // 0 and 2 pi bonds
    kEnd = kNitrogenEnd + 2,  // O, S, Se; number of its atom's neighbours, up to 4
    kOrderWeights = kEnd + 8
};

/// Reads features of atoms and bonds. Each function calls add(weight, value) for each feature.
class OrderFeatures {
public:
    explicit OrderFeatures(const ChemistryWork& work);

    /// Adds the features of a pi bond. @param index  of the bond
    template <typename Add>
    void pi(std::uint32_t index, const BondLengths& lengths, const Add& add) const {
        const Bond& bond = work_.molecule.bonds[index];
        const float length = work_.length(bond.a, bond.b);
        const std::size_t group = lengths.pair <= kPairCN ? lengths.pair : 2;
        curve(kByLength + lengths.pair * kLengthKnots.size(), kLengthKnots,
              (length - lengths.twofold) / (lengths.single - lengths.twofold), add);
        const BondRing& ring = ringOf_[index];
        if (ring.size == 5 || ring.size == 6) {
            curve((ring.size == 5 ? kInFive : kInSix) + group * kTorsionKnots.size(), kTorsionKnots, ring.torsion, add);
        } else if (work_.inRing[index]) {
            add(kInOther + group * 3 + (ring.size == 0 ? 2u : ring.size > 4 ? 1u : 0u), 1.0f);
        } else {
            const std::size_t outer = lengths.pair <= kPairCO ? lengths.pair : 3;
            const std::size_t flat = std::size_t{inFlatRing(bond.a)} + std::size_t{inFlatRing(bond.b)};
            add(kLeadsOut + outer * 3 + flat, 1.0f);
            if (const std::optional<float> twist = measureTwist(bond))
                curve(kTwisted + group * kTwistKnots.size(), kTwistKnots, *twist, add);
            else
                add(kUntwisted + group, 1.0f);
        }
        if (lengths.pair == kPairCO) {
            const std::uint32_t carbon = work_.element(bond.a) == kCarbon ? bond.a : bond.b;
            add(kCarbonyl + std::min<std::size_t>(hetero(carbon, false) - 1, 3), 1.0f);
        }
        if (lengths.pair == kPairCN) {
            const bool first = work_.element(bond.a) == kCarbon;
            const std::uint32_t carbon = first ? bond.a : bond.b, nitrogen = first ? bond.b : bond.a;
            const std::size_t degree = std::clamp<std::size_t>(work_.degree(nitrogen), 1, 3) - 1;
            add(kImine + degree * 4 + std::min<std::size_t>(hetero(carbon, false) - 1, 3), 1.0f);
        }
    }

    /// Adds the features of a second pi bond, in addition to those of the first.
    template <typename Add>
    void secondPi(std::uint32_t index, const BondLengths& lengths, const Add& add) const {
        const Bond& bond = work_.molecule.bonds[index];
        const float length = work_.length(bond.a, bond.b);
        curve(kTriple + (lengths.pair <= kPairCN ? lengths.pair : 2u) * kTripleKnots.size(), kTripleKnots,
              (length - lengths.threefold) / (lengths.twofold - lengths.threefold), add);
    }

    /// Adds the features of an atom with so many pi bonds. @param count  0, 1 or 2
    template <typename Add>
    void atom(std::uint32_t i, int count, const Add& add) const {
        const std::size_t degree = work_.degree(i);
        switch (work_.element(i)) {
            case kCarbon:
                if (count == 0 && degree == 3) {
                    const std::size_t place = ringsMeet(i) ? std::size_t{kOrderPlaces} : ringPlace(i);
                    curve(kCarbonThree + place * kThreeAngleKnots.size(), kThreeAngleKnots, angle_[i], add);
                    add(kCarbonHetero + std::min<std::size_t>(hetero(i, true), 3), 1.0f);
                }
                if (count == 0 && degree == 2)
                    curve(kCarbonTwo + ringPlace(i) * kTwoAngleKnots.size(), kTwoAngleKnots, angle_[i], add);
                if (count == 0 && degree == 1) add(kCarbonEnd, 1.0f);
                if (count == 2 && degree == 2) curve(kCarbonLinear, kLinearKnots, angle_[i], add);
                break;
            case kNitrogen:
                if (count == 1 && degree == 3)
                    curve(kNitrogenThree + ringPlace(i) * kThreeAngleKnots.size(), kThreeAngleKnots, angle_[i], add);
                if (count == 0 && degree == 2) {
                    curve(kNitrogenTwo + ringPlace(i) * kTwoAngleKnots.size(), kTwoAngleKnots, angle_[i], add);
                    add(kNitrogenBesideN + nitrogensAt(i), 1.0f);
                }
                if (count == 2 && degree == 2) curve(kNitrogenLinear, kLinearKnots, angle_[i], add);
                if (degree == 1 && count != 1) add(kNitrogenEnd + (count == 2 ? 1u : 0u), 1.0f);
                break;
            default: {
                if (count != 0 || degree != 1) break;
                const std::size_t others =
                    std::clamp<std::size_t>(work_.degree(work_.chemistry.of(i).front().atom), 1, 4);
                add(kEnd + (work_.element(i) == kOxygen ? 0u : 4u) + others - 1, 1.0f);
                break;
            }
        }
    }

    /// Mean angle between an atom's bonds, degrees; 0 with fewer than two.
    float angle(std::uint32_t i) const { return angle_[i]; }

private:
    struct BondRing {
        float torsion = 0;
        std::uint8_t size = 0;  ///< of the smallest ring; 0: none, or a large one
    };
    static constexpr float kFlatTorsion = 15;  // degrees

    template <std::size_t N, typename Add>
    static void curve(std::size_t first, const Knots<N>& knots, float x, const Add& add) {
        if (x <= knots.front()) return add(first, 1.0f);
        for (std::size_t i = 1; i < N; ++i) {
            if (x > knots[i]) continue;
            const float share = (x - knots[i - 1]) / (knots[i] - knots[i - 1]);
            add(first + i - 1, 1 - share);
            return add(first + i, share);
        }
        add(first + N - 1, 1.0f);
    }

    /// Whether an atom's bonds are all in rings.
    bool ringsMeet(std::uint32_t i) const {
        const auto around = work_.chemistry.of(i);
        return std::all_of(around.begin(), around.end(), [&](const Neighbour& n) { return work_.inRing[n.bond] != 0; });
    }
    bool inFlatRing(std::uint32_t i) const { return ringPlace(i) == kFiveFlat || ringPlace(i) == kSixFlat; }
    std::size_t ringPlace(std::uint32_t i) const { return place_[i]; }
    std::size_t hetero(std::uint32_t i, bool sulphur) const;
    std::size_t nitrogensAt(std::uint32_t i) const;
    std::optional<float> measureTwist(const Bond& bond) const;

    const ChemistryWork& work_;
    std::vector<BondRing> ringOf_;     // by bond
    std::vector<std::uint8_t> place_;  // by atom: OrderPlace
    std::vector<float> angle_;         // by atom
};

/// Fitted to bond orders of ligands of the Protein Data Bank.
extern const std::array<float, kOrderWeights> kOrderWeight;

}  // namespace nacre
