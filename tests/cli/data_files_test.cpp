// Every file that the build writes and every file of the data folder: good ones become pictures, damaged ones, by the
// built program, a picture or one clear line in bounded time and memory.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/error.h"
#include "engine/molecule/memory_bound.h"
#include "tests/support/measured_run.h"
#include "tests/support/test_data.h"
#include "tests/support/written_files.h"

namespace nacre {
namespace {

using test::MeasuredRun;
using test::TemporaryFolder;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMeasured = false;  // the bounds are those of the release build
#else
constexpr bool kMeasured = true;
#endif
constexpr double kMostSeconds = 10;  // of the processor: other programs may be busy
constexpr std::int64_t kMostBytes = 500'000'000;
/// More atoms than the default memory of occlusion has patches for.
constexpr std::int64_t kManyAtoms = 400'000;

nlohmann::json expectedFiles() {
    std::ifstream stream(test::dataFile("expected.json"));
    return nlohmann::json::parse(stream).at("files");
}

/// Exit 0, a picture, and nothing said; or exit 1, no picture, and one line that names the file.
void expectPictureOrOneLine(const MeasuredRun& run, const std::string& file, const TemporaryFolder& folder) {
    EXPECT_EQ(run.signal, 0);
    EXPECT_EQ(run.out, "");
    if (run.code == 0) {
        EXPECT_EQ(run.err, "");
        EXPECT_EQ(folder.count(), 1u);
        EXPECT_EQ(test::readContents(folder / "a.png").substr(0, 4), "\x89PNG");
        return;
    }
    EXPECT_EQ(run.code, 1) << run.err;
    EXPECT_EQ(run.err.rfind("nacre: error: ", 0), 0u) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(std::filesystem::path(file).filename()), std::string::npos) << run.err;
    EXPECT_EQ(folder.count(), 0u);
}

/// One damaged file, by the built program.
void expectBoundedEnd(const std::string& path) {
    SCOPED_TRACE(path);
    const TemporaryFolder folder;
    const MeasuredRun run = test::runMeasured({"render", path, "-o", folder / "a.png", "--size", "128x128"});
    expectPictureOrOneLine(run, path, folder);
    if (kMeasured) {
        EXPECT_LT(run.processorSeconds, kMostSeconds);
        EXPECT_LT(run.peakBytes, kMostBytes);
    }
}

/// Of the files that the build makes.
std::vector<test::WrittenFile> oneOfEachKind(const std::string& sample) {
    std::map<std::string, test::WrittenFile> kinds;
    for (const test::WrittenFile& file : test::writtenFiles())
        if (file.sample == sample) kinds.emplace(file.kind, file);
    std::vector<test::WrittenFile> files;
    for (const auto& [kind, file] : kinds) files.push_back(file);
    EXPECT_EQ(files.size(), 18u);
    return files;
}

TEST(DataFiles, DamagedOnesEndInAPictureOrOneLineWithinBounds) {
    NACRE_NEEDS_WRITTEN_FILES();
    // Cut short in the middle of a word or number, as a transfer that broke off leaves them.
    const TemporaryFolder damaged;
    int refused = 0;
    for (const test::WrittenFile& file : oneOfEachKind("dna")) {
        const std::string path = damaged / std::filesystem::path(file.path).filename();
        std::string text = test::readContents(file.path);
        text.resize(text.size() * 2 / 3);
        std::ofstream(path, std::ios::binary) << text;
        expectBoundedEnd(path);
        try {
            readMoleculeFile(path);
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GE(refused, 10);

    if (!test::dataFolder()) return;
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*test::dataFolder() / "bad")) {
        expectBoundedEnd(entry.path());
        ++files;
    }
    EXPECT_GT(files, 50);
}

/// Draws files by one batch, small, with occlusion by 16 directions or none.
class Drawn {
public:
    void add(const std::string& name, const std::string& path, bool occlusion) {
        names_.push_back(name);
        jobs_ << nlohmann::json{{"input", path}, {"output", output(name)}, {"occlusion", occlusion ? "16" : "off"}}
              << "\n";
    }
    /// What was said of each, by its name.
    std::map<std::string, nlohmann::json> draw() {
        std::ofstream(folder_ / "jobs") << jobs_.str();
        test::RunOptions options;
        options.processorSeconds = 600;
        const MeasuredRun run =
            test::runMeasured({"batch", folder_ / "jobs", "--cache", "off", "--size", "96x96", "--jobs", "1"}, options);
        EXPECT_EQ(run.signal, 0);
        std::map<std::string, nlohmann::json> said;
        std::istringstream lines(run.out);
        for (std::string line; std::getline(lines, line);) {
            const nlohmann::json one = nlohmann::json::parse(line);
            if (one.contains("job")) said[names_.at(one["job"].get<std::size_t>() - 1)] = one;
        }
        EXPECT_EQ(said.size(), names_.size()) << run.err;
        return said;
    }
    std::string output(const std::string& name) const {
        return folder_ / (std::to_string(std::hash<std::string>{}(name)) + ".png");
    }

private:
    TemporaryFolder folder_;
    std::vector<std::string> names_;
    std::ostringstream jobs_;
};

TEST(DataFiles, GoodOnesBecomePictures) {
    NACRE_NEEDS_WRITTEN_FILES();
    Drawn drawn;
    const std::vector<test::WrittenFile> written = oneOfEachKind("buckyball");
    for (const test::WrittenFile& file : written) drawn.add(file.name, file.path, true);
    if (test::dataFolder()) {
        const nlohmann::json files = expectedFiles();
        for (const auto& [file, expected] : files.items()) {
            const auto atoms = expected.find("atoms");
            const bool many = atoms != expected.end() && atoms->is_number() && *atoms > kManyAtoms;
            if (file.rfind("bad/", 0) != 0) drawn.add(file, test::dataFile(file), !many);
        }
    }
    std::map<std::string, nlohmann::json> said = drawn.draw();
    for (const test::WrittenFile& file : written) EXPECT_EQ(said[file.name]["status"], "done") << said[file.name];
    int pictures = 0;
    for (const auto& [name, how] : said) {
        SCOPED_TRACE(how.dump());
        if (how["status"] == "done") {
            ++pictures;
            EXPECT_EQ(test::readContents(drawn.output(name)).substr(0, 4), "\x89PNG");
            continue;
        }
        // Refused only for a format that `--format` does not know either.
        EXPECT_FALSE(std::filesystem::exists(drawn.output(name)));
        const std::string error = how["error"];
        const std::size_t at = error.find("format ");
        const std::size_t end = error.find(" is not supported");
        ASSERT_NE(end, std::string::npos);
        if (at < end) {
            EXPECT_FALSE(formatFromName(error.substr(at + 7, end - at - 7)));
        }
    }
    EXPECT_GT(pictures, test::dataFolder() ? 75 : 14);
}

/// 4,000 atoms too far from each other for bonds.
std::string manyAtoms() {
    std::string text = "4000\n\n";
    for (int i = 0; i < 4000; ++i)
        text += "C " + std::to_string(i % 20 * 4) + " " + std::to_string(i / 20 % 20 * 4) + " " +
                std::to_string(i / 400 * 4) + "\n";
    return text;
}

TEST(DataFiles, MemoryKeepsToTheStatedBound) {
    if (!kMeasured) GTEST_SKIP() << "sanitizers take memory of their own";
    const auto peak = [](const std::string& input, const char* size = "64x64") {
        const TemporaryFolder folder;
        const MeasuredRun run = test::runMeasured(
            {"render", input, "-o", folder / "a.png", "--size", size, "--style", "licorice", "--occlusion", "off"});
        EXPECT_EQ(run.code, 0) << run.err;
        return run.peakBytes;
    };
    const std::int64_t least = peak("sample:glucose");
    const std::int64_t driver = 100'000'000;
    if (test::dataFolder()) {
        EXPECT_LT(peak(test::dataFile("1aon-groel.pdb.gz")) - least,
                  driver + static_cast<std::int64_t>(58'870 * kBytesPerAtom + 4'800'000 * kBytesPerTextByte));
        EXPECT_LT(peak(test::dataFile("4v5a-ribosome.mmtf")) - least,
                  driver + static_cast<std::int64_t>(290'487 * kBytesPerAtom + 2'702'627 * kBytesPerTextByte));
    }
    EXPECT_LT(peak("sample:glucose", "2048x2048") - least,
              static_cast<std::int64_t>(2048 * 2048 * kBytesPerPicturePixel));
    // What does not fit is refused: 5 MB have room for 3,744 atoms.
    const TemporaryFolder folder;
    const TemporaryFolder input;
    std::ofstream(input / "many.xyz") << manyAtoms();
    const MeasuredRun run = test::runMeasured({"render", input / "many.xyz", "-o", folder / "a.png", "--memory", "5"});
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("many.xyz: more than 3744 atoms, the most that the memory limit allows"), std::string::npos)
        << run.err;
    EXPECT_EQ(folder.count(), 0u);
}

}  // namespace
}  // namespace nacre
