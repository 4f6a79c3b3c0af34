// A process that is killed while it writes, or whose disk is full, leaves the file as it was or whole.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <random>
#include <thread>

#include "app/files/output_file.h"
#include "app/images/image_file.h"
#include "app/picture/appearance_values.h"
#include "engine/error.h"
#include "engine/occlusion/cache.h"
#include "tests/support/measured_run.h"
#ifdef NACRE_DESKTOP
#include "app/desktop/state_files.h"
#endif

namespace nacre::app {
namespace {

namespace fs = std::filesystem;
using test::readContents;
using test::TemporaryFolder;

/// What a program writes again and again, in two versions.
struct Writer {
    const char* name;
    std::function<void(const std::string& folder, int version)> write;
    std::function<std::string(const std::string& folder)> file;
};

std::vector<float> grey(int version) {
    std::vector<float> rgba(std::size_t{300} * 200 * 4, 0.25f + 0.5f * static_cast<float>(version));
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 1;
    return rgba;
}

FinishedOcclusion bake(int version) {
    FinishedOcclusion bake;
    bake.layout.width = bake.layout.height = 700;
    bake.atlas.assign(700 * 700, static_cast<std::uint8_t>(version + 1));
    return bake;
}

std::vector<Writer> writers() {
    std::vector<Writer> all{{"text",
                             [](const std::string& folder, int version) {
                                 OutputFile file(folder + "/out.json");
                                 writeText(file, std::string(400000, static_cast<char>('a' + version)));
                             },
                             [](const std::string& folder) { return folder + "/out.json"; }},
                            {"occlusion cache",
                             [](const std::string& folder, int version) {
                                 writeOcclusion(DiskCache(folder, kOcclusionCacheBytes, {"bake"}), "bake",
                                                bake(version));
                             },
                             [](const std::string& folder) { return folder + "/bake"; }}};
    // EXR is written by threads, which a fork leaves behind: the program's own test (fault_test) has it.
    for (const char* name : {"/out.png", "/out.jpg", "/out.tif"})
        all.push_back({name,
                       [name](const std::string& folder, int version) {
                           OutputFile file(folder + name);
                           const std::vector<float> rgba = grey(version);
                           writePicture(file, Picture{300, 200, rgba}, {});
                       },
                       [name](const std::string& folder) { return folder + name; }});
#ifdef NACRE_DESKTOP
    all.push_back({"view",
                   [](const std::string& folder, int version) {
                       setenv("XDG_STATE_HOME", folder.c_str(), 1);
                       PictureDescription view;
                       view.input.path = std::string(200000, static_cast<char>('a' + version));
                       saveState(view);
                   },
                   [](const std::string& folder) { return folder + "/nacre/view.json"; }});
    all.push_back({"pipelines",
                   [](const std::string& folder, int version) {
                       setenv("XDG_CACHE_HOME", folder.c_str(), 1);
                       savePipelineCache(std::vector<std::byte>(300000, static_cast<std::byte>(version)));
                   },
                   [](const std::string& folder) { return folder + "/nacre/pipelines.bin"; }});
#endif
    return all;
}

TEST(KilledWriter, LeavesTheFileOldOrNew) {
    std::mt19937 random(7);
    bool caughtInTheAct = false;
    for (const Writer& writer : writers()) {
        SCOPED_TRACE(writer.name);
        const TemporaryFolder folder;
        std::string versions[2];
        for (int version : {0, 1}) {
            writer.write(folder.path(), version);
            versions[version] = readContents(writer.file(folder.path()));
            ASSERT_FALSE(versions[version].empty());
        }
        ASSERT_NE(versions[0], versions[1]);
        for (int round = 0; round < 15; ++round) {
            const pid_t child = fork();
            if (child == 0) {
                alarm(20);  // should nobody be left to kill it
                for (int version = 0;; version ^= 1) writer.write(folder.path(), version);
            }
            std::this_thread::sleep_for(std::chrono::microseconds(500 + random() % 8000));
            kill(child, SIGKILL);
            int status = 0;
            ASSERT_EQ(waitpid(child, &status, 0), child);
            ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
            const std::string seen = readContents(writer.file(folder.path()));
            ASSERT_TRUE(seen == versions[0] || seen == versions[1]) << seen.size() << " bytes";
            // What was being written has a name that nobody takes for a result.
            const fs::path parent = fs::path(writer.file(folder.path())).parent_path();
            for (const auto& entry : fs::directory_iterator(parent)) {
                if (entry.path() == writer.file(folder.path()) || entry.path().filename() == "CACHEDIR.TAG") continue;
                EXPECT_TRUE(entry.path().filename().string().starts_with(".n")) << entry.path();
                caughtInTheAct = true;
            }
        }
        writer.write(folder.path(), 0);
        EXPECT_TRUE(readContents(writer.file(folder.path())) == versions[0]);
    }
    EXPECT_TRUE(caughtInTheAct) << "no round killed anyone who was writing";
}

TEST(FullDisk, LeavesTheFileAsItWas) {
    for (const Writer& writer : writers()) {
        SCOPED_TRACE(writer.name);
        const TemporaryFolder folder;
        writer.write(folder.path(), 0);
        const std::string before = readContents(writer.file(folder.path()));
        const fs::path parent = fs::path(writer.file(folder.path())).parent_path();
        const auto entries = [&] { return std::distance(fs::directory_iterator(parent), {}); };
        const auto whole = entries();
        const rlim_t size = before.size();
        for (const rlim_t limit : {rlim_t{0}, rlim_t{1}, rlim_t{200}, size / 2, size - 1}) {
            const pid_t child = fork();
            if (child == 0) {
                alarm(20);
                std::signal(SIGXFSZ, SIG_IGN);
                const rlimit most{limit, limit};
                setrlimit(RLIMIT_FSIZE, &most);
                try {
                    writer.write(folder.path(), 1);
                } catch (const Error& error) {
                    _exit(std::string(error.what()).starts_with("cannot write file: ") ? 0 : 1);
                }
                _exit(0);  // caches are not missed
            }
            int status = 0;
            ASSERT_EQ(waitpid(child, &status, 0), child);
            EXPECT_EQ(status, 0);
            EXPECT_TRUE(readContents(writer.file(folder.path())) == before) << limit;
            EXPECT_EQ(entries(), whole) << limit;
        }
    }
}

#ifdef NACRE_DESKTOP
TEST(StateFiles, DamagedOnesCountAsAbsent) {
    const TemporaryFolder folder;
    setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);
    setenv("XDG_STATE_HOME", folder.path().c_str(), 1);
    std::vector<std::byte> data(40);
    for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::byte>(i * 7);
    savePipelineCache(data);
    EXPECT_EQ(loadPipelineCache(), data);
    const std::string path = folder / "nacre/pipelines.bin", whole = readContents(path);
    const auto put = [&](const std::string& name, const std::string& content) {
        std::ofstream(name, std::ios::binary | std::ios::trunc) << content;
    };
    for (std::size_t size = 0; size < whole.size(); ++size) {
        put(path, whole.substr(0, size));
        EXPECT_TRUE(loadPipelineCache().empty()) << size;
    }
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string flipped = whole;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
        put(path, flipped);
        EXPECT_TRUE(loadPipelineCache().empty()) << bit;
    }
    // A view is text: one that still reads as a view may be another, never an error.
    PictureDescription view;
    view.input.path = "sample:dna";
    view.look.rules = {parseHide("water"), parseShow("protein=licorice")};
    saveState(view);
    const std::string state = folder / "nacre/view.json", json = readContents(state);
    for (std::size_t size = 0; size + 2 < json.size(); size += 5) {
        put(state, json.substr(0, size));
        EXPECT_FALSE(loadState()) << size;
    }
    int read = 0;
    for (std::size_t bit = 0; bit < 8 * json.size(); bit += 31) {
        std::string flipped = json;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
        put(state, flipped);
        const auto loaded = loadState();
        if (!loaded) continue;
        EXPECT_NO_THROW(parseSavedView(savedViewJson(*loaded), "again")) << flipped;
        ++read;
    }
    EXPECT_GT(read, 0);
}
#endif

}  // namespace
}  // namespace nacre::app
