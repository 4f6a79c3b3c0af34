// Tables of colours and values: CSV, JSON, and files as Mol* has them.

#include "app/input/color_file.h"

#include <gtest/gtest.h>

#include "app/picture/appearance_values.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "tests/support/error_text.h"
#include "tests/support/test_data.h"

namespace nacre::app {
namespace {

ColorTable csv(const std::string& text, const std::string& column = "") {
    return readColorTable(text, "a.csv", column);
}

TEST(ColorFile, ReadsCsvOfResiduesAndAtoms) {
    const ColorTable t =
        csv("# a comment\n"
            "chain,resi,atom,color,label\n"
            "A,12,,red,\"active, site\"\r\n"
            "\n"
            "B,-3,CA,#00ff00,\n"
            "B,10-20,,blue,\n"
            "B,52A,,blue,\n");
    ASSERT_EQ(t.rows.size(), 4u);
    EXPECT_EQ(*t.rows[0].chain, "A");
    EXPECT_EQ(t.rows[0].numbers->first, 12);
    EXPECT_EQ(t.rows[0].color, 0xff0000ffu);
    EXPECT_EQ(t.rows[0].label, "active, site");
    EXPECT_EQ(t.rows[0].number, 3u);
    EXPECT_FALSE(t.rows[0].atom);
    EXPECT_EQ(*t.rows[1].atom, "CA");
    EXPECT_EQ(t.rows[1].numbers->first, -3);
    EXPECT_EQ(t.rows[2].numbers->last, 20);
    EXPECT_EQ(*t.rows[3].insertionCode, 'A');
}

TEST(ColorFile, TheOnlyUnknownColumnHasTheValues) {
    const ColorTable t = csv("chain\tresi\tconservation\nA\t1\t0.5\nA\t2\t\nA\t3\t1e-2\n");
    EXPECT_EQ(t.title, "conservation");
    ASSERT_EQ(t.rows.size(), 2u) << "what has no value says nothing";
    EXPECT_EQ(t.rows[1].value, 0.01);
    EXPECT_EQ(csv("resi;a;b\n1;2;3\n", "b").rows[0].value, 3);
}

TEST(ColorFile, ReadsJsonByRowsAndByColumnsAsMolstarDoes) {
    const ColorTable rows = readColorTable(
        R"([{"label_asym_id": "A", "beg_label_seq_id": 1, "end_label_seq_id": 13, "color": "#FF0000", "tooltip": "x"},
            {"label_asym_id": "B", "pdbx_PDB_ins_code": null, "color": "blue"}])",
        "a.json", "");
    ASSERT_EQ(rows.rows.size(), 2u);
    EXPECT_EQ(rows.rows[0].labelNumbers->last, 13);
    EXPECT_FALSE(rows.rows[0].numbers);
    EXPECT_FALSE(rows.rows[1].insertionCode);
    const ColorTable columns = readColorTable(
        R"({"auth_asym_id": ["A", "A"], "beg_auth_seq_id": [1, 200], "end_auth_seq_id": [137, 200],
            "color": ["#121212", "#FF0000"]})",
        "a.json", "");
    ASSERT_EQ(columns.rows.size(), 2u);
    EXPECT_EQ(columns.rows[0].numbers->last, 137);
}

TEST(ColorFile, TellsWhatIsWrongAndInWhichLine) {
    const std::pair<const char*, const char*> wrong[] = {
        {"chain,resi,value\nA,1,0.5\nA,x,0.5\n", "(line 3): 'x' is not a residue number"},
        {"chain,resi,value\nA,1,high\n", "(line 2): 'high' is not a number"},
        {"chain,resi,value\nA,1,nan\n", "(line 2)"},
        {"chain,resi,color\nA,1,rde\n", "(line 2)"},
        {"chain,resi,value\nA,1\n", "(line 2): it has 2 values, where the header names 3"},
        {"chain,resi,a,b\nA,1,2,3\n", "which column has the values: a or b?"},
        {"chain,resi\nA,1\n", "no column has colours or values"},
        {"value\n1\n", "no column names residues or atoms"},
        {"", "no row"},
        {"[{\"resi\": 1, \"value\": \n]", "(line 2): it is not valid JSON"},
        {"[{\"resi\": 1, \"value\": 5E5555}]", "a number is too large: '5E5555'"},
        {R"([{"resi": 1, "value": 1}, {"resi": "q", "value": 2}])", "(row 2): 'q' is not a residue number"},
        {R"({"resi": [1, 2], "value": [1]})", "has 1 values, where others have 2"}};
    for (const auto& [text, why] : wrong) {
        test::expectThrows([&] { csv(text); }, why);
    }
    EXPECT_THROW(csv("resi,value\n1,2\n", "nothing"), Error);
}

TEST(ColorSource, IsWrittenAsItIsRead) {
    for (const char* text : {"a.csv", "C:\\new\\a.csv", "a.csv:value=score:0..1:viridis", "csv:resi,value;1,2",
                             "[{\"resi\":1,\"value\":2}]"})
        EXPECT_EQ(colorSourceText(parseColorSource(text)), text);
    EXPECT_EQ(colorSourceText(parseColorSource("resi,value\n1,2\n")), "csv:resi,value;1,2;");
    EXPECT_THROW(parseColorSource("a.csv:muted"), std::invalid_argument);
    EXPECT_THROW(parseColorSource("a.csv:1..1"), std::invalid_argument);
}

/// Colours of some atoms of glucose-like numbering: 1CRN, whose residues are A 1 to A 46.
Representation crambin(const std::vector<std::string>& tables, const std::string& rule = "") {
    const Molecule m = readMoleculeFile(test::dataFile("1crn.pdb"));
    RepresentationOptions look{.style = Style::spacefill, .color = Coloring::uniform(0xff111111)};
    for (const std::string& table : tables) look.colorFrom.push_back(parseColorSource(table));
    if (!rule.empty()) look.rules.push_back(parseColorBy(rule));
    return represent(m, drawnAtoms(m), withTables(look));
}

TEST(ColorFrom, ColoursWhatItNamesUnderTheRules) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(test::dataFile("1crn.pdb"));
    const Representation r = crambin({"csv:chain,resi,color;A,1-3,red;A,2,blue;Z,1,red"}, "resi 3=green");
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        const std::uint32_t atom = r.sphereLooks[i].atom - 1;
        const std::int32_t number = m.residues[m.atoms[atom].residue].number;
        const std::uint32_t wanted = number == 1   ? 0xff0000ffu
                                     : number == 2 ? 0xffff0000u
                                     : number == 3 ? 0xff008000u
                                                   : 0xff111111u;
        EXPECT_EQ(r.sphereLooks[i].color, wanted) << number;
    }
    ASSERT_FALSE(r.warnings.empty());
    EXPECT_NE(r.warnings[0].find("1 of 3 rows"), std::string::npos) << r.warnings[0];
    EXPECT_NE(r.warnings[0].find("line 4"), std::string::npos) << r.warnings[0];
}

TEST(ColorFrom, ValuesRunAlongARampAsBFactorsDo) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(test::dataFile("1crn.pdb"));
    std::string table = "csv:id,b";
    for (std::size_t i = 0; i < m.atoms.size(); ++i)
        table += ";" + std::to_string(i + 1) + "," + std::to_string(m.atoms[i].temperatureFactor);
    const Representation mine = crambin({table});
    RepresentationOptions look{.style = Style::spacefill, .color = ColorScheme::bFactor};
    const Representation theirs = represent(m, drawnAtoms(m), look);
    ASSERT_EQ(mine.spheres.size(), theirs.spheres.size());
    for (std::size_t i = 0; i < mine.spheres.size(); ++i)
        EXPECT_EQ(mine.sphereLooks[i].color, theirs.sphereLooks[i].color);
    const auto legend = std::ranges::find_if(mine.legends, [](const Legend& l) { return l.stops > 0; });
    ASSERT_NE(legend, mine.legends.end());
    EXPECT_EQ(legend->scheme, "b");
    EXPECT_EQ(legend->entries.front().label, theirs.legends[0].entries.front().label);
}

TEST(ColorFrom, TellsLabelNumbersFromTheAuthors) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(test::dataFile("1bna.cif"));
    // Chain B is numbered 13 to 24 by the author, 1 to 12 by its sequence.
    for (const char* text : {"label_asym_id,label_seq_id,value\nB,1,5\n", "chain,resi,value\nB,13,5\n"}) {
        const ColorTable table = csv(text);
        const TableMatch match = matchTable(m, table);
        std::size_t matched = 0;
        for (std::size_t i = 0; i < match.rows.size(); ++i)
            if (match.rows[i] != TableMatch::kNone) {
                ++matched;
                EXPECT_EQ(m.residues[m.atoms[i].residue].number, 13);
            }
        EXPECT_GT(matched, 10u) << text;
    }
    EXPECT_EQ(matchTable(m, csv("label_asym_id,label_seq_id,value\nB,13,5\n")).idle, 1u);
}

TEST(ColorFrom, ReadsAnnotationsOfMolstar) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(test::dataFile("mvs/1cbs.cif.gz"));
    for (const char* name : {"rainbow", "auth_residue", "auth_residue_range", "chain_label", "validation"}) {
        RepresentationOptions look;
        look.colorFrom.push_back(parseColorSource(test::dataFile("mvs/1cbs-" + std::string(name) + ".json")));
        const RepresentationOptions read = withTables(look);
        const TableMatch match = matchTable(m, *read.colorFrom[0].table);
        EXPECT_EQ(match.idle, 0u) << name;
    }
}

}  // namespace
}  // namespace nacre::app
