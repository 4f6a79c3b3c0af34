// Which partners of a metal belong to the best-fitting geometry, by PLIP's method.

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/molecule/chemistry/interaction_search.h"

namespace nacre {
namespace {

/// The angles (degrees) from each partner of an ideal complex to the others: `sets` of equal angles, each with its
/// multiplicity.
struct IdealComplex {
    std::size_t partners;
    struct Set {
        std::size_t times, angles;
        double degrees[5];
    };
    std::size_t count;
    Set sets[2];
};

// From the largest number of partners to the smallest.
constexpr IdealComplex kComplexes[] = {{6, 1, {{6, 5, {90, 90, 90, 90, 180}}, {}}},
                                       {5, 2, {{3, 4, {120, 120, 90, 90}}, {2, 4, {90, 90, 90, 180}}}},
                                       {5, 2, {{4, 4, {90, 90, 90, 180}}, {1, 4, {90, 90, 90, 90}}}},
                                       {4, 1, {{4, 4, {109.5, 109.5, 109.5, 109.5}}, {}}},
                                       {4, 1, {{4, 4, {90, 90, 90, 90}}, {}}},
                                       {3, 1, {{3, 2, {120, 120}}, {}}},
                                       {3, 1, {{3, 2, {109.5, 109.5}}, {}}},
                                       {2, 1, {{2, 1, {180}}, {}}}};

using Angles = std::vector<std::vector<double>>;  // by partner: to each other one

/// Deviation of a partner's angles from an ideal set; each ideal angle takes the nearest remaining one.
double misfit(const std::vector<double>& observed, const IdealComplex::Set& set) {
    std::vector<std::uint8_t> used(observed.size());
    double sum = 0;
    for (std::size_t i = 0; i < set.angles; ++i) {
        std::optional<std::size_t> best;
        for (std::size_t j = 0; j < observed.size(); ++j)
            if (!used[j] &&
                (!best || std::abs(set.degrees[i] - observed[j]) < std::abs(set.degrees[i] - observed[*best])))
                best = j;
        if (!best) continue;
        used[*best] = 1;
        const double off = set.degrees[i] - observed[*best];
        sum += off * off;
    }
    return std::sqrt(sum);
}

struct Fit {
    double misfit = 0;
    std::size_t partners = 0;
    std::vector<std::uint8_t> left;  ///< by partner: it has no place
};

constexpr double kUnmatched = 999;  // PLIP's score of an empty place

Fit fitComplex(const IdealComplex& complex, const Angles& angles) {
    Fit fit{0, complex.partners, std::vector<std::uint8_t>(angles.size(), 1)};
    for (std::size_t s = 0; s < complex.count; ++s) {
        for (std::size_t time = 0; time < complex.sets[s].times; ++time) {
            double least = kUnmatched;
            std::optional<std::size_t> best;
            for (std::size_t i = 0; i < angles.size(); ++i) {
                if (!fit.left[i]) continue;
                const double off = misfit(angles[i], complex.sets[s]);
                if (off >= least) continue;
                least = off;
                best = i;
            }
            if (best) fit.left[*best] = 0;
            fit.misfit += least;
        }
    }
    fit.misfit /= static_cast<double>(complex.partners);
    return fit;
}

constexpr double kClearlyBetter = 0.5, kGoodFit = 3.5;

}  // namespace

std::vector<std::uint8_t> superfluousPartners(const glm::dvec3& metal, const std::vector<glm::dvec3>& partners) {
    const std::vector<std::uint8_t> none(partners.size());
    if (partners.size() < 2) return none;
    Angles angles(partners.size());
    for (std::size_t i = 0; i < partners.size(); ++i)
        for (std::size_t j = 0; j < partners.size(); ++j)
            if (i != j) angles[i].push_back(angleBetween(partners[i] - metal, partners[j] - metal));
    std::vector<Fit> fits;
    for (const IdealComplex& complex : kComplexes) fits.push_back(fitComplex(complex, angles));
    const auto off = [&](const Fit& fit) {
        return std::abs(static_cast<double>(fit.partners) - static_cast<double>(partners.size()));
    };
    std::stable_sort(fits.begin(), fits.end(), [&](const Fit& l, const Fit& r) { return off(l) < off(r); });
    for (std::size_t i = 0; i + 1 < fits.size(); ++i) {
        if (fits[i + 1].misfit - fits[i].misfit > kClearlyBetter) return fits[i].left;
        if (fits[i + 1].misfit < kGoodFit) return fits[i + 1].left;
    }
    return none;
}

}  // namespace nacre
