#include "engine/molecule/zhang_skolnik.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string_view>

namespace nacre {
namespace {

constexpr std::uint32_t kNoCarbon = 0xffffffffu;
constexpr Element kElementOfTrace = 6;
constexpr std::size_t kWindow = 5;

/// Distances of alpha carbons 2, 3 and 4 residues apart, and their tolerance, Å.
struct Pattern {
    SecondaryStructure kind;
    std::array<double, 3> distances;
    double tolerance;
    std::size_t fewest;  ///< residues in a row
};
constexpr std::array<Pattern, 2> kPatterns{{{SecondaryStructure::helix, {5.45, 5.18, 6.37}, 2.1, 4},
                                            {SecondaryStructure::strand, {6.1, 10.4, 13.0}, 1.42, 3}}};

struct AlphaCarbon {
    std::uint32_t residue = 0, atom = kNoCarbon;
    bool nitrogen = false, oxygen = false;
};

/// Alpha carbons of chains without other backbone atoms, in the file's order.
std::vector<AlphaCarbon> loneAlphaCarbons(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    std::vector<AlphaCarbon> carbons(molecule.residues.size());
    for (std::uint32_t r = 0; r < carbons.size(); ++r) carbons[r].residue = r;
    for (const std::uint32_t index : facts.conformer()) {
        const Atom& atom = molecule.atoms[index];
        const std::string_view name = atom.name.view();
        AlphaCarbon& carbon = carbons[facts.positions()[atom.residue]];
        if (name == "CA" && atom.element == kElementOfTrace && carbon.atom == kNoCarbon) carbon.atom = index;
        carbon.nitrogen |= name == "N";
        carbon.oxygen |= name == "O";
    }
    std::vector<bool> whole(molecule.chains.size());
    for (const AlphaCarbon& c : carbons)
        if (c.atom != kNoCarbon && c.nitrogen && c.oxygen) whole[molecule.residues[c.residue].chain] = true;
    std::erase_if(carbons, [&](const AlphaCarbon& c) {
        return c.atom == kNoCarbon || whole[molecule.residues[c.residue].chain];
    });
    return carbons;
}

bool fits(const Pattern& pattern, const Molecule& molecule, std::span<const AlphaCarbon, kWindow> row) {
    for (std::size_t i = 0; i < kWindow; ++i)
        for (std::size_t j = i + 2; j < kWindow; ++j) {
            const glm::dvec3 a = molecule.atoms[row[i].atom].position, b = molecule.atoms[row[j].atom].position;
            if (!(std::abs(glm::distance(a, b) - pattern.distances[j - i - 2]) < pattern.tolerance)) return false;
        }
    return true;
}

SecondaryStructure findKind(const Molecule& molecule, std::span<const AlphaCarbon, kWindow> row) {
    const std::uint32_t chain = molecule.residues[row[0].residue].chain;
    for (const AlphaCarbon& c : row)
        if (molecule.residues[c.residue].chain != chain) return SecondaryStructure::none;
    for (const Pattern& pattern : kPatterns)
        if (fits(pattern, molecule, row)) return pattern.kind;
    return SecondaryStructure::none;
}

void dropShort(std::vector<SecondaryStructure>& kinds) {
    for (std::size_t first = 0, end; first < kinds.size(); first = end) {
        for (end = first + 1; end < kinds.size() && kinds[end] == kinds[first];) ++end;
        for (const Pattern& pattern : kPatterns)
            if (kinds[first] == pattern.kind && end - first < pattern.fewest)
                std::fill(kinds.begin() + static_cast<std::ptrdiff_t>(first),
                          kinds.begin() + static_cast<std::ptrdiff_t>(end), SecondaryStructure::none);
    }
}

}  // namespace

std::vector<SecondaryStructure> zhangSkolnik(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    std::vector<SecondaryStructure> kinds(molecule.residues.size(), SecondaryStructure::none);
    const std::vector<AlphaCarbon> carbons = loneAlphaCarbons(facts);
    std::vector<SecondaryStructure> found(carbons.size(), SecondaryStructure::none);
    for (std::size_t i = 0; i + kWindow <= carbons.size(); ++i)
        found[i + kWindow / 2] = findKind(molecule, std::span(carbons).subspan(i).first<kWindow>());
    dropShort(found);
    for (std::size_t i = 0; i < carbons.size(); ++i) kinds[carbons[i].residue] = found[i];
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = kinds[facts.positions()[i]];
    return kinds;
}

}  // namespace nacre
