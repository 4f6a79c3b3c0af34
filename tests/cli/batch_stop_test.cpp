// nacre batch that is stopped: by one signal, by two, by SIGKILL.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "tests/cli/batch_jobs.h"
#include "tests/support/measured_run.h"

namespace nacre::app {
namespace {

using test::job;
using test::parseReport;
using test::readContents;
using test::TemporaryFolder;

// A pipe of jobs that stays open: a run that reads it cannot be through before it is stopped, however slow the test is.
class OpenJobs {
public:
    OpenJobs(std::string file, const std::vector<std::string>& lines) : path(std::move(file)) {
        EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
        end_ = open(path.c_str(), O_RDWR | O_CLOEXEC);
        std::string text;
        for (const std::string& line : lines) text += line + "\n";
        EXPECT_EQ(write(end_, text.data(), text.size()), static_cast<ssize_t>(text.size())) << "more than a pipe holds";
    }
    OpenJobs(const OpenJobs&) = delete;
    OpenJobs& operator=(const OpenJobs&) = delete;
    ~OpenJobs() { close(end_); }
    const std::string path;

private:
    int end_ = -1;
};

// What is killed in the middle leaves whole pictures alone, what is stopped ends what it began and says how far it
// came, and the next run makes the others.
TEST(StoppedBatch, IsGoneOnWithAfterItWasStopped) {
    const TemporaryFolder folder, pipes;
    std::vector<std::string> lines;
    for (int i = 0; i < 40; ++i) lines.push_back(job("sample:dna", folder / ("p" + std::to_string(i) + ".png")));
    const auto run = [](const std::string& jobs, const test::RunOptions& options = {}) {
        return test::runMeasured({"batch", jobs, "--resume", "--size", "64x64", "--occlusion", "8", "--jobs", "2"},
                                 options);
    };
    const auto pictures = [&] {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            if (entry.path().filename().string()[0] == 'p') all.push_back(readContents(entry.path().string()));
        return all;
    };
    test::RunOptions options;
    options.until = [&] { return pictures().size() >= 4; };
    options.signal = SIGKILL;
    const OpenJobs first(pipes / "first", lines), second(pipes / "second", lines);
    EXPECT_EQ(run(first.path, options).signal, SIGKILL);
    const std::size_t before = pictures().size();
    options.until = [&] { return pictures().size() >= std::min<std::size_t>(before + 3, 40); };
    options.signal = SIGINT;
    options.once = true;
    const test::MeasuredRun stopped = run(second.path, options);
    EXPECT_EQ(stopped.code, 1) << stopped.signal;
    const auto told = parseReport(stopped.out);
    const auto done = static_cast<std::size_t>(
        std::count_if(told.begin(), told.end(), [](const auto& line) { return line.second.at("status") == "done"; }));
    EXPECT_EQ(pictures().size(), before + done) << "what was begun is whole";
    EXPECT_NE(stopped.err.find("nacre: error: stopped: " + second.path + ": " + std::to_string(done) +
                               " jobs done, 0 failed, "),
              std::string::npos)
        << stopped.err;
    test::writeJobs(folder, lines);
    const test::MeasuredRun last = run(folder / "jobs.jsonl");
    EXPECT_EQ(last.code, 0) << last.err;
    const std::vector<std::string> all = pictures();
    EXPECT_EQ(all.size(), 40u);
    for (const std::string& picture : all) EXPECT_EQ(picture, all.front());
    EXPECT_EQ(folder.count(), 41u) << "something is left behind";
}

TEST(StoppedBatch, ASecondSignalEndsTheJobThatRuns) {
    const TemporaryFolder folder, pipes;
    const OpenJobs jobs(pipes / "jobs",
                        {job("sample:glucose", folder / "a.png", R"("size": "16x16")"),
                         job("sample:dna", folder / "b.png", R"("size": "8192x8192", "occlusion": 512)")});
    test::RunOptions options;
    int polls = 0;  // of 10 ms or more: the second job has begun after some
    options.until = [&] { return std::filesystem::exists(folder / "a.png") && ++polls > 50; };
    const test::MeasuredRun run = test::runMeasured({"batch", jobs.path, "--jobs", "1"}, options);
    EXPECT_EQ(run.signal, SIGINT) << run.code << run.err;
    EXPECT_EQ(folder.count(), 1u) << "the picture is half-written";
}

TEST(StoppedBatch, IsStoppedWhileItWaitsForJobs) {
    const TemporaryFolder folder;
    const OpenJobs jobs(folder / "jobs", {job("sample:glucose", folder / "a.png")});
    test::RunOptions options;
    options.until = [&] { return std::filesystem::exists(folder / "a.png"); };
    options.once = true;
    const test::MeasuredRun run =
        test::runMeasured({"batch", jobs.path, "--size", "16x16", "--occlusion", "off"}, options);
    EXPECT_EQ(run.code, 1) << run.signal;
    EXPECT_NE(run.err.find("1 jobs done"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace nacre::app
