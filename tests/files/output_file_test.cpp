#include "app/files/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app {
namespace {

namespace fs = std::filesystem;
using test::readContents;
using test::TemporaryFolder;

void put(const std::string& path, const std::string& content = "old") { std::ofstream(path) << content; }

bool apart(const std::string& input, const std::string& output) {
    const NamedFile files[] = {{"INPUT", input}, {"--stats", output, true}};
    try {
        checkApart(files);
        return true;
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("INPUT and --stats"), std::string::npos) << error.what();
        return false;
    }
}

TEST(OutputFile, KeepsThePermissionsOfWhatItReplaces) {
    const TemporaryFolder folder;
    for (const mode_t mode : {0600u, 0640u, 0644u}) {
        put(folder / "a");
        fs::permissions(folder / "a", static_cast<fs::perms>(mode));
        OutputFile file(folder / "a");
        writeText(file, "new");
        struct stat status {};
        ASSERT_EQ(stat((folder / "a").c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777, mode);
    }
}

TEST(OutputFile, NobodyForeseesItsTemporaryName) {
    const TemporaryFolder folder;
    const OutputFile one(folder / "a.png"), other(folder / "b.png");
    EXPECT_EQ(fs::path(one.temporary()).extension(), ".png");
    EXPECT_EQ(one.temporary().find(std::to_string(getpid())), std::string::npos);
    EXPECT_NE(one.temporary(), other.temporary());
}

TEST(OutputFile, WhatIsNoPlainFileIsRefusedAtOnce) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "folder");
    ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
    fs::create_symlink(folder / "fifo", folder / "link");
    for (const char* name : {"folder", "fifo", "link"}) EXPECT_THROW(OutputFile(folder / name), Error) << name;
    EXPECT_EQ(folder.count(), 3u);
}

TEST(OutputFile, ALinkThatTakesTheTemporaryFilesPlaceIsNotFollowed) {
    const TemporaryFolder folder, elsewhere;
    put(elsewhere / "mine");
    OutputFile file(folder / "a");
    fs::remove(file.temporary());
    fs::create_symlink(elsewhere / "mine", file.temporary());
    EXPECT_THROW(writeText(file, "new"), Error);
    EXPECT_EQ(readContents(elsewhere / "mine"), "old");
}

TEST(OutputFile, SweepsWhatCrashesLeftAndNothingElse) {
    const TemporaryFolder folder;
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
    const char* const left[] = {".nacre-0123456789abcdef.png", ".nacre-0123456789abcdef_capture.rdc"};
    const char* const others[] = {".nacre-0123.png", ".nacre-0123456789abcdeX.png", "nacre-0123456789abcdef.png",
                                  ".nacre-0123456789abcdef-notes"};
    for (const char* name : left) put(folder / name);
    for (const char* name : others) put(folder / name);
    OutputFile inUse(folder / "./b.png");         // by another name: the folder itself is read through once a run
    put(folder / ".nacre-fedcba9876543210.png");  // just now
    for (const char* name : left) fs::last_write_time(folder / name, old);
    for (const char* name : others) fs::last_write_time(folder / name, old);
    fs::last_write_time(inUse.temporary(), old);
    fs::create_symlink(folder / others[0], folder / ".nacre-aaaaaaaaaaaaaaaa.png");
    const OutputFile next(folder / "a.png");
    for (const char* name : left) EXPECT_FALSE(fs::exists(folder / name)) << name;
    for (const char* name : others) EXPECT_TRUE(fs::exists(folder / name)) << name;
    EXPECT_TRUE(fs::exists(inUse.temporary()));
    EXPECT_TRUE(fs::exists(folder / ".nacre-fedcba9876543210.png"));
    EXPECT_TRUE(fs::is_symlink(folder / ".nacre-aaaaaaaaaaaaaaaa.png"));
}

// What a killed run left is gone with the next, at once: on the machine that wrote it its lock tells that nobody has
// it.
TEST(OutputFile, SweepsAtOnceWhatItsOwnMachineLeft) {
    const TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        const OutputFile file(folder / "a.png");
        raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_EQ(folder.count(), 1u);
    const std::string left = fs::directory_iterator(folder.path())->path().string();
    const OutputFile next(folder / "b.png");
    EXPECT_FALSE(fs::exists(left)) << left;
    EXPECT_TRUE(fs::exists(next.temporary()));
}

TEST(OutputFile, IsNotLostToARunThatSweepsMeanwhile) {
    constexpr int kRounds = 60, kRuns = 8;
    for (int round = 0; round < kRounds; ++round) {
        const TemporaryFolder folder;  // one that each run meets for the first time, and sweeps
        int gate[2];
        ASSERT_EQ(pipe(gate), 0);
        std::array<pid_t, kRuns> runs{};
        for (int i = 0; i < kRuns; ++i) {
            runs[i] = fork();
            if (runs[i] != 0) continue;
            close(gate[1]);
            char end = 0;
            if (::read(gate[0], &end, 1) != 0) _exit(1);  // all begin when the gate is closed
            bool there = true;
            try {
                OutputFile file(folder / std::to_string(i));
                usleep(500);
                there = fs::exists(file.temporary());
            } catch (const Error&) {
                there = false;
            }
            _exit(there ? 0 : 1);
        }
        close(gate[0]);
        close(gate[1]);
        for (const pid_t run : runs) {
            int status = -1;
            ASSERT_EQ(waitpid(run, &status, 0), run);
            EXPECT_EQ(status, 0) << "in round " << round;
        }
    }
}

TEST(OutputFile, NoOutputReplacesWhatIsReadByAnyName) {
    const TemporaryFolder folder;
    put(folder / "in.pdb");
    put(folder / "other.pdb");
    fs::create_directory(folder / "sub");
    fs::create_symlink(folder / "in.pdb", folder / "link");
    fs::create_symlink(folder.path(), folder / "sub/up");
    fs::create_hard_link(folder / "in.pdb", folder / "hard");
    for (const char* name : {"in.pdb", "./in.pdb", "sub/../in.pdb", "link", "hard", "sub/up/in.pdb", "sub/up/link"})
        EXPECT_FALSE(apart(folder / "in.pdb", folder / name)) << name;
    EXPECT_FALSE(apart(folder / "link", folder / "hard"));
    EXPECT_TRUE(apart(folder / "in.pdb", folder / "other.pdb"));
    EXPECT_TRUE(apart(folder / "in.pdb", folder / "new.json"));
    EXPECT_TRUE(apart("/dev/null", "/dev/null"));
    // Neither is there yet, in a folder by two names.
    const NamedFile files[] = {{"--output", folder / "a.png", true}, {"--layers", folder / "sub/up/a.png", true}};
    EXPECT_THROW(checkApart(files), std::invalid_argument);
    const NamedFile streams[] = {{"--output", "-", true}, {"--stats", "/dev/stdout", true}};
    EXPECT_THROW(checkApart(streams), std::invalid_argument);
    const NamedFile both[] = {{"INPUT", folder / "in.pdb"}, {"--view", folder / "in.pdb"}};
    EXPECT_NO_THROW(checkApart(both));
}

TEST(OutputFile, NoOutputReplacesStandardInputWhereDevIsEmpty) {
    const TemporaryFolder folder;
    put(folder / "in.pdb");
    put(folder / "other.pdb");
    const pid_t child = fork();
    if (child == 0) {
        const int input = open((folder / "in.pdb").c_str(), O_RDONLY);
        if (dup2(input, STDIN_FILENO) != 0) _exit(2);
        if (chroot(folder.path().c_str()) != 0)  // whoever is not root is so in a namespace of their own
            if (unshare(CLONE_NEWUSER) != 0 || chroot(folder.path().c_str()) != 0) _exit(3);
        if (chdir("/") != 0 || fs::exists("/dev/stdin")) _exit(4);
        _exit(!apart("-", "in.pdb") && apart("-", "other.pdb") && apart("-", "new.json") ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    if (WEXITSTATUS(status) == 3) GTEST_SKIP() << "this user may change no root";
    EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace nacre::app
