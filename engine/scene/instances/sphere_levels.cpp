#include "engine/scene/instances/sphere_levels.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numeric>

#include "engine/scene/color/colors.h"
#include "engine/threads.h"

namespace nacre {
namespace {

/// The nearest sphere in each cell of a grid perpendicular to a direction.
class Sight {
public:
    Sight(std::span<const Sphere> spheres, const glm::vec3& way) : way_(way) {
        across_ = glm::normalize(glm::cross(way, std::abs(way.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
        up_ = glm::cross(way, across_);
        glm::vec2 low(std::numeric_limits<float>::max()), high = -low;
        for (const Sphere& s : spheres) {
            low = glm::min(low, seen(s) - s.radius);
            high = glm::max(high, seen(s) + s.radius);
        }
        // Large parts have larger cells: their number stays bounded.
        constexpr float kCell = 1, kCellsPerSide = 1024;
        cell_ = std::max({kCell, (high.x - low.x) / kCellsPerSide, (high.y - low.y) / kCellsPerSide});
        low_ = low;
        wide_ = static_cast<int>((high.x - low.x) / cell_) + 1;
        high_ = static_cast<int>((high.y - low.y) / cell_) + 1;
        near_.assign(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_), {});
        for (std::uint32_t i = 0; i < spheres.size(); ++i) put(spheres[i], i);
    }
    void addTo(std::vector<float>& areas) const {
        for (const Nearest& n : near_)
            if (n.sphere != UINT32_MAX) areas[n.sphere] += cell_ * cell_;
    }

private:
    struct Nearest {
        float at = -std::numeric_limits<float>::max();
        std::uint32_t sphere = UINT32_MAX;
    };
    glm::vec2 seen(const Sphere& s) const { return {glm::dot(s.center, across_), glm::dot(s.center, up_)}; }
    void put(const Sphere& s, std::uint32_t number) {
        const glm::vec2 at = (seen(s) - low_) / cell_;
        const float reach = s.radius / cell_, depth = glm::dot(s.center, way_);
        const auto first = [&](float c) { return std::max(static_cast<int>(std::ceil(c - reach - 0.5f)), 0); };
        for (int y = first(at.y); y < high_ && static_cast<float>(y) + 0.5f <= at.y + reach; ++y)
            for (int x = first(at.x); x < wide_ && static_cast<float>(x) + 0.5f <= at.x + reach; ++x) {
                const glm::vec2 aside = glm::vec2(x, y) + 0.5f - at;
                const float h = reach * reach - glm::dot(aside, aside);
                Nearest& n =
                    near_[static_cast<std::size_t>(y) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(x)];
                if (h > 0 && depth + std::sqrt(h) * cell_ > n.at) n = {depth + std::sqrt(h) * cell_, number};
            }
    }

    glm::vec3 way_, across_{}, up_{};
    glm::vec2 low_{};
    float cell_ = 1;
    int wide_ = 0, high_ = 0;
    std::vector<Nearest> near_;
};

/// Unit vectors to the corners, edges and faces of a cube.
const std::vector<glm::vec3>& cubeDirections() {
    static const std::vector<glm::vec3> kWays = [] {
        std::vector<glm::vec3> ways;
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (x != 0 || y != 0 || z != 0) ways.push_back(glm::normalize(glm::vec3(x, y, z)));
        return ways;
    }();
    return kWays;
}

/// Estimates each sphere's area visible in parallel projection from these directions, Å², summed over them.
std::vector<float> exposedAreas(std::span<const Sphere> spheres) {
    std::vector<float> areas(spheres.size());
    for (const glm::vec3& way : cubeDirections()) Sight(spheres, way).addTo(areas);
    return areas;
}

constexpr float kFarOff = std::numeric_limits<float>::max();

/// A tree of a part's atoms that halves boxes, with a sphere for each node.
class Tree {
public:
    /// A sphere that represents atoms order()[first] to order()[end - 1].
    struct Node {
        std::uint32_t first = 0, end = 0;
        std::uint32_t halves = 0;  ///< number of the first of two halves; 0: an atom
        Sphere sphere{};
        float error = 0;  ///< Å: half the range of its atoms' reach over directions
    };

    explicit Tree(std::span<const Sphere> spheres) : spheres_(spheres), order_(spheres.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        nodes_.reserve(2 * spheres.size());
        nodes_.push_back({0, static_cast<std::uint32_t>(order_.size()), 0, {}, 0});
        for (std::size_t i = 0; i < nodes_.size(); ++i) split(i);
    }
    std::span<const std::uint32_t> atoms(const Node& node) const {
        return std::span(order_).subspan(node.first, node.end - node.first);
    }
    /// The largest nodes within an error, in spatial order.
    std::vector<const Node*> within(float error) const {
        std::vector<const Node*> found;
        std::vector<std::uint32_t> open{0};
        while (!open.empty()) {
            const Node& node = nodes_[open.back()];
            open.pop_back();
            if (node.halves == 0 || node.error <= error)
                found.push_back(&node);
            else
                open.insert(open.end(), {node.halves + 1, node.halves});
        }
        return found;
    }

private:
    void split(std::size_t number) {
        Node node = nodes_[number];
        const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        if (node.end - node.first == 1) {
            nodes_[number].sphere = spheres_[order_[node.first]];
            return;
        }
        fit(node);
        glm::vec3 low(kFarOff), high(-kFarOff);
        for (const std::uint32_t i : atoms(node)) {
            low = glm::min(low, spheres_[i].center);
            high = glm::max(high, spheres_[i].center);
        }
        const glm::vec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t middle = node.first + (node.end - node.first) / 2;
        std::nth_element(at(node.first), at(middle), at(node.end), [&](std::uint32_t a, std::uint32_t b) {
            const float x = spheres_[a].center[axis], y = spheres_[b].center[axis];
            return x != y ? x < y : a < b;
        });
        node.halves = static_cast<std::uint32_t>(nodes_.size());
        nodes_[number] = node;
        nodes_.push_back({node.first, middle, 0, {}, 0});
        nodes_.push_back({middle, node.end, 0, {}, 0});
    }

    /// Sets the radius midway between the least and the largest reach of its atoms from their middle.
    void fit(Node& node) const {
        glm::vec3 low(kFarOff), high(-kFarOff);
        for (const std::uint32_t i : atoms(node)) {
            low = glm::min(low, spheres_[i].center - spheres_[i].radius);
            high = glm::max(high, spheres_[i].center + spheres_[i].radius);
        }
        node.sphere.center = low * 0.5f + high * 0.5f;
        float nearest = kFarOff, farthest = 0;
        for (const glm::vec3& way : cubeDirections()) {
            float reach = -kFarOff;
            for (const std::uint32_t i : atoms(node))
                reach = std::max(reach, glm::dot(spheres_[i].center - node.sphere.center, way) + spheres_[i].radius);
            nearest = std::min(nearest, reach);
            farthest = std::max(farthest, reach);
        }
        constexpr float kBetween = 1.25f;  // allowance for other directions, and for gaps between atoms
        node.error = kBetween * 0.5f * (farthest - nearest);
        node.sphere.radius = (farthest + nearest) * 0.5f;
    }

    std::span<const Sphere> spheres_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// The atoms' mean colour, weighted by visible area, and the number of the most visible one.
SphereLook averageLook(std::span<const SphereLook> looks, std::span<const float> areas,
                       std::span<const std::uint32_t> atoms) {
    const std::uint32_t most = *std::ranges::max_element(atoms, [&](auto a, auto b) { return areas[a] < areas[b]; });
    SphereLook look = looks[most];
    std::vector<std::uint32_t> colors;
    std::vector<float> shares;
    for (const std::uint32_t i : atoms) {
        if (isCopyTint(looks[i].color)) return look;
        colors.push_back(looks[i].color);
        shares.push_back(areas[i] + 1e-3f);  // if none is visible at all, all weigh the same
    }
    if (atoms.size() > 1) look.color = meanColor(colors, shares);
    return look;
}

/// One part with its levels, numbered from 0.
SphereLevels levelsOfPart(const Representation& r, const PrimitiveRun& run) {
    constexpr std::uint32_t kSpheres = SphereLevels::kSpheres;
    constexpr float kFewer = 0.8f;  // the next level has at most this fraction of a level's spheres
    const std::span<const Sphere> spheres(r.spheres.data() + run.first, run.count);
    const std::span<const SphereLook> looks(r.sphereLooks.data() + run.first, run.count);
    const std::vector<float> areas = exposedAreas(spheres);
    const Tree tree(spheres);
    SphereLevels made;
    LeveledPart part;
    part.list = run.list;
    for (std::uint32_t step = 0; part.levels.empty() || part.levels.back().count > 1; ++step) {
        const std::vector<const Tree::Node*> nodes = tree.within(SphereLevels::levelError(step));
        if (!part.levels.empty() && nodes.size() > 1 &&
            static_cast<float>(nodes.size()) > kFewer * static_cast<float>(part.levels.back().count))
            continue;
        part.levels.push_back(
            {static_cast<std::uint32_t>(made.spheres.size()), static_cast<std::uint32_t>(nodes.size()), step});
        for (const Tree::Node* node : nodes) {
            made.spheres.push_back(node->sphere);
            made.looks.push_back(averageLook(looks, areas, tree.atoms(*node)));
        }
        const std::size_t padded = (made.spheres.size() + kSpheres - 1) / kSpheres * kSpheres;
        made.spheres.resize(padded);
        made.looks.resize(padded);
    }
    made.parts.push_back(std::move(part));
    return made;
}

SphereLevels::Ball boundingBall(std::span<const Sphere> spheres) {
    glm::vec3 low(kFarOff), high(-kFarOff);
    for (const Sphere& s : spheres) {
        low = glm::min(low, s.center - s.radius);
        high = glm::max(high, s.center + s.radius);
    }
    SphereLevels::Ball ball{low * 0.5f + high * 0.5f, 0};
    for (const Sphere& s : spheres)
        ball.radius = std::max(ball.radius, (glm::distance(s.center, ball.center) + s.radius) * 1.00001f);
    return ball;
}

void addBalls(SphereLevels& all) {
    constexpr std::uint32_t kSpheres = SphereLevels::kSpheres;
    all.balls.resize(all.spheres.size() / kSpheres);
    for (LeveledPart& part : all.parts) {
        std::vector<Sphere> bounds;
        for (const SphereLevel& level : part.levels)
            for (std::uint32_t first = 0; first < level.count; first += kSpheres) {
                const std::uint32_t count = std::min(kSpheres, level.count - first);
                const auto ball = boundingBall(std::span(all.spheres).subspan(level.first + first, count));
                all.balls[(level.first + first) / kSpheres] = ball;
                bounds.push_back({ball.center, ball.radius});
            }
        const SphereLevels::Ball whole = boundingBall(bounds);
        part.center = whole.center;
        part.radius = whole.radius;
    }
}

}  // namespace

std::uint64_t spheresInCopies(const Representation& r) {
    std::uint64_t sum = 0;
    for (const PrimitiveRun& run : r.copies.spheres) sum += run.count * std::uint64_t{r.copies.lists[run.list].size()};
    return sum;
}

bool hasNumbers(const Representation& r) {
    const std::uint64_t primitives =
        r.spheres.size() + r.cylinders.size() + r.triangles.size() + r.coarseTriangles.size();
    return primitives * std::max<std::uint64_t>(r.copies.transforms.size(), 1) < UINT32_MAX;
}

bool canHaveLevels(const Representation& r) {
    return !r.copies.transforms.empty() && r.ellipsoids.empty() && r.cylinders.empty() && r.wires.empty() &&
           r.triangles.empty() && std::all_of(r.spheres.begin(), r.spheres.end(), [](const Sphere& s) {
               return std::isfinite(s.center.x + s.center.y + s.center.z) && s.radius > 0;
           });
}

SphereLevels makeSphereLevels(const Representation& r) {
    std::vector<SphereLevels> ofRuns(r.copies.spheres.size());
    inParallel(ofRuns.size(), [&](std::size_t i) { ofRuns[i] = levelsOfPart(r, r.copies.spheres[i]); });
    SphereLevels all;
    for (SphereLevels& one : ofRuns) {
        const auto first = static_cast<std::uint32_t>(all.spheres.size());
        for (SphereLevel& level : one.parts.front().levels) level.first += first;
        all.spheres.insert(all.spheres.end(), one.spheres.begin(), one.spheres.end());
        all.looks.insert(all.looks.end(), one.looks.begin(), one.looks.end());
        all.parts.push_back(std::move(one.parts.front()));
        one = {};
    }
    addBalls(all);
    return all;
}

}  // namespace nacre
