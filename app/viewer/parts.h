#pragma once
// Parts of a molecule: chains, ligands, ions, water; and the rules of a view for each.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/saved_view.h"
#include "engine/molecule/residue_facts.h"

namespace nacre::app {

struct Part {
    enum class Kind { all, chain, ligand, ion, water };
    Kind kind = Kind::all;
    std::string name;       ///< "Chain A, HIV-1 protease", "amprenavir"; without names in the file "Chain A", "HEM"
    std::string selection;  ///< "chain A and polymer"
    std::size_t residues = 0, atoms = 0;
    std::uint32_t chain = 0;  ///< index into Molecule::chains, for a chain
    std::string input = {};   ///< name of its molecule, if there are several
    /// Short enough for a row: "A  alpha" for "Chain A, Hemoglobin subunit alpha" if there is a subunit beta.
    std::string label = {};
    std::string chainName = {}, title = {};  ///< of a chain: "A", and its name in the file, if any
};

constexpr std::size_t kMostParts = 200;

/// Chains in file order, then ligands, ions and water; the whole molecule if it has none of these. For a packed scene,
/// its compartments and entities. For several molecules, the parts of each. At most kMostParts.
/// @param inputs  names of the molecules, if there are several
/// @param ofResidue  if not null: receives for each residue its part, or kNoPart; for a packed scene its entity
std::vector<Part> listParts(const ResidueFacts& facts, const std::vector<std::string>& inputs = {},
                            std::vector<std::uint32_t>* ofResidue = nullptr);
constexpr std::uint32_t kNoPart = 0xffffffff;

/// Visibility and look of a part, from rules for exactly its selection.
struct PartLook {
    bool seen = true;
    std::optional<Style> style;        ///< empty: same as molecule
    std::optional<Coloring> coloring;  ///< empty: same as molecule
};
PartLook findLook(const PictureDescription& view, const Part& part);
/// A name in the syntax of selections: plain, or in quotes.
std::string quotedName(const std::string& name);
/// Sets a part's look by rules for exactly its selection, after all others.
void setPartLook(PictureDescription& view, const Part& part, const PartLook& look);

/// Residues of a chain that have letters: the polymer, in file order.
/// @param chain  index into Molecule::chains @returns indices into Molecule::residues
std::vector<std::uint32_t> findSequence(const ResidueFacts& facts, std::uint32_t chain);
/// 'X' for an unusual residue of a polymer.
char residueLetter(const Residue& residue);
/// Consecutive residues as a selection: "chain A and resi 10-15". @param input  as Part::input
std::string residuesText(const Molecule& molecule, std::uint32_t first, std::uint32_t last,
                         const std::string& input = {});

/// The probably intended selection for an invalid text: "heme" for the component of that name, "Asp25", "D25" and "ASP"
/// for its residues, "25" for a number, "A" for a chain. Empty if the molecule has none.
std::string meantSelection(const std::string& typed, const Molecule& molecule);

/// Completions of a typed selection: keywords, names of chains and residues of the molecule.
/// @returns whole texts, most likely first, at most `most`
std::vector<std::string> completions(const std::string& typed, const Molecule& molecule, std::size_t most);

}  // namespace nacre::app
