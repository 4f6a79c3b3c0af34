// Files that a window opens: structures, saved views, looks, maps and trajectories.

#include <gtest/gtest.h>

#include <fstream>
#include <glm/geometric.hpp>

#include "app/input/read_input.h"
#include "app/picture/options.h"
#include "app/viewer/file_kind.h"
#include "tests/molecule/build_peptide.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/viewer_bench.h"

namespace nacre::app::test {
namespace {

using nacre::test::TemporaryFolder;

/// Samples; "protein" and "other" are peptides; "late" cannot be read at first.
struct Files {
    TemporaryFolder folder;
    CountingScreen screen;
    bool late = true;
    std::vector<PictureDescription> read;
    Viewer viewer;
    double now = 100;

    explicit Files(const char* input = "") : viewer(screen, sources(), Bench::makeView(input), staying()) {
        viewer.frames().resize({640, 480}, 1, now);
        load();
    }
    static ViewerOptions staying() {
        ViewerOptions options;
        options.errorsStay = true;
        return options;
    }
    Sources sources() {
        Sources all;
        all.read = [this](const PictureDescription& v) {
            read.push_back(v);
            const auto one = [this](const std::string& path) {
                if (path == "protein" || path == "other") return nacre::test::buildChain(30, -57, -47);
                if (path.ends_with(".dx")) return Molecule();
                if (path == "late" && std::exchange(late, false)) throw Error("cannot download", path, "no network");
                return sampleMolecule(path.starts_with("sample:") ? path.substr(7) : "glucose");
            };
            if (v.input.further.empty()) return one(v.input.path);
            std::vector<Molecule> molecules{one(v.input.path)};
            for (const FurtherInput& further : v.input.further) molecules.push_back(one(further.path));
            return joinInputs(makeInput(v), std::move(molecules), [](const std::string&) {});
        };
        return all;
    }
    void load() {
        for (int i = 0; i < 3; ++i) {
            viewer.reading().loader().wait();
            viewer.update(now += 1.0 / 60);
        }
    }
    void open(const std::vector<std::string>& paths, bool beside = false) {
        viewer.open(paths, beside, now);
        load();
    }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
        return folder / name;
    }
    std::string shown() const { return viewer.document() ? viewer.document()->view.input.path : ""; }
};

TEST(Opening, ASavedViewIsShownWithItsStructure) {
    Files f("sample:dna");
    f.open(
        {f.write("v.json", R"({"input": "sample:glucose", "style": "licorice", "background": "black", "zoom": 2})")});
    EXPECT_EQ(f.viewer.messages().failure(), "");
    EXPECT_EQ(f.shown(), "sample:glucose");
    EXPECT_EQ(f.viewer.view().look.style, Style::licorice);
    EXPECT_EQ(f.viewer.view().background, (std::array<float, 4>{0, 0, 0, 1}));
    EXPECT_EQ(f.viewer.view().view, f.folder / "v.json") << "recent files name it";
    f.viewer.undo(f.now);
    f.load();
    EXPECT_EQ(f.shown(), "sample:dna") << "opening can be undone";
}

TEST(Opening, ASavedViewHasItsCamera) {
    Files a("sample:dna");
    a.viewer.run(ViewerCommand::rotateLeft, a.now);
    a.viewer.run(ViewerCommand::zoomIn, a.now);
    a.viewer.run(ViewerCommand::panLeft, a.now);
    const View before = a.viewer.frames().settings().view;
    const std::string text = savedViewJson(a.viewer.picking().savedView());
    Files b("sample:glucose");
    b.open({b.write("v.view.json", text)});
    ASSERT_EQ(b.shown(), "sample:dna");
    const View after = b.viewer.frames().settings().view;
    EXPECT_NEAR(after.pixelsPerAngstrom, before.pixelsPerAngstrom, 1e-6 * before.pixelsPerAngstrom);
    EXPECT_NEAR(glm::distance(after.pan, before.pan), 0, 1e-6);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(glm::distance(after.rotation[i], before.rotation[i]), 0, 1e-6);
}

TEST(Opening, ALookChangesWhatIsOpen) {
    Files empty;
    empty.open({empty.write("look.json", R"({"contours": 2})")});
    EXPECT_NE(empty.viewer.messages().failure().find("open one first"), std::string::npos);
    Files f("sample:dna");
    f.open({f.write("look.json", R"({"contours": 2, "background": "black"})")});
    EXPECT_EQ(f.viewer.messages().failure(), "");
    EXPECT_EQ(f.shown(), "sample:dna");
    EXPECT_EQ(f.read.size(), 1u) << "nothing is read again";
    EXPECT_EQ(f.viewer.view().effects.contours.width, 2);
    EXPECT_EQ(f.viewer.view().background, (std::array<float, 4>{0, 0, 0, 1}));
    f.viewer.undo(f.now);
    EXPECT_EQ(f.viewer.view().effects.contours.width, 0);
}

TEST(Opening, KindsAreToldByContent) {
    const Files f;
    EXPECT_EQ(detectKind(f.write("a.json", R"({"input": "a.pdb", "zoom": 2})")), FileKind::view);
    EXPECT_EQ(detectKind(f.write("b.json", R"({"data_1ABC": {"atom_site": {}}})")), FileKind::structure) << "mmJSON";
    EXPECT_EQ(detectKind(f.write("c.json", R"({"chemicalJson": 1, "name": "x", "atoms": {}, "bonds": {}})")),
              FileKind::structure);
    EXPECT_EQ(detectKind(f.write("d.view.json", "{")), FileKind::view) << "a damaged one";
    EXPECT_EQ(detectKind(f.write("e.mvsj", "{}")), FileKind::scene);
    EXPECT_EQ(detectKind(f.write("f", std::string("\0\0\x07\xcb\0\0\0\3", 8))), FileKind::trajectory) << "XTC";
    EXPECT_EQ(detectKind(f.write("g", std::string("CDF\1\0\0\0\0", 8))), FileKind::trajectory);
    EXPECT_EQ(detectKind(f.write("h.pdb", "HEADER\n")), FileKind::structure);
    EXPECT_EQ(detectKind("pdb:4hhb"), FileKind::structure);
}

TEST(Opening, ATrajectoryMovesWhatIsOpen) {
    Files f;
    const std::string path = f.write("md.xtc", std::string("\0\0\x07\xcb\0\0\0\3", 8));
    f.open({path});
    EXPECT_NE(f.viewer.messages().failure().find("open the structure first"), std::string::npos);
    f.open({"sample:dna"});
    EXPECT_EQ(f.viewer.messages().failure(), "") << "an old error goes";
    f.open({path});
    EXPECT_EQ(f.shown(), "sample:dna");
    EXPECT_EQ(f.viewer.document()->view.input.trajectory.path, path);
    f.viewer.undo(f.now);
    f.load();
    EXPECT_EQ(f.viewer.document()->view.input.trajectory.path, "");
    f.open({"sample:glucose", path});
    EXPECT_EQ(f.shown(), "sample:glucose");
    EXPECT_EQ(f.viewer.document()->view.input.trajectory.path, path) << "both at once";
}

TEST(Opening, AMapAloneIsShown) {
    Files f;
    const std::string map =
        f.write("m.dx",
                "object 1 class gridpositions counts 3 3 3\norigin 0 0 0\ndelta 1 0 0\ndelta 0 1 0\n"
                "delta 0 0 1\nobject 2 class gridconnections counts 3 3 3\nobject 3 class array type "
                "double rank 0 items 27 data follows\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 9 0\n0 0 0\n0 0 0\n"
                "0 0 0\n0 0 0\n");
    f.open({map});
    EXPECT_EQ(f.viewer.messages().failure(), "");
    EXPECT_EQ(f.shown(), map);
    EXPECT_EQ(f.viewer.view().maps.files, std::vector{map});
    f.open({"sample:dna"});
    EXPECT_TRUE(f.viewer.view().maps.files.empty());
    f.open({map});
    EXPECT_EQ(f.shown(), "sample:dna") << "it joins a structure";
    EXPECT_EQ(f.viewer.view().maps.files, std::vector{map});
}

TEST(Opening, SeveralAtOnceLookAsOneAfterTheOther) {
    Files once, after;
    once.open({"protein", "other"});
    after.open({"protein"});
    after.open({"other"}, true);
    EXPECT_EQ(once.viewer.view().look.style, Style::cartoon);
    EXPECT_EQ(once.viewer.view().look, after.viewer.view().look);
}

TEST(Opening, WhatFailedIsTriedAgain) {
    Files f;
    f.open({"late"});
    EXPECT_TRUE(f.viewer.reading().failed());
    EXPECT_NE(f.viewer.messages().failure(), "");
    f.viewer.reading().again();
    f.load();
    EXPECT_FALSE(f.viewer.reading().failed());
    EXPECT_EQ(f.viewer.messages().failure(), "");
    EXPECT_EQ(f.shown(), "late");
}

}  // namespace
}  // namespace nacre::app::test
