#include "engine/software/sphere_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/scene/build/chunks.h"

namespace nacre {
namespace {

/// Spheres here and there; the atom of each is its number.
Representation scatteredSpheres(std::uint32_t count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-50, 50);
    Representation r;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 at(place(random), place(random), place(random));
        r.spheres.push_back({at, 1.5f});
        r.sphereLooks.push_back({0, i});
    }
    return r;
}

TEST(SphereBoxes, OfCopiesAreSmallerThanTheStreamsChunks) {
    Representation r = scatteredSpheres(20000);
    orderInSpace(r);
    const auto mean = [](const SphereBoxes& boxes) {
        double sum = 0;
        for (const SphereBox& box : boxes.boxes) sum += static_cast<double>(box.ball);
        return sum / static_cast<double>(boxes.boxes.size());
    };
    const SphereBoxes alone = makeSphereBoxes(r);
    EXPECT_TRUE(alone.spheres.empty());
    r.copies.lists = {{0}, {0, 1}};
    r.copies.transforms.resize(2, glm::dmat4x3(1.0));
    r.copies.spheres = {{0, 9000, 0}, {9000, 11000, 1}};
    r.spheres[77].center.x = std::numeric_limits<float>::quiet_NaN();
    const SphereBoxes boxes = makeSphereBoxes(r);
    EXPECT_FALSE(std::isfinite(boxes.reach));
    r.spheres[77].center.x = 0;
    const SphereBoxes finite = makeSphereBoxes(r);
    EXPECT_LT(mean(finite), 0.85 * mean(alone));
    EXPECT_EQ(finite.starts, (std::vector<std::uint32_t>{0, 9000, 20000}));
    for (const SphereBoxes* b : {&boxes, &finite}) {
        std::vector<bool> there(20000, false);
        ASSERT_EQ(b->spheres.size(), 20000u);
        for (std::uint32_t i = 0; i < 20000; ++i) {
            const std::uint32_t number = b->numbers[i];
            EXPECT_FALSE(there[number]);
            there[number] = true;
            EXPECT_EQ(i < 9000, number < 9000);
            if (b == &finite) {
                EXPECT_EQ(b->spheres[i].center, r.spheres[number].center);
            }
        }
    }
}

}  // namespace
}  // namespace nacre
