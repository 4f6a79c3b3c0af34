// How a format is told, what is refused, and where bytes come from.
#include "engine/molecule/read.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/molecule/formats/detect.h"
#include "engine/molecule/formats/text_encoding.h"
#include "engine/molecule/text.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/error_text.h"
#include "tests/support/temporary_folder.h"

namespace nacre {
namespace {

const std::string kWater = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n";

TEST(Read, TheContentWinsOverTheName) {
    EXPECT_EQ(detectFormat("a.pdb", kWater), Format::xyz);
    EXPECT_EQ(detectFormat("a.xyz", "data_x\nloop_\n"), Format::mmcif);
    EXPECT_EQ(detectFormat("a", "#comment\n\nDATA_X\n"), Format::mmcif);
    EXPECT_EQ(detectFormat("a.cif", "{\"data_1ABC\":{}}"), Format::mmjson);
    EXPECT_EQ(detectFormat("a", "ATOM      1  C   LIG A   1      -1.799   0.022   0.602\n"), Format::pdb);
    EXPECT_EQ(detectFormat("a", "HEADER    PLANT PROTEIN\n"), Format::pdb);
    EXPECT_EQ(detectFormat("a", "name\nprog\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n"), Format::sdf);
}

TEST(Read, TextFormatsByTheirContent) {
    EXPECT_EQ(detectFormat("a", "# made by hand\n\n@<TRIPOS>MOLECULE\nx\n"), Format::mol2);
    const std::string pqr = "ATOM      1  N   MET     1     -68.369 -25.337  40.428 -0.3200 2.0000\n";
    EXPECT_EQ(detectFormat("a", pqr), Format::pqr);
    EXPECT_EQ(detectFormat("a.pdb", pqr), Format::pqr);
    const std::string docked = "ATOM      1  C1  DXC     1       2.952   1.919   1.076  1.00  0.00     0.118 C\n";
    EXPECT_EQ(detectFormat("a", docked), Format::pdbqt);
    EXPECT_EQ(detectFormat("a", "REMARK x\nROOT\n" + docked), Format::pdbqt);
    EXPECT_EQ(detectFormat("a", "title\n1\n    1THR      N    1   1.705   1.410   0.363\n1 1 1\n"), Format::gro);
    EXPECT_EQ(detectFormat("a", "<?xml version=\"1.0\"?>\n<cml><molecule/></cml>"), Format::cml);
    EXPECT_EQ(detectFormat("a", "<m:molecule xmlns:m=\"http://www.xml-cml.org/schema\"/>"), Format::cml);
    // PQR files are free in their columns, so that a name decides what might be either.
    EXPECT_EQ(detectFormat("a.pqr", "ATOM 1 N MET 1 -68.36 -25.33 40.42 -0.32 2.00\n"), Format::pqr);
}

TEST(Read, TheNameTellsWhatTheContentDoesNot) {
    for (const char* name : {"a.sdf", "A.MOL", "b.sd.gz", "/tmp.x/c.mdl"})
        EXPECT_EQ(detectFormat(name, "nothing known"), Format::sdf) << name;
    EXPECT_EQ(detectFormat("dir/a.ent.gz", "nothing known"), Format::pdb);
    test::expectError("structure", "nothing known", {"neither content nor name tell its format"});
    test::expectError("dir.pdb/structure", "nothing known", {"neither content nor name tell its format"});
}

TEST(Read, TheFormatThatIsStatedIsTaken) {
    ReadOptions options{.format = Format::xyz};
    EXPECT_EQ(readMolecule("a.pdb", kWater, options).file.format, "xyz");
    options.format = Format::sdf;
    test::expectError("a.xyz", kWater, {"(line 4)"}, options);
}

TEST(Read, KnownButUnsupported) {
    test::expectError("a", "<?xml version=\"1.0\"?>\n<PDBx:datablock></PDBx:datablock>",
                      {"format pdbml is not supported; supported: pdb, mmcif, mmjson, bcif, mmtf, sdf, xyz, mol2"});
    test::expectError("a.cif", "<!DOCTYPE html><html></html>", {"web page"});
}

TEST(Read, EveryLineEndAndAMark) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string text = "\xEF\xBB\xBF";
        for (const char c : kWater) text += c == '\n' ? std::string(end) : std::string(1, c);
        EXPECT_EQ(readMolecule("a", text).atoms.size(), 3u);
    }
}

TEST(Read, TextOfTwoBytesALetter) {
    for (const bool little : {true, false}) {
        std::string text = little ? "\xff\xfe" : "\xfe\xff";
        for (const char c : kWater) text += little ? std::string{c, '\0'} : std::string{'\0', c};
        EXPECT_EQ(readMolecule("a", text).atoms.size(), 3u);
        ReadOptions options{.format = Format::xyz};
        EXPECT_EQ(readMolecule("a", text, options).atoms.size(), 3u);
        options.maxBytes = text.size() - 1;
        test::expectError("a", text, {"larger than the limit"}, options);
    }
    const auto utf8 = [](std::string_view units) { return utf8FromUtf16(units).value_or("none"); };
    EXPECT_EQ(utf8("3"), "none");
    EXPECT_EQ(utf8("\xff\xfe"), "");
    EXPECT_EQ(utf8(std::string_view("\xfe\xff\0A\0\xe9\x20\xac\xd8\x3e\xdd\xea", 12)), "A\u00e9\u20ac\U0001f9ea");
    EXPECT_EQ(utf8(std::string_view("\xfe\xff\xd8\x3e\0A\xdd\xea\0", 9)), "\ufffdA\ufffd\ufffd");
}

TEST(Read, MessagesAreCleanWhateverNameAndContentHold) {
    const std::string name = "a\n\x1b[31m\xff\xc3\xa9.xyz";
    const std::string message = test::catchError(name, "1\n\nC \x01\xfe\x80 0 0\n");
    EXPECT_NE(message.find("a\\x0a\\x1b[31m\\xff\xc3\xa9.xyz (line 3)"), std::string::npos) << message;
    EXPECT_NE(message.find("\\x01\\xfe\\x80"), std::string::npos) << message;
    EXPECT_EQ(printable(std::string(1000, 'a'), 10), "aaaaaaaaaa...");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a lone surrogate
    EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");           // a control character of two bytes
    EXPECT_EQ(printable("\xf0\x9f\xa7\xaa"), "\xf0\x9f\xa7\xaa");
}

TEST(Read, AHugeLineIsJustALine) {
    const std::string atom = "ATOM      1  N   THR A   1      17.047  14.099   3.625  1.00 13.79           N\n";
    const std::string longRemark = "REMARK " + std::string(3'000'000, 'x') + "\n";
    EXPECT_EQ(readMolecule("a", longRemark + atom).atoms.size(), 1u);
    EXPECT_EQ(readMolecule("a", "data_x\n#" + longRemark +
                                    "_atom_site.Cartn_x 1\n_atom_site.Cartn_y 2\n"
                                    "_atom_site.Cartn_z 3\n")
                  .atoms.size(),
              1u);
    EXPECT_EQ(readMolecule("a.xyz", "1\n" + longRemark + "C 0 0 0\n").atoms.size(), 1u);
}

TEST(Read, ModelsCountFromOne) {
    ReadOptions options{.model = -1};
    test::expectError("a.xyz", kWater, {"numbered from 1"}, options);
    options.model = 2;
    test::expectError("a.xyz", kWater, {"no frame 2; the file has 1"}, options);
}

TEST(Read, NumbersOfText) {
    EXPECT_EQ(parseNumber(" +1.5D+02 "), 150.0);
    EXPECT_EQ(parseNumber("-.5"), -0.5);
    EXPECT_FALSE(parseNumber("1.5x"));
    EXPECT_FALSE(parseNumber("+-1"));
    EXPECT_FALSE(parseNumber(""));
    EXPECT_EQ(parseInteger(" 12"), 12);
    EXPECT_FALSE(parseInteger("99999999999999999999"));
    EXPECT_FALSE(parseInteger("1 2"));
}

TEST(Read, FilesAndWhatIsNone) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "water.xyz") << kWater;
    EXPECT_EQ(readMoleculeFile(folder / "water.xyz").atoms.size(), 3u);
    EXPECT_THROW(readMoleculeFile(folder / "absent.xyz"), Error);
    EXPECT_THROW(readMoleculeFile(folder.path()), Error);
    EXPECT_THROW(readMoleculeFile("/dev/zero", {.maxBytes = 1 << 20}), Error);
}

TEST(Read, StandardInput) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "water.xyz") << kWater;
    ASSERT_NE(std::freopen((folder / "water.xyz").c_str(), "rb", stdin), nullptr);
    EXPECT_EQ(readMoleculeFile("-").atoms.size(), 3u);
    EXPECT_EQ(test::errorText([&] { readMoleculeFile("-"); }), "cannot read molecule: standard input: it is empty");
}

}  // namespace
}  // namespace nacre
