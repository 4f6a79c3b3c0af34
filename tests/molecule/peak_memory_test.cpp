// What readers take at most while they read, measured: files at their bounds, each in a process of its own.

#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>

#include "engine/error.h"
#include "engine/molecule/memory_bound.h"
#include "tests/molecule/bcif_writer.h"
#include "tests/molecule/gzip_bytes.h"
#include "tests/molecule/mmtf_writer.h"
#include "tests/support/temporary_folder.h"

namespace nacre {
namespace {

using namespace test;

constexpr std::uint64_t kMemory = std::uint64_t{32} << 20;
const std::size_t kText = readWithin(kMemory).maxBytes, kMostAtoms = readWithin(kMemory).maxAtoms;

/// A line of /proc/self/status, in bytes.
std::int64_t statusBytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind(key + ":", 0) == 0) return std::stoll(line.substr(key.size() + 1)) * 1024;
    return -1;
}

/// Reads a file in a child, and says by how much its resident memory rose at most.
std::int64_t measurePeak(const std::string& path) {
    int ends[2];
    if (pipe(ends) != 0) return -1;
    const pid_t child = fork();
    if (child == 0) {
        malloc_trim(0);
        std::ofstream("/proc/self/clear_refs") << "5";  // the peak counts from here
        const std::int64_t before = statusBytes("VmRSS");
        try {
            const Molecule molecule = readMoleculeFile(path, readWithin(kMemory));
        } catch (const Error&) {
        }
        const std::int64_t rise = statusBytes("VmHWM") - before;
        const auto written = write(ends[1], &rise, sizeof rise);
        _exit(written == sizeof rise ? 0 : 1);
    }
    std::int64_t rise = -1;
    const auto got = read(ends[0], &rise, sizeof rise);
    int state = 0;
    waitpid(child, &state, 0);
    close(ends[0]);
    close(ends[1]);
    return got == sizeof rise && state == 0 ? rise : -1;
}

/// As many repetitions as the bound on text allows, between a head and a tail.
std::string filled(const std::string& head, const std::string& line, const std::string& tail = "") {
    std::string text = head;
    text.reserve(kText);
    while (text.size() + line.size() + tail.size() <= kText) text += line;
    return text + tail;
}
std::string times(std::size_t count, const std::function<std::string(std::size_t)>& getLine) {
    std::string text;
    for (std::size_t i = 0; i < count && text.size() < kText - 1024; ++i) text += getLine(i);
    return text;
}

struct Bound {
    std::string name;  ///< of the file; what it holds stands before the ending
    std::function<std::string()> bytes;
};

const std::string kSiteX = "data_a\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";

std::string makeRuns(std::int32_t value, std::size_t rows) {
    const std::string bytes = int32Bytes({value, static_cast<std::int32_t>(rows)});
    return bcifData(bytes, {bcifEncoding("RunLength", {{"srcSize", packInteger(static_cast<std::int64_t>(rows))}}),
                            bcifByteArray(3)});
}
/// _atom_site of as many rows as the file has bytes, all the same, and what else is given.
std::string bcifOfRows(std::size_t rows, std::vector<std::string> columns) {
    for (const char* name : {"Cartn_x", "Cartn_y", "Cartn_z"}) columns.push_back(bcifColumn(name, makeRuns(0, rows)));
    return bcifFile(
        {bcifCategory("_padding", 1, {bcifColumn("a", bcifData(std::string(rows, '0'), {bcifByteArray(4)}))}),
         bcifCategory("_atom_site", static_cast<std::int64_t>(rows), columns)});
}
std::string bcifSharedText(std::size_t rows, std::size_t length) {
    const std::string text = bcifData(
        int32Bytes({0, static_cast<std::int32_t>(rows)}),
        {bcifEncoding(
            "StringArray",
            {{"dataEncoding",
              packArray({bcifEncoding("RunLength", {{"srcSize", packInteger(std::int64_t(rows))}}), bcifByteArray(3)})},
             {"stringData", packText(std::string(length, 'a'))},
             {"offsetEncoding", packArray({bcifByteArray(3)})},
             {"offsets", packBinary(int32Bytes({0, static_cast<std::int32_t>(length)}))}})});
    std::vector<std::string> columns;
    for (int i = 0; i < 40; ++i) columns.push_back(bcifColumn("details" + std::to_string(i), text));
    const std::string padding =
        bcifCategory("_padding", 1, {bcifColumn("a", bcifData(std::string(rows, '0'), {bcifByteArray(4)}))});
    return bcifFile({padding, bcifCategory("_struct_conn", static_cast<std::int64_t>(rows), columns),
                     bcifCategory("_atom_site", 1,
                                  {bcifColumn("Cartn_x", bcifPlain({0})), bcifColumn("Cartn_y", bcifPlain({0})),
                                   bcifColumn("Cartn_z", bcifPlain({0}))})});
}

const std::vector<Bound>& cases() {
    static const std::string atom = "ATOM      1  C   LIG A   1       0.000   0.000   0.000  1.00  0.00           C\n";
    static const std::vector<Bound> list = {
        {"atoms.pdb", [] { return filled("", atom); }},
        {"conect.pdb", [] { return filled(atom, "CONECT    1    2    3    4    5\n"); }},
        {"helices.pdb", [] { return filled(atom, "HELIX    1   1 ALA A    1  ALA A    1  1\n"); }},
        {"biomolecules.pdb",
         [] {
             return filled(atom, "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S\n");
         }},
        {"atoms.pdbqt", [] { return filled("", atom); }},
        {"atoms.pqr", [] { return filled("", "ATOM 1 C LIG 1 0.0 0.0 0.0 0.0 1.7\n"); }},
        {"conect.pqr",
         [] { return filled("ATOM 1 C LIG 1 0.0 0.0 0.0 0.0 1.7\n", "CONECT    1    2    3    4    5\n"); }},
        {"atoms.xyz", [] { return filled("2000000\n\n", "C 0 0 0\n"); }},
        {"frames.xyz", [] { return filled("1\n\nC 0 0 0\n", "1\n\nC 0 0 0\n"); }},
        {"atoms.gro", [] { return filled("a\n500000\n", "    1LIG      C    1   0.000   0.000   0.000\n"); }},
        {"atoms.mol2", [] { return filled("@<TRIPOS>MOLECULE\na\n1 0\nSMALL\nNO\n@<TRIPOS>ATOM\n", "1 C 0 0 0 C\n"); }},
        {"bonds.mol2",
         [] {
             return filled(
                 "@<TRIPOS>MOLECULE\na\n2 0\nSMALL\nNO\n@<TRIPOS>ATOM\n1 C 0 0 0 C\n2 C 0 0 1 C\n@<TRIPOS>BOND\n",
                 "1 1 2 1\n");
         }},
        {"substructures.mol2",
         [] {
             return "@<TRIPOS>MOLECULE\na\n1 0\nSMALL\nNO\n@<TRIPOS>ATOM\n1 C 0 0 0 C\n@<TRIPOS>SUBSTRUCTURE\n" +
                    times(1'000'000, [](std::size_t i) { return std::to_string(i) + " A 1\n"; });
         }},
        {"bonds.sdf", [] { return filled("a\n\n\n2 1200000 0 V2000\n0 0 0 C\n0 0 1 C\n", "  1  2  1\n"); }},
        {"atoms.sdf",
         [] {
             return filled("a\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN ATOM\n",
                           "M  V30 1 C 0 0 0 0\n");
         }},
        {"bonds3000.sdf",
         [] {
             return filled(
                 "a\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN ATOM\nM  V30 1 C 0 0 0 0\n"
                 "M  V30 2 C 0 0 1 0\nM  V30 END ATOM\nM  V30 BEGIN BOND\n",
                 "M  V30 1 1 1 2\n");
         }},
        {"atoms.cml",
         [] {
             return filled("<cml><molecule><atomArray>", "<atom x3='0' y3='0' z3='0'/>",
                           "</atomArray></molecule></cml>");
         }},
        {"ids.cml",
         [] {
             return "<cml><molecule><atomArray>" +
                    times(1'000'000, [](std::size_t i) { return "<bond atomRefs2='a" + std::to_string(i) + " b'/>"; });
         }},
        {"bonds.cml",
         [] { return filled("<cml><molecule><bondArray atomRef1='", "a ", "' atomRef2='b'/></molecule></cml>"); }},
        {"atoms.cif", [] { return filled(kSiteX, "0 0 0\n"); }},
        {"chains.cif",
         [] {
             return kSiteX + "_atom_site.auth_asym_id\n" +
                    times(1'000'000, [](std::size_t i) { return "0 0 0 chain" + std::to_string(i) + "\n"; });
         }},
        {"longchains.cif",
         [] {
             return kSiteX + "_atom_site.auth_asym_id\n" + times(1'000'000, [](std::size_t i) {
                        return "0 0 0 " + std::string(240, 'a') + std::to_string(i) + "\n";
                    });
         }},
        {"models.cif",
         [] {
             return kSiteX + "_atom_site.pdbx_PDB_model_num\n" +
                    times(1'000'000, [](std::size_t i) { return "0 0 0 " + std::to_string(i) + "\n"; });
         }},
        {"cells.cif",
         [] { return filled(kSiteX + "0 0 0\nloop_\n_struct_conn.id\n_struct_conn.conn_type_id\n", "a covale\n"); }},
        {"component.cif",
         [] { return filled("data_a\nloop_\n_chem_comp_atom.x\n_chem_comp_atom.y\n_chem_comp_atom.z\n", "0 0 0\n"); }},
        {"values.json",
         [] {
             return filled("{\"data_a\":{\"atom_site\":{\"Cartn_x\":[0", ",0", "],\"Cartn_y\":[],\"Cartn_z\":[]}}}");
         }},
        {"objects.json", [] { return filled("{\"data_a\":{\"a\":[{}", ",{}", "]}}"); }},
        {"escapes.json", [] { return filled("{\"data_a\":{\"struct_conn\":{\"id\":[\"a\"", ",\"\\n\"", "]}}}"); }},
        {"rows.bcif", [] { return bcifOfRows(kText - 4096, {}); }},
        {"models.bcif",
         [] {
             const std::size_t rows = kText / 2;
             return bcifOfRows(
                 rows, {bcifColumn("pdbx_PDB_model_num",
                                   bcifData(int32Bytes({1, static_cast<std::int32_t>(rows)}),
                                            {bcifEncoding("Delta", {{"origin", packInteger(0)}}),
                                             bcifEncoding("RunLength", {{"srcSize", packInteger(std::int64_t(rows))}}),
                                             bcifByteArray(3)}))});
         }},
        {"strings.bcif",
         [] {
             const std::size_t rows = kText / 4;
             const std::string ones = int32Bytes({1, static_cast<std::int32_t>(rows)});
             const std::vector<std::string> counted = {
                 bcifEncoding("Delta", {{"origin", packInteger(-1)}}),
                 bcifEncoding("RunLength", {{"srcSize", packInteger(std::int64_t(rows))}}), bcifByteArray(3)};
             const std::string text =
                 bcifData(ones, {bcifEncoding("StringArray", {{"dataEncoding", packArray(counted)},
                                                              {"stringData", packText(std::string(rows, 'a'))},
                                                              {"offsetEncoding", packArray(counted)},
                                                              {"offsets", packBinary(ones)}})});
             return bcifOfRows(rows, {bcifColumn("auth_asym_id", text)});
         }},
        {"shared.bcif", [] { return bcifSharedText(100'000, 2'500); }},
        {"longshared.bcif", [] { return bcifSharedText(1'000, 200'000); }},
        {"atoms.mmtf", [] { return mmtfFile(kText - 8192, 1, kText - 4096); }},
        {"groups.mmtf", [] { return mmtfFile(1, (kText - 8192) / 4, kText - 4096); }},
        {"zeros.pdb.gz", [] { return gzipBytes(std::string(std::size_t{1} << 20, '\0'), 1000); }},
        {"rows.bcif.gz", [] { return gzipBytes(bcifOfRows(kText - 4096, {})); }},
    };
    return list;
}

TEST(PeakMemory, OfEveryFormatIsBounded) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "AddressSanitizer's own memory would be measured";
#endif
    const TemporaryFolder folder;
    for (const Bound& one : cases()) {
        SCOPED_TRACE(one.name);
        const std::string path = (std::filesystem::path(folder.path()) / one.name).string();
        {
            const std::string bytes = one.bytes();
            EXPECT_LE(bytes.size(), kText);
            std::ofstream(path, std::ios::binary) << bytes;
        }
        const std::int64_t peak = measurePeak(path);
        std::printf("%-22s %6.1f MB\n", one.name.c_str(), static_cast<double>(peak) / 1e6);
        EXPECT_GE(peak, 0);
        EXPECT_LE(peak, static_cast<std::int64_t>(kMemory));
        std::remove(path.c_str());
    }
}

}  // namespace
}  // namespace nacre
