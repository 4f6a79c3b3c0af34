#pragma once
// The connection tables of MOL and SDF files (BIOVIA, "CTfile Formats").

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/text.h"

namespace nacre {

struct CtabCounts {
    std::int64_t atoms = 0;
    std::int64_t bonds = 0;
};

/// The first two numbers of a counts line; they may be negative or wrong.
std::optional<CtabCounts> parseCountsV2000(std::string_view line);

/// Read the table that follows the header. @throws Error with the line
/// @param lines stands on the counts line
/// @return what was read
CtabCounts readCtabV2000(MoleculeBuilder& builder, LineReader& lines, std::string_view counts);
CtabCounts readCtabV3000(MoleculeBuilder& builder, LineReader& lines);

/// Drawn order of a bond type: aromatic 4; queries and coordination are single; 0 for hydrogen bonds, which are not
/// stored.
int bondOrderOfCtab(std::int64_t type);

/// Adds an atom named by the file's own symbol.
void addCtabAtom(MoleculeBuilder& builder, std::string_view symbol, glm::vec3 position, std::int64_t charge,
                 std::uint64_t line);

}  // namespace nacre
