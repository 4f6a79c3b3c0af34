#pragma once
// The boundary of the possible centres of a probe that touches balls: that of a union of larger balls.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/mesh/ball_grid.h"
#include "engine/mesh/surface_field.h"

namespace nacre {

/// Arc of a circle that no other ball covers, from 0 to 2 pi; `begin` may be below 0.
struct OpenArc {
    double begin = 0, end = 0;
};

/// The circle where two spheres meet, or its open arcs.
struct ProbeCircle {
    std::uint32_t a = 0, b = 0;  ///< balls
    glm::dvec3 center{}, axis{}, x{}, y{};
    double radius = 0;
    std::vector<OpenArc> arcs;

    glm::dvec3 at(double angle) const { return center + (x * std::cos(angle) + y * std::sin(angle)) * radius; }
};

/// An open point of three spheres.
struct ProbePoint {
    std::uint32_t a = 0, b = 0, c = 0;  ///< balls
    glm::dvec3 place{};
};

/// Spheres around the balls, larger by the probe's radius, and their intersections.
class ProbePlaces {
public:
    /// @param balls  outlive this
    ProbePlaces(const std::vector<SurfaceBall>& balls, double probe);

    const std::vector<ProbeCircle>& circles() const { return circles_; }
    const std::vector<ProbePoint>& points() const { return points_; }
    /// Whether the probe can touch a ball anywhere.
    bool isOpen(std::uint32_t ball) const { return open_[ball] != 0; }
    std::span<const std::uint32_t> neighbours(std::uint32_t ball) const { return grid_.neighbours(ball); }

    const BallGrid& grid() const { return grid_; }

    /// Radius of the sphere around a ball. Å
    double reachOf(std::uint32_t ball) const { return balls_[ball].radius + probe_; }
    /// Whether a position is inside that sphere.
    bool covers(std::uint32_t ball, const glm::dvec3& place) const {
        const glm::dvec3 way = place - balls_[ball].center;
        const double reach = reachOf(ball) - kTouch;
        return glm::dot(way, way) < reach * reach;
    }

private:
    static constexpr double kTouch = 1e-9;        ///< Å: touching a sphere is not inside
    static constexpr std::size_t kTogether = 64;  ///< balls

    bool isAlone(std::uint32_t ball) const;
    bool circleOf(std::uint32_t a, std::uint32_t b, ProbeCircle& circle) const;
    bool openArcs(ProbeCircle& circle, std::vector<ProbePoint>& points) const;

    const std::vector<SurfaceBall>& balls_;
    double probe_;
    BallGrid grid_;
    std::vector<char> open_;
    std::vector<ProbeCircle> circles_;
    std::vector<ProbePoint> points_;
};

}  // namespace nacre
