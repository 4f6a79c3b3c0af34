#include "engine/passes/plates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "engine/graph/capability_sets.h"

namespace nacre::passes {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr graph::GeometryCaps kSoftware{false, kNever, kNever, kNever};
const graph::GeometryCaps kGpu, kStoring = graph::capabilitySet("mali").plan.geometry;

/// Million instructions of a frame of 4HHB by mean radius and by shapes of plates and impostors, the prepass, the
/// encoding and the colour together: tools/tilers_costs.py
struct Cost {
    double radius, squares, octagonsAndSquares, octagons, domesAndPyramids;
};
struct Measured {
    const char* set;
    Cost costs[9];
};
constexpr Measured kMeasured[] = {
    {"turnip",
     {{1.4, 5.4, 6.1, 9.3, 13.7},
      {2.8, 8.7, 8.8, 11.5, 15.3},
      {4.2, 14.3, 13.3, 15.2, 17.9},
      {5.6, 22.1, 19.6, 20.4, 21.5},
      {7.0, 32.0, 27.6, 27.0, 26.1},
      {8.8, 47.5, 40.2, 37.3, 33.4},
      {10.5, 66.7, 55.6, 50.0, 42.3},
      {14.1, 115.2, 94.6, 82.1, 64.9},
      {21.1, 253.2, 206.2, 174.1, 129.5}}},
    {"v3dv",
     {{1.4, 9.0, 10.9, 16.1, 25.9},
      {2.8, 13.3, 14.6, 19.1, 28.2},
      {4.2, 20.6, 20.5, 24.1, 31.9},
      {5.6, 30.8, 28.9, 31.2, 37.1},
      {7.0, 43.7, 39.7, 40.1, 43.7},
      {8.8, 64.1, 56.5, 54.2, 54.1},
      {10.5, 89.1, 77.2, 71.5, 66.8},
      {14.1, 152.4, 129.6, 115.1, 99.1},
      {21.1, 332.8, 279.1, 240.1, 191.5}}},
    {"mali",
     {{1.4, 34.3, 40.9, 66.8, 100.3},
      {2.8, 38.4, 44.2, 69.6, 102.3},
      {4.2, 45.3, 49.8, 74.1, 105.5},
      {5.6, 55.0, 57.6, 80.6, 110.1},
      {7.0, 67.2, 67.5, 88.8, 115.9},
      {8.8, 86.4, 83.1, 101.7, 125.1},
      {10.5, 110.1, 102.3, 117.5, 136.3},
      {14.1, 170.1, 150.8, 157.5, 164.7},
      {21.1, 340.8, 289.4, 272.0, 245.9}}},
};

constexpr PlateShape kShapes[] = {PlateShape::square, PlateShape::octagon, PlateShape::dome2, PlateShape::dome3};

TEST(Plates, LieInsideTheirSphereAndLeaveRoomForTheNext) {
    for (const PlateShape shape : kShapes) {
        ASSERT_FALSE(listPlates(shape).empty());
        float outer = 1;
        for (const Plate& plate : listPlates(shape)) {
            EXPECT_TRUE(plate.corners == 4 || plate.corners == 8);
            // Corners on the sphere: all else of the polygon is nearer to the axis, hence inside.
            EXPECT_GT(plate.rim, 0.0f);
            EXPECT_LT(plate.rim, outer) << "a plate behind one that is as wide hides nothing more";
            outer = plate.rim;
        }
    }
    EXPECT_TRUE(listPlates(PlateShape::none).empty());
}

TEST(Plates, ShapesAreThoseThatCostLeast) {
    for (const Measured& of : kMeasured)
        for (const Cost& c : of.costs) {
            SCOPED_TRACE(testing::Message() << of.set << ", " << c.radius << " pixels");
            const graph::GeometryCaps& caps = graph::capabilitySet(of.set).plan.geometry;
            const PlateShape plates = choosePlates(PlateShape::automatic, caps, c.radius);
            const ImpostorShape impostor = chooseImpostor(ImpostorShape::automatic, caps, c.radius, false);
            const double cost = impostor == ImpostorShape::pyramid   ? c.domesAndPyramids
                                : impostor == ImpostorShape::octagon ? c.octagons
                                : plates == PlateShape::octagon      ? c.octagonsAndSquares
                                                                     : c.squares;
            EXPECT_EQ(impostor == ImpostorShape::pyramid, plates == PlateShape::dome3);
            EXPECT_LE(cost, 1.1 * std::min({c.squares, c.octagonsAndSquares, c.octagons, c.domesAndPyramids}));
        }
}

// A pinch that goes to and fro across a threshold changes what is drawn by once, not with each turn.
TEST(Plates, ShapesStayWhereAZoomGoesToAndFro) {
    const graph::GeometryCaps kDirect = graph::capabilitySet("turnip").plan.geometry;
    for (const graph::GeometryCaps& caps : {kGpu, kStoring, kDirect})
        for (const double threshold : {caps.domes, caps.octagons, caps.plateOctagons}) {
            if (threshold <= 0 || !std::isfinite(threshold)) continue;
            double last = 0;
            int changes = 0, unsteady = 0;
            const auto shapes = [&](double radius) {
                return std::tuple(choosePlates(PlateShape::automatic, caps, radius),
                                  chooseImpostor(ImpostorShape::automatic, caps, radius, false));
            };
            double before = 0;
            for (int frame = 0; frame < 40; ++frame) {
                const double radius = threshold * (frame % 2 ? 1.06 : 0.94);
                const double steady = steadyRadius(last, radius, caps);
                if (last > 0) changes += shapes(steady) != shapes(last);
                if (before > 0) unsteady += shapes(radius) != shapes(before);
                last = steady, before = radius;
            }
            EXPECT_EQ(changes, 0) << threshold;
            EXPECT_EQ(unsteady, 39) << threshold;  // without this the test would prove nothing
            // Who goes on past it gets there, in both directions.
            EXPECT_EQ(shapes(steadyRadius(last, 1.5 * threshold, caps)), shapes(1.5 * threshold));
            EXPECT_EQ(shapes(steadyRadius(1.5 * threshold, 0.7 * threshold, caps)), shapes(0.7 * threshold));
        }
    EXPECT_EQ(steadyRadius(0, 5.9, kGpu), 5.9);  // the first frame
}

TEST(Plates, TheOctagonIsTheOriginals) {
    const auto octagon = listPlates(PlateShape::octagon);
    ASSERT_EQ(octagon.size(), 1u);
    EXPECT_EQ(octagon[0].corners, 8u);
    EXPECT_NEAR(octagon[0].rim, 0.91017 / std::cos(std::numbers::pi / 8), 1e-5);
    EXPECT_NEAR(std::sqrt(1 - octagon[0].rim * octagon[0].rim), 0.1716, 1e-4);  // radii in front of the centre
}

TEST(Plates, MoreOfThemHideMoreOfTheSphere) {
    // The share of the sphere's depth behind the plates, over the disc: corners on circles of radius rim, sides at
    // rim cos(pi / corners), of which the inscribed circle is taken.
    const auto hidden = [](PlateShape shape) {
        double sum = 0;
        for (double r = 0.005; r < 1; r += 0.01) {
            double height = -1;  // of the nearest plate over this ring, in radii
            for (const Plate& plate : listPlates(shape))
                if (r < plate.rim * std::cos(std::numbers::pi / plate.corners))
                    height = std::max(height, std::sqrt(1.0 - double{plate.rim} * plate.rim));
            sum += (height + 1) * r;
        }
        return sum;
    };
    EXPECT_LT(hidden(PlateShape::square), hidden(PlateShape::octagon));
    EXPECT_LT(hidden(PlateShape::octagon), hidden(PlateShape::dome2));
    EXPECT_LT(hidden(PlateShape::dome2), hidden(PlateShape::dome3));
}

TEST(Plates, WhatIsAskedForIsTaken) {
    for (const PlateShape shape : kShapes)
        for (const graph::GeometryCaps& caps : {kGpu, kSoftware}) EXPECT_EQ(choosePlates(shape, caps, 50), shape);
    EXPECT_EQ(choosePlates(PlateShape::none, kGpu, 50), PlateShape::none);
    EXPECT_EQ(chooseImpostor(ImpostorShape::square, kGpu, 50, false), ImpostorShape::square);
}

TEST(Plates, AutomaticOnesFollowDeviceAndSize) {
    EXPECT_EQ(choosePlates(PlateShape::automatic, kSoftware, 50), PlateShape::square);
    EXPECT_EQ(choosePlates(PlateShape::automatic, kGpu, 50), PlateShape::dome3);
    EXPECT_EQ(choosePlates(PlateShape::automatic, kGpu, 2), PlateShape::octagon);
    EXPECT_EQ(chooseImpostor(ImpostorShape::automatic, kSoftware, 50, false), ImpostorShape::square);
    EXPECT_EQ(chooseImpostor(ImpostorShape::automatic, kGpu, 50, false), ImpostorShape::pyramid);
    EXPECT_EQ(chooseImpostor(ImpostorShape::automatic, kGpu, 2, false), ImpostorShape::octagon);
}

TEST(Plates, FewerCornersWhereTheyGoThroughMemory) {
    EXPECT_EQ(choosePlates(PlateShape::automatic, kStoring, 2), PlateShape::square);
    EXPECT_EQ(choosePlates(PlateShape::automatic, kStoring, 9.4), PlateShape::octagon);
    EXPECT_EQ(choosePlates(PlateShape::automatic, kStoring, 30), PlateShape::dome3);
    EXPECT_EQ(chooseImpostor(ImpostorShape::automatic, kStoring, 9.4, false), ImpostorShape::square);
    EXPECT_EQ(chooseImpostor(ImpostorShape::automatic, kStoring, 15, false), ImpostorShape::square);
    EXPECT_EQ(chooseImpostor(ImpostorShape::automatic, kStoring, 30, true), ImpostorShape::octagon);
    EXPECT_EQ(chooseImpostor(ImpostorShape::automatic, kStoring, 30, false), ImpostorShape::pyramid);
}

TEST(Plates, NoPyramidLeansInPerspective) {
    EXPECT_EQ(chooseImpostor(ImpostorShape::automatic, kGpu, 50, true), ImpostorShape::octagon);
    EXPECT_EQ(chooseImpostor(ImpostorShape::pyramid, kGpu, 50, true), ImpostorShape::octagon);
}

}  // namespace
}  // namespace nacre::passes
