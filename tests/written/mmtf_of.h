#pragma once
// Writes a molecule as MMTF: every residue a group type of its own, arrays as plain 32-bit values.

#include <algorithm>
#include <bit>

#include "engine/molecule/element.h"
#include "engine/molecule/molecule.h"
#include "tests/molecule/mmtf_writer.h"

namespace nacre::test {

inline std::string mmtfIntegers(const std::vector<std::int64_t>& values) {
    std::string bytes;
    for (const std::int64_t value : values) bytes += bigEndian(static_cast<std::uint64_t>(value), 4);
    return mmtfArray(4, values.size(), 0, bytes);
}

inline std::string mmtfCoordinates(const Molecule& molecule, int axis) {
    std::string bytes;
    for (const Atom& atom : molecule.atoms) bytes += bigEndian(std::bit_cast<std::uint32_t>(atom.position[axis]), 4);
    return mmtfArray(1, molecule.atoms.size(), 0, bytes);
}

/// A residue with the bonds inside it.
inline std::string mmtfGroup(const Molecule& molecule, const Residue& residue) {
    std::vector<std::string> names, symbols, bonds, orders;
    const std::uint32_t end = residue.firstAtom + residue.atomCount;
    for (std::uint32_t i = residue.firstAtom; i < end; ++i) {
        names.push_back(packText(molecule.atoms[i].name.view()));
        symbols.push_back(packText(elementSymbol(molecule.atoms[i].element)));
    }
    for (const Bond& bond : molecule.bonds) {
        if (bond.a < residue.firstAtom || bond.b >= end) continue;
        for (const std::uint32_t atom : {bond.a, bond.b}) bonds.push_back(packInteger(atom - residue.firstAtom));
        orders.push_back(packInteger(bond.order));
    }
    const bool hetero = molecule.atoms[residue.firstAtom].hetero;
    return packMap({{"groupName", packText(residue.name.view())},
                    {"chemCompType", packText(hetero ? "NON-POLYMER" : "DNA LINKING")},
                    {"atomNameList", packArray(names)},
                    {"elementList", packArray(symbols)},
                    {"bondAtomList", packArray(bonds)},
                    {"bondOrderList", packArray(orders)}});
}

/// @param molecule  one model, its residues in the order of its chains
inline std::string writeMmtf(const Molecule& molecule) {
    std::vector<std::string> groups, groupsOfChain;
    std::vector<std::int64_t> types, numbers, linked;
    std::string chainNames, linkOrders;
    for (std::size_t chain = 0; chain < molecule.chains.size(); ++chain) {
        groupsOfChain.push_back(packInteger(std::count_if(molecule.residues.begin(), molecule.residues.end(),
                                                          [&](const Residue& r) { return r.chain == chain; })));
        std::string name = molecule.chains[chain].name;
        name.resize(4);
        chainNames += name;
    }
    for (const Residue& residue : molecule.residues) {
        types.push_back(static_cast<std::int64_t>(groups.size()));
        numbers.push_back(residue.number);
        groups.push_back(mmtfGroup(molecule, residue));
    }
    for (const Bond& bond : molecule.bonds) {
        if (molecule.atoms[bond.a].residue == molecule.atoms[bond.b].residue) continue;
        linked.insert(linked.end(), {bond.a, bond.b});
        linkOrders += static_cast<char>(bond.order);
    }
    const auto count = [](std::size_t value) { return packInteger(static_cast<std::int64_t>(value)); };
    const std::size_t chains = molecule.chains.size();
    return packMap({{"mmtfVersion", packText("1.0.0")},
                    {"numAtoms", count(molecule.atoms.size())},
                    {"numBonds", count(molecule.bonds.size())},
                    {"numGroups", count(groups.size())},
                    {"numChains", count(chains)},
                    {"numModels", count(1)},
                    {"chainsPerModel", packArray({count(chains)})},
                    {"groupsPerChain", packArray(groupsOfChain)},
                    {"chainIdList", mmtfArray(5, chains, 4, chainNames)},
                    {"chainNameList", mmtfArray(5, chains, 4, chainNames)},
                    {"groupList", packArray(groups)},
                    {"groupTypeList", mmtfIntegers(types)},
                    {"groupIdList", mmtfIntegers(numbers)},
                    {"bondAtomList", mmtfIntegers(linked)},
                    {"bondOrderList", mmtfArray(2, linkOrders.size(), 0, linkOrders)},
                    {"xCoordList", mmtfCoordinates(molecule, 0)},
                    {"yCoordList", mmtfCoordinates(molecule, 1)},
                    {"zCoordList", mmtfCoordinates(molecule, 2)}});
}

}  // namespace nacre::test
