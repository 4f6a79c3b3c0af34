#pragma once
// Elements of numbered or lettered types (LAMMPS, HOOMD), or grains if types are no elements.

#include <map>
#include <string>
#include <string_view>

#include "engine/molecule/formats/molecule_builder.h"

namespace nacre {

class LammpsTypes {
public:
    /// @param label  an element's symbol, or another name, or empty
    void add(std::string_view type, double mass, std::string_view label);

    /// Sets names and elements of atoms by their types. If types are no elements, all atoms become grains of a size
    /// that fits their distances.
    void apply(MoleculeBuilder& builder) const;

private:
    struct Kind {
        double mass = 0;
        std::string label;
    };
    std::map<std::string, Kind, std::less<>> kinds_;
};

/// Makes grains of all atoms without element. Their radius is half of the usual distance between neighbours.
void makeGrains(Molecule& molecule);

}  // namespace nacre
