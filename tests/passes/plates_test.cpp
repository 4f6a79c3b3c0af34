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
/// encoding and the colour together: tests/benchmark/shape_costs.py
struct Cost {
    double radius, squares, octagonsAndSquares, octagons, domesAndPyramids;
};
struct Measured {
    const char* set;
    Cost costs[8];
};
constexpr Measured kMeasured[] = {
    {"turnip",
     {{1.4, 5.3, 6.0, 9.2, 13.7},
      {2.8, 8.3, 8.5, 11.3, 15.1},
      {4.2, 13.3, 12.5, 14.6, 17.4},
      {5.6, 20.4, 18.2, 19.2, 20.7},
      {7.0, 29.2, 25.4, 25.2, 24.9},
      {10.5, 60.6, 50.7, 46.0, 39.6},
      {14.1, 104, 85.9, 75.0, 60.0},
      {21.1, 229, 187, 158, 118}}},
    {"v3dv",
     {{1.4, 8.9, 10.9, 16.0, 25.9},
      {2.8, 12.9, 14.2, 18.9, 28.0},
      {4.2, 19.7, 19.8, 23.5, 31.5},
      {5.6, 29.2, 27.6, 30.1, 36.3},
      {7.0, 41.2, 37.6, 38.4, 42.5},
      {10.5, 83.3, 72.6, 67.7, 64.2},
      {14.1, 142, 121, 108, 94.5},
      {21.1, 310, 261, 225, 181}}},
    {"mali",
     {{1.4, 42.4, 49.0, 83.3, 119},
      {2.8, 45.6, 51.6, 85.5, 121},
      {4.2, 51.0, 56.0, 89.1, 123},
      {5.6, 58.7, 62.2, 94.2, 127},
      {7.0, 68.3, 70.1, 101, 131},
      {10.5, 102, 97.6, 124, 148},
      {14.1, 150, 136, 155, 170},
      {21.1, 284, 246, 246, 235}}},
};

constexpr PlateShape kShapes[] = {PlateShape::square, PlateShape::octagon, PlateShape::dome2, PlateShape::dome3};

TEST(Plates, LieInsideTheirSphereAndLeaveRoomForTheNext) {
    for (const PlateShape shape : kShapes) {
        ASSERT_FALSE(platesOf(shape).empty());
        float outer = 1;
        for (const Plate& plate : platesOf(shape)) {
            EXPECT_TRUE(plate.corners == 4 || plate.corners == 8);
            // Corners on the sphere: all else of the polygon is nearer to the axis, hence inside.
            EXPECT_GT(plate.rim, 0.0f);
            EXPECT_LT(plate.rim, outer) << "a plate behind one that is as wide hides nothing more";
            outer = plate.rim;
        }
    }
    EXPECT_TRUE(platesOf(PlateShape::none).empty());
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
        for (const double threshold :
             {caps.domes, caps.octagons, caps.plateOctagons, caps.storesVaryings ? kFetchedPixels : 0}) {
            if (threshold <= 0 || !std::isfinite(threshold)) continue;
            double last = 0;
            int changes = 0, unsteady = 0;
            const auto shapes = [&](double radius) {
                return std::tuple(choosePlates(PlateShape::automatic, caps, radius),
                                  chooseImpostor(ImpostorShape::automatic, caps, radius, false),
                                  fetchesSpheres(caps, radius));
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
    const auto octagon = platesOf(PlateShape::octagon);
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
            for (const Plate& plate : platesOf(shape))
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
