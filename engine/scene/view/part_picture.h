#pragma once
// A small picture of a part of a scene, drawn on the host, and the spheres in front of it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "engine/scene/view/camera.h"

namespace nacre {

/// A small picture of the part alone: its depth in each cell of the plane z = 0.
class PartPicture {
public:
    static constexpr double kEmpty = -std::numeric_limits<double>::infinity();

    explicit PartPicture(const View& view)
        : perEye_(view.projection == Projection::perspective ? 1 / view.eyeDistance : 0) {}

    void reachBall(const glm::dvec3& center, double radius) {
        for (const double sign : {-1.0, 1.0}) {
            const double larger = magnified(center.z + sign * radius);
            low_ = glm::min(low_, (glm::dvec2(center) - radius) * larger);
            high_ = glm::max(high_, (glm::dvec2(center) + radius) * larger);
        }
    }
    /// Call once everything was added to the bounds.
    void begin() {
        constexpr double kMost = 256, kLeast = 0.05;  // cells per side; Å
        const glm::dvec2 size = high_ - low_;
        cell_ = std::max(std::max(size.x, size.y) / kMost, kLeast);
        width_ = static_cast<int>(std::ceil(size.x / cell_)) + 1;
        height_ = static_cast<int>(std::ceil(size.y / cell_)) + 1;
        front_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), kEmpty);
    }

    /// Calls visit(cell, nearest z, farthest z) for all cells whose ray meets a ball.
    template <typename Visit>
    void eachOfBall(const glm::dvec3& center, double radius, const Visit& visit) const {
        const double nearer = magnified(center.z + radius), farther = magnified(center.z - radius);
        const glm::dvec2 least = glm::dvec2(center) - radius, most = glm::dvec2(center) + radius;
        eachIn(glm::min(least * nearer, least * farther), glm::max(most * nearer, most * farther),
               [&](std::size_t cell, const glm::dvec2& u) {
                   // The ray through u reaches z at u (1 - z / eye): one equation for both projections.
                   const glm::dvec2 off = u - glm::dvec2(center);
                   const double a = perEye_ * perEye_ * glm::dot(u, u) + 1, b = perEye_ * glm::dot(u, off) + center.z;
                   const double root = b * b - a * (glm::dot(off, off) + center.z * center.z - radius * radius);
                   if (root >= 0) visit(cell, (b + std::sqrt(root)) / a, (b - std::sqrt(root)) / a);
               });
    }
    /// Calls visit(cell, z, z) for all cells whose ray meets a triangle.
    template <typename Visit>
    void eachOfTriangle(const std::array<glm::dvec3, 3>& corners, const Visit& visit) const {
        std::array<glm::dvec3, 3> at;  // on the plane, where depth is linear
        for (std::size_t i = 0; i < 3; ++i) {
            const double larger = magnified(corners[i].z);
            at[i] = {glm::dvec2(corners[i]) * larger, perEye_ > 0 ? larger : corners[i].z};
        }
        const auto side = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
        eachIn(glm::min(glm::min(at[0], at[1]), at[2]), glm::max(glm::max(at[0], at[1]), at[2]),
               [&](std::size_t cell, const glm::dvec2& u) {
                   std::array<double, 3> shares;
                   for (std::size_t i = 0; i < 3; ++i)
                       shares[i] = side(glm::dvec2(at[(i + 1) % 3]) - u, glm::dvec2(at[(i + 2) % 3]) - u);
                   const double sum = shares[0] + shares[1] + shares[2];
                   const auto [least, most] = std::minmax({shares[0], shares[1], shares[2]});
                   if (sum == 0 || (least < 0 && most > 0)) return;
                   const double linear = (shares[0] * at[0].z + shares[1] * at[1].z + shares[2] * at[2].z) / sum;
                   const double z = perEye_ > 0 ? (1 - 1 / linear) / perEye_ : linear;
                   visit(cell, z, z);
               });
    }

    void draw(std::size_t cell, double z) { front_[cell] = std::max(front_[cell], z); }
    bool isCoveredBy(std::size_t cell, double z) const {
        constexpr double kClear = 0.01;  // Å
        return front_[cell] > kEmpty && z > front_[cell] + kClear;
    }
    std::size_t cells() const {
        return front_.size() - static_cast<std::size_t>(std::count(front_.begin(), front_.end(), kEmpty));
    }
    /// Largest z of everything drawn, Å towards the viewer.
    double nearest() const { return *std::max_element(front_.begin(), front_.end()); }
    std::size_t size() const { return front_.size(); }

private:
    double magnified(double z) const { return 1 / (1 - perEye_ * z); }

    template <typename Visit>
    void eachIn(const glm::dvec2& least, const glm::dvec2& most, const Visit& visit) const {
        const glm::ivec2 from = glm::max(glm::ivec2(glm::ceil(glm::clamp((least - low_) / cell_, -1.0, 1e6))), 0);
        const glm::ivec2 end = glm::min(glm::ivec2(glm::floor(glm::clamp((most - low_) / cell_, -1.0, 1e6))) + 1,
                                        glm::ivec2(width_, height_));
        for (int y = from.y; y < end.y; ++y)
            for (int x = from.x; x < end.x; ++x)
                visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x),
                      low_ + glm::dvec2(x, y) * cell_);
    }

    double perEye_;
    glm::dvec2 low_{std::numeric_limits<double>::infinity()}, high_{kEmpty};
    double cell_ = 1;
    int width_ = 0, height_ = 0;
    std::vector<double> front_;
};

}  // namespace nacre
