// What a run prints and writes: streams, aliases, what must not reach a terminal, and views from others.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;
using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::readContents;
using test::TemporaryFolder;

constexpr const char* kAtom = "ATOM      1  C   GLY A   1       0.000   0.000   0.000  1.00  0.00           C\n";
constexpr const char* kTiny = " --size 32x32 --occlusion off";

void put(const std::string& path, const std::string& content) { std::ofstream(path) << content; }

TEST(Outputs, ADashIsStandardOutput) {
    const TemporaryFolder folder;
    EXPECT_EQ(nacreIn(folder, std::string("render sample:glucose -o -") + kTiny).out.substr(1, 3), "PNG");
    EXPECT_EQ(nacreIn(folder, std::string("render sample:glucose -o /dev/stdout") + kTiny).out.substr(1, 3), "PNG");
    const Outcome stats = nacreIn(folder, std::string("render sample:glucose -o a.png --stats -") + kTiny);
    EXPECT_EQ(nlohmann::json::parse(stats.out)["atoms"]["read"], 24);
    EXPECT_EQ(stats.err, "");
    const Outcome layers = nacreIn(folder, std::string("render sample:glucose -o a.png --layers -") + kTiny);
    EXPECT_EQ(layers.out.substr(0, 4), "\x76\x2f\x31\x01");
    EXPECT_EQ(nacreIn(folder, std::string("render sample:glucose -o - --stats -") + kTiny).code, 2);
    EXPECT_EQ(folder.count(), 1u);
    const Outcome full = nacreIn(folder, std::string("render sample:glucose -o -") + kTiny, ">/dev/full");
    EXPECT_EQ(full.code, 1);
    EXPECT_NE(full.err.find("standard output"), std::string::npos) << full.err;
}

/// Width, height and dots a metre of a PNG.
std::array<std::uint32_t, 3> readPaper(const std::string& png) {
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(png.at(at + i));
        return value;
    };
    const std::size_t physical = png.find("pHYs");
    return {word(16), word(20), physical == std::string::npos ? 0 : word(physical + 4)};
}

TEST(Outputs, PaperBecomesPixels) {
    const TemporaryFolder folder;
    const auto drawn = [&](const std::string& options) {
        const Outcome outcome = nacreDone(folder, "render sample:glucose -o - --occlusion off " + options);
        return readPaper(outcome.out);
    };
    using Paper = std::array<std::uint32_t, 3>;
    EXPECT_EQ(drawn("--width 8mm"), (Paper{94, 94, 11811}));  // at 300 dots per inch
    EXPECT_EQ(drawn("--width 8mm --size 40x30 --dpi 127"), (Paper{40, 30, 5000}));
    EXPECT_EQ(drawn("--width 1cm --height 0.5in --dpi 100"), (Paper{39, 50, 3937}));
    EXPECT_EQ(drawn("--height 60px --size 40x30"), (Paper{80, 60, 0}));
    EXPECT_EQ(drawn("--size 40x30 --dpi 254"), (Paper{40, 30, 10000}));
}

TEST(Outputs, PointsGoByTheDotsAnInch) {
    const TemporaryFolder folder;
    const std::string same = "render sample:glucose -o - --occlusion off --size 64x64 --title A ";
    const std::string points = nacreIn(folder, same + "--dpi 144 --contours 1pt --text-size 8pt").out;
    EXPECT_EQ(points, nacreIn(folder, same + "--dpi 144 --contours 2 --text-size 16").out);
    EXPECT_NE(points, nacreIn(folder, same + "--dpi 144 --contours 1 --text-size 16").out);
}

TEST(Outputs, AreWrittenByAProgramThatIsFoundAlongThePath) {
    const TemporaryFolder folder;
    const fs::path program = NACRE_PROGRAM;
    const std::string command = "cd '" + folder.path() + "' && PATH='" + program.parent_path().string() + "' " +
                                program.filename().string() + " render sample:glucose -o a.png" + kTiny;
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_TRUE(fs::exists(folder / "a.png"));
}

TEST(Outputs, NothingThatIsReadIsReplaced) {
    const TemporaryFolder folder;
    put(folder / "m.pdb", kAtom);
    put(folder / "v.json", R"({"input": "m.pdb"})");
    fs::create_symlink("m.pdb", folder / "link.json");
    fs::create_hard_link(folder / "v.json", folder / "hard.json");
    for (const char* arguments :
         {"view m.pdb --stats m.pdb", "view m.pdb --stats link.json", "view --view v.json --stats hard.json",
          "view --view v.json --stats m.pdb", "render m.pdb -o a.png --stats link.json",
          "render --view v.json -o a.png --stats v.json", "render --view v.json -o a.png --stats hard.json",
          "render --view v.json -o a.png --stats m.pdb", "render - -o a.png --stats m.pdb"}) {
        const Outcome outcome = nacreIn(folder, arguments, "<m.pdb");
        EXPECT_EQ(outcome.code, 2) << arguments;
        EXPECT_NE(outcome.err.find("are the same file"), std::string::npos) << arguments << ": " << outcome.err;
    }
    EXPECT_EQ(readContents(folder / "m.pdb"), kAtom);
    EXPECT_EQ(readContents(folder / "v.json"), R"({"input": "m.pdb"})");
    EXPECT_EQ(folder.count(), 4u);
}

/// No byte that a terminal would obey, and valid UTF-8 as far as C1 goes.
void expectHarmless(const std::string& text, const std::string& what) {
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        EXPECT_TRUE(byte == '\n' || (byte >= 0x20 && byte != 0x7f)) << what << ": " << int{byte};
    }
    for (const char* bytes : {"\xc2\x9b", "\xe2\x80\xae", "\xff"})
        EXPECT_EQ(text.find(bytes), std::string::npos) << what;
}

TEST(Outputs, NothingFromOutsideCommandsTheTerminal) {
    const TemporaryFolder folder;
    const std::string evil =
        "\x1b]0;x\a\x1b[2J\xc2\x9b"
        "31m\xe2\x80\xae\xff";
    put(folder / "title.pdb", "TITLE     A" + evil + "\n" + kAtom);
    put(folder / "m.cif", "data_x\n_struct.title '" + evil +
                              "'\nloop_\n_atom_site.id\n_atom_site.type_symbol\n"
                              "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 C 0 0 0\n");
    put(folder / ("n" + evil + ".pdb"), kAtom);
    put(folder / "bad.pdb", "ATOM      1  C   GLY A   1       " + evil.substr(0, 8) + "\n");
    put(folder / "v.json", "{\"" + std::string("\\u001b[2J\\u009b\\u202e") + "\": 1}");
    const std::vector<std::string> runs = {"info title.pdb",
                                           "info m.cif",
                                           "info title.pdb --json",
                                           "info n*.pdb",
                                           "info bad.pdb",
                                           "info $(printf 'x\\033[2J')",
                                           "render sample:glucose --view v.json -o a.png",
                                           "render sample:glucose -o $(printf 'a\\033.bmp')",
                                           "render sample:glucose -o a.png --color $(printf 'r\\033ed')",
                                           "render n*.pdb -o a.png --water hide --hide all",
                                           "$(printf 'fr\\033ob')",
                                           "info $(printf -- '--fr\\033ob')",
                                           "render sample:glucose -o a.png --hide \"$(printf 'chain \\033')\""};
    for (const std::string& arguments : runs) {
        const Outcome outcome = nacreIn(folder, arguments);
        expectHarmless(outcome.out, arguments);
        expectHarmless(outcome.err, arguments);
        EXPECT_FALSE(outcome.out.empty() && outcome.err.empty()) << arguments;
    }
    EXPECT_NE(nacreIn(folder, "info n*.pdb").out.find("\\x1b[2J"), std::string::npos);
}

TEST(Outputs, InfoTakesSeveralFiles) {
    const TemporaryFolder folder;
    put(folder / "m.pdb", kAtom);
    const Outcome text = nacreDone(folder, "info sample:glucose m.pdb");
    EXPECT_NE(text.out.find("sample:glucose ("), std::string::npos);
    EXPECT_NE(text.out.find("\nm.pdb (pdb)"), std::string::npos) << text.out;
    const auto json = nlohmann::json::parse(nacreIn(folder, "info sample:glucose m.pdb --json").out);
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(json[1]["file"], "m.pdb");
    EXPECT_EQ(json[1]["atoms"], 1);
    // One that cannot be read is told, and keeps no other back.
    const Outcome some = nacreIn(folder, "info none.pdb m.pdb gone.pdb");
    EXPECT_EQ(some.code, 1);
    EXPECT_NE(some.out.find("m.pdb (pdb)"), std::string::npos);
    EXPECT_EQ(std::count(some.err.begin(), some.err.end(), '\n'), 2) << some.err;
}

TEST(Outputs, QuietKeepsWarningsBackAndErrorsNot) {
    const TemporaryFolder folder;
    const std::string render = std::string("render sample:glucose -o a.png --hide 'chain Z'") + kTiny;
    EXPECT_NE(nacreIn(folder, render).err.find("nacre: warning: "), std::string::npos);
    EXPECT_EQ(nacreIn(folder, render + " --quiet").err, "");
    EXPECT_NE(nacreIn(folder, "info none.pdb -q").err, "");
}

TEST(Outputs, OneCameraIsForAllModelsUnlessAsked) {
    const TemporaryFolder folder;
    put(folder / "two.xyz", "2\n\nHe 0 0 0\nNe 2 0 0\n2\n\nHe 10 0 0\nNe 12 0 0\n");
    const auto measureCenter = [&](const std::string& options, const std::string& input = "two.xyz") {
        nacreDone(folder, "render " + input + " -o a.png --stats s.json " + options + kTiny,
                  input == "-" ? "<two.xyz" : "");
        return nlohmann::json::parse(readContents(folder / "s.json"))["view"]["center"].dump();
    };
    for (const char* options : {"", "--model 2", "--model all", "--model 2 --camera all"})
        EXPECT_EQ(measureCenter(options), "[6.0,0.0,0.0]") << options;
    EXPECT_EQ(measureCenter("--format xyz --model 2", "-"), "[6.0,0.0,0.0]");
    EXPECT_EQ(measureCenter("--camera model"), "[1.0,0.0,0.0]");
    EXPECT_EQ(measureCenter("--model 2 --camera model"), "[11.0,0.0,0.0]");
    // A view keeps what was asked for.
    put(folder / "view.json", R"({"input": "two.xyz", "model": 2, "camera": "model", "occlusion-models": "all"})");
    EXPECT_EQ(measureCenter("--view view.json", ""), "[11.0,0.0,0.0]");
    EXPECT_NE(nacreIn(folder, std::string("render two.xyz -o a.png --camera both") + kTiny).code, 0);
}

TEST(Outputs, AViewFromSomebodyElseFetchesNothingAndQuotesNothing) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "view");
    put(folder / "secret.txt", "ATOM  password=hunter2 this is no number at all and stays what it is\n");
    put(folder / "m.pdb", kAtom);
    put(folder / "view/near.pdb", kAtom);
    put(folder / "view/secret.json", R"({"input": "../secret.txt", "format": "pdb"})");
    put(folder / "view/outside.json", R"({"input": "../m.pdb"})");
    put(folder / "view/near.json", R"({"input": "near.pdb"})");
    put(folder / "view/own.json", "{\"input\": \"" + (folder / "view/near.pdb") + "\"}");
    put(folder / "view/fetch.json", R"({"input": "pdb:1bna"})");
    const auto render = [&](const std::string& view, const std::string& more = "") {
        return nacreIn(folder, "render --view view/" + view + ".json -o a.png " + more + kTiny, "",
                       "export NACRE_PDB_URL=http://127.0.0.1:9");
    };
    const Outcome secret = render("secret");
    EXPECT_EQ(secret.code, 1);
    EXPECT_EQ(secret.err.find("hunter2"), std::string::npos) << secret.err;
    EXPECT_NE(secret.err.find("not in its folder: "), std::string::npos) << secret.err;
    EXPECT_LT(secret.err.find("not in its folder"), secret.err.find("error"));
    const Outcome outside = render("outside");
    EXPECT_EQ(outside.code, 0) << outside.err;
    EXPECT_NE(outside.err.find("m.pdb"), std::string::npos);
    for (const char* view : {"near", "own"}) {
        EXPECT_EQ(render(view).code, 0) << view;
        EXPECT_EQ(render(view).err, "") << view;
    }
    // Whoever wants no warnings wants these.
    EXPECT_NE(render("outside", "-q").err.find("not in its folder"), std::string::npos);
    // What might never end is not waited for.
    ASSERT_EQ(mkfifo((folder / "view/pipe").c_str(), 0600), 0);
    put(folder / "view/pipe.json", R"({"input": "pipe", "format": "pdb"})");
    put(folder / "view/moves.json", R"({"input": "near.pdb", "trajectory": "pipe"})");
    put(folder / "view/standard.json", R"({"input": "-", "format": "pdb"})");
    const std::pair<const char*, const char*> endless[] = {
        {"pipe", "error: cannot read molecule: view/pipe: view/pipe.json names it, and it is not a regular file\n"},
        {"moves", "error: cannot read trajectory: view/pipe: it is not a plain file\n"},
        {"standard",
         "error: cannot read molecule: view/standard.json: it names standard input: give an INPUT as well\n"}};
    for (const auto& [view, why] : endless) {
        const Outcome outcome =
            nacreIn(folder, std::string("render --view view/") + view + ".json -o a.png", "", "exec </dev/zero");
        EXPECT_EQ(outcome.code, 1) << view;
        EXPECT_EQ(outcome.err, std::string("nacre: ") + why) << view;
    }
    const Outcome fetch = render("fetch");
    EXPECT_EQ(fetch.code, 1);
    EXPECT_NE(fetch.err.find("--allow-download"), std::string::npos) << fetch.err;
    EXPECT_NE(render("fetch", "--allow-download --verbose").err.find("http://127.0.0.1:9"), std::string::npos);
    // What the user names is the user's.
    EXPECT_NE(nacreIn(folder, "info secret.txt --format pdb").err.find("secret.txt"), std::string::npos);
}

}  // namespace
}  // namespace nacre
