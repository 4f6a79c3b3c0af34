#pragma once
// Shared by the readers of assemblies: transforms, operator expressions, and limits against hostile files.

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Why an assembly is omitted; becomes a warning.
struct AssemblyFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Three rows of four numbers: rotation and shift (Å).
using TransformRows = std::array<double, 12>;

/// The product: `second` is applied first, then `first`.
TransformRows multiply(const TransformRows& first, const TransformRows& second);
/// @throws AssemblyFault if a number is not finite or beyond ±1e9
glm::mat4x3 toMatrix(const TransformRows& rows);

/// Limits for all assemblies of a file together. There may be as many transforms as atoms: with its name, a transform
/// takes less memory until it is on the device (memory_bound.h).
class AssemblyLimits {
public:
    static constexpr std::size_t kMaxAssemblies = 10'000;
    static constexpr std::size_t kFewTransforms = std::size_t{1} << 16;  ///< always allowed: 3 MB of matrices
    static constexpr std::size_t kMaxTransforms = std::size_t{1} << 22;  ///< 200 MB
    static constexpr std::size_t kMaxSubchains = std::size_t{1} << 22;   ///< mentions of subchains, 17 MB

    /// @param maxAtoms  number of atoms that fit into memory
    explicit AssemblyLimits(std::size_t maxAtoms)
        : maxTransforms_(std::clamp(maxAtoms, kFewTransforms, kMaxTransforms)), transforms_(maxTransforms_) {}

    /// @throws AssemblyFault if less than that is left
    void spend(std::size_t transforms, std::size_t subchains);

private:
    std::size_t maxTransforms_, transforms_, subchains_ = kMaxSubchains;
};

using TransformsById = std::map<std::string, TransformRows, std::less<>>;

/// The transforms of an mmCIF operator expression: "1", "1,2,5-8", "P", "(1-60)(61-88)", "(X0)(1-60)". In a product the
/// last factor is applied first and varies fastest.
/// @returns a part without subchains
/// @throws AssemblyFault if it is malformed, names a missing operator, or exceeds the limits
AssemblyPart expandOperators(std::string_view expression, const TransformsById& operators, AssemblyLimits& limits);

/// Adds a part, with subchains in any order and repeated, to an assembly; extends the previous part if it has the same
/// subchains. Adds nothing without transforms or subchains.
void addPart(Assembly& assembly, AssemblyPart part);

/// The warning about an assembly that cannot be placed.
std::string leftOutWarning(std::string_view id, const std::string& why);
/// The molecule's warning about an assembly, or about any. Empty: none.
std::string findLeftOutWarning(const Molecule& molecule, std::string_view id = {});

/// Assemblies of one molecule for another, whose subchains are numbered differently.
std::vector<Assembly> assembliesFor(const Molecule& to, const Molecule& from);

}  // namespace nacre
