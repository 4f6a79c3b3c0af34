#include "tests/benchmark/gemmi_mmcif.h"

#include <gemmi/cif.hpp>
#include <gemmi/mmcif.hpp>
#include <gemmi/pdb.hpp>

namespace nacre::test {

namespace {

std::size_t countAtoms(const gemmi::Model& model) {
    std::size_t atoms = 0;
    for (const gemmi::Chain& chain : model.chains)
        for (const gemmi::Residue& residue : chain.residues) atoms += residue.atoms.size();
    return atoms;
}

}  // namespace

std::size_t gemmiPdb(const std::string& bytes) {
    const gemmi::Structure structure = gemmi::read_pdb_from_memory(bytes.data(), bytes.size(), "file");
    return countAtoms(structure.models.at(0));
}

std::size_t gemmiMmcif(const std::string& bytes) {
    const gemmi::cif::Document document = gemmi::cif::read_memory(bytes.data(), bytes.size(), "file");
    const gemmi::Structure structure = gemmi::make_structure_from_block(document.blocks.at(0));
    return countAtoms(structure.models.at(0));
}

}  // namespace nacre::test
