// `nacre view` as a user has it: a real window, a real window manager, a real mouse; lavapipe draws.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <random>

#include "tests/desktop/x_session.h"
#include "tests/support/run_program.h"
#include "tests/support/structure_server.h"
#include "tests/support/test_data.h"

namespace nacre::test {
namespace {

struct Image {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;
    std::vector<std::string> names;
    float at(int x, int y, const std::string& channel) const {
        const auto c = std::find(names.begin(), names.end(), channel) - names.begin();
        return values[static_cast<std::size_t>((y * width + x) * channels + c)];
    }
};

Image readImage(const std::string& path) {
    Image image;
    const auto in = OIIO::ImageInput::open(path);
    if (!in) throw std::runtime_error("no image " + path);
    image.width = in->spec().width;
    image.height = in->spec().height;
    image.channels = in->spec().nchannels;
    image.names = in->spec().channelnames;
    image.values.resize(static_cast<std::size_t>(image.width) * image.height * image.channels);
    in->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.values.data());
    return image;
}

/// Hides the panel and saves the view. @returns the JSON's path
std::string saveView(XSession& session) {
    session.typeAtOnce({"S", "Return"});  // under the name that the dialog suggests
    std::string saved;
    EXPECT_TRUE(session.waitUntil([&] {
        for (const auto& entry : std::filesystem::directory_iterator(session.folder().path()))
            if (entry.path().string().ends_with(".view.json")) saved = entry.path().string();
        return !saved.empty();
    })) << "no view was saved: "
        << session.errors();
    session.type("Escape");  // takes the message away
    session.moveTo(1, 1);    // and this the name of what the pointer is over
    session.settle();
    return saved;
}

std::string formatSize(const WindowPicture& p) { return std::to_string(p.width) + "x" + std::to_string(p.height); }

struct Difference {
    int differing = 0, largest = 0, coloured = 0;
    double mean = 0;
    /// The window's samples are frames of views that are shifted, whose rays are rounded otherwise: one in some
    /// thousand that meet an outline falls on its other side.
    bool small() const { return differing <= coloured / 200 && mean < 1; }
};

Difference measureDifference(const WindowPicture& shown, const Image& image) {
    Difference d;
    if (image.width != shown.width || image.height != shown.height) return {1 << 30, 255, 0, 255};
    for (std::size_t i = 0; i < shown.rgb.size(); ++i) {
        const int step = std::abs(static_cast<int>(std::lround(image.values[i] * 255)) - shown.rgb[i]);
        // The window's samples are coded by the device, a picture's by a polynomial within 0.09 of a step: samples may
        // be a step apart, and their mean is rounded once more.
        d.differing += step > 2;
        d.largest = std::max(d.largest, step);
        d.coloured += shown.rgb[i] < 250;
        d.mean += step / static_cast<double>(shown.rgb.size());
    }
    return d;
}

/// Renders what the window shows, without the window, and compares. The window's refinement takes 2 x 2 samples.
void expectAsRendered(XSession& session, const std::string& view) {
    const std::string size = formatSize(session.picture());
    nacreDone(session.folder(), "render --view '" + view + "' -o render.png --supersample 2 --size " + size);
    const Image image = readImage(session.folder() / "render.png");
    Difference d;
    // On a busy machine the refinement may be late; what counts is the picture that stays.
    for (int i = 0; i < 20; ++i) {
        d = measureDifference(session.picture(), image);
        if (d.small()) break;
        session.sleep(0.5);
    }
    EXPECT_GT(d.coloured, 5000);
    EXPECT_TRUE(d.small()) << d.differing << " of " << d.coloured << ", at most by " << d.largest << ", on average by "
                           << d.mean;
}

nlohmann::json readJson(const std::string& path) { return nlohmann::json::parse(readContents(path)); }

TEST(Window, ShowsAndSavesWhatRenderDrawsAndThenRests) {
    XSession session("sample:dna ball=sample:buckyball --size 300x360");
    EXPECT_EQ(session.title(), "sample:dna + sample:buckyball - Nacre");
    session.type("m");
    const std::string view = saveView(session);
    // Both molecules are in it, and the colours that keep them apart.
    const nlohmann::json saved = readJson(view);
    EXPECT_EQ(saved["further-inputs"][0]["name"], "ball");
    EXPECT_EQ(saved["rules"].size(), 1u);
    expectAsRendered(session, view);
    session.type("i");
    EXPECT_TRUE(session.waitUntil([&] { return std::filesystem::exists(session.folder() / "dna.png"); }));
    const Image image = readImage(session.folder() / "dna.png");
    EXPECT_EQ(image.width, 300);
    EXPECT_EQ(image.height, 360);
    session.type("Escape");
    session.sleep(1.5);
    EXPECT_EQ(session.quit(), 0) << session.errors();
    EXPECT_GE(session.stats()["seconds_since_last_frame"].get<double>(), 0.5);  // the last may have come late
    EXPECT_EQ(session.stats()["occlusion"], 1.0);
    const nlohmann::json start = session.stats()["start_ms"];
    EXPECT_GT(start["before_device"].get<double>(), 0);
    EXPECT_GT(start["first_picture"].get<double>(),
              start["before_device"].get<double>() + start["device"].get<double>());
    EXPECT_GT(readContents(session.folder() / "cache/nacre/pipelines.bin").size(), 40u);
}

TEST(Window, AsksBeforeItDownloadsWhatAViewNames) {
    const StructureServer server;
    server.serve("1xyz.cif.gz",
                 "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                 "_atom_site.Cartn_z\nCA 0 0 0\nCB 1.5 0 0\n");
    const TemporaryFolder folder;
    std::ofstream(folder / "sent.json") << R"({"input": "pdb:1xyz", "style": "licorice"})";
    setenv("NACRE_PDB_URL", server.base("ok").c_str(), 1);
    XSession session("--view '" + (folder / "sent.json") + "' --size 600x400");
    unsetenv("NACRE_PDB_URL");
    EXPECT_EQ(session.title(), "question - Nacre");
    EXPECT_EQ(server.requests().size(), 0u);
    const WindowPicture question = session.picture();
    session.click(325, 237);  // Cancel
    EXPECT_TRUE(session.waitUntil([&] { return session.picture() != question; }));
    EXPECT_EQ(server.requests().size(), 0u);
    EXPECT_EQ(session.quit(), 0) << session.errors();

    setenv("NACRE_PDB_URL", server.base("ok").c_str(), 1);
    XSession again("--view '" + (folder / "sent.json") + "' --size 600x400");
    unsetenv("NACRE_PDB_URL");
    again.click(414, 237);  // Download
    EXPECT_TRUE(again.waitForTitle("1xyz")) << again.title();
    EXPECT_GT(server.requests().size(), 0u);
    EXPECT_EQ(again.quit(), 0) << again.errors();
}

TEST(Window, KeepsOcclusionForTheNextTime) {
    const std::string molecule = "sample:dna --size 300x300 --occlusion 256 --occlusion-memory 2";
    TemporaryFolder cache;
    std::vector<nlohmann::json> stats;
    for (int i = 0; i < 2; ++i) {
        XSession session(molecule + " --cache '" + (cache / "kept") + "'");
        session.settle();
        EXPECT_EQ(session.quit(), 0) << session.errors();
        EXPECT_EQ(session.stats()["occlusion"], 1.0);
        EXPECT_LE(session.stats()["occlusion_bytes"].get<int>(), 2 << 20);
        stats.push_back(session.stats());
    }
    EXPECT_FALSE(stats[0]["occlusion_cached"].get<bool>());
    EXPECT_TRUE(stats[1]["occlusion_cached"].get<bool>());
}

TEST(Window, DragRotatesWheelZooms) {
    XSession session("sample:dna --size 300x360 --rotate 0,0,0");
    session.type("m");
    session.drag(100, 180, 150, 180);
    session.settle();
    session.wheel(210, 120, 3);
    session.settle();
    const std::string path = saveView(session);
    const nlohmann::json view = readJson(path);
    const auto q = view["orientation"];
    const double half = 25 * M_PI / 180;  // 50 points are 50 degrees about +y
    EXPECT_NEAR(q[0].get<double>(), std::cos(half), 1e-6);
    EXPECT_NEAR(q[1].get<double>(), 0, 1e-9);
    EXPECT_NEAR(q[2].get<double>(), std::sin(half), 1e-6);
    EXPECT_NEAR(q[3].get<double>(), 0, 1e-9);
    EXPECT_EQ(view["zoom"], 1.0);                // its scale holds it
    EXPECT_LT(view["pan"][0].get<double>(), 0);  // what was under the pointer stayed there
    EXPECT_LT(view["pan"][1].get<double>(), 0);
    expectAsRendered(session, path);
    EXPECT_EQ(session.quit(), 0) << session.errors();
    EXPECT_GT(session.stats()["input_to_present"]["median"].get<double>(), 0);
}

TEST(Window, ClickPicksTheAtomThatIsSeen) {
    for (const char* style : {"spacefill", "ball-and-stick --projection perspective"}) {
        XSession session(std::string("sample:dna --size 260x300 --rotate 20,30,0 --style ") + style);
        session.type("m");
        const std::string view = saveView(session);
        nacreDone(session.folder(), "render --view '" + view + "' -o r.png --layers l.exr --occlusion 1 --size " +
                                        formatSize(session.picture()));
        const Image layers = readImage(session.folder() / "l.exr");
        std::vector<int> expected;
        for (int i = 0; i < 3; ++i) session.type("u");  // measures torsions: four atoms
        std::mt19937 random(7);
        int lastX = 0, lastY = 0;
        while (expected.size() < 4) {
            const int x = static_cast<int>(random() % 260), y = static_cast<int>(random() % 300);
            const int id = static_cast<int>(layers.at(x, y, "id.Y"));
            if (id == 0 || std::find(expected.begin(), expected.end(), id) != expected.end()) continue;
            if (!expected.empty() && std::hypot(x - lastX, y - lastY) < 10) continue;  // that is a double click
            lastX = x, lastY = y;
            session.click(x, y);
            expected.push_back(id);
        }
        EXPECT_EQ(session.quit(), 0) << session.errors();
        EXPECT_EQ(session.stats()["picked"].get<std::vector<int>>(), expected) << style;
    }
}

TEST(Window, QuittingAsksWhereWorkIsLost) {
    XSession session("sample:dna --size 700x500");
    session.type("m");
    session.type("d");  // a keyframe that no movie is made of
    session.settle();
    const WindowPicture before = session.picture();
    session.typeAtOnce({"Control_L+q"});
    EXPECT_TRUE(session.waitUntil([&] { return session.picture() != before; }));
    session.type("Escape");
    session.settle();
    session.typeAtOnce({"Control_L+q"});
    session.settle();
    EXPECT_EQ(session.quit(), 0) << "who asks once more means it: " << session.errors();
}

TEST(Window, ADroppedFileIsShownAndABadOneIsToldOf) {
    XSession session("sample:glucose --size 300x300");
    session.type("m");
    {
        std::ofstream out(session.folder() / "two words.xyz");
        out << "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n";
        std::ofstream bad(session.folder() / "bad.pdb");
        bad << "HEADER nothing\n";
    }
    ASSERT_TRUE(session.drop({session.folder() / "two%20words.xyz"}));
    session.settle();
    session.type("Return");  // it replaces what is open
    EXPECT_TRUE(session.waitForTitle("two words.xyz")) << session.title();
    session.settle();
    // A view that is saved beside its molecule goes where both go, to whoever has neither its folder nor its name.
    const std::string saved = saveView(session);
    EXPECT_EQ(nlohmann::json::parse(readContents(saved))["input"], "two words.xyz");
    const TemporaryFolder elsewhere;
    std::filesystem::copy(saved, elsewhere / "v.json");
    std::filesystem::copy(session.folder() / "two words.xyz", elsewhere / "renamed.xyz");
    for (const std::string& view : {elsewhere / "v.json", saved}) {
        nacreDone(elsewhere, "render --view '" + view + "' -o " + (view == saved ? "r" : "v") +
                                 ".png --size 40x40 --occlusion off");
    }
    EXPECT_TRUE(readContents(elsewhere / "v.png") == readContents(elsewhere / "r.png"));
    session.sleep(4.3);  // until the message of the saved view is gone
    session.settle();
    const WindowPicture before = session.picture();
    ASSERT_TRUE(session.drop({session.folder() / "bad.pdb"}));
    session.settle();
    session.type("Return");
    // What went wrong stands over the picture until it is read.
    EXPECT_TRUE(session.waitUntil([&] { return session.picture() != before; }));
    session.sleep(4.3);
    EXPECT_NE(session.picture(), before);
    session.type("Escape");
    session.moveTo(5, 5);  // the pointer of the drop hovers over an atom
    EXPECT_TRUE(session.waitUntil([&] { return session.picture() == before; }));
    EXPECT_TRUE(session.waitForTitle("two words.xyz"));
    // Several stand together.
    std::ofstream(session.folder() / "salt.xyz") << "2\nsalt\nNa 5 0 0\nCl 5 2.8 0\n";
    ASSERT_TRUE(session.drop({session.folder() / "salt.xyz", session.folder() / "two%20words.xyz"}));
    session.settle();
    session.type("Return");
    EXPECT_TRUE(session.waitForTitle("salt.xyz + two words.xyz")) << session.title();
    EXPECT_EQ(session.quit(), 0) << session.errors();
    // The next window without INPUT goes on there.
    EXPECT_NE(readContents(session.folder() / "state/nacre/view.json").find("two words.xyz"), std::string::npos);
}

TEST(Window, ASavedViewOpensFromTheCommandLineAndByADrop) {
    const TemporaryFolder folder;
    std::ofstream(folder / "salt.xyz") << "2\nsalt\nNa 5 0 0\nCl 5 2.8 0\n";
    std::string view;
    {
        XSession session((folder / "salt.xyz") + " --size 300x300 --zoom 0.7 --style ball-and-stick");
        session.type("m");
        view = saveView(session);
        std::filesystem::copy(view, folder / "v.view.json");
        EXPECT_EQ(session.quit(), 0) << session.errors();
    }
    view = folder / "v.view.json";
    {
        XSession session("'" + view + "' --size 300x300");
        EXPECT_EQ(session.title(), "salt.xyz - Nacre");
        session.type("m");
        expectAsRendered(session, view);
        EXPECT_EQ(session.quit(), 0) << session.errors();
    }
    XSession session("sample:dna --size 300x300");
    session.type("m");
    ASSERT_TRUE(session.drop({view}));
    EXPECT_TRUE(session.waitForTitle("salt.xyz")) << session.title();
    expectAsRendered(session, view);
    EXPECT_EQ(session.quit(), 0) << session.errors();
    EXPECT_NE(readContents(session.folder() / "state/nacre/recent.json").find("v.view.json"), std::string::npos);
}

TEST(Window, AnEntryThatCannotBeDownloadedIsAnErrorInTheWindow) {
    XSession session("pdb:4hhb --offline --size 400x400");
    EXPECT_EQ(session.title(), "not opened - Nacre");
    EXPECT_EQ(session.quit(), 0) << session.errors();
}

TEST(Window, ALogOutKeepsWhatClosingKeeps) {
    const TemporaryFolder folder;
    std::ofstream(folder / "salt.xyz") << "2\nsalt\nNa 5 0 0\nCl 5 2.8 0\n";
    for (const int signal : {SIGTERM, SIGINT}) {
        XSession session((folder / "salt.xyz") + " --size 300x200");
        EXPECT_EQ(session.end(signal), signal) << session.errors();
        for (const char* kept : {"view.json", "recent.json"})
            EXPECT_NE(readContents(session.folder() / (std::string("state/nacre/") + kept)).find("salt.xyz"),
                      std::string::npos)
                << kept;
    }
}

TEST(Window, BeginsAsItWasLeft) {
    const nlohmann::json left{{"theme", "dark"}, {"text_percent", 150}, {"dark_background", true}};
    XSession session("sample:dna --size 700x600", left.dump());
    const WindowPicture picture = session.picture();
    const std::size_t corner = 3 * (static_cast<std::size_t>(picture.width) * 20 + 40);  // of the panel
    EXPECT_LT(picture.rgb[corner] + picture.rgb[corner + 1] + picture.rgb[corner + 2], 3 * 60);
    EXPECT_EQ(session.quit(), 0) << session.errors();
    const nlohmann::json then = readJson(session.folder() / "state/nacre/window.json");
    for (const auto& [key, value] : left.items()) EXPECT_EQ(then.value(key, nlohmann::json()), value) << key;
}

TEST(Window, WhatCannotBeReadIsAnErrorBeforeThereIsAWindow) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreIn(folder, "view nofile.pdb", "", "export DISPLAY=" + XSession::display());
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("nofile.pdb: No such file or directory"), std::string::npos) << outcome.err;
}

TEST(Window, SurvivesResizesAndMinimising) {
    XSession session("sample:glucose --size 500x400");
    session.type("m");
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        session.resize(120 + static_cast<int>(random() % 700), 120 + static_cast<int>(random() % 600));
        session.sleep(random() % 4 == 0 ? 0.03 : 0.002);
        if (i % 40 == 20) session.type("space");
    }
    session.type("Escape");
    session.click(3, 3);  // stops whatever turns
    session.iconify();
    EXPECT_TRUE(session.waitUntil([&] { return session.picture().width == 0; }));
    session.restore();
    EXPECT_TRUE(session.waitUntil([&] { return session.picture().width != 0; }));
    session.resize(520, 430);
    session.settle();
    EXPECT_EQ(session.picture().width, 520);
    const std::string view = saveView(session);
    expectAsRendered(session, view);
    EXPECT_EQ(session.quit(), 0) << session.errors();
}

}  // namespace
}  // namespace nacre::test
