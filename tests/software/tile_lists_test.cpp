// Lists of what may show in a part of the picture, against every primitive asked about every pixel.

#include "engine/software/tile_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "tests/software/listed_scene.h"

namespace nacre::test {
namespace {

constexpr std::uint32_t kBin = TileLists::kBinPixels;

/// The ray of a pixel's centre, view space.
struct Ray {
    glm::dvec3 origin, direction;
};
Ray makeRay(const TileView& v, std::uint32_t x, std::uint32_t y) {
    const glm::dvec2 p = (glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(v.axis)) / static_cast<double>(v.pixels);
    // Undoing the turns of the image, then rows that run downwards.
    const glm::dvec2 turned[] = {p, {p.y, -p.x}, -p, {-p.y, p.x}};
    const glm::dvec2 q(turned[v.quarterTurns].x, -turned[v.quarterTurns].y);
    if (!v.perspective) return {{q, 1000.0}, {0, 0, -1}};
    return {{0, 0, v.origin}, glm::normalize(glm::dvec3(q, -v.origin))};
}

glm::dvec3 placed(const glm::vec4* rows, const glm::vec3& p) {
    const glm::dvec4 from(p, 1.0);
    return {glm::dot(glm::dvec4(rows[0]), from), glm::dot(glm::dvec4(rows[1]), from),
            glm::dot(glm::dvec4(rows[2]), from)};
}

double distanceToSegment(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b) {
    // Least distance of a line and a segment: t along the segment, clamped, found by its derivative.
    const glm::dvec3 span = b - a, d = ray.direction;
    const glm::dvec3 across = span - d * glm::dot(span, d), from = a - ray.origin;
    const glm::dvec3 off = from - d * glm::dot(from, d);
    const double t = std::clamp(-glm::dot(off, across) / std::max(glm::dot(across, across), 1e-12), 0.0, 1.0);
    return glm::length(off + across * t);
}

/// How far along a ray it meets a triangle, in whatever unit; infinitely: it runs on different sides of its edges.
double distanceTo(const Ray& ray, const glm::vec4* rows, const Representation& mesh, std::size_t triangle) {
    const Triangle& t = mesh.triangles[triangle];
    const auto from = [&](std::uint32_t i) {
        return placed(rows, decodePosition(mesh.meshVertices[i], t.step())) - ray.origin;
    };
    const glm::dvec3 a = from(t.a), b = from(t.b), c = from(t.c);
    const double ab = glm::dot(ray.direction, glm::cross(a, b)), bc = glm::dot(ray.direction, glm::cross(b, c)),
                 ca = glm::dot(ray.direction, glm::cross(c, a));
    const bool inside = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    return inside ? glm::dot(normal, a) / glm::dot(normal, ray.direction) : std::numeric_limits<double>::infinity();
}

class TileListsTest : public testing::TestWithParam<std::tuple<bool, int>> {};

TEST_P(TileListsTest, NoPrimitiveThatAPixelMeetsIsLeftOut) {
    const auto [perspective, turns] = GetParam();
    TileLists lists;  // used again and again, as by a renderer
    std::size_t met = 0, listed = 0, meetings = 0, begun = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        ListedScene s = randomListedScene(seed, perspective, turns);
        s.view.edges = seed % 4 == 1;
        lists.build(s.view, s.scenery());
        const std::vector<std::uint32_t> numbers = writeLists(lists);
        listed += numbers.size();
        ASSERT_EQ(lists.across(), (s.view.width + kBin - 1) / kBin);
        ASSERT_EQ(lists.down(), (s.view.height + kBin - 1) / kBin);
        std::vector<std::set<std::uint32_t>> ofBin(lists.offsets().size() - 1);
        for (std::size_t bin = 0; bin < ofBin.size(); ++bin) {
            const auto from = numbers.begin() + lists.offsets()[bin], to = numbers.begin() + lists.offsets()[bin + 1];
            ofBin[bin] = {from, to};
            ASSERT_EQ(ofBin[bin].size(), static_cast<std::size_t>(to - from)) << "an entry twice";
        }
        const std::vector<std::uint32_t> seeds = listSeeds(lists, s.view);
        const auto expect = [&](std::uint32_t number, std::uint32_t x, std::uint32_t y) {
            ++met;
            const std::size_t bin = y / kBin * lists.across() + x / kBin;
            const bool begins = seeds[std::size_t{y} * s.view.width + x] == number;
            begun += begins;
            EXPECT_TRUE(lists.holds(bin));
            EXPECT_TRUE(begins || ofBin[bin].contains(number))
                << "seed " << seed << ", number " << number << " at " << x << " " << y;
        };
        for (std::uint32_t y = seed % 3; y < s.view.height; y += 3)
            for (std::uint32_t x = seed % 3; x < s.view.width; x += 3) {
                const Ray ray = makeRay(s.view, x, y);
                for (const TileCall& call : s.sphereCalls)
                    for (std::uint32_t i = call.first; i < call.first + call.count; ++i) {
                        const glm::dvec3 at = placed(call.rows, s.spheres[i].center);
                        if (distanceToSegment(ray, at, at) < s.spheres[i].radius) expect(call.number + i, x, y);
                    }
                for (const TileCall& call : s.cylinderCalls)
                    for (std::uint32_t i = call.first; i < call.first + call.count; ++i) {
                        const Cylinder& c = s.cylinders[i];
                        // With round ends it is larger than it is.
                        const glm::dvec3 a = placed(call.rows, c.a), b = placed(call.rows, c.b);
                        if (distanceToSegment(ray, a, b) < c.radius) expect(call.number + i, x, y);
                    }
                // Where the host draws triangles, a pixel's centre wants the nearest.
                double nearest = std::numeric_limits<double>::infinity();
                for (const TileCall& call : s.triangleCalls)
                    for (std::uint32_t i = call.first; i < call.first + call.count; ++i)
                        nearest = std::min(nearest, distanceTo(ray, call.rows, s.mesh, i));
                for (const TileCall& call : s.triangleCalls)
                    for (std::uint32_t i = call.first; i < call.first + call.count; ++i) {
                        const double distance = distanceTo(ray, call.rows, s.mesh, i);
                        const bool drawn = s.view.centers || s.view.edges;
                        if (std::isfinite(distance) && (!drawn || distance == nearest)) expect(call.number + i, x, y);
                        if (std::isfinite(distance)) ++meetings;
                    }
            }
    }
    EXPECT_GT(met, 1000u);
    EXPECT_GT(meetings, 1000u);
    EXPECT_GT(begun, 100u);
    EXPECT_GT(listed, 300u);
}

TEST(TileLists, LeaveOutTrianglesBehindOthersAtAllCenters) {
    TileView v = smallView();
    // One over the whole picture, one behind it, one in front that covers it, and one that lies in it.
    Mesh mesh;
    for (const float z : {0.0f, -1.0f, 1.0f, 0.0f}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const float reach = first == 0 ? 40.0f : 3.0f;
        for (const glm::vec2 corner : {glm::vec2(-reach, -reach), {reach, -reach}, {0, reach}})
            mesh.positions.emplace_back(corner, z), mesh.normals.emplace_back(0, 0, 1), mesh.atoms.push_back(0);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    Representation r;
    appendMesh(
        mesh, glm::dvec3(0), [](std::uint32_t) { return SphereLook{}; }, r);
    const TileCall call{kUnturned, 0, 4, 1};
    const auto listed = [&] {
        TileLists lists;
        lists.build(v, {{}, {}, {}, {}, {}, r.triangles, r.meshVertices, {&call, 1}});
        return namedBy(lists, v);
    };
    EXPECT_EQ(listed(), (std::set<std::uint32_t>{1, 2, 3, 4}));
    v.centers = true;
    EXPECT_EQ(listed(), (std::set<std::uint32_t>{1, 3}));
    v.clipNear = 3.5f;  // cuts the one in front away
    EXPECT_EQ(listed(), (std::set<std::uint32_t>{1, 4}));
    v.clipNear = 4.5f;  // and those in the middle
    EXPECT_EQ(listed(), (std::set<std::uint32_t>{2}));
    v.clipNear = -TileView::kNoPlane;
    v.contour = 0.1f;  // there are lines about them
    EXPECT_EQ(listed(), (std::set<std::uint32_t>{1, 2, 3, 4}));
}

/// Where edges are drawn, samples between centres see what may pass beside a triangle near its rim.
TEST(TileLists, LeaveOutTrianglesBehindAllCentersAroundThem) {
    TileView v = smallView();
    v.edges = true;
    Mesh mesh;
    const auto add = [&](glm::vec2 a, glm::vec2 b, glm::vec2 c, float z) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 corner : {a, b, c})
            mesh.positions.emplace_back(corner, z), mesh.normals.emplace_back(0, 0, 1), mesh.atoms.push_back(0);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    };
    // Four each, since as many are judged together: deep behind what covers the left half, and near its rim.
    for (const float x : {-6.0f, -1.6f})
        for (const float y : {-4.0f, -2.0f, 0.0f, 2.0f}) add({x, y}, {x + 1, y}, {x, y + 1}, -1);
    add({0, -90}, {0, 90}, {-90, 0}, 0);
    add({3, 0}, {4, 0}, {3, 1}, -1);    // beside it
    add({-6, 0}, {-5, 0}, {-6, 1}, 1);  // in front, and so small that few centres are in it
    add({-6, 4}, {-6, 5}, {-5, 4}, 1);  // as well, turned away
    Representation r;
    appendMesh(
        mesh, glm::dvec3(0), [](std::uint32_t) { return SphereLook{}; }, r);
    const TileCall call{kUnturned, 0, 12, 1};
    TileLists lists;
    const auto listed = [&] {
        lists.build(v, {{}, {}, {}, {}, {}, r.triangles, r.meshVertices, {&call, 1}});
        return namedBy(lists, v);
    };
    EXPECT_EQ(listed(), (std::set<std::uint32_t>{5, 6, 7, 8, 9, 10, 11, 12}));
    EXPECT_TRUE(lists.seeded());
    v.frontsOnly = true;
    const std::set<std::uint32_t> fronts = listed();
    EXPECT_TRUE(fronts.contains(11));
    EXPECT_FALSE(fronts.contains(12));
    v.edges = v.frontsOnly = false;
    EXPECT_EQ(listed().size(), 12u);
    EXPECT_FALSE(lists.seeded());
}

TEST(TileLists, LeaveOutTrianglesBetweenTheCentersOfPixels) {
    TileView v = smallView();
    const auto entries = [&](glm::vec2 at, bool centers) {
        Mesh mesh;
        for (const glm::vec2 corner : {at, at + glm::vec2(0.6f, 0), at + glm::vec2(0, 0.6f)})
            mesh.positions.emplace_back(corner, 0), mesh.normals.emplace_back(0, 0, 1), mesh.atoms.push_back(0);
        mesh.triangles = {{0, 1, 2}};
        Representation r;
        appendMesh(
            mesh, glm::dvec3(0), [](std::uint32_t) { return SphereLook{}; }, r);
        const TileCall call{kUnturned, 0, 1, 1};
        v.centers = centers;
        TileLists lists;
        lists.build(v, {{}, {}, {}, {}, {}, r.triangles, r.meshVertices, {&call, 1}});
        return namedBy(lists, v).size();
    };
    EXPECT_EQ(entries({1.7f, 1.7f}, true), 0u);
    EXPECT_EQ(entries({1.7f, 1.7f}, false), 1u);
    EXPECT_EQ(entries({1.7f, 1.2f}, true), 0u);
    EXPECT_EQ(entries({1.2f, 1.2f}, true), 1u);
}

TEST_P(TileListsTest, EveryListGoesFromNearToFar) {
    const auto [perspective, turns] = GetParam();
    for (std::uint32_t seed = 100; seed < 110; ++seed) {
        const ListedScene s = randomListedScene(seed, perspective, turns);
        TileLists lists;
        lists.build(s.view, s.scenery());
        const std::vector<std::uint32_t> numbers = writeLists(lists);
        const auto nearDepth = [&](std::uint32_t number) {
            for (const TileCall& call : s.sphereCalls)
                if (number >= call.number + call.first && number < call.number + call.first + call.count) {
                    const Sphere& ball = s.spheres[number - call.number];
                    return s.view.origin - placed(call.rows, ball.center).z - ball.radius;
                }
            for (const TileCall& call : s.cylinderCalls)
                if (number >= call.number && number < call.number + call.count) {
                    const Cylinder& c = s.cylinders[number - call.number];
                    return s.view.origin - std::max(placed(call.rows, c.a).z, placed(call.rows, c.b).z) - c.radius;
                }
            for (const TileCall& call : s.triangleCalls)
                if (number >= call.number + call.first && number < call.number + call.first + call.count) {
                    const Triangle& t = s.mesh.triangles[number - call.number];
                    const auto z = [&](std::uint32_t k) {
                        return placed(call.rows, decodePosition(s.mesh.meshVertices[k], t.step())).z;
                    };
                    return s.view.origin - std::max({z(t.a), z(t.b), z(t.c)});
                }
            ADD_FAILURE() << "no primitive has the number " << number;
            return 0.0;
        };
        const double step = s.view.range / TileLists::kDepthSteps;
        for (std::size_t bin = 0; bin + 1 < lists.offsets().size(); ++bin)
            for (std::size_t i = lists.offsets()[bin] + 1; i < lists.offsets()[bin + 1]; ++i)
                EXPECT_LT(nearDepth(numbers[i - 1]), nearDepth(numbers[i]) + 1.01 * step);
    }
}

INSTANTIATE_TEST_SUITE_P(Views, TileListsTest, testing::Combine(testing::Bool(), testing::Values(0, 1, 2, 3)));

}  // namespace
}  // namespace nacre::test
