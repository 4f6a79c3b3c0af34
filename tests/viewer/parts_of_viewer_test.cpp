// The viewer's parts, each without the others.

#include <gtest/gtest.h>

#include "tests/viewer/viewer_bench.h"

namespace nacre::app::test {
namespace {

PictureDescription zoomed(double zoom) {
    PictureDescription view = Bench::makeView("sample:glucose");
    view.camera.zoom = zoom;
    return view;
}

/// A stage on which a document stands that nobody read.
struct Shown {
    Stage stage{Bench::makeView("sample:glucose"), true};
    CountingScreen screen;
    Frames frames{screen, stage, {}};

    Shown() {
        Document& document = stage.document;
        document.view = stage.view();
        document.placed = document.molecule = std::make_shared<Molecule>(sampleMolecule("glucose"));
        document.drawing.build(*document.molecule, document.view);
        frames.resize({640, 480}, 2, 0);
    }
};

TEST(ViewHistory, StepsAreWhatStoodBeforeAnAct) {
    History history;
    history.begin(zoomed(1));
    EXPECT_FALSE(history.canUndo(zoomed(1)));
    EXPECT_FALSE(history.canUndo(zoomed(2))) << "nobody said that anything was done";
    history.remember(zoomed(1));
    EXPECT_TRUE(history.canUndo(zoomed(2)));
    const PictureDescription* before = history.undo(zoomed(2));
    ASSERT_TRUE(before);
    EXPECT_EQ(before->camera.zoom, 1);
    EXPECT_EQ(history.undo(zoomed(1)), nullptr);
    ASSERT_TRUE(history.canRedo(zoomed(1)));
    EXPECT_EQ(history.redo(zoomed(1))->camera.zoom, 2);
    history.remember(zoomed(2));
    EXPECT_EQ(history.undo(zoomed(3))->camera.zoom, 2);
    history.remember(zoomed(2));
    history.remember(zoomed(4));
    EXPECT_FALSE(history.canRedo(zoomed(4))) << "what was taken back is forgotten by another act";
}

TEST(Messages, OnePassesAndAFailureStays) {
    FrameSchedule schedule;
    Messages messages(schedule, true);
    EXPECT_TRUE(std::isinf(messages.advance(0)));
    messages.say("hello", 10);
    EXPECT_EQ(messages.advance(11), 10 + Messages::kSeconds);
    EXPECT_EQ(messages.message(), "hello");
    messages.advance(10 + Messages::kSeconds);
    EXPECT_EQ(messages.message(), "");
    messages.fail("it is bad", 20);
    messages.advance(100);
    EXPECT_EQ(messages.failure(), "it is bad");
    messages.dismissFailure();
    EXPECT_EQ(messages.failure(), "");
}

TEST(Picking, OneAtomIsNamedWhereNothingIsMeasured) {
    Shown s;
    Picking picking(s.stage, s.frames);
    for (const std::uint32_t atom : {1u, 3u, 5u, 7u}) {
        s.screen.atom = atom;
        picking.tap({10, 10}, 1);
        EXPECT_EQ(picking.picks(), std::vector<std::uint32_t>{atom - 1});
        EXPECT_EQ(picking.annotations().measurement, "");
        EXPECT_TRUE(picking.selection().any());
    }
}

TEST(Picking, PicksMeasuresAndSelects) {
    Shown s;
    Picking picking(s.stage, s.frames);
    picking.measure(Measuring::distance);
    EXPECT_EQ(picking.annotations().measurement, "distance: pick 2 atoms");
    for (const std::uint32_t atom : {1u, 3u, 3u}) {
        s.screen.atom = atom;
        picking.tap({10, 10}, 1);
    }
    EXPECT_EQ(picking.picks(), (std::vector<std::uint32_t>{0, 2})) << "one atom twice in a row is one";
    EXPECT_EQ(picking.annotations().atoms.size(), 2u);
    EXPECT_EQ(picking.savedView().words.measures.size(), 1u);
    EXPECT_EQ(picking.measuredView().words.measures.size(), 1u);
    EXPECT_TRUE(picking.savedView().camera.scale);
    EXPECT_FALSE(picking.measuredView().camera.isPlaced()) << "words beside it would get no room";
    EXPECT_TRUE(s.stage.view().words.measures.empty());
    EXPECT_FALSE(picking.selection().any()) << "a measured atom selects nothing";
    picking.select("elem C");
    EXPECT_EQ(picking.selection().count, 6u);
    picking.select("elem");
    EXPECT_FALSE(picking.selection().any());
    s.screen.atom = 0;
    picking.tap({10, 10}, 2);
    EXPECT_TRUE(picking.picks().empty()) << "beside the molecule";
}

TEST(Picking, NamesWhatThePointerRestsOn) {
    Shown s;
    Picking picking(s.stage, s.frames);
    s.screen.atom = 2;
    picking.pointerMoved({5, 5}, 10);
    const double due = picking.advance(10);
    EXPECT_GT(due, 10);
    EXPECT_EQ(picking.annotations().hover, "");
    EXPECT_TRUE(std::isinf(picking.advance(due)));
    EXPECT_NE(picking.annotations().hover, "");
    s.stage.changed(20);
    EXPECT_EQ(picking.annotations().hover, "") << "something else may be there";
    EXPECT_GT(picking.advance(20), 20);
    EXPECT_FALSE(std::isinf(picking.advance(20)));
}

TEST(Reading, SaysHowADocumentDiffersFromTheOneBefore) {
    Stage stage(Bench::makeView("sample:glucose"), true);
    Reading reading(stage, sampleSources(), {});
    const auto arrive = [&] {
        reading.loader().wait();
        std::optional<Document> document = reading.take(0);
        EXPECT_TRUE(document);
        return reading.arrive(std::move(*document));
    };
    Reading::Arrival arrival = arrive();
    EXPECT_TRUE(arrival.another);
    EXPECT_FALSE(arrival.step || arrival.restored);
    EXPECT_TRUE(stage.shown());
    stage.wanted().look.style = Style::licorice;
    reading.build();
    arrival = arrive();
    EXPECT_FALSE(arrival.another) << "the same molecule in another style";
    reading.restore(Bench::makeView("sample:dna"), true);
    EXPECT_TRUE(reading.another());
    EXPECT_TRUE(arrive().restored);
    reading.open("bad", 0);
    reading.loader().wait();
    EXPECT_FALSE(reading.take(0));
    EXPECT_NE(stage.messages.failure().find("it is bad"), std::string::npos);
    const PictureDescription& there = stage.document.view;
    EXPECT_EQ(there.input.path, "sample:dna") << "the one before stays";
}

TEST(Frames, TheMoleculeStandsInTheMiddleOfWhatIsFree) {
    Shown s;
    s.frames.setCovered({200, 0, 0, 100}, 1);
    EXPECT_EQ(s.frames.freeSize().width, 440u);
    EXPECT_EQ(s.frames.freeSize().height, 380u);
    const glm::dvec2 middle = s.frames.projectPoint({0, 0, 0}, s.frames.settings().view);
    EXPECT_NEAR(middle.x, (200 + 640) / 2.0 / 2, 1e-9);
    EXPECT_NEAR(middle.y, (480 - 100) / 2.0 / 2, 1e-9);
}

}  // namespace
}  // namespace nacre::app::test
