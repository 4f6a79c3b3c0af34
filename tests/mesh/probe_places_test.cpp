#include "engine/mesh/probe_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

namespace nacre {
namespace {

std::vector<SurfaceBall> someBalls(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 9), radius(1.2, 2);
    std::vector<SurfaceBall> balls;
    for (std::uint32_t i = 0; i < count; ++i)
        balls.push_back({{place(random), place(random), place(random)}, radius(random), i});
    return balls;
}

constexpr double kProbe = 1.4;

/// Whether a probe at a place overlaps no ball, by looking at all. @param room  Å
bool isFree(const std::vector<SurfaceBall>& balls, const glm::dvec3& place, double room) {
    for (const SurfaceBall& ball : balls)
        if (glm::distance(ball.center, place) < ball.radius + kProbe + room) return false;
    return true;
}

bool contains(const ProbeBox& box, const glm::dvec3& place) {
    constexpr double kRoom = 1e-9;
    for (int i = 0; i < 3; ++i)
        if (place[i] < box[0][i] - kRoom || place[i] > box[1][i] + kRoom) return false;
    return true;
}

TEST(ProbePlaces, ArcsAreOpenWhereNoBallIsInTheWay) {
    const std::vector<SurfaceBall> balls = someBalls(60);
    const ProbePlaces places(balls, kProbe);
    ASSERT_GT(places.circles().size(), 20u);
    std::size_t open = 0, covered = 0;
    for (const ProbeCircle& circle : places.circles()) {
        const ProbeBox box = ProbePlaces::boundingBox(circle);
        for (int i = 0; i < 360; ++i) {
            const double angle = i * std::numbers::pi / 180;
            const glm::dvec2 way(std::cos(angle), std::sin(angle));
            const glm::dvec3 place = circle.at(way);
            // A place so near to a third ball may be either.
            if (isFree(balls, place, -1e-7) != isFree(balls, place, -1e-5)) continue;
            const bool free = isFree(balls, place, -1e-7);
            EXPECT_EQ(circle.isOpen(way * 0.3), free) << "circle of " << circle.a << " and " << circle.b << " at " << i;
            EXPECT_TRUE(!free || contains(box, place));
            ++(free ? open : covered);
        }
    }
    EXPECT_GT(open, 1000u);
    EXPECT_GT(covered, 1000u);
}

TEST(ProbePlaces, APointOfThreeSpheresIsThereOnce) {
    const std::vector<SurfaceBall> balls = someBalls(60);
    const ProbePlaces places(balls, kProbe);
    ASSERT_GT(places.points().size(), 20u);
    for (std::size_t i = 0; i < places.points().size(); ++i) {
        const ProbePoint& point = places.points()[i];
        for (const std::uint32_t ball : {point.a, point.b, point.c})
            EXPECT_NEAR(glm::distance(balls[ball].center, point.place), balls[ball].radius + kProbe, 1e-6);
        EXPECT_TRUE(isFree(balls, point.place, -1e-6));
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_GT(glm::distance(places.points()[k].place, point.place), 1e-6) << k << " and " << i;
    }
}

TEST(ProbePlaces, BoxesHoldTheOpenPartOfEachSphere) {
    std::vector<SurfaceBall> balls = someBalls(40);
    balls.push_back({{40, 0, 0}, 1.5, 40});  // alone
    const ProbePlaces places(balls, kProbe);
    const std::vector<ProbeBox> boxes = places.openBoxes();
    std::size_t closed = 0, narrow = 0;
    for (std::uint32_t ball = 0; ball < balls.size(); ++ball) {
        const double reach = places.reachRadius(ball);
        bool open = false;
        for (int z = 0; z < 60; ++z)
            for (int turn = 0; turn < 60; ++turn) {
                const double height = (z + 0.5) / 30 - 1, out = std::sqrt(1 - height * height),
                             angle = turn * std::numbers::pi / 30;
                const glm::dvec3 way(out * std::cos(angle), out * std::sin(angle), height);
                const glm::dvec3 place = balls[ball].center + way * reach;
                if (!isFree(balls, place, -1e-9)) continue;
                open = true;
                EXPECT_TRUE(contains(boxes[ball], place)) << ball;
            }
        EXPECT_TRUE(!open || places.isOpen(ball));
        if (!places.isOpen(ball)) {
            EXPECT_GT(boxes[ball][0].x, boxes[ball][1].x);
            ++closed;
        } else if (boxes[ball][1].x - boxes[ball][0].x < 1.5 * reach) {
            ++narrow;
        }
    }
    EXPECT_GT(closed, 2u);
    EXPECT_GT(narrow, 5u);
    EXPECT_NEAR(boxes[40][0].x, 40 - 2.9, 1e-9);
    EXPECT_NEAR(boxes[40][1].z, 2.9, 1e-9);
}

TEST(ProbePlaces, TurnsGrowWithTheAngle) {
    double before = -1;
    for (int i = 0; i < 720; ++i) {
        const double angle = i * std::numbers::pi / 360, turn = OpenArc::turnTo({std::cos(angle), std::sin(angle)});
        EXPECT_GT(turn, before);
        EXPECT_LT(turn, OpenArc::kTurn);
        before = turn;
    }
}

}  // namespace
}  // namespace nacre
