// nacre batch, as a user meets it.

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/cli/batch_jobs.h"
#include "tests/support/measured_run.h"
#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

using test::job;
using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::parseReport;
using test::readContents;
using test::TemporaryFolder;
using Json = nlohmann::json;
using test::writeJobs;

constexpr const char* kSmall = " --size 32x32 --occlusion 4 --occlusion-detail 8";

TEST(Batch, DrawsWhatRenderDraws) {
    const TemporaryFolder folder;
    writeJobs(folder,
              {job("sample:dna", "a.png", R"("color": "chain", "rotate": [0, 90, 0])"), "",
               job("sample:glucose", "b.jpg", R"("size": [40, 30], "lighting": false, "style": "licorice")"),
               job("sample:dna", "c.png", R"("show": ["chain A=licorice"], "hide": "chain B", "offline": true)"),
               job("sample:glucose", "d.png", R"("rules": [{"color-by": "all=red"}], "layers": "d.exr")")});
    const Outcome batch = nacreDone(folder, std::string("batch jobs.jsonl --jobs 3") + kSmall);
    const auto report = parseReport(batch.out);
    ASSERT_EQ(report.size(), 4u);
    const std::pair<int, const char*> alone[] = {
        {1, "render sample:dna -o one.png --color chain --rotate 0,90,0"},
        {3, "render sample:glucose -o one.jpg --size 40x30 --lighting off --style licorice"},
        {4, "render sample:dna -o one.png --show 'chain A=licorice' --hide 'chain B'"},
        {5, "render sample:glucose -o one.png --color-by all=red --layers one.exr"}};
    for (const auto& [line, command] : alone) {
        const Json& told = report.at(line);
        EXPECT_EQ(told["status"], "done");
        EXPECT_GT(told["ms"].get<double>(), 0);
        const std::string output = told["output"];
        const bool sized = std::string(command).find("--size") != std::string::npos;
        const std::string rest = sized ? " --occlusion 4 --occlusion-detail 8" : kSmall;
        nacreDone(folder, command + rest);
        const std::string same = readContents(folder / ("one" + output.substr(1)));
        EXPECT_EQ(readContents(folder / output), same) << command;
        EXPECT_EQ(told["bytes"].get<std::size_t>(), same.size());
    }
    EXPECT_EQ(readContents(folder / "d.exr"), readContents(folder / "one.exr"));
}

/// On a GPU the jobs' renderers share one device.
TEST(Batch, DrawsTheSameByAnyNumberOfJobs) {
    const TemporaryFolder folder;
    const auto draw = [&](const std::string& prefix, const std::string& more) {
        std::vector<std::string> jobs;
        for (int i = 0; i < 12; ++i)
            jobs.push_back(job(i % 3 == 0 ? "sample:dna" : "sample:glucose", prefix + std::to_string(i) + ".png",
                               R"("rotate": [0, )" + std::to_string(30 * i) + ", 0]"));
        writeJobs(folder, jobs);
        nacreDone(folder, "batch jobs.jsonl --validate" + more + kSmall);
    };
    draw("one", " --jobs 1");
    draw("four", " --jobs 4");
    for (int i = 0; i < 12; ++i)
        EXPECT_EQ(readContents(folder / ("four" + std::to_string(i) + ".png")),
                  readContents(folder / ("one" + std::to_string(i) + ".png")))
            << i;
}

TEST(Batch, TakesSeveralInputsAndWhatFitsThem) {
    const TemporaryFolder folder;
    writeJobs(folder, {R"({"input": ["a=sample:dna", "b=sample:dna"], "fit": ["/b and name P", "/a and name P"],)"
                       R"( "rotate": [0, 30, 0], "output": "a.png"})",
                       job("sample:dna", "b.png", R"("fit": "all")")});
    const Outcome batch = nacreIn(folder, std::string("batch jobs.jsonl") + kSmall);
    const auto report = parseReport(batch.out);
    EXPECT_EQ(report.at(1)["status"], "done") << report.at(1);
    EXPECT_NE(report.at(2)["error"].get<std::string>().find("expected two values"), std::string::npos);
    nacreDone(folder, std::string("render a=sample:dna b=sample:dna --fit '/b and name P' '/a and name P' "
                                  "--rotate 0,30,0 -o one.png") +
                          kSmall);
    EXPECT_EQ(readContents(folder / "a.png"), readContents(folder / "one.png"));
}

TEST(Batch, AFailedJobStopsNoOther) {
    const TemporaryFolder folder;
    std::ofstream(folder / "bad.pdb") << "ATOM  no\n";
    const std::pair<std::string, std::string> wrong[] = {
        {job("nosuch.pdb", "a.png"), "cannot read molecule: nosuch.pdb: No such file or directory"},
        {job("bad.pdb", "b.png"), "bad.pdb (line 1)"},
        {job("sample:dna", "c.png", R"("siez": "3x3")"), R"(has no option "siez" (did you mean 'size'?))"},
        {job("sample:dna", "c.png", R"("size": "3by3")"), "size: expected"},
        {job("sample:dna", "c.png", R"("show": ["chian A=licorice"])"), "show: "},
        {job("sample:dna", "c.png", R"("offline": "yes")"), R"("offline": expected true or false)"},
        {job("sample:dna", "c.png", R"("zoom": {"a": 1})"), R"("zoom": expected a text or a number)"},
        {job("sample:dna", "c.png", R"("device": "0")"), "all jobs are drawn by one device"},
        {job("sample:dna", "missing/c.png"), "missing/c.png"},
        {job("sample:dna", "-"), R"("output": a job's files have names)"},
        {job("-", "c.png"), R"("input": a job's files have names)"},
        {R"({"input": "sample:dna"})", R"("output" is required)"},
        {R"({"output": "c.png"})", "INPUT is required"},
        {R"({"input": 5, "output": "c.png"})", R"("input": expected a text, not 5)"},
        {R"({"input": "sample:dna", "output": true})", R"("output": expected a text, not true)"},
        {R"({"input": "sample:dna", "output": "c.png", "input": "sample:glucose"})", R"("input": it occurs twice)"},
        {job("sample:dna", R"(c\u0000.png)"), "output: it contains a NUL character"},
        {job(R"(no\u0000such)", "c.png"), "input: it contains a NUL character"},
        {"[1, 2]", "not a JSON object"},
        {R"({"input": "sample:dna", )", "not a JSON object"}};
    std::vector<std::string> lines;
    for (const auto& [line, why] : wrong) lines.push_back(line);
    lines.push_back(job("sample:glucose", "good.png"));
    writeJobs(folder, lines);
    const Outcome batch = nacreIn(folder, std::string("batch jobs.jsonl --jobs 2") + kSmall);
    EXPECT_EQ(batch.code, 1);
    EXPECT_NE(batch.err.find("nacre: error: batch: jobs.jsonl: not all jobs are done"), std::string::npos) << batch.err;
    const auto report = parseReport(batch.out);
    ASSERT_EQ(report.size(), lines.size());
    for (std::size_t i = 0; i < std::size(wrong); ++i) {
        const Json& told = report.at(static_cast<int>(i) + 1);
        EXPECT_EQ(told["status"], "failed") << told;
        EXPECT_NE(told["error"].get<std::string>().find(wrong[i].second), std::string::npos) << told;
        // What is wrong with a job does not hide which one it is.
        const Json said = Json::parse(wrong[i].first, nullptr, false);
        for (const char* name : {"input", "output"})
            EXPECT_EQ(told.at(name), said.is_object() ? said.value(name, Json()) : Json()) << told;
    }
    EXPECT_EQ(report.at(static_cast<int>(lines.size()))["status"], "done");
    EXPECT_EQ(folder.count(), 3u) << "the jobs, the bad file and the good picture";
}

TEST(Batch, OptionsOfTheCommandLineHoldForAllAndJobsPrevail) {
    const TemporaryFolder folder;
    writeJobs(folder, {job("sample:glucose", "a.png"), job("sample:glucose", "b.png", R"("background": "blue")")});
    nacreDone(folder, std::string("batch jobs.jsonl --background red") + kSmall);
    for (const char* color : {"red", "blue"})
        nacreDone(folder, std::string("render sample:glucose -o ") + color + ".png --background " + color + kSmall);
    EXPECT_EQ(readContents(folder / "a.png"), readContents(folder / "red.png"));
    EXPECT_EQ(readContents(folder / "b.png"), readContents(folder / "blue.png"));
    EXPECT_EQ(nacreIn(folder, "batch jobs.jsonl --background nocolour").code, 2);
    EXPECT_EQ(nacreIn(folder, "batch jobs.jsonl --jobs 0").code, 2);
    EXPECT_EQ(nacreIn(folder, "batch").code, 2);
}

TEST(Batch, GoesOnAfterAJobThatIsNestedTooDeep) {
    const TemporaryFolder folder;
    const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
    writeJobs(folder, {R"({"input": "sample:glucose", "output": )" + deep + "}", job("sample:glucose", "b.png")});
    const Outcome outcome = nacreIn(folder, std::string("batch jobs.jsonl") + kSmall);
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    auto report = parseReport(outcome.out);
    EXPECT_EQ(report.at(1)["error"], "it is nested more than 64 levels deep");
    EXPECT_EQ(report.at(2)["status"], "done");
}

TEST(Batch, ResumesWhereFilesAreMissing) {
    const TemporaryFolder folder;
    writeJobs(folder, {job("sample:glucose", "a.png"), job("sample:glucose", "b.png", R"("stats": "b.json")"),
                       job("sample:glucose", "c.png")});
    std::ofstream(folder / "a.png") << "kept";
    std::ofstream(folder / "b.png") << "its other file is missing";
    std::ofstream(folder / "c.png").close();  // there, and nothing in it
    const std::string command = std::string("batch jobs.jsonl --resume") + kSmall;
    const Outcome first = nacreDone(folder, command);
    auto report = parseReport(first.out);
    EXPECT_EQ(report.at(1)["status"], "skipped");
    EXPECT_EQ(report.at(2)["status"], "done");
    EXPECT_EQ(report.at(3)["status"], "done");
    EXPECT_EQ(readContents(folder / "a.png"), "kept");
    EXPECT_EQ(readContents(folder / "b.png"), readContents(folder / "c.png"));
    // All is there: no device is asked for.
    const Outcome second = nacreDone(folder, command, "", "export VK_DRIVER_FILES=/nowhere VK_ICD_FILENAMES=/nowhere");
    for (const auto& [line, told] : parseReport(second.out)) EXPECT_EQ(told["status"], "skipped") << line;
}

TEST(Batch, RefusesASecondJobOfTheSameFileByWhateverName) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "there");
    std::filesystem::create_directory_symlink(folder / "there", folder / "link");
    writeJobs(folder,
              {job("sample:glucose", "there/a.png", R"("stats": "a.json")"), job("sample:glucose", "./there/a.png"),
               job("sample:glucose", "link/a.png"), job("sample:glucose", folder / "there/../there/a.png"),
               job("sample:glucose", "b.png", R"("stats": "there/../a.json")"),
               job("sample:glucose", "c.png", R"("layers": "l.exr")"),
               job("sample:glucose", "d.png", R"("layers": "./l.exr")"), job("sample:glucose", "b.png")});
    const Outcome batch = nacreIn(folder, std::string("batch jobs.jsonl --jobs 1") + kSmall);
    EXPECT_EQ(batch.code, 1);
    auto report = parseReport(batch.out);
    for (const int line : {1, 6, 8}) EXPECT_EQ(report.at(line)["status"], "done") << report.at(line);
    for (const int line : {2, 3, 4, 5, 7}) {
        EXPECT_EQ(report.at(line)["status"], "failed") << line;
        EXPECT_NE(report.at(line)["error"].get<std::string>().find("an earlier job writes the same file"),
                  std::string::npos)
            << report.at(line);
    }
}

TEST(Batch, OfNoJobsIsDone) {
    const TemporaryFolder folder;
    std::ofstream(folder / "none.jsonl").close();
    std::ofstream(folder / "blank.jsonl") << "\n \n";
    for (const char* jobs : {"none.jsonl", "blank.jsonl", "-"}) {
        const Outcome batch = nacreDone(folder, std::string("batch ") + jobs);
        EXPECT_EQ(batch.out + batch.err, "") << jobs;
    }
    EXPECT_EQ(nacreIn(folder, "batch .").err, "nacre: error: cannot read jobs: .: it is a folder\n");
}

TEST(Batch, WithoutADeviceIsOneError) {
    const TemporaryFolder folder;
    writeJobs(folder, {job("sample:glucose", "a.png"), job("sample:glucose", "b.png")});
    const Outcome batch =
        nacreIn(folder, "batch jobs.jsonl", "", "export VK_DRIVER_FILES=/nowhere VK_ICD_FILENAMES=/nowhere");
    EXPECT_EQ(batch.code, 1);
    EXPECT_EQ(batch.out, "");
    EXPECT_EQ(batch.err.rfind("nacre: error: cannot start Vulkan", 0), 0u) << batch.err;
    EXPECT_EQ(nacreIn(folder, "batch nosuch.jsonl").err,
              "nacre: error: cannot read jobs: nosuch.jsonl: No such file or directory\n");
}

TEST(Batch, ReadsStandardInputWhereverItEnds) {
    const TemporaryFolder folder;
    std::ofstream(folder / "jobs") << job("sample:glucose", "a.png");  // no line end
    nacreDone(folder, std::string("batch -") + kSmall, "<jobs");
    EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
}

TEST(Batch, NoJobTakesAwayWhatIsRead) {
    const TemporaryFolder folder;
    const std::string molecule = "2\nm\nC 0 0 0\nO 1.2 0 0\n";
    const char* const names[] = {"early.xyz", "late.xyz", "seen.xyz", "odd.png"};
    for (const char* name : names) std::ofstream(folder / name) << molecule;
    std::ofstream(folder / "v.json") << R"({"input": "seen.xyz"})";
    const std::string seen = R"({"view": "v.json", "output": ")";
    writeJobs(folder, {job("early.xyz", "a.png"), seen + "b.png\"}",
                       job("sample:glucose", "c.png", R"("stats": "./early.xyz")"),
                       job("sample:glucose", "d.png", R"("stats": "late.xyz")"), job("late.xyz", "e.png"),
                       job("sample:glucose", "f.png", R"("stats": "v.json")"),
                       job("sample:glucose", "g.png", R"("stats": "seen.xyz")"),
                       job("sample:glucose", "h.png", R"("stats": "jobs.jsonl")"),
                       job("sample:glucose", "i.png", R"("stats": "s.json")"), job("odd.png", "j.png"),
                       job("sample:glucose", "odd.png")});
    const std::string jobs = readContents(folder / "jobs.jsonl");
    const Outcome batch = nacreIn(folder, std::string("batch jobs.jsonl --jobs 1") + kSmall);
    const auto report = parseReport(batch.out);
    for (const int line : {1, 2, 5, 9, 10}) EXPECT_EQ(report.at(line)["status"], "done") << report.at(line);
    const auto refused = [&](int line, const std::string& why) {
        EXPECT_NE(report.at(line).value("error", "").find(why), std::string::npos) << report.at(line);
    };
    for (const int line : {3, 4, 6, 7, 8}) refused(line, R"("stats": )");
    refused(4, "the existing file is not a stats file: late.xyz");
    refused(11, R"("output": an earlier job reads this file: odd.png)");
    for (const char* name : names) EXPECT_EQ(readContents(folder / name), molecule) << name;
    EXPECT_EQ(readContents(folder / "v.json"), R"({"input": "seen.xyz"})");
    EXPECT_EQ(readContents(folder / "jobs.jsonl"), jobs);
    // Stats of a run before are replaced.
    writeJobs(folder, {job("early.xyz", "a.png", R"("stats": "s.json")")});
    EXPECT_EQ(parseReport(nacreIn(folder, std::string("batch jobs.jsonl --jobs 1") + kSmall).out).at(1)["status"],
              "done");
}

TEST(Batch, TellsOfEachJobWhatRenderSays) {
    const TemporaryFolder folder, elsewhere;
    std::ofstream(elsewhere / "m.xyz") << "2\nm\nC 0 0 0\nO 1.2 0 0\n";
    std::ofstream(folder / "v.json") << R"({"input": ")" << elsewhere / "m.xyz"
                                     << "\"}";
    writeJobs(folder, {R"({"view": "v.json", "output": "a.png"})",
                       R"({"input": ["a=sample:dna", "b=sample:dna"], "fit": ["/b", "/a"], "output": "b.png"})"});
    const Outcome batch = nacreIn(folder, std::string("batch jobs.jsonl -q") + kSmall);
    EXPECT_EQ(batch.err, "");
    const auto report = parseReport(batch.out);
    ASSERT_EQ(report.at(1)["warnings"].size(), 1u) << report.at(1);
    EXPECT_EQ(report.at(1)["warnings"][0],
              "v.json has this file opened, which is not in its folder: " + elsewhere / "m.xyz");
    EXPECT_NE(report.at(2)["notes"].dump().find("RMSD 0.000"), std::string::npos) << report.at(2);
}

// Pipelines, descriptor sets, images, the driver's caches: hundreds of jobs more take no more memory.
TEST(Batch, TakesNoMoreMemoryForMoreJobs) {
    if (std::getenv("NACRE_SANITIZED")) GTEST_SKIP() << "sanitizers keep freed memory";
    const TemporaryFolder folder;
    const auto measurePeak = [&](int jobs) {
        std::vector<std::string> lines;
        for (int i = 0; i < jobs; ++i) {
            const char* sizes[] = {"16x16", "24x16", "20x30"};
            const char* styles[] = {"spacefill", "licorice"};
            lines.push_back(job("sample:glucose", folder / (std::to_string(i) + ".png"),
                                std::string(R"("size": ")") + sizes[i % 3] + R"(", "style": ")" + styles[i % 2] +
                                    R"(", "occlusion": )" + std::to_string(2 + i % 4)));
        }
        writeJobs(folder, lines);
        // One at a time: what two take together at most goes with how they meet.
        const test::MeasuredRun run = test::runMeasured({"batch", folder / "jobs.jsonl", "--jobs", "1", "-q"});
        EXPECT_EQ(run.code, 0) << run.err;
        return run.peakBytes;
    };
    const std::int64_t few = measurePeak(100), many = measurePeak(400);
    EXPECT_LT((many - few) / 300, 4096) << few << " bytes, then " << many;
}

}  // namespace
}  // namespace nacre::app
