// What outlives an activity, and what other apps hand over to it.

#include <fstream>
#include <future>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/android_host/host_fixture.h"

namespace nacre::test {
namespace {

/// The last digits of a rotation may differ.
void expectSameState(const std::string& one, const std::string& other) {
    auto a = nlohmann::json::parse(one), b = nlohmann::json::parse(other);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(a.at("orientation").at(i).get<double>(), b.at("orientation").at(i).get<double>(), 1e-12);
    a.erase("orientation"), b.erase("orientation");
    // A camera that an earlier style framed is stated by its scale, and once restored by its zoom: pictures judge it.
    if (a.contains("scale") != b.contains("scale"))
        for (auto* state : {&a, &b}) state->erase("scale"), state->erase("zoom");
    EXPECT_EQ(a, b);
}

TEST_F(AndroidHost, TheStateOutlivesTheProcess) {
    std::string state;
    {
        Host host(folder_, std::nullopt, kQuick);
        host.lowMemory();
        host.open(160, 200);
        const std::string before = host.saveState();
        host.key(AKEYCODE_3, AKEY_EVENT_ACTION_DOWN);
        ASSERT_TRUE(eventually([&] { return host.saveState() != before; }));
        expectAsRendered(host, kMenu, "before the drag", 1);
        host.drag(80, 100, 80, 160);
        state = host.saveState();
        host.pause();
        host.stop();
    }
    Host restored(folder_, std::nullopt, state);
    restored.lowMemory();
    restored.open(160, 200);
    expectSameState(restored.saveState(), state);
    expectAsRendered(restored, kMenu, "", 1);
    const WindowPicture shown = restored.picture();
    const WindowPicture saved = expectedPicture(app::parseSavedView(state, "state"), shown.width, shown.height, 1);
    EXPECT_TRUE(measureDifference(shown, saved, kMenu).small());
    restored.destroy();
    Host again(folder_);  // from the launcher: as it was left
    expectSameState(again.saveState(), state);
    again.destroy();
    Host damaged(folder_, std::nullopt, "{\"zoom\": \"far\"}");
    expectSameState(damaged.saveState(), state);
    EXPECT_FALSE(takeLog().empty());
}

std::string makePdb(const char* element, double x) {
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
    document.bytes = makePdb("FE", 1) + std::string(100000, '\n');
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
std::string findLine(Host& host, const std::string& name) {
    std::istringstream lines(host.java().controls());
    for (std::string line; std::getline(lines, line);)
        if (line.find('\t' + name + '\t') != std::string::npos) return line;
    return {};
}

TEST_F(AndroidHost, TellsScreenReadersWhatIsThere) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(360, 640);
    ASSERT_TRUE(eventually([&] { return !findLine(host, "Menu").empty(); }));
    EXPECT_TRUE(findLine(host, "sample:glucose - Nacre").starts_with("image\t")) << host.java().controls();
    EXPECT_TRUE(findLine(host, "Menu").starts_with("button\tMenu\t\t1\t")) << host.java().controls();
    host.java().press("button", "no such control");
    host.java().press("switch", "Menu");
    sleep(0.3);
    EXPECT_FALSE(findLine(host, "Menu").empty());
    const int before = host.java().controlChanges();
    host.java().press("button", "Menu");
    ASSERT_TRUE(eventually([&] { return !findLine(host, "Spacefill").empty(); }));
    EXPECT_TRUE(eventually([&] { return host.java().controlChanges() > before; }));  // told once they are there
}

TEST_F(AndroidHost, OpensWhatProvidersStream) {
    Document document;
    document.bytes = makePdb("C", 1) + std::string(1500000, '\n');
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
    EXPECT_TRUE(eventually([&] { return !findLine(refused, "Close").empty(); }));
    EXPECT_FALSE(takeLog().empty());
    refused.destroy();
    document.refuses = false;
    document.bytes = "no molecule at all";
    Host senseless(folder_, document);
    senseless.open(320, 200);
    EXPECT_TRUE(eventually([&] { return !findLine(senseless, "Cannot read molecule").empty(); }));
}

// A provider may take any time, as one that fetches from a network does. The activity does not wait for it.
TEST_F(AndroidHost, EndsAtOnceWhileADocumentIsStillComing) {
    std::promise<void> opens;
    Document document;
    document.bytes = makePdb("C", 1);
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
    document.bytes = makePdb("FE", 1);
    host.java().newIntent(document);
    EXPECT_TRUE(eventually([&] { return host.view().input.path.ends_with("second.pdb"); }));
}

TEST_F(AndroidHost, ADocumentThatAnotherAppSharesIsOpened) {
    Document document;
    document.sent = true;
    document.name = "shared.pdb";
    document.bytes = makePdb("FE", 1);
    Host host(folder_, document);
    host.lowMemory();
    host.open(120, 120);
    EXPECT_TRUE(eventually([&] { return host.view().input.path.ends_with("shared.pdb"); }));
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

TEST_F(AndroidHost, WithoutADeviceTheUserIsToldWhy) {
    setVulkanBroken(true);
    {
        Host host(folder_, std::nullopt, kQuick);
        host.open(160, 160);
        EXPECT_TRUE(eventually([&] { return !host.java().gaveUp().empty(); }));
        EXPECT_NE(host.java().gaveUp().find("Vulkan"), std::string::npos) << host.java().gaveUp();
        EXPECT_FALSE(host.finishAsked()) << "the dialog's answer ends the activity";
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
