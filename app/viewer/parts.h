#pragma once
// A molecule as people speak of it: chains, ligands, ions, water; and what a view's rules say of each.

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
    std::string name;       ///< "Chain A, HIV-1 protease", "amprenavir"; where the file has no names "Chain A", "HEM"
    std::string selection;  ///< "chain A and polymer"
    std::size_t residues = 0, atoms = 0;
    std::uint32_t chain = 0;  ///< index into Molecule::chains, of a chain
    std::string input = {};   ///< name of the molecule that it is of, if there are several
};

constexpr std::size_t kMostParts = 200;

/// Chains in the file's order, then ligands, ions and water; of a molecule that has none of these, all of it.
/// Of several molecules the same for each. At most kMostParts.
/// @param inputs  names of the molecules, if there are several
std::vector<Part> partsOf(const ResidueFacts& facts, const std::vector<std::string>& inputs = {});

/// Whether a part is seen, and how, as far as rules of just its selection say.
struct PartLook {
    bool seen = true;
    std::optional<Style> style;        ///< empty: as all
    std::optional<Coloring> coloring;  ///< empty: as all
};
PartLook lookOf(const PictureDescription& view, const Part& part);
/// Gives a part a look: by rules of just its selection, behind all others.
void setLookOf(PictureDescription& view, const Part& part, const PartLook& look);

/// Residues of a chain that have letters: the polymer, in the file's order. @param chain  index into Molecule::chains
/// @returns indices into Molecule::residues
std::vector<std::uint32_t> sequenceOf(const ResidueFacts& facts, std::uint32_t chain);
/// 'X' where a residue of a polymer is none of the usual.
char letterOf(const Residue& residue);
/// Neighbours of a sequence, as a selection: "chain A and resi 10-15". @param input  as Part::input
std::string residuesText(const Molecule& molecule, std::uint32_t first, std::uint32_t last,
                         const std::string& input = {});

/// Words that go on from what is typed: key words, names of chains and residues of the molecule.
/// @returns whole texts, the likeliest first, at most `most`
std::vector<std::string> completions(const std::string& typed, const Molecule& molecule, std::size_t most);

}  // namespace nacre::app
