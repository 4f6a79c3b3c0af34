#include "engine/storage/disk_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "tests/support/temporary_folder.h"

namespace nacre::test {
std::function<bool(int)> onSync;  // whether it succeeds
}

/// In place of libc's.
extern "C" int fsync(int file) {
    if (nacre::test::onSync && !nacre::test::onSync(file)) return -1;
    return static_cast<int>(syscall(SYS_fsync, file));
}

namespace nacre {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

const std::vector<std::string> kPrefixes = {"a", "b", "c", "d", "entry"};
constexpr const char* kTag = "CACHEDIR.TAG";

bool put(const DiskCache& cache, const std::string& name, const std::string& content) {
    const std::string_view parts[] = {content};
    return cache.write(name, parts);
}

/// As if the entry had last been used some hours ago.
void age(const DiskCache& cache, const std::string& name, int hours) {
    fs::last_write_time(cache.entryPath(name), fs::file_time_type::clock::now() - std::chrono::hours(hours));
}

TEST(DiskCache, WritesAllToDiskBeforeAnEntryHasItsName) {
    const TemporaryFolder folder;
    const DiskCache cache(folder / "cache", 1000, kPrefixes);
    const auto entries = [&] {
        return std::distance(fs::directory_iterator(folder / "cache"), fs::directory_iterator());
    };
    ASSERT_TRUE(put(cache, "b", "before"));
    const auto before = entries();
    int syncs = 0;
    test::onSync = [&](int file) {
        struct stat status {};
        EXPECT_EQ(fstat(file, &status), 0);
        EXPECT_EQ(status.st_size, 7);
        EXPECT_FALSE(fs::exists(cache.entryPath("a")));
        return ++syncs > 1;
    };
    EXPECT_FALSE(put(cache, "a", "content"));  // the disk is full
    EXPECT_EQ(entries(), before);
    EXPECT_TRUE(put(cache, "a", "content"));
    EXPECT_EQ(syncs, 2);
    test::onSync = nullptr;
    EXPECT_EQ(cache.read("a"), "content");
}

TEST(DiskCache, GivesBackWhatItWasGiven) {
    const TemporaryFolder folder;
    const DiskCache cache(folder / "made/when/needed", 1000, kPrefixes);
    EXPECT_EQ(cache.read("a"), std::nullopt);
    const std::string_view parts[] = {"one", std::string_view("\0two", 4)};
    ASSERT_TRUE(cache.write("a", parts));
    EXPECT_EQ(cache.read("a"), std::string("one\0two", 7));
    ASSERT_TRUE(put(cache, "a", "new"));
    EXPECT_EQ(cache.read("a"), "new");
    cache.remove("a");
    EXPECT_EQ(cache.read("a"), std::nullopt);
}

TEST(DiskCache, OffKeepsNothing) {
    const DiskCache cache;
    EXPECT_FALSE(put(cache, "a", "content"));
    EXPECT_EQ(cache.read("a"), std::nullopt);
}

TEST(DiskCache, TheEntryUsedLongestAgoGoesFirst) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), 100, kPrefixes);
    for (const char* name : {"a", "b", "c"}) ASSERT_TRUE(put(cache, name, std::string(30, 'x')));
    age(cache, "a", 3);
    age(cache, "b", 2);
    age(cache, "c", 1);
    ASSERT_TRUE(cache.read("a"));  // now "b" is the oldest
    ASSERT_TRUE(put(cache, "d", std::string(30, 'x')));
    EXPECT_FALSE(cache.read("b"));
    for (const char* name : {"a", "c", "d"}) EXPECT_TRUE(cache.read(name)) << name;
}

TEST(DiskCache, AnEntryAboveTheLimitIsNotKeptAndEvictsNothing) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), 100, kPrefixes);
    ASSERT_TRUE(put(cache, "a", std::string(90, 'x')));
    EXPECT_FALSE(put(cache, "b", std::string(101, 'x')));
    EXPECT_TRUE(cache.read("a"));
    EXPECT_EQ(folder.count(), 2u);  // and the tag
}

TEST(DiskCache, WhatIsBeingWrittenStaysForADay) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), 10, kPrefixes);
    for (const char* name : {".new-1", "b.part", ".new-2", "c.part"})
        std::ofstream(cache.entryPath(name)) << "some more than the limit";
    ASSERT_TRUE(cache.makeFolder());
    age(cache, ".new-2", 25);
    age(cache, "c.part", 25);
    cache.trim();
    EXPECT_TRUE(fs::exists(cache.entryPath(".new-1")));
    EXPECT_TRUE(fs::exists(cache.entryPath("b.part")));
    EXPECT_EQ(folder.count(), 3u);  // and the tag
}

TEST(DiskCache, AFolderThatCannotBeMadeHoldsNothing) {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "in the way";
    const DiskCache cache(folder / "file", 100, kPrefixes);
    EXPECT_FALSE(put(cache, "a", "content"));
    EXPECT_EQ(cache.read("a"), std::nullopt);
    EXPECT_EQ(test::readContents(folder / "file"), "in the way");
}

TEST(DiskCache, RemovesNothingThatItDidNotMake) {
    const TemporaryFolder folder, elsewhere;
    const DiskCache cache(folder.path(), 100, kPrefixes);
    ASSERT_TRUE(put(cache, "a", "first"));
    const std::string large(1000, 'x');
    std::ofstream(elsewhere / "mine") << large;
    std::ofstream(folder / "notes.txt") << large;
    std::ofstream(folder / ".hidden") << large;
    std::ofstream(folder / "z.part") << large;
    fs::create_symlink(elsewhere / "mine", folder / "b");
    fs::create_directory(folder / "c");
    std::ofstream(folder / "c/d") << large;
    for (const char* name : {"notes.txt", ".hidden", "z.part"}) age(cache, name, 100);
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(put(cache, "d" + std::to_string(i), std::string(60, 'y')));
    EXPECT_FALSE(cache.read("a"));  // the cache did outgrow its limit
    for (const char* name : {"notes.txt", ".hidden", "z.part", "c/d"})
        EXPECT_EQ(test::readContents(folder / name), large) << name;
    EXPECT_TRUE(fs::is_symlink(folder / "b"));
    cache.remove("b");
    cache.remove("c");
    EXPECT_TRUE(fs::is_symlink(folder / "b"));
    EXPECT_EQ(test::readContents(elsewhere / "mine"), large);
}

TEST(DiskCache, AFolderOfSomebodyElsesIsNoCache) {
    const TemporaryFolder folder;
    std::ofstream(folder / "notes.txt") << "mine";
    std::ofstream(folder / "a") << std::string(1000, 'x');
    const DiskCache cache(folder.path(), 100, kPrefixes);
    EXPECT_FALSE(put(cache, "b", "content"));
    cache.trim();
    EXPECT_EQ(folder.count(), 2u);
    // One from before there were tags.
    const TemporaryFolder old;
    std::ofstream(old / "a") << "entry";
    EXPECT_TRUE(put(DiskCache(old.path(), 100, kPrefixes), "b", "content"));
    EXPECT_TRUE(fs::exists(old / kTag));
    // Another program's.
    const TemporaryFolder others;
    std::ofstream(others / kTag) << "Signature: 8a477f597d28d172789f06886806bc55\n# another's\n";
    EXPECT_FALSE(put(DiskCache(others.path(), 100, kPrefixes), "b", "content"));
    EXPECT_EQ(others.count(), 1u);
}

TEST(DiskCache, WhatStandsInAnEntrysPlaceIsAMissAtOnce) {
    const TemporaryFolder folder, elsewhere;
    const DiskCache cache(folder.path(), 100, kPrefixes);
    ASSERT_TRUE(cache.makeFolder());
    std::ofstream(elsewhere / "secret") << "secret";
    fs::create_symlink(elsewhere / "secret", folder / "a");
    fs::create_directory(folder / "b");
    ASSERT_EQ(mkfifo((folder / "c").c_str(), 0600), 0);
    for (const char* name : {"a", "b", "c"}) {
        EXPECT_EQ(cache.read(name), std::nullopt) << name;
        EXPECT_FALSE(put(cache, name, "content")) << name;
    }
    EXPECT_EQ(test::readContents(elsewhere / "secret"), "secret");
    EXPECT_EQ(folder.count(), 4u);
}

TEST(DiskCache, ReadersNeverSeeHalfOfWhatOthersWrite) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), 1 << 22, kPrefixes);
    const std::string contents[] = {std::string(300000, 'a'), std::string(200000, 'b')};
    ASSERT_TRUE(put(cache, "entry", contents[0]));
    pid_t writers[2];
    for (int i = 0; i < 2; ++i) {
        writers[i] = fork();
        if (writers[i] == 0) {
            for (int round = 0; round < 100; ++round) put(cache, "entry", contents[i]);
            _exit(0);
        }
    }
    for (int left = 2; left > 0;) {
        const auto seen = cache.read("entry");
        ASSERT_TRUE(seen);
        EXPECT_TRUE(*seen == contents[0] || *seen == contents[1]) << seen->size();
        int status = 0;
        if (waitpid(-1, &status, WNOHANG) > 0) {
            EXPECT_EQ(status, 0);
            --left;
        }
    }
    EXPECT_EQ(folder.count(), 2u);  // and the tag
}

}  // namespace
}  // namespace nacre
