#pragma once
// Boundary of the possible centres of a probe that touches balls: the boundary of a union of larger balls.

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/mesh/ball_grid.h"
#include "engine/mesh/surface_field.h"

namespace nacre {

/// Arc of a circle, between two directions in the circle's plane, that no other ball covers.
struct OpenArc {
    static constexpr double kTurn = 4;  ///< a full turn, in the measure of turnTo()
    glm::dvec2 begin{1, 0}, end{1, 0};  ///< unit vectors, counter-clockwise
    double span = kTurn;

    /// Grows with the angle of a direction, from 0 to kTurn, without trigonometric functions.
    static double turnTo(const glm::dvec2& way) {
        if (way.y >= 0) return way.x >= 0 ? way.y / (way.x + way.y) : 1 - way.x / (way.y - way.x);
        return way.x < 0 ? 2 - way.y / (-way.x - way.y) : 3 + way.x / (way.x - way.y);
    }
    bool holds(const glm::dvec2& way) const {
        const bool afterBegin = begin.x * way.y - begin.y * way.x >= 0, beforeEnd = way.x * end.y - way.y * end.x >= 0;
        if (span > kTurn / 2) return span >= kTurn || afterBegin || beforeEnd;
        return afterBegin && beforeEnd && glm::dot(way, begin + end) >= 0;
    }
};

/// The circle where two spheres meet, or its open arcs.
struct ProbeCircle {
    std::uint32_t a = 0, b = 0;  ///< balls
    glm::dvec3 center{}, axis{}, x{}, y{};
    double radius = 0;
    std::vector<OpenArc> arcs;

    glm::dvec3 at(const glm::dvec2& way) const { return center + (x * way.x + y * way.y) * radius; }
    bool isOpen(const glm::dvec2& way) const {
        for (const OpenArc& arc : arcs)
            if (arc.holds(way)) return true;
        return false;
    }
};

using ProbeBox = std::array<glm::dvec3, 2>;  ///< low, high

/// An open point where three spheres meet.
struct ProbePoint {
    std::uint32_t a = 0, b = 0, c = 0;  ///< indices of balls
    glm::dvec3 place{};
};

/// Part of a circle that a ball covers.
struct CoveredArc {
    double begin = 0, end = 0;  ///< as OpenArc::turnTo(); `end` may be beyond a turn
    glm::dvec2 beginWay{}, endWay{};
    std::uint32_t by = 0;
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
    /// Bounding box of the open arcs of a circle.
    static ProbeBox boundingBox(const ProbeCircle& circle);
    /// Bounding box of the open part of each ball's sphere; empty (low above high) if there is none.
    std::vector<ProbeBox> openBoxes() const;
    std::span<const std::uint32_t> neighbours(std::uint32_t ball) const { return grid_.neighbours(ball); }

    const BallGrid& grid() const { return grid_; }

    /// Radius of the sphere around a ball, Å.
    double reachRadius(std::uint32_t ball) const { return balls_[ball].radius + probe_; }
    /// Whether a position is inside that sphere.
    bool covers(std::uint32_t ball, const glm::dvec3& place) const {
        const glm::dvec3 way = place - balls_[ball].center;
        const double reach = reachRadius(ball) - kTouch;
        return glm::dot(way, way) < reach * reach;
    }

private:
    static constexpr double kTouch = 1e-9;        ///< Å: touching a sphere is not inside
    static constexpr double kSame = 1e-6;         ///< Å: maximum distance of duplicate points
    static constexpr std::size_t kTogether = 64;  ///< balls per batch

    void dropRepeated();
    bool isAlone(std::uint32_t ball) const;
    bool isCovered(std::uint32_t ball, const glm::dvec3& place) const;
    bool findCircle(std::uint32_t a, std::uint32_t b, ProbeCircle& circle) const;
    bool coveredArcs(const ProbeCircle& circle, std::vector<CoveredArc>& covered) const;
    bool openArcs(ProbeCircle& circle, std::vector<CoveredArc>& covered, std::vector<ProbePoint>& points) const;

    const std::vector<SurfaceBall>& balls_;
    double probe_;
    BallGrid grid_;
    std::vector<char> open_;
    std::vector<ProbeCircle> circles_;
    std::vector<ProbePoint> points_;
};

}  // namespace nacre
