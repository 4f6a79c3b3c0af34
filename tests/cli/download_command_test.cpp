// Downloads as a user has them: the whole program, several at once, interrupted.

#include <gtest/gtest.h>
#include <signal.h>

#include <future>

#include "tests/support/measured_run.h"
#include "tests/support/structure_server.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;
using test::MeasuredRun;
using test::RunOptions;
using test::StructureServer;
using test::TemporaryFolder;

/// A server of 1bna as mmCIF that sends 3000 atoms in about three seconds where it is slow.
class DownloadCommand : public testing::Test {
protected:
    DownloadCommand() {
        std::string cif = test::readContents(NACRE_SOURCE_DIR "/tests/fuzz/seeds/water.cif");
        for (int i = 3; i <= kAtoms; ++i)
            cif += "HETATM " + std::to_string(i) + " O O HOH A " + std::to_string(i) + " " + std::to_string(3 * i) +
                   " 0 0\n";
        server_.serve("1bna.cif.gz", cif);
    }

    RunOptions options(const std::string& way) const {
        RunOptions options{.environment = {{"NACRE_PDB_URL", server_.base(way)}, {"NACRE_CACHE", folder_ / "cache"}}};
        return options;
    }
    static MeasuredRun info(const RunOptions& options) {
        return test::runMeasured({"info", "pdb:1BNA", "--json"}, options);
    }
    static bool hasAll(const MeasuredRun& run) {
        return run.code == 0 && run.out.find("\"atoms\": " + std::to_string(kAtoms)) != std::string::npos;
    }
    fs::path entry(const char* ending = "") const {
        return fs::path(folder_ / "cache") / "downloads" / (std::string("pdb-1bna.cif.gz") + ending);
    }

    static constexpr int kAtoms = 3000;
    StructureServer server_;
    TemporaryFolder folder_;
};

TEST_F(DownloadCommand, ShowsItsProgressOnATerminal) {
    RunOptions slow = options("slow");
    slow.terminal = true;
    const MeasuredRun run = info(slow);
    EXPECT_TRUE(hasAll(run)) << run.err;
    EXPECT_NE(run.err.find("nacre: downloading [#"), std::string::npos) << run.err;
}

TEST_F(DownloadCommand, SaysNothingElsewhere) {
    const MeasuredRun run = info(options("ok"));
    EXPECT_TRUE(hasAll(run)) << run.err;
    EXPECT_EQ(run.err, "");
}

TEST_F(DownloadCommand, AnErrorIsOneLine) {
    const MeasuredRun run = info(options("busy"));
    EXPECT_EQ(run.code, 1);
    EXPECT_EQ(run.err,
              "nacre: error: cannot download: pdb:1BNA: the server answered with status 503 (it is busy: try again "
              "later)\n");
    const MeasuredRun told = test::runMeasured({"info", "pdb:1BNA", "--verbose"}, options("busy"));
    EXPECT_EQ(std::count(told.err.begin(), told.err.end(), '\n'), 1) << told.err;
    EXPECT_EQ(told.err.rfind("nacre: error: cannot download: pdb:1BNA: http://localhost", 0), 0u) << told.err;
}

TEST_F(DownloadCommand, InterruptedItLeavesAPartThatTheNextGoesOnWith) {
    RunOptions slow = options("slow");
    slow.until = [this] { return fs::exists(entry(".part")) && fs::file_size(entry(".part")) > 0; };
    const MeasuredRun run = info(slow);
    EXPECT_EQ(run.signal, SIGINT);
    EXPECT_FALSE(fs::exists(entry()));
    const auto part = fs::file_size(entry(".part"));
    ASSERT_GT(part, 0u);
    EXPECT_TRUE(hasAll(info(options("slow"))));
    const std::string last = server_.requests().back();
    EXPECT_NE(last.find(" bytes=" + std::to_string(part) + "- \"v1\""), std::string::npos) << last;
    EXPECT_TRUE(fs::exists(entry()));
    EXPECT_FALSE(fs::exists(entry(".part")));
    EXPECT_FALSE(fs::exists(entry(".tag")));
}

TEST_F(DownloadCommand, SeveralAtOnceLeaveOneWholeFile) {
    const RunOptions slow = options("slow");
    std::vector<std::future<MeasuredRun>> runs;
    for (int i = 0; i < 4; ++i) runs.push_back(std::async(std::launch::async, [&] { return info(slow); }));
    for (auto& run : runs) {
        const MeasuredRun done = run.get();
        EXPECT_TRUE(hasAll(done)) << done.err;
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(entry().parent_path()), {}), 2);  // and the cache's tag
    const std::size_t asked = server_.requests().size();
    RunOptions offline = options("ok");
    EXPECT_TRUE(hasAll(test::runMeasured({"info", "pdb:1bna", "--json", "--offline"}, offline)));
    EXPECT_EQ(server_.requests().size(), asked);
}

TEST_F(DownloadCommand, TheCacheIsWhereTheUserWantsIt) {
    RunOptions elsewhere = options("ok");
    elsewhere.environment.pop_back();
    elsewhere.environment.insert(elsewhere.environment.end(),
                                 {{"NACRE_CACHE", ""}, {"HOME", folder_ / "home"}, {"XDG_CACHE_HOME", "relative"}});
    EXPECT_TRUE(hasAll(info(elsewhere)));
    EXPECT_TRUE(fs::exists(folder_ / "home/.cache/nacre/downloads/pdb-1bna.cif.gz"));
    elsewhere.environment.emplace_back("XDG_CACHE_HOME", folder_ / "xdg");
    EXPECT_TRUE(hasAll(info(elsewhere)));
    EXPECT_TRUE(fs::exists(folder_ / "xdg/nacre/downloads/pdb-1bna.cif.gz"));
    const auto run = test::runMeasured({"info", "pdb:1bna", "--cache", folder_ / "named"}, elsewhere);
    EXPECT_TRUE(fs::exists(folder_ / "named/downloads/pdb-1bna.cif.gz")) << run.err;
    const auto off = test::runMeasured({"info", "pdb:1bna", "--json", "--cache", "off"}, options("ok"));
    EXPECT_TRUE(hasAll(off));
    EXPECT_FALSE(fs::exists(folder_ / "cache"));
}

TEST_F(DownloadCommand, AMovieThroughModelsAsksOnce) {
    std::string xyz =
        "data_m\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "_atom_site.pdbx_PDB_model_num\n";
    for (int model = 1; model <= 3; ++model)
        xyz += "C 0 0 " + std::to_string(model) + " " + std::to_string(model) + "\n";
    server_.serve("1mod.cif.gz", xyz);
    const std::vector<std::string> movie{"movie",        "pdb:1MOD",    "--models", "--fps", "10",
                                         "--cache",      "off",         "--size",   "16x16", "-o",
                                         folder_ / "f/", "--occlusion", "off"};
    const MeasuredRun run = test::runMeasured(movie, options("ok"));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(fs::exists(folder_ / "f/frame_00003.png"));
    EXPECT_EQ(server_.requests().size(), 2u) << "for BinaryCIF, which is not there, and mmCIF";
}

// A view that somebody else wrote, with several inputs, for each of the commands that take one.
TEST_F(DownloadCommand, AViewDownloadsNothingUnlessItIsAllowed) {
    std::ofstream(folder_ / "v.json") << R"({"input": "sample:glucose", "further-inputs": [{"input": "pdb:1bna"}]})";
    std::ofstream(folder_ / "w.json") << R"({"input": "pdb:1bna", "occlusion": "off"})";
    const std::string v = folder_ / "v.json", w = folder_ / "w.json", small = "16x16";
    const std::vector<std::vector<std::string>> commands{
        {"render", "--view", v, "-o", folder_ / "a.png", "--size", small},
        {"render", "--view", w, "-o", folder_ / "a.png", "--size", small},
        {"movie", "--views", v + "," + v, "-o", folder_ / "a.gif", "--size", small},
        {"movie", "--views", w + "," + w, "--models", "-o", folder_ / "a.gif", "--size", small},
        {"movie", "--view", w, "--spin", "y", "-o", folder_ / "a.gif", "--size", small}};
    for (const std::vector<std::string>& command : commands) {
        const MeasuredRun run = test::runMeasured(command, options("ok"));
        EXPECT_EQ(run.code, 1) << run.err;
        EXPECT_NE(run.err.find("use --allow-download"), std::string::npos) << run.err;
    }
    EXPECT_TRUE(server_.requests().empty());
    std::vector<std::string> allowed = commands[1];
    allowed.insert(allowed.end(), {"--allow-download", "--water", "show"});
    const MeasuredRun run = test::runMeasured(allowed, options("ok"));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(server_.requests().size(), 2u) << "for BinaryCIF, which is not there, and mmCIF";
}

TEST_F(DownloadCommand, AFolderThatCannotBeUsedIsAnErrorOnlyIfItWasNamed) {
    const auto named = test::runMeasured({"info", "pdb:1bna", "--cache", "/proc/cache"}, options("ok"));
    EXPECT_EQ(named.code, 1);
    EXPECT_EQ(named.err.rfind("nacre: error: cannot use cache: /proc/cache: ", 0), 0u) << named.err;
    RunOptions usual = options("ok");
    usual.environment.insert(usual.environment.end(), {{"NACRE_CACHE", ""}, {"HOME", "/proc"}, {"XDG_CACHE_HOME", ""}});
    EXPECT_TRUE(hasAll(info(usual)));
}

}  // namespace
}  // namespace nacre
