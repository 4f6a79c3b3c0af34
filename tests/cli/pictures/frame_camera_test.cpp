// One camera for the frames of a trajectory.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/input/input_files.h"
#include "tests/support/run_program.h"

namespace nacre::test {
namespace {

void addRecord(std::string& file, const void* data, std::size_t bytes) {
    const auto length = static_cast<std::int32_t>(bytes);
    file.append(reinterpret_cast<const char*>(&length), 4);
    file.append(static_cast<const char*>(data), bytes);
    file.append(reinterpret_cast<const char*>(&length), 4);
}

/// A DCD file, as CHARMM writes it, of four atoms. @param place  of an atom along an axis, by the frame from 0
template <typename Place>
std::string framesFile(int frames, const Place& place) {
    std::string file;
    std::int32_t head[21] = {};
    std::memcpy(head, "CORD", 4);
    head[1] = frames;
    head[2] = head[3] = 1;
    head[20] = 24;
    addRecord(file, head, sizeof head);
    std::string title(84, ' ');
    const std::int32_t lines = 1, atoms = 4;
    std::memcpy(title.data(), &lines, 4);
    addRecord(file, title.data(), title.size());
    addRecord(file, &atoms, 4);
    for (int f = 0; f < frames; ++f)
        for (int axis = 0; axis < 3; ++axis) {
            float values[4];
            for (int i = 0; i < 4; ++i) values[i] = static_cast<float>(place(f, i, axis));
            addRecord(file, values, sizeof values);
        }
    return file;
}

/// Four atoms in a row that drift apart and away.
std::string drifting(int frames) {
    return framesFile(frames, [](int f, int i, int axis) {
        return axis == 0 ? (1.5 + 0.5 * f) * i : axis == 1 ? 2.0 * f : 0.3 * i;
    });
}

nlohmann::json renderView(const TemporaryFolder& folder, const std::string& options) {
    nacreDone(folder,
              "render a.xyz --trajectory t.dcd -o a.png --stats s.json --size 64x64 "
              "--occlusion off " +
                  options);
    return nlohmann::json::parse(readContents(folder / "s.json"))["view"];
}

TEST(FrameCamera, IsThatOfTheFirstFrameUnlessEachIsToHaveItsOwn) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.xyz") << "4\nnames\nC 9 9 9\nC 9 9 8\nC 9 9 7\nC 9 9 6\n";
    std::ofstream(folder / "t.dcd", std::ios::binary) << drifting(5);
    for (const char* lens : {"", " --projection perspective"}) {
        const nlohmann::json first = renderView(folder, lens),
                             fifth = renderView(folder, std::string("--frame 5") + lens);
        EXPECT_NEAR(first["center"][0].get<double>(), 2.25, 1e-6);
        EXPECT_EQ(fifth["center"], first["center"]) << lens;
        EXPECT_EQ(fifth["pixels_per_angstrom"], first["pixels_per_angstrom"]) << lens;
        EXPECT_GT(fifth["radius"].get<double>(), 10) << "all atoms are seen, however far they went";
    }
    const nlohmann::json own = renderView(folder, "--frame 5 --camera model");
    EXPECT_NEAR(own["center"][0].get<double>(), 5.25, 1e-6);
    EXPECT_NEAR(own["center"][1].get<double>(), 8, 1e-6);
}

/// The least depth of an atom in a file of layers, Å.
float readNearest(const std::string& path, float atom) {
    const auto input = OIIO::ImageInput::open(path);
    const OIIO::ImageSpec& spec = input->spec();
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> pixels(spec.image_pixels() * channels);
    EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
    const auto z = static_cast<std::size_t>(spec.channelindex("Z")),
               id = static_cast<std::size_t>(spec.channelindex("id.Y"));
    float nearest = INFINITY;
    for (std::size_t i = 0; i < pixels.size(); i += channels)
        if (pixels[i + id] == atom) nearest = std::min(nearest, pixels[i + z]);
    return nearest;
}

TEST(FrameCamera, DepthsOfAllFramesCountFromOnePlane) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.xyz") << "4\nnames\nC 9 9 9\nC 9 9 8\nC 9 9 7\nC 9 9 6\n";
    std::ofstream(folder / "t.dcd", std::ios::binary) << drifting(5);
    for (const char* lens : {"", " --projection perspective"}) {
        std::vector<float> depths;
        for (const char* frame : {"1", "3", "5"}) {
            renderView(folder, std::string("--zoom 0.3 --layers l.exr --frame ") + frame + lens);
            depths.push_back(readNearest(folder / "l.exr", 4));
        }
        // They drift across the view, whose plane is that of the file's z.
        EXPECT_NEAR(depths[1], depths[0], 0.1) << lens;
        EXPECT_NEAR(depths[2], depths[0], 0.1) << lens;
    }
}

// A view and its trajectory that were moved together, or sent to someone: found by what it holds, told of if it is
// elsewhere.
TEST(SavedTrajectory, IsFoundBesideItsViewByItsHash) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "sent");
    const auto put = [&](const char* name, const std::string& content) {
        std::ofstream(folder / name, std::ios::binary) << content;
    };
    put("sent/a.xyz", "4\nnames\nC 9 9 9\nC 9 9 8\nC 9 9 7\nC 9 9 6\n");
    put("sent/t.dcd", drifting(3));
    put("sent/as-long.dcd", drifting(3).replace(300, 1, "x"));
    const std::string hash = app::trajectoryHash(folder / "sent/t.dcd");
    const auto view = [&](const std::string& trajectory, const std::string& more) {
        put("sent/v.json", "{\"input\": \"a.xyz\", \"trajectory\": \"" + trajectory + "\", \"frame\": 2" + more + "}");
    };
    const std::string small = " -o a.png --size 16x16 --occlusion off ";
    const auto drawn = [&](const std::string& said) {
        const Outcome outcome = nacreIn(folder, "render --view sent/v.json" + small);
        if (said.empty())
            EXPECT_EQ(outcome.err, "");
        else
            EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), said.empty() ? 0 : 1) << outcome.err;
        return outcome.code == 0 ? readContents(folder / "a.png") : "";
    };
    nacreDone(folder, "render sent/a.xyz --trajectory sent/t.dcd --frame 2" + small);
    const std::string picture = readContents(folder / "a.png"), stated = ", \"trajectory-hash\": \"" + hash + "\"";
    view("t.dcd", "");
    EXPECT_EQ(drawn(""), picture);
    view("/nowhere/at/all/t.dcd", stated);
    EXPECT_EQ(drawn(""), picture);
    view("gone/by-another-name.dcd", stated);
    EXPECT_EQ(drawn(""), picture);
    view("as-long.dcd", stated);
    drawn("as-long.dcd has changed since sent/v.json was saved");
    view("gone/as-long.dcd", ", \"trajectory-hash\": \"" + hash + "0\"");
    EXPECT_EQ(drawn("gone/as-long.dcd"), "") << "the name alone is not enough";
    put("t.dcd", drifting(3));
    view("../t.dcd", "");
    EXPECT_EQ(drawn("sent/v.json has this file opened, which is not in its folder: "), picture);
    // Of a long one, both ends.
    put("long.dcd", std::string(40u << 20, 'a'));
    const std::string before = app::trajectoryHash(folder / "long.dcd");
    std::fstream file(folder / "long.dcd", std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(-1, std::ios::end);
    file << 'b';
    file.close();
    EXPECT_NE(app::trajectoryHash(folder / "long.dcd"), before);
    EXPECT_EQ(before.substr(0, 9), "41943040-");
}

std::string renderPicture(const TemporaryFolder& folder, const std::string& options) {
    nacreDone(folder,
              "render a.xyz --trajectory t.dcd -o p.png -q --size 96x96 --style spacefill "
              "--occlusion off " +
                  options);
    return readContents(folder / "p.png");
}

TEST(Frames, StillsAreFittedToTheFirst) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.xyz") << "4\nnames\nC 9 9 9\nO 9 9 8\nN 9 9 7\nS 9 9 6\n";
    // A quarter turn about z and a shift per frame.
    constexpr double kPlaces[4][3] = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {1, 1, 2}};
    std::ofstream(folder / "t.dcd", std::ios::binary) << framesFile(4, [&](int f, int i, int axis) {
        const double x = kPlaces[i][0], y = kPlaces[i][1];
        const double turned[4][2] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
        return axis == 2 ? kPlaces[i][2] : turned[f][axis] + 2 * f;
    });
    const std::string first = renderPicture(folder, "--frame 1");
    EXPECT_FALSE(renderPicture(folder, "--frame 3") == first);
    EXPECT_FALSE(renderPicture(folder, "--frame 2 --fit-frames 'elem C+O+N'") == renderPicture(folder, "--frame 2"));
    for (const char* frame : {"2", "3", "4"}) {
        const nlohmann::json view = renderView(folder, std::string("--fit-frames all --frame ") + frame);
        EXPECT_NEAR(view["center"][0].get<double>(), 2, 1e-4) << frame;
        // Positions agree up to the rounding of floats: so do nearly all pixels.
        renderPicture(folder, std::string("--fit-frames all --frame ") + frame);
        std::vector<unsigned char> a(96 * 96 * 3), b = a;
        std::ofstream(folder / "first.png", std::ios::binary) << first;
        OIIO::ImageInput::open(folder / "first.png")->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, a.data());
        OIIO::ImageInput::open(folder / "p.png")->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, b.data());
        std::size_t differ = 0;
        for (std::size_t i = 0; i < a.size(); ++i) differ += std::abs(a[i] - b[i]) > 8;
        EXPECT_LT(differ, a.size() / 100) << frame;
    }
}

TEST(Frames, TitlesNameThem) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.xyz") << "4\nnames\nC 9 9 9\nC 9 9 8\nC 9 9 7\nC 9 9 6\n";
    std::ofstream(folder / "t.dcd", std::ios::binary) << drifting(5);
    const std::string third = renderPicture(folder, "--frame 3 --title 'frame 3 of five'");
    EXPECT_TRUE(renderPicture(folder, "--frame 3 --title 'frame {frame} of five'") == third);
    EXPECT_FALSE(renderPicture(folder, "--frame 3 --title 'frame {time} of five'") == third);
}

}  // namespace
}  // namespace nacre::test
