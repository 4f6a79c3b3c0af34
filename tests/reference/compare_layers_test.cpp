#include "tests/reference/compare_layers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/reference/ray_caster.h"
#include "tests/reference/scenes.h"

namespace nacre::reference {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class CompareLayers : public ::testing::Test {
protected:
    CompareLayers() {
        Representation scene;
        addSphere(scene, {0, 0, 0}, 2.0f, 7);
        addSphere(scene, {1.5f, 0, 0}, 1.25f, 9);
        reference = castRays(scene, viewOfScene(scene, Projection::orthographic, 80, 60));
        drawn = reference;
        drawn.primitive.clear();
        drawn.gap.clear();
        drawn.nearEdge.clear();
    }
    /// A pixel well inside the first sphere, and one well outside both.
    std::size_t inside() const { return reference.index(25, 30); }
    std::size_t outside() const { return reference.index(1, 1); }

    void erase(std::size_t at) {
        drawn.id[at] = 0;
        drawn.z[at] = kInfinity;
        drawn.nx[at] = drawn.ny[at] = drawn.nz[at] = 0.0f;
    }

    Layers reference, drawn;
};

TEST_F(CompareLayers, SamePictureAgreesWholly) {
    ASSERT_EQ(reference.id[inside()], 7u);
    ASSERT_EQ(reference.id[outside()], 0u);
    const Comparison result = compareLayers(reference, drawn);
    EXPECT_EQ(result.pixels, 4800u);
    EXPECT_EQ(result.silhouetteDisagrees, 0u);
    EXPECT_EQ(result.ties, 0u);
    EXPECT_GT(result.idJudged, 1000u);
    EXPECT_EQ(result.idAgrees, result.idJudged);
    EXPECT_EQ(result.maxDepthError, 0.0);
    EXPECT_LT(result.maxNormalAngle, 1e-9);
    EXPECT_LT(result.maxNormalLengthError, 1e-6);
    EXPECT_EQ(result.backgroundFaults, 0u);
    EXPECT_GT(result.nearEdge, 100u);
}

TEST_F(CompareLayers, CountsAHoleAndASpeck) {
    erase(inside());
    drawn.id[outside()] = 7;
    const Comparison result = compareLayers(reference, drawn);
    EXPECT_EQ(result.coveredInReferenceOnly, 1u);
    EXPECT_EQ(result.coveredInDrawnOnly, 1u);
    EXPECT_EQ(result.silhouetteDisagrees, 2u);
    EXPECT_LT(result.silhouetteAgreement(), 1.0);
    EXPECT_EQ(result.idAgreement(), 1.0);
}

TEST_F(CompareLayers, ForgivesTheSilhouetteByOnePixelOnly) {
    // From the left, the first covered pixel of the middle row is at an edge; the one after next is not.
    std::uint32_t column = 0;
    while (reference.id[reference.index(column, 30)] == 0) ++column;
    erase(reference.index(column, 30));
    EXPECT_EQ(compareLayers(reference, drawn).silhouetteDisagrees, 0u);
    erase(reference.index(column + 2, 30));
    EXPECT_EQ(compareLayers(reference, drawn).silhouetteDisagrees, 1u);
}

TEST_F(CompareLayers, CountsAnotherAtomAndLeavesItsDepthOut) {
    drawn.id[inside()] = 9;
    drawn.z[inside()] += 1.0f;
    const Comparison result = compareLayers(reference, drawn);
    EXPECT_EQ(result.idAgrees, result.idJudged - 1);
    EXPECT_LT(result.idAgreement(), 1.0);
    EXPECT_EQ(result.maxDepthError, 0.0);
}

TEST_F(CompareLayers, LeavesTiesOut) {
    drawn.id[inside()] = 9;
    reference.gap[inside()] = 0.5e-4f;
    const Comparison result = compareLayers(reference, drawn);
    EXPECT_EQ(result.ties, 1u);
    EXPECT_EQ(result.idAgreement(), 1.0);
}

TEST_F(CompareLayers, MeasuresDepth) {
    drawn.z[inside()] += 0.25f;
    const Comparison result = compareLayers(reference, drawn);
    EXPECT_NEAR(result.maxDepthError, 0.25, 1e-6);
    EXPECT_EQ(result.depthErrorAt, inside());
    EXPECT_NEAR(result.rmsDepthError, 0.25 / std::sqrt(static_cast<double>(result.idAgrees)), 1e-7);
}

TEST_F(CompareLayers, MeasuresNormals) {
    const double angle = 2.0 * std::numbers::pi / 180.0;  // about the view axis x
    const double y = drawn.ny[inside()], z = drawn.nz[inside()];
    drawn.nx[inside()] = 0.0f;
    reference.nx[inside()] = 0.0f;
    drawn.ny[inside()] = static_cast<float>(1.5 * (std::cos(angle) * y - std::sin(angle) * z));
    drawn.nz[inside()] = static_cast<float>(1.5 * (std::sin(angle) * y + std::cos(angle) * z));
    const Comparison result = compareLayers(reference, drawn);
    EXPECT_NEAR(result.maxNormalAngle, 2.0, 1e-4);
    EXPECT_EQ(result.normalAngleAt, inside());
    EXPECT_NEAR(result.maxNormalLengthError, 1.5 * std::hypot(y, z) - 1.0, 1e-5);
}

TEST_F(CompareLayers, NumbersThatAreNotFiniteDoNotPass) {
    drawn.z[inside()] = std::numeric_limits<float>::quiet_NaN();
    drawn.ny[inside()] = std::numeric_limits<float>::quiet_NaN();
    const Comparison result = compareLayers(reference, drawn);
    EXPECT_TRUE(std::isinf(result.maxDepthError));
    EXPECT_TRUE(std::isinf(result.rmsDepthError));
    EXPECT_EQ(result.maxNormalAngle, 180.0);
    EXPECT_TRUE(std::isinf(result.maxNormalLengthError));
}

TEST_F(CompareLayers, AMissingNormalDoesNotPass) {
    drawn.nx[inside()] = drawn.ny[inside()] = drawn.nz[inside()] = 0.0f;
    EXPECT_EQ(compareLayers(reference, drawn).maxNormalAngle, 180.0);
}

TEST_F(CompareLayers, BackgroundMustBeClean) {
    drawn.z[outside()] = 0.0f;
    drawn.nz[outside() + 1] = 1.0f;
    EXPECT_EQ(compareLayers(reference, drawn).backgroundFaults, 2u);
}

TEST_F(CompareLayers, RefusesPicturesThatDoNotFit) {
    EXPECT_THROW(compareLayers(reference, emptyLayers(60, 80)), std::invalid_argument);
    EXPECT_THROW(compareLayers(drawn, reference), std::invalid_argument);  // not of the ray caster
    drawn.nz.pop_back();
    EXPECT_THROW(compareLayers(reference, drawn), std::invalid_argument);
}

}  // namespace
}  // namespace nacre::reference
