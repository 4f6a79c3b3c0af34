// What outlives an activity, and what other apps hand over to it.

#include <cmath>
#include <fstream>
#include <future>
#include <sstream>

#include "tests/android_host/host_fixture.h"

namespace nacre::test {
namespace {

TEST_F(AndroidHost, BringsASample) {
    Host host(folder_);
    host.start();
    EXPECT_EQ(host.view().input.path, "sample:dna");
}

TEST_F(AndroidHost, TheStateOutlivesTheProcess) {
    std::string state;
    {
        Host host(folder_, std::nullopt, kQuick);
        host.lowMemory();
        host.open(160, 200);
        host.key(AKEYCODE_3, AKEY_EVENT_ACTION_DOWN);
        host.drag(80, 100, 80, 160);
        state = host.saveState();
        host.pause();
        host.stop();
    }
    Host restored(folder_, std::nullopt, state);
    restored.lowMemory();
    restored.open(160, 200);
    EXPECT_EQ(restored.saveState(), state);
    expectAsRendered(restored, kMenu, "", 1);
    restored.destroy();
    Host again(folder_);  // from the launcher: as it was left
    EXPECT_EQ(again.saveState(), state);
    again.destroy();
    Host damaged(folder_, std::nullopt, "{\"zoom\": \"far\"}");
    EXPECT_EQ(damaged.saveState(), state);
    EXPECT_FALSE(takeLog().empty());
}

std::string pdbOf(const char* element, double x) {
    char line[400];
    std::snprintf(line, sizeof line,
                  "HETATM    1 %2s   UNK A   1    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n"
                  "HETATM    2 %2s   UNK A   1    %8.3f%8.3f%8.3f  1.00  0.00          %2s\nEND\n",
                  element, x, 0.0, 0.0, element, element, -x, 0.0, 0.0, element);
    return line;
}

TEST_F(AndroidHost, OpensWhatOtherAppsHandOver) {
    Document document;
    document.name = "../../two atoms.pdb";
    document.bytes = pdbOf("FE", 1) + std::string(100000, '\n');
    std::string state;
    {
        Host host(folder_, document);
        host.lowMemory();
        host.open(120, 120);
        host.key(AKEYCODE_O, AKEY_EVENT_ACTION_DOWN);  // occlusion off
        ASSERT_TRUE(eventually([&] { return !host.view().input.path.empty(); }));
        expectAsRendered(host, kMenu, "", 1);
        const std::filesystem::path copy = host.view().input.path;
        EXPECT_EQ(copy.filename(), "two atoms.pdb");
        EXPECT_EQ(copy.parent_path().parent_path(), folder_ / "opened");
        state = host.saveState();
    }
    document.refuses = true;  // leave to read has gone with the activity
    Host host(folder_, document, state);
    host.lowMemory();
    host.open(120, 120);
    expectAsRendered(host, kMenu, "", 1);
    EXPECT_EQ(host.saveState(), state);
}

/// The line of the control of a name, in what a screen reader is told. Empty: there is none
std::string toldOf(Host& host, const std::string& name) {
    std::istringstream lines(host.java().controls());
    for (std::string line; std::getline(lines, line);)
        if (line.find('\t' + name + '\t') != std::string::npos) return line;
    return {};
}

TEST_F(AndroidHost, OpensWhatIsPickedThere) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(360, 480);
    ASSERT_TRUE(eventually([&] { return !toldOf(host, "Menu").empty(); }));
    EXPECT_EQ(host.java().documentsAsked(), 0);
    const auto press = [&](const char* name) {
        ASSERT_TRUE(eventually([&] { return toldOf(host, name).starts_with("button\t"); }))
            << name << " is not in " << host.java().controls();
        host.java().press("button", name);
    };
    press("Menu");
    press("Open");
    press("Open a file ...");
    ASSERT_TRUE(eventually([&] { return host.java().documentsAsked() == 1; }));
    Document document;
    document.name = "picked.pdb";
    document.bytes = pdbOf("FE", 1);
    host.java().documentPicked(document);
    ASSERT_TRUE(eventually([&] { return host.view().input.path.ends_with("picked.pdb"); }));
}

TEST_F(AndroidHost, WhatIsTypedIsInTheSharedPictureAndView) {
    Host host(folder_, std::nullopt, kQuick, 80);
    host.lowMemory();
    host.open(240, 400);
    const auto press = [&](const char* name) {
        ASSERT_TRUE(eventually([&] { return !toldOf(host, name).empty(); })) << host.java().controls();
        host.java().press(toldOf(host, name).substr(0, toldOf(host, name).find('\t')), name);
    };
    press("Menu");
    press("Labels");
    ASSERT_TRUE(eventually([&] { return host.java().controls().find("field\tTitle\t") != std::string::npos; }));
    host.java().press("field", "Title");
    ASSERT_TRUE(eventually([&] { return host.java().asked().first == "Title"; }));
    host.java().typed("Title", "Sugar \u00e9 \U0001f9ec");
    ASSERT_TRUE(eventually([&] { return host.view().words.title == "Sugar \u00e9 \U0001f9ec"; }));
    EXPECT_TRUE(eventually(
        [&] { return host.java().controls().find("field\tTitle\tSugar \u00e9 \U0001f9ec\t") != std::string::npos; }));
    host.java().typed("no such field", "nobody hears of it");
    host.key(AKEYCODE_S, AKEY_EVENT_ACTION_DOWN);
    ASSERT_TRUE(eventually([&] { return host.java().shared().width > 0; }));
    const JavaMachine::Shared shared = host.java().shared();
    EXPECT_EQ(shared.width, 240);
    EXPECT_EQ(shared.height, 400);
    EXPECT_TRUE(shared.name.ends_with(".png")) << shared.name;
    ASSERT_EQ(shared.pixels.size(), 240u * 400u);
    EXPECT_EQ(static_cast<std::uint32_t>(shared.pixels[0]), 0xffffffffu);
    const auto drawn =
        std::count_if(shared.pixels.begin(), shared.pixels.end(), [](std::int32_t p) { return p != -1; });
    EXPECT_GT(drawn, 2000);
    // The title stands over the molecule, where nothing else is drawn.
    int ink = 0;
    for (int i = 0; i < 24 * shared.width; ++i) ink += (shared.pixels[static_cast<std::size_t>(i)] & 0xff) < 128;
    EXPECT_GT(ink, 30);
    host.key(AKEYCODE_S, AKEY_EVENT_ACTION_DOWN, AMETA_SHIFT_ON);
    ASSERT_TRUE(eventually([&] { return !host.java().sharedText().first.empty(); }));
    EXPECT_NE(host.java().sharedText().first.find("Sugar \u00e9 \U0001f9ec"), std::string::npos);
    EXPECT_TRUE(host.java().sharedText().second.ends_with(".view.json"));
}

TEST_F(AndroidHost, ShowsWhatADatabaseHas) {
    Host host(folder_, std::nullopt, kQuick, 80);
    std::string entry =
        "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\nCA 0 0 0\nCB 1.5 0 0\n";
    host.java().serve("https://files.rcsb.org/download/1xyz.cif.gz", entry + std::string(5000, '\n'));
    host.lowMemory();
    host.open(240, 400);
    const auto press = [&](const char* role, const char* name) {
        const std::string line = std::string(role) + "\t" + name + "\t";
        ASSERT_TRUE(eventually([&] { return host.java().controls().find(line) != std::string::npos; }))
            << name << " is not in " << host.java().controls();
        host.java().press(role, name);
    };
    press("button", "Menu");
    press("button", "Open");
    const auto ask = [&](const char* what) {
        press("field", "ID or path");
        ASSERT_TRUE(eventually([&] { return host.java().asked().first == "ID or path"; }));
        host.java().typed("ID or path", what);
    };
    ask("pdb:1xyz");
    ASSERT_TRUE(eventually([&] { return host.view().input.path == "pdb:1xyz"; }));
    std::size_t kept = 0;
    // The system may clear it.
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder_ / "cache"))
        kept += file.path().filename() == "pdb-1xyz.cif.gz";
    EXPECT_EQ(kept, 1u) << "it is downloaded once";
    press("button", "Open");
    ask("pdb:2xyz");
    ASSERT_TRUE(eventually([&] { return !toldOf(host, "An error occurred").empty(); }));
    EXPECT_TRUE(eventually([&] { return host.java().controls().find("no such entry (404)") != std::string::npos; }));
    EXPECT_EQ(host.view().input.path, "pdb:1xyz");
}

TEST_F(AndroidHost, TellsScreenReadersWhatIsThere) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(360, 640);
    ASSERT_TRUE(eventually([&] { return !toldOf(host, "Menu").empty(); }));
    EXPECT_TRUE(toldOf(host, "sample:glucose - Nacre").starts_with("image\t")) << host.java().controls();
    EXPECT_TRUE(toldOf(host, "Menu").starts_with("button\tMenu\t\t1\t")) << host.java().controls();
    host.java().press("button", "no such control");
    host.java().press("switch", "Menu");
    sleep(0.3);
    EXPECT_FALSE(toldOf(host, "Menu").empty());
    const int before = host.java().controlChanges();
    host.java().press("button", "Menu");
    ASSERT_TRUE(eventually([&] { return !toldOf(host, "Spacefill").empty(); }));
    EXPECT_TRUE(eventually([&] { return host.java().controlChanges() > before; }));  // told once they are there
}

TEST_F(AndroidHost, MovesSlidersAndGoesByTheDisplaysOwnRate) {
    Host host(folder_, std::nullopt, kQuick, 40);  // all of the panel has room
    host.lowMemory();
    host.open(500, 320);
    const auto press = [&](const char* name) {
        ASSERT_TRUE(eventually([&] { return !toldOf(host, name).empty(); })) << host.java().controls();
        host.java().press(toldOf(host, name).substr(0, toldOf(host, name).find('\t')), name);
    };
    press("Menu");
    // A slider, as a screen reader moves it: a tenth of its way at a time.
    press("Light, outlines, fog");
    ASSERT_TRUE(eventually([&] { return !toldOf(host, "Ambient light").empty(); })) << host.java().controls();
    const double light = host.view().effects.light.ambient;
    host.java().adjust("no such slider", true);
    host.java().adjust("Ambient light", true);
    EXPECT_TRUE(eventually([&] { return std::abs(host.view().effects.light.ambient - light - 0.2) < 0.06; }))
        << light << " " << host.view().effects.light.ambient;
    sleep(0.3);  // the finger is lifted with the next frame
    press("More");
    press("For developers");
    const auto tells = [&](const char* rate) {
        return eventually([&] { return host.java().controls().find(rate) != std::string::npos; });
    };
    EXPECT_TRUE(tells("display 60 Hz")) << host.java().controls();
    host.java().displayRefreshes(120, 120);
    host.tap(490, 310);  // the panel is drawn anew
    EXPECT_TRUE(tells("display 120 Hz")) << host.java().controls();
    host.java().displayRefreshes(0, 0);
    host.tap(490, 310);
    sleep(0.3);
    EXPECT_TRUE(tells("display 120 Hz"));
}

TEST_F(AndroidHost, OpensWhatProvidersStream) {
    Document document;
    document.bytes = pdbOf("C", 1) + std::string(1500000, '\n');
    document.hasDescriptor = false;
    Host host(folder_, document);
    host.start();
    ASSERT_TRUE(eventually([&] { return !host.view().input.path.empty(); }));
    const std::filesystem::path copy = host.view().input.path;
    EXPECT_EQ(copy.filename(), "7");  // the provider keeps no names
    std::ifstream file(copy, std::ios::binary);
    EXPECT_TRUE(std::string(std::istreambuf_iterator<char>(file), {}) == document.bytes);
}

TEST_F(AndroidHost, SaysWhyADocumentCannotBeOpened) {
    Document document;
    document.refuses = true;
    Host refused(folder_, document);
    refused.open(320, 200);
    EXPECT_TRUE(eventually([&] { return !toldOf(refused, "An error occurred").empty(); }));
    EXPECT_FALSE(takeLog().empty());
    refused.destroy();
    document.refuses = false;
    document.bytes = "no molecule at all";
    Host senseless(folder_, document);
    senseless.open(320, 200);
    EXPECT_TRUE(eventually([&] { return !toldOf(senseless, "An error occurred").empty(); }));
}

TEST_F(AndroidHost, KeepsAFewOfTheOpenedFiles) {
    for (int i = 0; i < 10; ++i) {
        Document document;
        document.name = std::to_string(i) + ".pdb";
        document.bytes = pdbOf("C", 1 + i);
        Host host(folder_, document);
        host.start();
        ASSERT_TRUE(eventually([&] { return !host.view().input.path.empty(); })) << i;
    }
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_ / "opened")) ++count;
    EXPECT_EQ(count, 8u);
}

// A provider may take any time, as one that fetches from a network does. The activity does not wait for it.
TEST_F(AndroidHost, EndsAtOnceWhileADocumentIsStillComing) {
    std::promise<void> opens;
    Document document;
    document.bytes = pdbOf("C", 1);
    document.opens = opens.get_future().share();
    {
        Host host(folder_, document);
        host.open(160, 160);
        sleep(0.1);
        host.destroy();
        opens.set_value();
    }
}

TEST_F(AndroidHost, ADocumentThatIsOpenedComesToTheActivityThatIsThere) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(120, 120);
    Document document;
    document.name = "second.pdb";
    document.bytes = pdbOf("FE", 1);
    host.java().newIntent(document);
    EXPECT_TRUE(eventually([&] { return host.view().input.path.ends_with("second.pdb"); }));
}

TEST_F(AndroidHost, AnActivityThatEndsTakesTheNetworkFromNoOther) {
    Host host(folder_, std::nullopt, kQuick, 80);
    host.java().serve("https://files.rcsb.org/download/1xyz.cif.gz",
                      "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                      "_atom_site.Cartn_z\nCA 0 0 0\nCB 1.5 0 0\n");
    host.lowMemory();
    host.open(240, 400);
    { Host other(folder_, std::nullopt, kQuick); }
    const auto press = [&](const char* role, const char* name) {
        const std::string line = std::string(role) + "\t" + name + "\t";
        ASSERT_TRUE(eventually([&] { return host.java().controls().find(line) != std::string::npos; })) << name;
        host.java().press(role, name);
    };
    press("button", "Menu");
    press("button", "Open");
    press("field", "ID or path");
    ASSERT_TRUE(eventually([&] { return host.java().asked().first == "ID or path"; }));
    host.java().typed("ID or path", "pdb:1xyz");
    EXPECT_TRUE(eventually([&] { return host.view().input.path == "pdb:1xyz"; }));
}

TEST_F(AndroidHost, WithoutADeviceTheActivityEnds) {
    setVulkanBroken(true);
    {
        Host host(folder_, std::nullopt, kQuick);
        host.open(160, 160);
        EXPECT_TRUE(eventually([&] { return host.finishAsked(); }));
        EXPECT_FALSE(takeLog().empty());
        host.tap(80, 80);
        // Before the first step, too, the view to keep is the one that was to be shown.
        const std::string state = host.saveState();
        EXPECT_NE(state.find("\"input\": \"sample:glucose\""), std::string::npos) << state;
    }
    setVulkanBroken(false);
}

}  // namespace
}  // namespace nacre::test
