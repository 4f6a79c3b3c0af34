// Films through the models of a file.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "engine/molecule/text.h"
#include "tests/movie/films.h"
#include "tests/support/measured_run.h"

namespace nacre::app {
namespace {

TEST(Movie, GoesThroughModels) {
    const TemporaryFolder folder;
    std::ofstream xyz(folder / "m.xyz");
    for (int model = 0; model < 3; ++model) xyz << "2\nm\nC 0 0 0\nO " << 1.2 + model * 0.2 << " 0 0\n";
    xyz.close();
    const Outcome outcome = test::nacreDone(folder, "movie m.xyz -o f/ --models --fps 10 --report -" + kSmall);
    for (const char* model : {"1", "2", "3"})
        EXPECT_NE(outcome.out.find(R"({"frame": )" + std::string(model) + R"(, "frames": 3, "model": )" + model + "}"),
                  std::string::npos)
            << outcome.out;
    EXPECT_TRUE(std::filesystem::exists(folder / "f/frame_00003.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "f/frame_00004.png"));
    EXPECT_NE(readContents(folder / "f/frame_00001.png"), readContents(folder / "f/frame_00003.png"));
}

TEST(Movie, GoesThroughARangeOfModelsInStrides) {
    const TemporaryFolder folder;
    std::ofstream xyz(folder / "m.xyz");
    for (int model = 0; model < 7; ++model) xyz << "2\nm\nC 0 0 0\nO " << 1.2 + model * 0.2 << " 0 0\n";
    xyz.close();
    const auto models = [&](const std::string& options) {
        const Outcome outcome = test::nacreDone(folder, "movie m.xyz -o f.png --models --report - " + options + kSmall);
        std::string shown;
        for (std::size_t at = 0; (at = outcome.out.find("\"model\": ", at)) != std::string::npos; ++at)
            if (shown.empty() || shown.back() != outcome.out[at + 9]) shown += outcome.out[at + 9];
        return shown;
    };
    EXPECT_EQ(models("--fps 10"), "1234567");
    EXPECT_EQ(models("--fps 10 --frames 2-6:2"), "246");
    EXPECT_EQ(models("--fps 10 --frames 3-5"), "345");
    EXPECT_EQ(models("--fps 10 --frames 5-"), "567");
    EXPECT_EQ(models("--fps 10 --frames 2-:4"), "26");
    // Titles have the model's number, not the frame's.
    const auto movie = [&](const char* title) {
        nacreIn(folder, std::string("movie m.xyz -o t.png --models --center 2,0,0 --frames 4-4 --fps 10 --title ") +
                            title + kSmall);
        return readFrames(folder / "t.png");
    };
    EXPECT_EQ(movie("'m {frame}'"), movie("'m 4'"));
    EXPECT_NE(movie("'m {frame}'"), movie("'m 1'"));
    const Outcome beyond = nacreIn(folder, "movie m.xyz -o f.png --models --frames 2-9" + kSmall);
    EXPECT_EQ(beyond.code, 1);
    EXPECT_NE(beyond.err.find("there is no frame 9; it has 7"), std::string::npos) << beyond.err;
}

// The camera that all models share, or one for each; bonds and atoms are each model's own.
TEST(Movie, ModelsAreThePicturesThatRenderDraws) {
    const TemporaryFolder folder;
    std::ofstream(folder / "m.xyz") << "2\nm\nC 0 0 0\nO 1.2 0 0\n2\nm\nC 0 5 0\nO 2.6 5 0\n3\nm\nC 0 0 3\nO 0 1.2 3\n"
                                       "N 4 4 4\n";
    for (const std::string options : {"", " --camera model", " --projection perspective --rotate 10,20,30"}) {
        test::nacreDone(folder, "movie m.xyz -o f/ --models --fps 10" + kSmall + options);
        for (const char* model : {"1", "2", "3"}) {
            test::nacreDone(folder, std::string("render m.xyz -o a.png --model ") + model + kSmall + options);
            EXPECT_TRUE(readContents(folder / ("f/frame_0000" + std::string(model) + ".png")) ==
                        readContents(folder / "a.png"))
                << model << options;
        }
    }
}

TEST(Movie, MovingAtomsHaveCoarserOcclusionUnlessItIsAskedFor) {
    const TemporaryFolder folder;
    std::ofstream xyz(folder / "m.xyz");
    for (int model = 0; model < 2; ++model) {
        xyz << "27\nm\n";
        for (int i = 0; i < 27; ++i)
            xyz << "C " << i % 3 * 2.5 << " " << i / 3 % 3 * 2.5 << " " << i / 9 * 2.5 + model * 0.1 << "\n";
    }
    xyz.close();
    const std::string small = " --size 64x48 --cache off --style spacefill --rotate 20,30,0";
    const auto frame = [&](const std::string& options) {
        test::nacreDone(folder, "movie m.xyz -o f/ --models --fps 10" + small + options);
        return readContents(folder / "f/frame_00002.png");
    };
    const std::string moving = frame("");
    EXPECT_NE(moving, frame(" --occlusion off"));
    test::nacreDone(folder, "render m.xyz -o a.png --model 2" + small);
    EXPECT_NE(moving, readContents(folder / "a.png"));
    EXPECT_EQ(frame(" --occlusion 128"), readContents(folder / "a.png"));
}

TEST(Movie, SurfacesThatMoveHaveTheColoursOfAMap) {
    const TemporaryFolder folder;
    std::ofstream xyz(folder / "m.xyz");
    for (int model = 0; model < 3; ++model) xyz << "2\nm\nC 0 0 0\nO " << 1.2 + model * 0.2 << " 0 0\n";
    xyz.close();
    std::string cube = "the place\nalong x\n 0 -9 -9 -9\n 3 9 0 0\n 3 0 9 0\n 3 0 0 9\n";
    for (int node = 0; node < 27; ++node) cube += std::to_string(node / 9 - 1) + "\n";
    std::ofstream(folder / "x.cube") << cube;
    const std::string movie = "movie m.xyz --models --smooth 3 --fps 10 --style surface" + kSmall;
    test::nacreDone(folder, movie + " -o plain/");
    const Outcome colored = test::nacreDone(folder, movie + " -o colored/ --surface-color-from x.cube:-0.3..0.3:grays");
    for (int i = 1; i <= 3; ++i) {
        const std::string name = "/frame_0000" + std::to_string(i) + ".png";
        EXPECT_NE(readContents(folder / ("plain" + name)), readContents(folder / ("colored" + name))) << i;
    }
}

TEST(Movie, ModelsGoOnAlongViews) {
    const TemporaryFolder folder;
    std::ofstream xyz(folder / "m.xyz");
    for (int model = 0; model < 4; ++model) xyz << "2\nm\nC 0 0 0\nO 0 " << 1.2 + model << " 0\n";
    xyz.close();
    for (const char* name : {"a.json", "b.json"})
        std::ofstream(folder / name) << R"({"input": "m.xyz", "orientation": [1, 0, 0, 0], "occlusion": "off"})";
    for (const char* smooth : {"", " --smooth 3"}) {
        test::nacreDone(
            folder,
            std::string("movie --views a.json,b.json --models --fps 4 --seconds 1 -o f/ --size 64x48") + smooth);
        for (int i = 2; i <= 4; ++i)
            EXPECT_NE(readContents(folder / "f/frame_00001.png"),
                      readContents(folder / ("f/frame_0000" + std::to_string(i) + ".png")))
                << i << smooth;
    }
}

// A file that is longer than what is held of one, whose models are read as they are needed.
TEST(Movie, HoldsNoMoreOfAFileThanItsModels) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer keeps what was freed";
#endif
    const TemporaryFolder folder;
    std::string model;
    for (int i = 0; i < 5000; ++i) {
        model += formatted("ATOM  %5d  CA  GLY A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n", i, i, i % 20 * 4.0,
                           i / 20 % 20 * 4.0, i / 400 * 4.0);
    }
    const auto write = [&](const char* name, int models) {
        std::ofstream out(folder / name);
        for (int i = 1; i <= models; ++i) out << "MODEL " << i << "\n" << model << "ENDMDL\n";
    };
    write("few.pdb", 2);
    write("many.pdb", 120);  // 48 MB
    const auto measurePeak = [&](const char* name) {
        const test::MeasuredRun run =
            test::runMeasured({"movie", folder / name, "--models", "--seconds", "0.3", "--fps", "10", "--size", "32x32",
                               "--occlusion", "off", "--style", "spacefill", "-o", folder / "a.png", "-q"});
        EXPECT_EQ(run.code, 0) << run.err;
        return run.peakBytes;
    };
    const auto few = measurePeak("few.pdb"), many = measurePeak("many.pdb");
    EXPECT_LT(many, few + (24u << 20)) << "the text is 48 MB, its positions 7";
}

TEST(Movie, FitsAndSmoothsModels) {
    const TemporaryFolder folder;
    // What shakes stands at its mean, at both ends that of two; what turns goes back. Beside the same written out.
    // Four atoms about it are where the camera that all models share goes by.
    const std::string still = "C 0 0 0\nO 2 0 0\nN 0 2 0\n", frame = "He 4 0 0\nHe 0 4 0\nHe -4 0 0\nHe 0 -4 0\n",
                      turned = "He 0 4 0\nHe -4 0 0\nHe 0 -4 0\nHe 4 0 0\n";
    const auto write = [&](const char* name, std::initializer_list<std::string> models) {
        std::ofstream out(folder / name + ".xyz");
        for (const std::string& atoms : models) out << "7\nm\n" << atoms;
    };
    const auto lifted = [&](const std::string& y, const std::string& top) {
        return "C 0 " + y + " 0\nO 2 " + y + " 0\nN 0 " + top + " 0\n" + frame;
    };
    write("shaken", {still + frame, lifted("0.6", "2.6"), still + frame});
    write("smooth", {lifted("0.3", "2.3"), lifted("0.2", "2.2"), lifted("0.3", "2.3")});
    write("turned", {still + frame, "C 0 0 0\nO 0 2 0\nN -2 0 0\n" + turned});
    write("still", {still + frame, still + frame});
    const auto frames = [&](const std::string& molecule, const std::string& options) {
        const std::string movie = std::to_string(folder.count()) + ".png";
        test::nacreDone(folder, "movie " + molecule + ".xyz -o " + movie + " --models --fps 10 " + options + kSmall);
        return readFrames(folder / movie);
    };
    // Outlines that pass through centres of pixels fall to either side.
    const auto apart = [](const std::string& a, const std::string& b) {
        EXPECT_EQ(a.size(), b.size());
        double sum = 0;
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
            sum += std::abs(static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(b[i]));
        return sum / static_cast<double>(a.size());
    };
    const std::string smoothed = frames("smooth", ""), unmoved = frames("still", "");
    EXPECT_LT(apart(frames("shaken", "--smooth 3"), smoothed), 0.3);
    EXPECT_GT(apart(frames("shaken", ""), smoothed), 1);
    EXPECT_LT(apart(frames("turned", "--fit-frames all"), unmoved), 0.3);
    EXPECT_GT(apart(frames("turned", ""), unmoved), 1);
}

TEST(Movie, MorphsFromModelToModelOrFromInputToInput) {
    const TemporaryFolder folder;
    const std::string still = "7\nm\nC -3 0 0\nC -2.5 1.4 0\nC -1 1.4 0\nC -0.5 0 0\nC 1 0 0\nC 1.5 1.4 0\n";
    const std::string open = still + "O 2.9 1.4 0\n", closed = still + "O 0.7 2.5 0\n";
    std::ofstream(folder / "m.xyz") << open << closed;
    std::ofstream(folder / "a.xyz") << open;
    std::ofstream(folder / "b.xyz") << closed;
    const auto frames = [&](const std::string& options) {
        const std::string movie = std::to_string(folder.count()) + ".png";
        const Outcome outcome =
            test::nacreDone(folder, "movie " + options + " -o " + movie + " --fps 4 --report -" + kSmall);
        EXPECT_NE(outcome.out.find(R"("frames": 8,)"), std::string::npos) << "2 s: " << outcome.out;
        return readFrames(folder / movie);
    };
    const std::string through = frames("m.xyz --morph");
    const std::size_t frame = through.size() / 8;
    const auto at = [&](const std::string& all, std::size_t i) { return all.substr(i * frame, frame); };
    test::nacreDone(folder, "movie m.xyz -o models.png --models --fps 10" + kSmall);
    const std::string models = readFrames(folder / "models.png");
    for (std::size_t i = 1; i < 8; ++i) EXPECT_NE(at(through, i), at(through, i - 1)) << i;
    EXPECT_EQ(at(through, 0), at(models, 0)) << "it begins as the first model";
    EXPECT_EQ(at(frames("a.xyz b.xyz --morph"), 0), at(through, 0));
    // Inputs are shown one by one, too.
    test::nacreDone(folder, "movie a.xyz b.xyz -o inputs.png --models --conformations --fps 10" + kSmall);
    EXPECT_EQ(readFrames(folder / "inputs.png").substr(0, frame), at(models, 0));
    EXPECT_EQ(readFrames(folder / "inputs.png").size(), models.size());
    // There and back in the same time.
    const std::string round = frames("m.xyz --morph --loop --seconds 2 --easing linear");
    EXPECT_EQ(at(round, 0), at(through, 0));
    EXPECT_NE(at(round, 7), at(through, 0)) << "the last frame leads on to the first";
    EXPECT_EQ(at(round, 4), at(through, 7)) << "it turns back at the last model";
}

TEST(Movie, WordsGoWithTheAtomsThatTheyName) {
    const TemporaryFolder folder;
    std::ofstream xyz(folder / "m.xyz");
    for (const int y : {-4, 0, 4}) xyz << "3\nm\nC 0 -8 0\nC 0 8 0\nN 4 " << y << " 0\n";
    xyz.close();
    const auto frames = [&](const char* movie, const char* options) {
        test::nacreDone(folder, std::string("movie m.xyz --models --smooth 3 --fps 10 -o ") + movie + kSmall + options);
        return readFrames(folder / movie);
    };
    const std::string plain = frames("a.png", ""), named = frames("b.png", "--label 'element N=N'");
    ASSERT_EQ(plain.size(), 3 * kFrameBytes);
    ASSERT_EQ(named.size(), plain.size());
    std::vector<double> rows;
    for (std::size_t frame = 0; frame < 3; ++frame) {
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < kFrameBytes; ++i)
            if (plain[frame * kFrameBytes + i] != named[frame * kFrameBytes + i])
                sum += static_cast<double>(i / (3 * 64)), ++count;
        ASSERT_GT(count, 20) << frame;
        rows.push_back(sum / count);
    }
    EXPECT_GT(rows[0], rows[1] + 1);
    EXPECT_GT(rows[1], rows[2] + 1);
}

}  // namespace
}  // namespace nacre::app
