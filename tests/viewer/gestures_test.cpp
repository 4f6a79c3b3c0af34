#include "app/viewer/gestures.h"

#include <gtest/gtest.h>

#include <numbers>

namespace nacre::app {
namespace {

using Kind = Gesture::Kind;

/// Fingers on a screen, and all the gestures they made.
struct Hand {
    TouchGestures touches;
    std::vector<Gesture> all;

    void at(double now, std::int64_t finger, TouchPhase phase, glm::dvec2 place) {
        for (const Gesture& g : touches.handle({finger, phase, place}, now)) all.push_back(g);
    }
    void tick(double now) {
        for (const Gesture& g : touches.tick(now)) all.push_back(g);
    }
    int count(Kind kind) const {
        int n = 0;
        for (const Gesture& g : all) n += g.kind == kind;
        return n;
    }
};

TEST(TouchGestures, OneFingerRotatesAfterTheSlopWithoutAJump) {
    Hand hand;
    hand.at(0.00, 1, TouchPhase::began, {100, 100});
    hand.at(0.05, 1, TouchPhase::moved, {105, 100});
    hand.at(0.10, 1, TouchPhase::moved, {112, 100});
    EXPECT_EQ(hand.count(Kind::rotate), 0);
    hand.at(0.15, 1, TouchPhase::moved, {130, 96});
    ASSERT_EQ(hand.count(Kind::rotate), 1);
    EXPECT_EQ(hand.all.back().by, glm::dvec2(18, -4));
    hand.at(0.20, 1, TouchPhase::ended, {130, 96});
    EXPECT_EQ(hand.all.back().kind, Kind::released);
    EXPECT_EQ(hand.count(Kind::tap), 0);
}

TEST(TouchGestures, TapThenDoubleTap) {
    Hand hand;
    hand.at(0.00, 1, TouchPhase::began, {50, 60});
    hand.at(0.10, 1, TouchPhase::ended, {53, 61});
    ASSERT_EQ(hand.all.back().kind, Kind::tap);
    EXPECT_EQ(hand.all.back().at, glm::dvec2(50, 60));
    hand.at(0.25, 1, TouchPhase::began, {55, 66});
    hand.at(0.30, 1, TouchPhase::ended, {55, 66});
    EXPECT_EQ(hand.all.back().kind, Kind::doubleTap);
    // A third one begins anew; one that is late or far is a tap of its own.
    hand.at(0.40, 1, TouchPhase::began, {55, 66});
    hand.at(0.45, 1, TouchPhase::ended, {55, 66});
    EXPECT_EQ(hand.all.back().kind, Kind::tap);
    hand.at(1.40, 1, TouchPhase::began, {55, 66});
    hand.at(1.45, 1, TouchPhase::ended, {55, 66});
    EXPECT_EQ(hand.all.back().kind, Kind::tap);
    hand.at(1.60, 1, TouchPhase::began, {155, 66});
    hand.at(1.65, 1, TouchPhase::ended, {155, 66});
    EXPECT_EQ(hand.all.back().kind, Kind::tap);
    EXPECT_EQ(hand.count(Kind::doubleTap), 1);
}

TEST(TouchGestures, LongPressComesByTimeAloneAndIsNoTap) {
    Hand hand;
    hand.at(2.0, 7, TouchPhase::began, {10, 20});
    ASSERT_TRUE(hand.touches.wake());
    EXPECT_DOUBLE_EQ(*hand.touches.wake(), 2.0 + TouchGestures::kLongPressSeconds);
    hand.tick(2.4);
    EXPECT_EQ(hand.count(Kind::longPress), 0);
    hand.tick(2.51);
    hand.tick(2.60);
    EXPECT_EQ(hand.count(Kind::longPress), 1);
    EXPECT_FALSE(hand.touches.wake());
    hand.at(2.7, 7, TouchPhase::ended, {10, 20});
    EXPECT_EQ(hand.count(Kind::tap), 0);
}

TEST(TouchGestures, TwoFingersPanPinchAndTwist) {
    Hand hand;
    hand.at(0, 1, TouchPhase::began, {100, 100});
    hand.at(0, 2, TouchPhase::began, {200, 100});
    hand.at(0.1, 1, TouchPhase::moved, {100, 130});
    hand.at(0.1, 2, TouchPhase::moved, {200, 130});
    glm::dvec2 pan{};
    double scale = 1, turn = 0;
    for (const Gesture& g : hand.all)
        if (g.kind == Kind::transform) pan += g.by, scale *= g.scale, turn += g.turn;
    EXPECT_EQ(pan, glm::dvec2(0, 30));
    EXPECT_NEAR(scale, 1, 1e-12);
    EXPECT_NEAR(turn, 0, 1e-12);
    hand.at(0.2, 2, TouchPhase::moved, {300, 130});
    EXPECT_NEAR(hand.all.back().scale, 2.0, 1e-12);
    EXPECT_EQ(hand.all.back().at, glm::dvec2(200, 130));
    hand.at(0.3, 2, TouchPhase::moved, {100, 330});  // from right of the first finger to below it
    EXPECT_NEAR(hand.all.back().turn, std::numbers::pi / 2, 1e-12);
    // The finger that stays rotates on from where it is: no jump, no tap.
    hand.at(0.4, 1, TouchPhase::ended, {100, 130});
    hand.at(0.5, 2, TouchPhase::moved, {103, 330});
    EXPECT_EQ(hand.all.back().kind, Kind::rotate);
    EXPECT_EQ(hand.all.back().by, glm::dvec2(3, 0));
    hand.at(0.6, 2, TouchPhase::ended, {103, 330});
    EXPECT_EQ(hand.count(Kind::tap), 0);
    EXPECT_EQ(hand.count(Kind::longPress), 0);
}

TEST(TouchGestures, ThreeFingersToTheLeftUndoAndToTheRightRedo) {
    for (const double by : {-80.0, 80.0, -30.0, 0.0}) {
        Hand hand;
        for (int finger = 1; finger <= 3; ++finger) {
            hand.at(0.01 * finger, finger, TouchPhase::began, {100.0 * finger, 200});
            hand.at(0.01 * finger + 0.005, finger, TouchPhase::moved, {100.0 * finger + 2, 203});
        }
        for (int step = 1; step <= 8; ++step)
            for (int finger = 1; finger <= 3; ++finger)
                hand.at(0.1 + 0.02 * step, finger, TouchPhase::moved, {100.0 * finger + by * step / 8, 210});
        for (int finger = 1; finger <= 3; ++finger) {
            hand.at(0.4 + 0.1 * finger, finger, TouchPhase::ended, {100.0 * finger + by, 210});
            hand.at(0.45 + 0.1 * finger, 3, TouchPhase::moved, {150, 300});  // one that stays moves nothing
        }
        EXPECT_EQ(hand.count(Kind::undo), by == -80) << by;
        EXPECT_EQ(hand.count(Kind::redo), by == 80) << by;
        EXPECT_EQ(hand.count(Kind::transform) + hand.count(Kind::rotate) + hand.count(Kind::tap), 0) << by;
        hand.at(2, 7, TouchPhase::began, {10, 10});
        hand.at(2.1, 7, TouchPhase::moved, {50, 10});
        hand.at(2.2, 7, TouchPhase::moved, {60, 10});
        EXPECT_EQ(hand.count(Kind::rotate), 1) << "the next touch is a drag again";
    }
}

TEST(TouchGestures, StrayAndCancelledFingersAreForgotten) {
    Hand hand;
    hand.at(0, 5, TouchPhase::moved, {1, 1});
    hand.at(0, 5, TouchPhase::ended, {1, 1});
    EXPECT_TRUE(hand.all.empty());
    hand.at(0, 1, TouchPhase::began, {1, 1});
    hand.at(0.1, 1, TouchPhase::cancelled, {1, 1});
    hand.at(0.1, 1, TouchPhase::ended, {1, 1});
    EXPECT_EQ(hand.count(Kind::tap), 0);
    EXPECT_FALSE(hand.touches.wake());
}

TEST(MouseGestures, ButtonsAndModifiersChooseTheDrag) {
    struct Case {
        MouseButton button;
        Modifiers with;
        Kind kind;
        bool turns;
    };
    for (const Case& c :
         {Case{MouseButton::left, {}, Kind::rotate, false}, Case{MouseButton::right, {}, Kind::transform, false},
          Case{MouseButton::left, {true, false}, Kind::transform, false},
          Case{MouseButton::left, {false, true}, Kind::transform, true}}) {
        MouseGestures mouse;
        mouse.button(c.button, true, {300, 200}, c.with, 0);
        EXPECT_TRUE(mouse.move({302, 200}, {200, 200}).empty());  // within the slop
        const auto moved = mouse.move({300, 300}, {200, 200});
        ASSERT_EQ(moved.size(), 1u);
        EXPECT_EQ(moved[0].kind, c.kind);
        if (c.turns)
            EXPECT_NEAR(moved[0].turn, std::numbers::pi / 4, 1e-12);
        else
            EXPECT_EQ(moved[0].by, glm::dvec2(0, 100));
        EXPECT_EQ(mouse.button(c.button, false, {300, 300}, c.with, 1).front().kind, Kind::released);
    }
}

TEST(MouseGestures, ClickDoubleClickAndWheel) {
    MouseGestures mouse;
    mouse.button(MouseButton::left, true, {10, 10}, {}, 0);
    EXPECT_EQ(mouse.button(MouseButton::left, false, {11, 10}, {}, 0.1).front().kind, Kind::tap);
    mouse.button(MouseButton::left, true, {10, 10}, {}, 0.2);
    EXPECT_EQ(mouse.button(MouseButton::left, false, {10, 10}, {}, 0.3).front().kind, Kind::doubleTap);
    const Gesture in = mouse.wheel(2, {5, 6}).front(), out = mouse.wheel(-2, {5, 6}).front();
    EXPECT_GT(in.scale, 1);
    EXPECT_NEAR(in.scale * out.scale, 1, 1e-12);
    EXPECT_EQ(in.at, glm::dvec2(5, 6));
}

}  // namespace
}  // namespace nacre::app
