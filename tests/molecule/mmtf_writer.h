#pragma once
// Writes MMTF files whose few bytes stand for many atoms.

#include "tests/molecule/msgpack_writer.h"

namespace nacre::test {

/// An array of numbers with its header. @param size  values that it announces
inline std::string mmtfArray(int codec, std::size_t size, int parameter, const std::string& data) {
    return packBinary(bigEndian(static_cast<std::uint32_t>(codec), 4) + bigEndian(size, 4) +
                      bigEndian(static_cast<std::uint32_t>(parameter), 4) + data);
}
/// `size` times the same integer, as a run.
inline std::string mmtfSame(std::size_t size, int value, int codec = 6, int parameter = 0) {
    return mmtfArray(codec, size, parameter, bigEndian(static_cast<std::uint32_t>(value), 4) + bigEndian(size, 4));
}

/// One chain of `groups` groups of one kind, all atoms at the origin; padded to at least `size` bytes.
inline std::string mmtfFile(std::size_t groups, std::size_t atomsOfGroup, std::size_t size) {
    const std::size_t atoms = groups * atomsOfGroup;
    const std::vector<std::string> symbols(atomsOfGroup,
                                           "\xA1"
                                           "C");
    const std::string group = packMap(
        {{"groupName", packText("LIG")}, {"atomNameList", packArray(symbols)}, {"elementList", packArray(symbols)}});
    const std::string zeros = mmtfSame(atoms, 0, 9, 1000);
    const auto count = [](std::size_t value) { return packInteger(static_cast<std::int64_t>(value)); };
    std::vector<std::pair<std::string, std::string>> fields = {
        {"mmtfVersion", packText("1.0.0")},
        {"numAtoms", count(atoms)},
        {"numGroups", count(groups)},
        {"numChains", count(1)},
        {"numModels", count(1)},
        {"groupsPerChain", packArray({count(groups)})},
        {"chainsPerModel", packArray({count(1)})},
        {"chainIdList", mmtfArray(5, 1, 4, std::string("A\0\0\0", 4))},
        {"groupList", packArray({group})},
        {"groupTypeList", mmtfSame(groups, 0)},
        {"groupIdList", mmtfSame(groups, 1)},
        {"xCoordList", zeros},
        {"yCoordList", zeros},
        {"zCoordList", zeros}};
    const std::size_t bytes = packMap(fields).size();
    if (bytes < size) fields.emplace_back("padding", packBinary(std::string(size - bytes, ' ')));
    return packMap(fields);
}

}  // namespace nacre::test
