#pragma once
// Writes BinaryCIF with the encodings that servers use: FixedPoint, Delta, RunLength, IntegerPacking, StringArray,
// masks.

#include <cmath>
#include <functional>
#include <map>

#include "engine/molecule/element.h"
#include "engine/molecule/molecule.h"
#include "tests/molecule/msgpack_writer.h"

namespace nacre::test {

inline std::string bcifEncoding(const std::string& kind, std::vector<std::pair<std::string, std::string>> rest = {}) {
    rest.emplace(rest.begin(), "kind", packText(kind));
    return packMap(rest);
}
inline std::string bcifByteArray(int type) { return bcifEncoding("ByteArray", {{"type", packInteger(type)}}); }

inline std::string bcifData(const std::string& bytes, const std::vector<std::string>& encodings) {
    return packMap({{"data", packBinary(bytes)}, {"encoding", packArray(encodings)}});
}
inline std::string bcifColumn(const std::string& name, const std::string& data, const std::string& mask = "\xC0") {
    return packMap({{"name", packText(name)}, {"data", data}, {"mask", mask}});
}
inline std::string bcifCategory(const std::string& name, std::int64_t rows, const std::vector<std::string>& columns) {
    return packMap({{"name", packText(name)}, {"rowCount", packInteger(rows)}, {"columns", packArray(columns)}});
}
inline std::string bcifFile(const std::vector<std::string>& categories) {
    const std::string block = packMap({{"header", packText("TEST")}, {"categories", packArray(categories)}});
    return packMap({{"encoder", packText("test")}, {"version", packText("0.3.0")}, {"dataBlocks", packArray({block})}});
}

using BcifIntegers = std::vector<std::int32_t>;

inline std::string int32Bytes(const BcifIntegers& values) {
    std::string bytes;
    bytes.reserve(values.size() * 4);
    for (const std::int32_t value : values) bytes += littleEndian(static_cast<std::uint32_t>(value), 4);
    return bytes;
}
inline std::string bcifPlain(const BcifIntegers& values) { return bcifData(int32Bytes(values), {bcifByteArray(3)}); }

/// Delta, then IntegerPacking into 16 bits; `first` goes before them (FixedPoint).
inline std::string bcifPackedDeltas(BcifIntegers values, std::vector<std::string> first = {}) {
    const std::int32_t origin = values.empty() ? 0 : values.front();
    for (std::size_t i = values.size(); i-- > 1;) values[i] -= values[i - 1];
    if (!values.empty()) values.front() = 0;
    std::string bytes;
    for (std::int32_t value : values) {
        const std::int32_t extreme = value < 0 ? -32768 : 32767;
        for (; value < 0 ? value <= extreme : value >= extreme; value -= extreme)
            bytes += littleEndian(static_cast<std::uint32_t>(extreme), 2);
        bytes += littleEndian(static_cast<std::uint32_t>(value), 2);
    }
    first.push_back(bcifEncoding("Delta", {{"origin", packInteger(origin)}, {"srcType", packInteger(3)}}));
    first.push_back(bcifEncoding("IntegerPacking", {{"byteCount", packInteger(2)},
                                                    {"isUnsigned", packBoolean(false)},
                                                    {"srcSize", packInteger(std::int64_t(values.size()))}}));
    first.push_back(bcifByteArray(2));
    return bcifData(bytes, first);
}

inline std::string bcifRuns(const BcifIntegers& values) {
    BcifIntegers runs;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i == 0 || values[i] != values[i - 1]) runs.insert(runs.end(), {values[i], 0});
        ++runs.back();
    }
    const auto size = static_cast<std::int64_t>(values.size());
    return bcifData(
        int32Bytes(runs),
        {bcifEncoding("RunLength", {{"srcSize", packInteger(size)}, {"srcType", packInteger(3)}}), bcifByteArray(3)});
}

inline std::string bcifStrings(std::size_t rows, const std::function<std::string(std::size_t)>& toText) {
    std::map<std::string, std::int32_t> known;
    BcifIntegers indices, offsets{0};
    std::string all;
    for (std::size_t i = 0; i < rows; ++i) {
        const auto [found, added] = known.emplace(toText(i), static_cast<std::int32_t>(known.size()));
        if (added) {
            all += found->first;
            offsets.push_back(static_cast<std::int32_t>(all.size()));
        }
        indices.push_back(found->second);
    }
    std::string bytes;
    for (const std::int32_t index : indices) bytes += littleEndian(static_cast<std::uint32_t>(index), 2);
    return bcifData(bytes, {bcifEncoding("StringArray", {{"dataEncoding", packArray({bcifByteArray(5)})},
                                                         {"stringData", packText(all)},
                                                         {"offsetEncoding", packArray({bcifByteArray(3)})},
                                                         {"offsets", packBinary(int32Bytes(offsets))}})});
}

/// A molecule's atoms as _atom_site, with as many different texts to a column as fit 16 bits.
inline std::string writeBcif(const Molecule& molecule) {
    const std::size_t rows = molecule.atoms.size();
    const auto integers = [&](const auto& of) {
        BcifIntegers values(rows);
        for (std::size_t i = 0; i < rows; ++i) values[i] = static_cast<std::int32_t>(of(i));
        return values;
    };
    const auto atom = [&](std::size_t i) -> const Atom& { return molecule.atoms[i]; };
    const auto residue = [&](std::size_t i) -> const Residue& { return molecule.residues[atom(i).residue]; };
    const auto fixed = [&](const char* name, double factor, const auto& of) {
        const auto values = integers([&](std::size_t i) { return std::lround(static_cast<double>(of(i)) * factor); });
        return bcifColumn(name,
                          bcifPackedDeltas(values, {bcifEncoding("FixedPoint", {{"factor", packNumber(factor)}})}));
    };
    const auto text = [&](const char* name, const auto& of, const std::string& mask = "\xC0") {
        return bcifColumn(name, bcifStrings(rows, [&](std::size_t i) { return std::string(of(i)); }), mask);
    };
    const auto alternate = [&](std::size_t i) {
        return atom(i).alternate == '\0' ? std::string() : std::string(1, atom(i).alternate);
    };
    std::vector<std::string> columns = {
        text("group_PDB", [&](std::size_t i) { return atom(i).hetero ? "HETATM" : "ATOM"; }),
        bcifColumn("id", bcifPackedDeltas(integers([](std::size_t i) { return i + 1; }))),
        text("type_symbol", [&](std::size_t i) { return elementSymbol(atom(i).element); }),
        text("label_atom_id", [&](std::size_t i) { return atom(i).name.view(); }),
        text("label_alt_id", alternate, bcifRuns(integers([&](std::size_t i) { return atom(i).alternate == '\0'; }))),
        text("label_comp_id", [&](std::size_t i) { return residue(i).name.view(); }),
        text("label_asym_id", [&](std::size_t i) { return molecule.subchains[residue(i).subchain]; }),
        text("auth_asym_id", [&](std::size_t i) { return molecule.chains[residue(i).chain].name; }),
        bcifColumn("auth_seq_id", bcifRuns(integers([&](std::size_t i) { return residue(i).number; }))),
        fixed("Cartn_x", 1000, [&](std::size_t i) { return atom(i).position.x; }),
        fixed("Cartn_y", 1000, [&](std::size_t i) { return atom(i).position.y; }),
        fixed("Cartn_z", 1000, [&](std::size_t i) { return atom(i).position.z; }),
        fixed("occupancy", 100, [&](std::size_t i) { return atom(i).occupancy; }),
        fixed("B_iso_or_equiv", 100, [&](std::size_t i) { return atom(i).temperatureFactor; }),
        bcifColumn("pdbx_PDB_model_num", bcifRuns(BcifIntegers(rows, 1)))};
    return bcifFile({bcifCategory("_atom_site", static_cast<std::int64_t>(rows), columns)});
}

}  // namespace nacre::test
