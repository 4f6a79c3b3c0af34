#pragma once
// Small molecules written out by hand, atom by atom.

#include <string_view>

#include "engine/molecule/element.h"
#include "engine/molecule/molecule.h"

namespace nacre::test {

class MoleculeText {
public:
    MoleculeText& residue(std::string_view name, int number = 1, char insertionCode = '\0') {
        if (molecule.chains.empty()) molecule.chains.push_back({"A"});
        Residue residue;
        residue.name = name;
        residue.number = number;
        residue.insertionCode = insertionCode;
        residue.firstAtom = static_cast<std::uint32_t>(molecule.atoms.size());
        molecule.residues.push_back(residue);
        return *this;
    }
    MoleculeText& atom(std::string_view name, std::string_view symbol, glm::vec3 position, char alternate = '\0',
                       float occupancy = 1) {
        Atom atom;
        atom.name = name;
        atom.element = elementFromSymbol(symbol);
        atom.position = position;
        atom.alternate = alternate;
        atom.occupancy = occupancy;
        atom.residue = static_cast<std::uint32_t>(molecule.residues.size() - 1);
        molecule.atoms.push_back(atom);
        ++molecule.residues.back().atomCount;
        return *this;
    }

    Molecule molecule;
};

}  // namespace nacre::test
