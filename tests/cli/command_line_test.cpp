// Runs the program itself: exit codes, messages, and what it leaves behind.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/error_line.h"

namespace nacre {
namespace {

using test::expectOneErrorLine;
using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

TEST(CommandLine, HelpShowsExamplesAndOptions) {
    const TemporaryFolder folder;
    EXPECT_NE(nacreIn(folder, "--help").out.find("nacre render sample:dna -o dna.png"), std::string::npos);
    const Outcome help = nacreDone(folder, "render --help");
    EXPECT_EQ(help.err, "");
    for (const char* option :
         {"--size", "--style", "--color ", "byres", "secondary-structure", "--visibility", "Examples"})
        EXPECT_NE(help.out.find(option), std::string::npos) << option;
}

TEST(CommandLine, WhatIsMisspelledOrAskedForOtherwiseIsHelped) {
    const TemporaryFolder folder;
    struct Case {
        const char* arguments;
        const char* says;
    };
    for (const Case& c :
         {Case{"rendr sample:dna", "did you mean 'render'?"},
          Case{"render sample:dna -o a.png --size 8x8 --size 9x9", "--size: given more than once"},
          Case{"render sample:dna -o a.png --look", "--look: expected NAME|FILE"},
          Case{"render sample:dna b=sample:dna --fit", "--fit: expected SEL SEL"},
          Case{"render sample:dna -o a.png --sytle licorice", "did you mean '--style'?"},
          Case{"render sample:dna -o a.png --silhouette on", "no option --silhouette (did you mean '--contours'?)"},
          Case{"serve --port 8080", "nacre serve has no option --port (did you mean '--listen'?)"},
          Case{"render sample:dna -o a.png --sel all", "did you mean '--show'?"},
          Case{"render sample:dna -o a.png --opacity 1",
               "mean '--surface-opacity', '--cartoon-opacity', '--atom-opacity' or '--map-opacity'?"},
          Case{"render sample:dna -o a.png --cartoon",
               "did you mean '--style cartoon', '--cartoon-scale' or '--cartoon-opacity'?"},
          Case{"info sample:dna --transparent", "nacre info has no option --transparent (see"},
          Case{"render sample:dna -o a.png --nonsense on", "nacre render has no option --nonsense (see"},
          Case{"render sample:dna -o a.png --style spacefil", "did you mean 'spacefill'?"},
          Case{"render sample:dna -o a.png --color chian", "did you mean 'chain'?"},
          Case{"render sample:dna -o a.png --style stiks", "did you mean 'sticks'?"},
          Case{"render sample:dna -o a.png --color residues", "did you mean 'residue'?"},
          Case{"render sample:dna -o a.png --color entities", "did you mean 'entity'?"},
          Case{"render sample:dna -o a.png --color b-factors:10..60", "did you mean 'b-factor:10..60'?"},
          Case{"render sample:dna -o a.png --color-by all=copies", "did you mean 'copy'?"},
          Case{"render sample:dna -o a.png --color spectrm", "did you mean 'spectrum'?"},
          Case{"render sample:dna -o a.png --color elemnt:orange", "did you mean 'element'?"},
          Case{"render sample:dna -o a.png --color element:ornage", "did you mean 'orange'?"},
          Case{"render sample:dna -o a.png --color chain:mutd", "did you mean 'muted'?"},
          Case{"render sample:dna -o a.png --color chain:virids", "after 'chain:', not 'virids' (see"},
          Case{"render sample:dna -o a.png --palette mutd", "did you mean 'muted'?"},
          Case{"render sample:dna -o a.png --look glosy", "did you mean 'glossy'?"},
          Case{"render sample:dna -o a.png --background blakc", "did you mean 'black'?"},
          Case{"render sample:dna -o a.png --format pbd", "did you mean 'pdb'?"},
          Case{"render sample:dna -o a.pgn", "did you mean '.png'?"},
          Case{"movie sample:dna -o a.mp5 --spin y", "did you mean '.mp4'?"},
          Case{"export sample:dna -o a.gbl", "did you mean '.glb'?"},
          Case{"plan --caps mail", "did you mean 'mali'?"},
          Case{"info sample:dna --interactions all --interaction-rules plipp", "did you mean 'plip'?"},
          Case{"help selectons", "did you mean 'selections'?"},
          Case{"help movies", "did you mean 'movie'?"},
          Case{"help halso", "did you mean 'halos'?"},
          Case{"render", "usage: nacre render INPUT -o FILE [OPTION...], for example: nacre render 1bna.pdb -o "},
          Case{"movie", "usage: nacre movie INPUT -o FILE|FOLDER/ [OPTION...], for example: nacre movie "},
          Case{"info", "usage: nacre info INPUT [OPTION...], for example: nacre info 1bna.pdb"},
          Case{"batch", "usage: nacre batch JOBS [OPTION...], for example: nacre batch jobs.jsonl"},
          Case{"render sample:dna", "--output is required, for example: nacre render"},
          Case{"render -o a.png", "INPUT is required: a file, pdb:1BNA, or sample:dna"},
          Case{"", "for example: nacre render sample:dna -o dna.png"},
          Case{"4HHB", "a command comes before 'pdb:4hhb': `nacre view pdb:4hhb` shows it"},
          Case{"4hhb.pdb", "`nacre view 4hhb.pdb` shows it"}}) {
        const Outcome outcome = nacreIn(folder, c.arguments);
        EXPECT_EQ(outcome.code, 2) << c.arguments;
        expectOneErrorLine(outcome);
        EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(nacreIn(folder, "help").out, nacreIn(folder, "--help").out);
    EXPECT_EQ(nacreIn(folder, "help render").out, nacreIn(folder, "render --help").out);
    const std::string halos = nacreIn(folder, "help halos").out;
    EXPECT_TRUE(halos.starts_with("nacre render, movie, ")) << halos;
    EXPECT_NE(halos.find("--halos WIDTH"), std::string::npos) << halos;
    EXPECT_EQ(nacreIn(folder, "help --halos").out, halos);
    EXPECT_NE(nacreIn(folder, "help -o").out.find("nacre movie:\n  -o,--output"), std::string::npos);
    nacreDone(folder, "render sample:glucose -o a.png --style sticks --size 32x32 --occlusion off");
    // A frame that its device cannot draw is the user's mistake.
    const Outcome plan = nacreIn(folder, "plan --caps powervr --visibility raster-order");
    EXPECT_EQ(plan.code, 1);
    expectOneErrorLine(plan);
}

TEST(CommandLine, OfAFileThatIsNotThereItSaysWhatWasProbablyMeant) {
    const TemporaryFolder folder;
    std::ofstream(folder / "1abc.cif.gz") << "x";
    std::ofstream(folder / "model.pdb") << "x";
    std::ofstream(folder / "4hhb.png") << "x";  // no molecule
    struct Case {
        const char *input, *says;
    };
    for (const Case& c :
         {Case{"4HHB", "4HHB: No such file or directory (did you mean 'pdb:4hhb'?)\n"},
          Case{"1ABC", "(did you mean '1abc.cif.gz'?)\n"}, Case{"dna", "(did you mean 'sample:dna'?)\n"},
          Case{"p69905", "(did you mean 'afdb:P69905'?)\n"}, Case{"model.pbd", "(did you mean 'model.pdb'?)\n"},
          Case{"sample:dan", "(did you mean 'dna'?)\n"},
          Case{"nothing.like.it", "nothing.like.it: No such file or directory\n"}}) {
        for (const char* command : {"info ", "render -o a.png "}) {
            const Outcome outcome = nacreIn(folder, command + std::string(c.input));
            EXPECT_EQ(outcome.code, 1) << c.input;
            expectOneErrorLine(outcome);
            EXPECT_TRUE(outcome.err.ends_with(c.says)) << outcome.err;
        }
    }
}

TEST(CommandLine, OfDataThatIsNoFileItSaysWhatItIs) {
    const TemporaryFolder folder;
    std::ofstream(folder / "empty.ccp4");
    for (const auto& [options, says] : {std::pair("--map .", "cannot read map: .: it is a folder\n"),
                                        std::pair("--map empty.ccp4", "cannot read map: empty.ccp4: it is empty\n"),
                                        std::pair("--map none.ccp4", "none.ccp4: No such file or directory\n"),
                                        std::pair("--map /dev/null", "/dev/null: it is not a plain file\n"),
                                        std::pair("--trajectory .", "cannot read trajectory: .: it is a folder\n")}) {
        const Outcome outcome = nacreIn(folder, "render sample:glucose -o a.png --size 8x8 " + std::string(options));
        EXPECT_EQ(outcome.code, 1) << options;
        expectOneErrorLine(outcome);
        EXPECT_TRUE(outcome.err.ends_with(says)) << outcome.err;
    }
}

TEST(CommandLine, WhoWritesNoPictureOrPngLoadsNoImageFormats) {
    const TemporaryFolder folder;
    for (const char* command : {"info sample:glucose", "render sample:glucose -o a.png --size 32x32 --occlusion off"}) {
        // The loader names every library that it loads.
        const Outcome outcome = nacreDone(folder, command, "", "export LD_DEBUG=files");
        EXPECT_NE(outcome.err.find("libc.so"), std::string::npos);
        EXPECT_EQ(outcome.err.find("OpenEXR"), std::string::npos) << command;
        EXPECT_EQ(outcome.err.find("nacre_images"), std::string::npos) << command;
    }
}

TEST(CommandLine, AModuleOfAnotherBuildIsToldNotCalled) {
    const TemporaryFolder folder;
    const std::filesystem::path built = std::filesystem::path(NACRE_PROGRAM).parent_path();
    std::filesystem::copy_file(NACRE_PROGRAM, folder / "nacre");
    std::string module = test::readContents((built / "nacre_images.so").string());
    // What it is known by is a text of 64 digits; that of another build has others.
    std::size_t at = 0;
    for (std::size_t run = 0; at < module.size() && (run < 64 || module[at] != '\0'); ++at)
        run = std::isxdigit(static_cast<unsigned char>(module[at])) ? run + 1 : 0;
    ASSERT_LT(at, module.size());
    module[at - 1] = module[at - 1] == '0' ? '1' : '0';
    std::ofstream(folder / "nacre_images.so", std::ios::binary) << module;
    Outcome outcome =
        nacreIn(folder, "--version", "", "./nacre render sample:glucose -o a.tif --size 16x16 --occlusion off 2>err");
    outcome.err = test::readContents(folder / "err");
    EXPECT_EQ(outcome.code, 1);
    expectOneErrorLine(outcome);
    EXPECT_NE(outcome.err.find("nacre_images.so belongs to another build of nacre"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.tif"));
}

TEST(CommandLine, VersionNamesCommitHeadersAndDevice) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreDone(folder, "--version");
    for (const char* word : {"nacre 0.", "Vulkan headers 1.", "captures by RenderDoc", "device "})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << outcome.out;
}

TEST(CommandLine, NoticesNameEveryPartAndHoldItsLicence) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreDone(folder, "--notices");
    // Words of the licences of Nacre, GLM, gemmi, OpenEXR, curl, GLFW, Dear ImGui and DejaVu.
    for (const char* words : {"Redistribution and use in source and binary forms", "Christophe Riccio",
                              "Mozilla Public", "OpenEXR", "Daniel Stenberg", "Camilla", "Omar Cornut", "Bitstream"})
        EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
    EXPECT_GT(outcome.out.size(), 50000u);
}

TEST(CommandLine, DevicesAsJson) {
    const TemporaryFolder folder;
    const auto json = nlohmann::json::parse(nacreIn(folder, "devices --json").out);
    ASSERT_GE(json.size(), 1u);
    for (const char* key : {"number", "name", "type", "api_version", "driver", "visibility", "why", "encoded_format"})
        EXPECT_TRUE(json[0].contains(key)) << key;
    // What is wanted of a device that nobody here has: as Vulkan itself tells it.
    const nlohmann::json& device = json[0];
    EXPECT_GT(device["memory_bytes"], 0);
    EXPECT_GE(device["limits"]["max_image_dimension_2d"], 4096);
    EXPECT_EQ(device["formats"].size(), 11u);
    const auto& extensions = device["extensions"];
    EXPECT_TRUE(std::is_sorted(extensions.begin(), extensions.end()));
    const bool budget = std::count(extensions.begin(), extensions.end(), "VK_EXT_memory_budget") > 0;
    EXPECT_EQ(device["memory_budget_bytes"] > 0, budget);
}

TEST(CommandLine, TheSelfTestTimesEveryPathThatTheDeviceHas) {
    const TemporaryFolder folder;
    const auto json = nlohmann::json::parse(nacreIn(folder, "devices --self-test --json --cache .").out);
    ASSERT_GE(json.size(), 1u);
    for (const auto& device : json) {
        const std::string test = device["self_test"];
        for (const char* path : {"encoded", "fragdepth", "raster-order", "deferred", "tiles"}) {
            const bool there = path != std::string("raster-order") || device["raster_order"].get<bool>();
            const std::size_t at = test.find(path + std::string(" "));
            EXPECT_EQ(at != std::string::npos, there) << path << " of " << test;
            // "tiles 3.14 ms"
            if (!there) continue;
            EXPECT_GT(std::atof(test.c_str() + at + std::string(path).size()), 0) << path << " of " << test;
        }
    }
}

TEST(CommandLine, InfoAsJsonAndAsText) {
    const TemporaryFolder folder;
    const auto json = nlohmann::json::parse(nacreIn(folder, "info sample:glucose --json").out);
    ASSERT_EQ(json.size(), 1u);  // a list, of one INPUT too
    EXPECT_EQ(json[0]["atoms"], 24);
    EXPECT_EQ(json[0]["file"], "sample:glucose");
    const std::string lines = nacreIn(folder, "info sample:glucose sample:dna --json-lines").out;
    const std::size_t end = lines.find('\n');
    EXPECT_EQ(nlohmann::json::parse(lines.substr(0, end)), json[0]);
    EXPECT_EQ(nlohmann::json::parse(lines.substr(end))["atoms"], 486);
    EXPECT_NE(nacreIn(folder, "info sample:glucose").out.find("24"), std::string::npos);
}

TEST(CommandLine, OutputThatIsLostIsAnError) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreIn(folder, "info sample:dna", ">/dev/full");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("standard output"), std::string::npos) << outcome.err;
}

TEST(CommandLine, RenderWritesWholeFilesAndTheStats) {
    const TemporaryFolder folder;
    const Outcome outcome =
        nacreDone(folder,
                  "render sample:glucose -o a.png --size 64x48 --occlusion 8 --zoom 1 --rotate -90,0,0 "
                  "--layers l.exr --stats s.json");
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_EQ(folder.count(), 3u);
    EXPECT_EQ(test::readContents(folder / "a.png").substr(1, 3), "PNG");
    EXPECT_EQ(test::readContents(folder / "l.exr").substr(0, 4), "\x76\x2f\x31\x01");
    const auto stats = nlohmann::json::parse(test::readContents(folder / "s.json"));
    EXPECT_EQ(stats["view"]["width"], 64);
    EXPECT_EQ(stats["view"]["rotation"].dump(), "[[1.0,0.0,0.0],[0.0,0.0,1.0],[0.0,-1.0,0.0]]");
    EXPECT_NEAR(stats["view"]["pixels_per_angstrom"].get<double>(),
                0.95 * 48 / (2 * stats["view"]["radius"].get<double>()), 1e-9);
    EXPECT_EQ(stats["atoms"]["read"], 24);
    EXPECT_EQ(stats["atoms"]["drawn"], 24);
    EXPECT_GT(stats["covered_pixels"], 0);
    for (const char* key : {"load", "bake", "first_picture", "frame"}) EXPECT_TRUE(stats["times"].contains(key)) << key;
    EXPECT_GT(stats["memory"]["resident_peak"], 1000000);
    EXPECT_NE(stats["device"]["name"], "");
    ASSERT_FALSE(stats["passes"].empty());
    double ms = 0;
    for (const auto& pass : stats["passes"]) {
        EXPECT_NE(pass["name"], "");
        EXPECT_FALSE(pass.at("ms").is_null() && pass.at("shaded_fragments").is_null()) << pass;
        if (!pass["shaded_fragments"].is_null()) {
            EXPECT_GT(pass["shaded_fragments"], 0) << pass;
        }
        if (!pass["ms"].is_null()) ms += pass["ms"].get<double>();
    }
    EXPECT_GT(ms, 0);
}

TEST(CommandLine, TheSameCommandGivesTheSameBytes) {
    // Again, and with one thread or two, of the driver's and of ours.
    const TemporaryFolder folder;
    for (const std::string path : {"encoded", "deferred", "raster-order", "tiles"})
        for (const std::string type : {"png", "exr", "tif"}) {
            if (type != "png" && path != "encoded") continue;
            std::vector<std::string> pictures, layers;
            for (const std::string threads : {"", "LP_NUM_THREADS=1 taskset -c 0 ", "LP_NUM_THREADS=2 "}) {
                const std::string name = "a." + type;
                const std::string command = "cd '" + folder.path() + "' && " + threads +
                                            "'" NACRE_PROGRAM
                                            "' render sample:dna --size 96x64 --occlusion 8 --cache off -o " +
                                            name + (type == "exr" ? " --layers l.exr" : "") + " --visibility " + path;
                ASSERT_EQ(std::system(command.c_str()), 0);
                pictures.push_back(test::readContents(folder / name));
                if (type == "exr") layers.push_back(test::readContents(folder / "l.exr"));
            }
            EXPECT_GT(pictures[0].size(), 1000u);
            for (int i : {1, 2}) {
                EXPECT_EQ(pictures[i], pictures[0]) << path << " " << type;
                EXPECT_TRUE(type != "exr" || layers[i] == layers[0]);
            }
        }
}

TEST(CommandLine, AFailedRunKeepsTheOldPicture) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.png") << "old";
    EXPECT_EQ(nacreIn(folder, "render none.pdb -o a.png").code, 1);
    EXPECT_EQ(test::readContents(folder / "a.png"), "old");
    EXPECT_EQ(folder.count(), 1u);
}

}  // namespace
}  // namespace nacre
