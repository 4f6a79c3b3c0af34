#pragma once
// Sugars as symbols: the Symbol Nomenclature for Glycans (A. Varki et al., Glycobiology 25 (2015) 1323; shapes and
// colours of its update of 2019), as solids in space (3D-SNFG: D. F. Thieker et al., Glycobiology 26 (2016) 786).

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/molecule/molecule.h"

namespace nacre {

enum class SugarShape : std::uint8_t {
    sphere,          ///< hexoses
    cube,            ///< N-acetylhexosamines
    crossedCube,     ///< hexosamines: half of it white
    dividedDiamond,  ///< hexuronates: half of it white
    cone,            ///< deoxyhexoses
    dividedCone,     ///< N-acetylated ones: half of it white
    flatRectangle,   ///< dideoxyhexoses
    star,            ///< pentoses
    diamond,         ///< nonulosonates
    flatDiamond,     ///< dideoxynonulosonates
    flatHexagon,     ///< other sugars
    pentagon         ///< ketohexoses and the like
};

struct SugarSymbol {
    std::string_view name;  ///< "GlcNAc"
    SugarShape shape;
    std::uint32_t color;  ///< packed as in colors.h
};

/// The symbol of a residue by its name in the chemical component dictionary ("NAG"); null: not a known sugar.
const SugarSymbol* sugarSymbol(const Name& residue);

/// Whether a residue is drawn as a symbol: its name is known, and it has a ring.
bool isSugar(const Molecule& molecule, std::uint32_t residue);

struct SugarOptions {
    bool icons = false;  ///< small symbols, without sticks between them
    double scale = 1;
};

/// Second halves of two-coloured symbols have this bit in Mesh::atoms.
constexpr std::uint32_t kWhiteHalf = 0x80000000u;

/// The symbols of the sugars that contain some atoms, with sticks between bonded sugars, and to bonded atoms of other
/// residues. Mesh::atoms names a ring atom of each, with kWhiteHalf.
/// @param atoms  ascending @param origin  of the positions, Å, in the file's frame
Mesh sugarSymbols(const Molecule& molecule, const std::vector<std::uint32_t>& atoms, const SugarOptions& options,
                  const glm::dvec3& origin);

}  // namespace nacre
