#include "engine/mesh/ball_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "engine/error.h"

namespace nacre {
namespace {

constexpr double kMostCells = 4e6;  // atoms that are far apart get larger cells

}  // namespace

BallGrid::BallGrid(const std::vector<SurfaceBall>& balls, double margin) {
    double largest = 0;
    glm::dvec3 high{};
    if (!balls.empty()) low_ = high = balls[0].center;
    for (const SurfaceBall& ball : balls) {
        largest = std::max(largest, ball.radius + margin);
        low_ = glm::min(low_, ball.center);
        high = glm::max(high, ball.center);
    }
    cell_ = std::max(2 * largest, 1.0);
    const auto countCells = [&] {
        const glm::dvec3 n = glm::floor((high - low_) / cell_) + 1.0;
        return n.x * n.y * n.z;
    };
    // Few balls far apart need few cells: clearing millions would take longer than their surface.
    const double most = std::min<double>(kMostCells, 4096.0 + 32.0 * static_cast<double>(balls.size()));
    while (countCells() > most) cell_ *= 1.26;
    cells_ = glm::ivec3(glm::floor((high - low_) / cell_)) + 1;
    sortIntoCells(balls);

    offsets_.reserve(balls.size() + 1);
    offsets_.push_back(0);
    std::vector<std::pair<double, std::uint32_t>> found;
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
        found.clear();
        near(balls[i].center, balls[i].radius + margin + largest, [&](std::uint32_t other) {
            const double distance = glm::distance(balls[i].center, balls[other].center);
            if (other != i && distance < balls[i].radius + balls[other].radius + 2 * margin)
                found.emplace_back(distance, other);
        });
        std::sort(found.begin(), found.end());
        for (const auto& [distance, other] : found) neighbours_.push_back(other);
        offsets_.push_back(neighbours_.size());
        checkCrowd();
    }
}

void BallGrid::checkCrowd() const {
    constexpr std::size_t kMostOfAny = 32'000'000, kMostOfEach = 256;
    if (neighbours_.size() > kMostOfAny + kMostOfEach * sorted_.size())
        throw Error("cannot make surface", "",
                    "its atoms lie over one another: they have more than " + std::to_string(neighbours_.size()) +
                        " neighbours (draw fewer of them, or use a smaller probe)");
}

glm::ivec3 BallGrid::cellAt(const glm::dvec3& place) const {
    return glm::ivec3(glm::clamp(glm::floor((place - low_) / cell_), glm::dvec3(0), glm::dvec3(cells_ - 1)));
}

void BallGrid::sortIntoCells(const std::vector<SurfaceBall>& balls) {
    const auto number = [&](const SurfaceBall& ball) {
        const glm::ivec3 c = cellAt(ball.center);
        return (static_cast<std::size_t>(c.z) * cells_.y + c.y) * cells_.x + c.x;
    };
    cellStarts_.assign(static_cast<std::size_t>(cells_.x) * cells_.y * cells_.z + 1, 0);
    for (const SurfaceBall& ball : balls) ++cellStarts_[number(ball) + 1];
    for (std::size_t i = 1; i < cellStarts_.size(); ++i) cellStarts_[i] += cellStarts_[i - 1];
    sorted_.resize(balls.size());
    std::vector<std::uint32_t> places(cellStarts_.begin(), cellStarts_.end() - 1);
    for (std::uint32_t i = 0; i < balls.size(); ++i) sorted_[places[number(balls[i])]++] = i;
}

BallExit findExit(const std::vector<SurfaceBall>& balls, const BallGrid& grid, double widest, const glm::dvec3& from,
                  const glm::dvec3& way) {
    struct Span {
        double begin = 0, end = 0;
        std::uint32_t ball = 0;
    };
    std::vector<Span> spans;  // of the line, in each ball near it
    const double squared = glm::dot(way, way);
    grid.near(from, widest + std::sqrt(squared), [&](std::uint32_t number) {
        const glm::dvec3 off = from - balls[number].center;
        const double half = glm::dot(off, way), radius = balls[number].radius;
        const double under = half * half - squared * (glm::dot(off, off) - radius * radius);
        if (under <= 0) return;
        const double root = std::sqrt(under);
        if (root > half) spans.push_back({(-half - root) / squared, (root - half) / squared, number});
    });
    BallExit exit;
    for (bool further = true; further;) {
        further = false;
        for (const Span& span : spans)
            if (span.begin <= exit.share && span.end > exit.share) {
                exit = {span.end, span.ball};
                further = true;
            }
    }
    return exit;
}

}  // namespace nacre
