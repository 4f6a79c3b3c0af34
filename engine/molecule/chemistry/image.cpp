#include "engine/molecule/chemistry/image.h"

namespace nacre {
namespace {

/// Appends what a list holds once more. @param shift  changes a copied value
template <typename T, typename Shift>
void repeat(std::vector<T>& list, const Shift& shift) {
    const std::size_t count = list.size();
    list.reserve(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        list.push_back(list[i]);
        shift(list.back());
    }
}

template <typename T>
void repeat(std::vector<T>& list) {
    repeat(list, [](T&) {});
}

}  // namespace

Molecule withImage(const Molecule& molecule, const glm::dmat4x3& image) {
    const auto atoms = static_cast<std::uint32_t>(molecule.atoms.size());
    const auto residues = static_cast<std::uint32_t>(molecule.residues.size());
    Molecule both;
    both.atoms = molecule.atoms;
    both.residues = molecule.residues;
    both.chains = molecule.chains;
    both.modelsAreInputs = molecule.modelsAreInputs;
    both.file.title = molecule.file.title;
    repeat(both.atoms, [&](Atom& atom) {
        atom.position = glm::vec3(image * glm::dvec4(atom.position, 1));
        atom.residue += residues;
    });
    repeat(both.residues, [&](Residue& residue) { residue.firstAtom += atoms; });
    return both;
}

Chemistry withImage(const Chemistry& chemistry) {
    const auto atoms = static_cast<std::uint32_t>(chemistry.present.size());
    const auto bonds = static_cast<std::uint32_t>(chemistry.order.size());
    const auto neighbours = static_cast<std::uint32_t>(chemistry.neighbours.size());
    Chemistry both = chemistry;
    for (std::vector<std::uint8_t>* list : {&both.present, &both.order, &both.aromatic, &both.delocalised, &both.hybrid,
                                            &both.aromaticAtom, &both.hydrogens})
        repeat(*list);
    repeat(both.charge);
    both.first.pop_back();
    repeat(both.first, [&](std::uint32_t& first) { first += neighbours; });
    both.first.push_back(2 * neighbours);
    repeat(both.neighbours, [&](Neighbour& n) { n = {n.atom + atoms, n.bond + bonds}; });
    repeat(both.rings, [&](Ring& ring) {
        for (std::uint32_t& atom : ring.atoms) atom += atoms;
    });
    return both;
}

Features withImage(const Features& features, const Chemistry& chemistry) {
    const auto atoms = static_cast<std::uint32_t>(chemistry.present.size());
    const auto residues = static_cast<std::uint32_t>(features.receptor.size());
    const auto rings = static_cast<std::uint32_t>(chemistry.rings.size());
    Features both = features;
    const auto shifted = [&](std::uint32_t& atom) { atom += atoms; };
    const auto ends = [&](HalogenEnd& end) {
        end.atom += atoms;
        end.base += atoms;
    };
    for (std::vector<std::uint32_t>* list :
         {&both.acceptors, &both.hydrophobic, &both.metals, &both.metalBinders, &both.waters})
        repeat(*list, shifted);
    repeat(both.donors, [&](Donor& donor) { donor.atom += atoms; });
    repeat(both.halogens, ends);
    repeat(both.halogenAcceptors, ends);
    repeat(both.charged, [&](ChargedGroup& group) {
        for (std::vector<std::uint32_t>* list : {&group.atoms, &group.centre})
            for (std::uint32_t& atom : *list) atom += atoms;
    });
    repeat(both.rings, [&](std::uint32_t& ring) { ring += rings; });
    repeat(both.unit, [&](std::uint32_t& unit) { unit += residues; });
    for (std::vector<std::uint8_t>* list : {&both.waterOxygen, &both.receptor}) repeat(*list);
    return both;
}

}  // namespace nacre
