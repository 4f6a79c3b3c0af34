#pragma once
// Input of a cartoon: the residues of each unbroken stretch of a chain, and the points that guide the curve.

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "engine/mesh/cartoon.h"
#include "engine/molecule/molecule.h"

namespace nacre {

constexpr std::uint32_t kNoAtom = 0xffffffffu;

/// A helix or a strand: residues from first to last of a trace.
struct FoldRun {
    SecondaryStructure kind = SecondaryStructure::none;
    std::uint32_t first = 0, last = 0;
};

/// An unbroken stretch of a chain. Parameter u of its curve is i at point i.
struct Trace {
    bool nucleic = false;
    /// Residue i owns the curve from i - shift to i + 1 - shift: half of the way to both neighbours or, if points are
    /// phosphates, all of the way to the next.
    double shift = 0.5;
    std::vector<glm::dvec3> points;    ///< Å, in the file's frame; for a nucleic acid one more, at its 3' end
    std::vector<std::uint32_t> atoms;  ///< per residue: CA or C4', for colour and number
    std::vector<std::uint32_t>
        residues;  ///< index into the molecule's residues, of the first at the position; fused backbones repeat theirs
    std::vector<SecondaryStructure> kinds;
    std::vector<bool> shown;
    std::vector<bool> fused;            ///< one of the backbones that a residue without CA has
    std::vector<double> temperatures;   ///< B factor of the guide atoms, Å^2
    std::vector<glm::dvec3> carbonyls;  ///< from C to O; 0 where these are missing
};

/// The unbroken stretches of a molecule's chains, found once for many cartoons of it.
class ChainStretches {
public:
    /// @param facts  outlive this
    explicit ChainStretches(const ResidueFacts& facts);
    const ResidueFacts& facts() const { return facts_; }
    /// Traces with a shown residue. Takes time by their length, not by the molecule's.
    /// @param atoms, secondary  as for cartoon()
    std::vector<Trace> traces(std::span<const std::uint32_t> atoms,
                              std::span<const SecondaryStructure> secondary) const;

private:
    const ResidueFacts& facts_;
    std::shared_ptr<const void> index_;  ///< StretchIndex
};

/// The cartoon of a part of the molecule (cartoon.h).
Mesh cartoon(const ChainStretches& stretches, std::span<const std::uint32_t> atoms,
             std::span<const SecondaryStructure> secondary, const CartoonOptions& options, const glm::dvec3& origin);

/// @param atoms, secondary  as for cartoon()
std::vector<Trace> cartoonTraces(const ResidueFacts& facts, std::span<const std::uint32_t> atoms,
                                 std::span<const SecondaryStructure> secondary);

/// Helices of at least three and strands of at least two residues.
std::vector<FoldRun> foldRuns(const Trace& trace);

}  // namespace nacre
