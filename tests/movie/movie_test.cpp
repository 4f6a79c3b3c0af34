// `nacre movie` as a user meets it. What it writes is read by ffmpeg, which nobody here wrote.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/movie/films.h"

namespace nacre::app {
namespace {

TEST(Movie, FramesAreTheFilesThatRenderWrites) {
    const TemporaryFolder folder;
    const Outcome outcome =
        test::nacreDone(folder, "movie sample:glucose -o f/ --spin y --fps 8 --seconds 0.5" + kSmall);
    EXPECT_EQ(outcome.err, "");
    const TemporaryFolder pictures;
    for (int i = 0; i < 4; ++i) {
        const std::string name = std::to_string(i) + ".png";
        test::nacreDone(pictures, "render sample:glucose -o " + name + " --rotate 0," + std::to_string(90 * i) +
                                      ",0 --zoom 1" + kSmall);
        EXPECT_EQ(readContents(folder / ("f/frame_0000" + std::to_string(i + 1) + ".png")),
                  readContents(pictures / name))
            << i;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "f/frame_00005.png")) << "the last frame leads on to the first";
}

TEST(Movie, ShowsInteractionsInEveryFrame) {
    const TemporaryFolder folder;
    const std::string look = " --style licorice --zoom 2" + kSmall, contacts = look + " --interactions 'chain A'";
    test::nacreDone(folder, "movie sample:dna -o f/ --spin y --fps 4 --seconds 0.5" + contacts);
    for (int i = 0; i < 2; ++i) {
        const std::string turned = " --rotate 0," + std::to_string(180 * i) + ",0";
        test::nacreDone(folder, "render sample:dna -o with.png" + turned + contacts);
        test::nacreDone(folder, "render sample:dna -o without.png" + turned + look);
        const std::string frame = readContents(folder / ("f/frame_0000" + std::to_string(i + 1) + ".png"));
        EXPECT_EQ(frame, readContents(folder / "with.png")) << i;
        EXPECT_NE(frame, readContents(folder / "without.png")) << i;
    }
}

TEST(Movie, SweepsTheLevelOfAMap) {
    const TemporaryFolder folder;
    std::string cube = "a ball\nof density\n 0 -6 -6 -6\n 13 1 0 0\n 13 0 1 0\n 13 0 0 1\n";
    for (int x = -6; x <= 6; ++x)
        for (int y = -6; y <= 6; ++y)
            for (int z = -6; z <= 6; ++z) cube += std::to_string(40 - x * x - y * y - z * z) + "\n";
    std::ofstream(folder / "ball.cube") << cube;
    const std::string map = " --map ball.cube --map-style mesh --center 0,0,0 --scale 20A";
    test::nacreDone(folder,
                    "movie sample:glucose -o f/ --map-sweep 10,30 --fps 2 --seconds 1.5 --map-level 3" + map + kSmall);
    for (int i = 0; i < 3; ++i) {
        const std::string name = std::to_string(i) + ".png";
        test::nacreDone(
            folder, "render sample:glucose -o " + name + " --map-level " + std::to_string(10 + 10 * i) + map + kSmall);
        EXPECT_EQ(readContents(folder / ("f/frame_0000" + std::to_string(i + 1) + ".png")), readContents(folder / name))
            << i;
    }
    EXPECT_NE(readContents(folder / "0.png"), readContents(folder / "1.png"));
}

TEST(Movie, EveryFormatHoldsTheFramesThatWereDrawn) {
    const TemporaryFolder folder;
    const std::string motion = "movie sample:glucose --spin x --fps 10 --seconds 0.8" + kSmall + "-o ";
    test::nacreDone(folder, motion + "f/");
    std::string expected;
    for (int i = 1; i <= 8; ++i) expected += readFrames(folder / ("f/frame_0000" + std::to_string(i) + ".png"));
    ASSERT_EQ(expected.size(), 8 * kFrameBytes);
    const struct {
        const char *name, *codec;
        int difference;
    } formats[] = {{"a.png", "apng", 0}, {"a.gif", "gif", 40}, {"a.mp4", "h264", 255}, {"a.webm", "vp9", 255}};
    for (const auto& format : formats) {
        test::nacreDone(folder, motion + format.name);
        const std::string told = probed(folder / format.name, "codec_name,width,height,r_frame_rate,nb_read_frames");
        EXPECT_EQ(told, std::string("codec_name=") + format.codec +
                            "\nwidth=64\nheight=48\nr_frame_rate=10/1\nnb_read_frames=8\n");
        const std::string frames = readFrames(folder / format.name);
        ASSERT_EQ(frames.size(), expected.size()) << format.name;
        EXPECT_LE(largestDifference(frames, expected), format.difference) << format.name;
        double sum = 0;  // thin sticks lose colour in video, whose colour has half the pixels
        for (std::size_t i = 0; i < frames.size(); ++i)
            sum += std::abs(static_cast<unsigned char>(frames[i]) - static_cast<unsigned char>(expected[i]));
        EXPECT_LT(sum / static_cast<double>(frames.size()), 4) << format.name;
        // The same once more, to the byte.
        const std::string first = readContents(folder / format.name);
        test::nacreDone(folder, motion + format.name);
        EXPECT_TRUE(first == readContents(folder / format.name)) << format.name << " is not the same twice";
    }
    EXPECT_EQ(folder.count(), 5u) << "something is left behind";
}

TEST(Movie, KeepsTransparencyWhereTheFormatCan) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.gif"}) {
        test::nacreDone(folder, std::string("movie sample:glucose --rock 40 --background transparent --fps 5 "
                                            "--seconds 0.4 -o ") +
                                    name + kSmall);
        const std::string pixels =
            captureOutput("ffmpeg -v error -nostdin -i '" + (folder / name) + "' -f rawvideo -pix_fmt rgba - 2>&1");
        ASSERT_GE(pixels.size(), 2 * 64 * 48 * 4u) << pixels;
        EXPECT_EQ(pixels[3], 0) << name << ": the corner is not transparent";
        int opaque = 0;
        for (std::size_t i = 3; i < pixels.size(); i += 4) opaque += static_cast<unsigned char>(pixels[i]) == 255;
        EXPECT_GT(opaque, 100) << name;
    }
}

TEST(Movie, KeyViewsAreThePicturesOfTheirFiles) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.json") << R"({"input": "sample:glucose", "orientation": [1, 0, 0, 0], "title": "Sugar"})";
    std::ofstream(folder / "b.json") << R"({"input": "sample:glucose", "orientation": [0.6, 0, 0.8, 0], "zoom": 2,
        "pan": [0.5, 1], "style": "licorice", "background": "navy"})";
    for (const char* name : {"a", "b"})
        test::nacreDone(folder,
                        "render --view " + std::string(name) + ".json -o " + name + ".png --size 64x48 --cache off");
    const std::string common = "movie --views a.json,b.json --size 64x48 --cache off --fps 3 --seconds ";
    test::nacreDone(folder, common + "1 -o open/");
    EXPECT_EQ(readContents(folder / "open/frame_00001.png"), readContents(folder / "a.png"));
    EXPECT_EQ(readContents(folder / "open/frame_00003.png"), readContents(folder / "b.png")) << "ends at the last view";
    test::nacreDone(folder, common + "1.3333 -o loop/ --loop");
    EXPECT_EQ(readContents(folder / "loop/frame_00001.png"), readContents(folder / "a.png"));
    EXPECT_EQ(readContents(folder / "loop/frame_00003.png"), readContents(folder / "b.png"));
    EXPECT_NE(readContents(folder / "loop/frame_00004.png"), readContents(folder / "a.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "loop/frame_00005.png"));
}

TEST(Movie, KeepsTheTransparencyOfItsViews) {
    const TemporaryFolder folder;
    for (const char* view : {"a", "b"})
        std::ofstream(folder / view + ".json") << R"({"input": "sample:glucose", "background": "transparent"})";
    const std::string common = " --size 64x48 --cache off -o ";
    test::nacreDone(folder, "render --view a.json" + common + "a.png");
    test::nacreDone(folder, "movie --views a.json,b.json --seconds 0.2 --fps 10" + common + "f/");
    EXPECT_EQ(readContents(folder / "f/frame_00001.png"), readContents(folder / "a.png"));
    EXPECT_NE(probed(folder / "a.png", "pix_fmt").find("rgba"), std::string::npos);
}

TEST(Movie, OptionsPrevailOverEachOfItsViews) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.json") << R"({"input": "sample:glucose", "occlusion": 16, "style": "licorice",
        "rules": [{"color-by": "elem O=navy"}]})";
    std::ofstream(folder / "b.json") << R"({"input": "sample:glucose", "orientation": [0.6, 0, 0.8, 0], "zoom": 2,
        "background": "navy"})";
    const std::string options =
        " --occlusion off --style spacefill --color-by 'elem O=lime' --fog auto --label 'elem C=C' --size 64x48 -o ";
    for (const char* name : {"a", "b"})
        test::nacreDone(folder, "render --view " + std::string(name) + ".json" + options + name + ".png");
    test::nacreDone(folder, "movie --views a.json,b.json --fps 4 --seconds 1" + options + "f/");
    EXPECT_EQ(readContents(folder / "f/frame_00001.png"), readContents(folder / "a.png"));
    EXPECT_EQ(readContents(folder / "f/frame_00004.png"), readContents(folder / "b.png"));
}

TEST(Movie, GoesAlongViewsOfSeveralInputs) {
    const TemporaryFolder folder;
    const std::string inputs = R"({"name": "sweet", "input": "sample:glucose", "further-inputs": [{"name": "ball",
        "input": "sample:buckyball"}], "rules": [{"hide": "/sweet and elem H"}, {"color-by": "/ball=gold"}], )";
    std::ofstream(folder / "a.json") << inputs << R"("zoom": 1})";
    std::ofstream(folder / "b.json") << inputs << R"("zoom": 3})";
    std::ofstream(folder / "c.json") << R"({"input": "sample:glucose"})";
    const std::string options = " --occlusion off --size 64x48 --show /sweet=spacefill -o ";
    for (const char* name : {"a", "b"})
        test::nacreDone(folder, "render --view " + std::string(name) + ".json" + options + name + ".png");
    const Outcome movie = test::nacreDone(folder, "movie --views a.json,b.json --fps 3 --seconds 1" + options + "f/");
    EXPECT_EQ(readContents(folder / "f/frame_00001.png"), readContents(folder / "a.png"));
    EXPECT_EQ(readContents(folder / "f/frame_00003.png"), readContents(folder / "b.png"));
    const Outcome other = nacreIn(folder, "movie --views a.json,c.json -o c/");
    EXPECT_NE(other.err.find("another molecule than the first: sample:glucose"), std::string::npos) << other.err;
}

TEST(Movie, WordsAlongViewsStandAsInEachView) {
    const TemporaryFolder folder;
    // Labels that crowd each other: where they stand goes with who came first.
    const std::string view = R"({"input": "sample:glucose", "occlusion": "off", "labels": ["all={atom} {element}"],
        "orientation": )";
    std::ofstream(folder / "a.json") << view << "[1, 0, 0, 0]}";
    std::ofstream(folder / "b.json") << view << "[0.6, 0, 0.8, 0]}";
    const std::string size = " --size 96x96 -o ";
    for (const char* name : {"a", "b"})
        test::nacreDone(folder, "render --view " + std::string(name) + ".json" + size + name + ".png");
    const std::string movie = "movie --views a.json,b.json,a.json --fps 10 --seconds 0.9" + size;
    test::nacreDone(folder, movie + "f/");
    EXPECT_EQ(readContents(folder / "f/frame_00001.png"), readContents(folder / "a.png"));
    EXPECT_EQ(readContents(folder / "f/frame_00005.png"), readContents(folder / "b.png"));
    EXPECT_EQ(readContents(folder / "f/frame_00009.png"), readContents(folder / "a.png"));
    // A palette is made of some frames beforehand: that moves no label.
    test::nacreDone(folder, movie + "a.gif");
    std::string drawn;
    for (int i = 1; i <= 9; ++i) drawn += readFrames(folder / ("f/frame_0000" + std::to_string(i) + ".png"));
    EXPECT_LE(largestDifference(readFrames(folder / "a.gif"), drawn), 60);
}

TEST(Movie, RocksToEitherSideAndBackWithoutAJump) {
    const TemporaryFolder folder;
    test::nacreDone(folder, "movie sample:glucose -o f/ --rock 40 --fps 8 --seconds 1" + kSmall);
    const auto frame = [&](int i) { return readFrames(folder / ("f/frame_0000" + std::to_string(i) + ".png")); };
    const auto rotated = [&](const char* degrees) {
        test::nacreDone(folder,
                        std::string("render sample:glucose -o a.png --rotate 0,") + degrees + ",0 --zoom 1" + kSmall);
        return readFrames(folder / "a.png");
    };
    EXPECT_EQ(frame(1), rotated("0"));
    EXPECT_EQ(frame(3), rotated("40"));
    EXPECT_EQ(frame(7), rotated("-40"));
    // The last leads on to the first as the second comes from it.
    EXPECT_LE(largestDifference(frame(8), rotated("-28.2842712474619")), 2);
    EXPECT_LE(largestDifference(frame(2), rotated("28.2842712474619")), 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "f/frame_00009.png"));
}

TEST(Movie, ReportsEachFrame) {
    const TemporaryFolder folder;
    const Outcome outcome =
        test::nacreDone(folder, "movie sample:glucose -o a.gif --spin y --seconds 0.4 --fps 10 --report -" + kSmall);
    for (const char* line : {"{\"frame\": 1, \"frames\": 4}\n", "{\"frame\": 4, \"frames\": 4}\n"})
        EXPECT_NE(outcome.out.find(line), std::string::npos) << outcome.out;
}

TEST(Movie, StopsCleanlyAndKeepsWhatIsWhole) {
    for (const char* name : {"a.gif", "a.png", "a.mp4", "f/"}) {
        const TemporaryFolder folder;
        std::string said;
        for (const char* seconds : {"0.4", "1", "4", "16", "64"}) {  // until a frame is drawn, however slow the machine
            said = captureOutput("cd '" + folder.path() + "' && timeout --foreground --preserve-status -s INT " +
                                 seconds + " '" NACRE_PROGRAM "' movie sample:dna --spin y --seconds 3000 -o " + name +
                                 kSmall + "2>&1; echo code $?");
            if (said.find(" of 90000 frames") != std::string::npos) break;
        }
        EXPECT_EQ(said.find("nacre: error: stopped: "), 0u) << said;
        EXPECT_NE(said.find(" of 90000 frames are in it\ncode 1\n"), std::string::npos) << said;
        const std::string written = name == std::string("f/") ? folder / "f/frame_00001.png" : folder / name;
        ASSERT_TRUE(std::filesystem::exists(written)) << said;
        EXPECT_GE(readFrames(written).size(), kFrameBytes) << name;
        EXPECT_EQ(folder.count(), 1u) << name << ": something is left behind";
    }
}

TEST(Movie, RefusesWhatCannotBeInOneLine) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.json") << R"({"input": "sample:glucose"})";
    std::ofstream(folder / "b.json") << R"({"input": "sample:dna"})";
    std::ofstream(folder / "unlike.xyz") << "2\nm\nC 0 0 0\nO 1.2 0 0\n3\nm\nC 0 0 0\nO 1.2 0 0\nO -1.2 0 0\n";
    std::ofstream(folder / "other.xyz") << "2\nm\nC 0 0 0\nO 1.2 0 0\n2\nm\nC 0 0 0\nN 1.2 0 0\n";
    const struct {
        const char* arguments;
        int code;
        const char* says;
    } cases[] = {
        {"sample:dna -o a.gif", 2, "no motion given"},
        {"sample:dna -o a.avi --spin y", 2, ".mp4, .webm, .gif or .png"},
        {"sample:dna -o a.gif --spin y --rock 20", 2, "exclude each other"},
        {"sample:dna -o a.gif --spin y --loop", 2, "--loop is for --views"},
        {"sample:dna -o a.gif --spin y --smooth 3", 2, "--smooth is for the frames of --trajectory"},
        {"sample:dna -o a.gif --models --whole", 2, "--whole are for the frames of --trajectory"},
        {"unlike.xyz -o a.gif --models --smooth 3", 1, "model 2 has 3 atoms, the first 2"},
        {"other.xyz -o a.gif --models --smooth 3", 1, "of model 2, atom 2 is N; of the first, atom 2 is O"},
        {"sample:dna -o a.gif --rock 20 --turns 2", 2, "--turns is for --spin"},
        {"sample:dna -o a.gif --spin y --axis x", 2, "--axis is for --rock"},
        {"sample:dna -o a.gif --rock 0", 2, "0 degrees show no motion"},
        {"sample:dna -o a.gif --spin y --turns 0", 2, "0 turns show no motion"},
        {"other.xyz -o a.gif --models --easing smooth", 2,
         "--easing is for --spin, --rock, --views, --morph, --map-sweep and --snapshot all"},
        {"sample:dna -o a.gif --spin y --easing stops", 2, "--easing stops is for --views"},
        {"sample:dna -o a.gif --spin 0,0,0", 2, "no direction"},
        {"sample:dna -o a.gif --map-sweep 1,2", 2, "--map-sweep needs --map"},
        {"sample:dna -o a.gif --map a.mrc --map-sweep 1sigma,2", 2, "two levels of the same unit"},
        {"sample:dna -o a.gif --map a.mrc --map-sweep 1", 2, "two levels"},
        {"unlike.xyz -o a.gif --models --map a.mrc --map-sweep 1,2", 2, "goes with --spin and --rock only"},
        {"sample:dna -o a.gif --spin y --seconds 80000 --fps 100", 2, "more than 100000 frames"},
        {"sample:dna -o a.gif --spin y --fps 60", 1, "50 frames per second"},
        {"sample:dna -o a.mp4 --spin y --size 65x48", 1, "even numbers of pixels only: --size 66x48"},
        {"sample:dna -o a.gif --models", 1, "only one"},
        {"sample:dna -o a.gif --morph", 1, "it has one model: name another INPUT"},
        {"sample:dna sample:buckyball -o a.gif --morph", 1, "sample:buckyball: only 4 of 486 atoms have a counterpart"},
        {"unlike.xyz -o a.gif --morph", 1, "model 2 has 3 atoms, the first 2"},
        {"unlike.xyz -o a.gif --morph --models", 2, "--models and --morph exclude each other"},
        {"sample:dna -o a.gif --morph --trajectory a.dcd", 2, "--morph goes through models or inputs"},
        {"sample:dna sample:dna -o a.gif --morph --fit /dna /dna_2", 2, "--morph superposes its inputs"},
        {"unlike.xyz other.xyz -o a.gif --models", 2, "--models is for one INPUT"},
        {"other.xyz other.xyz -o a.gif --conformations --trajectory a.dcd --models", 2, "exclude each other"},
        {"other.xyz other.xyz -o a.gif --conformations --fit /a /b --models", 2, "leave out --fit and --align"},
        {"unlike.xyz -o a.gif --models --model 2", 2, "leave out --model"},
        {"unlike.xyz -o a.gif --models --frame 2 --trajectory a.dcd", 2, "leave out --frame"},
        {"-o a.gif --views a.json,a.json --view a.json", 2, "exclude each other"},
        {"unlike.xyz -o a.gif --views a.json,a.json --models --camera model", 2, "--views move the camera"},
        {"- -o a.gif --models", 2, "not standard input"},
        {"-o a.gif --views a.json", 2, "two views or more"},
        {"unlike.xyz -o a.gif --spin y --report ./unlike.xyz", 2, "INPUT and --report are the same file"},
        {"-o a.gif --views a.json,a.json --report a.json", 2, "--report are the same file"},
        {"-o a.gif --views a.json,b.json --report b.json", 2, "--report and --views are the same file"},
        {"sample:dna -o a.gif --spin y --report a.gif", 2, "--output and --report are the same file"},
        {"-o a.gif --views a.json,b.json", 1, "another molecule"},
        {"-o a.gif --views a.json,none.json", 1, "none.json"},
        {"-o a.gif --spin y", 2, "INPUT is required"},
        {"sample:dna -o none/there/a.gif --spin y", 1, "No such file"},
    };
    for (const auto& c : cases) {
        const Outcome outcome = nacreIn(folder, std::string("movie ") + c.arguments);
        EXPECT_EQ(outcome.code, c.code) << c.arguments << outcome.err;
        EXPECT_NE(outcome.err.find(c.says), std::string::npos) << c.arguments << ": " << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_EQ(folder.count(), 4u) << "something is left behind";
    EXPECT_EQ(readContents(folder / "a.json"), R"({"input": "sample:glucose"})");
    const Outcome outcome = nacreIn(folder, "movie sample:dna -o a.mp4 --spin y", "", "PATH=/nowhere");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("Debian: ffmpeg"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace nacre::app
