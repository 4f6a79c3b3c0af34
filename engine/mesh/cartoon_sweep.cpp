#include "engine/mesh/cartoon_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/mesh/solids.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

/// How many rings make the round end of a tube, besides its pole.
constexpr int kEndRings = 3;

/// A corner of a cross-section: where it is, from -1 to 1 along side and normal, and which way its outline goes there.
struct OutlinePoint {
    double x = 0, y = 0;
    double alongX = 0, alongY = 0;
};

/// Counter-clockwise seen from the curve's end. A rectangle's corners stand twice, for each of its faces.
std::vector<OutlinePoint> outlineOf(SectionShape shape, int sides) {
    if (shape == SectionShape::rectangle)
        return {{1, -1, 0, 1},  {1, 1, 0, 1},    {1, 1, -1, 0},  {-1, 1, -1, 0},
                {-1, 1, 0, -1}, {-1, -1, 0, -1}, {-1, -1, 1, 0}, {1, -1, 1, 0}};
    std::vector<OutlinePoint> outline;
    for (int j = 0; j < sides; ++j) {
        const double angle = 2 * std::numbers::pi * j / sides;
        outline.push_back({std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle)});
    }
    return outline;
}

class Sweeper {
public:
    Sweeper(Mesh& mesh, std::span<const Frame> frames, const SweepPiece& piece, std::span<const std::uint32_t> owners,
            const glm::dvec3& origin, int sides)
        : mesh_(mesh),
          frames_(frames),
          piece_(piece),
          owners_(owners),
          origin_(origin),
          outline_(outlineOf(piece.shape, sides)) {}

    void run() {
        cap(piece_.first, piece_.roundBegin, owners_[piece_.first], false);
        std::uint32_t before = addRing(piece_.first, owners_[piece_.first]);
        for (std::size_t k = piece_.first + 1; k <= piece_.last; ++k) {
            const std::uint32_t ring = addRing(k, owners_[k - 1]);
            join(before, ring);
            before = k < piece_.last && owners_[k] != owners_[k - 1] ? addRing(k, owners_[k]) : ring;
        }
        cap(piece_.last, piece_.roundEnd, owners_[piece_.last - 1], true);
    }

private:
    const Section& section(std::size_t k) const { return piece_.sections[k - piece_.first]; }

    glm::dvec3 place(std::size_t k, const OutlinePoint& point) const {
        const Frame& frame = frames_[k];
        return frame.center + frame.side * (point.x * section(k).width) +
               frame.normal * (point.y * section(k).thickness);
    }

    /// Across the outline and the way that this corner goes along the curve, so that arrows and tapers are lit as they
    /// lean. Where the curve folds upon itself: straight away from it.
    glm::dvec3 normal(std::size_t k, const OutlinePoint& point) const {
        const Frame& frame = frames_[k];
        const double w = std::max(section(k).width, 1e-6), h = std::max(section(k).thickness, 1e-6);
        const glm::dvec3 plain =
            unitOr(frame.side * (point.alongY / w) - frame.normal * (point.alongX / h), frame.side);
        const std::size_t a = k == piece_.first ? k : k - 1, b = k == piece_.last ? k : k + 1;
        const glm::dvec3 along = place(b, point) - place(a, point);
        const glm::dvec3 around = frame.side * (point.alongX * w) + frame.normal * (point.alongY * h);
        const glm::dvec3 exact = unitOr(glm::cross(around, along), plain);
        return glm::dot(exact, plain) > 0.3 ? exact : plain;
    }

    std::uint32_t addRing(std::size_t k, std::uint32_t atom) {
        const std::uint32_t first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (const OutlinePoint& point : outline_) addVertex(mesh_, place(k, point) - origin_, normal(k, point), atom);
        return first;
    }

    void join(std::uint32_t before, std::uint32_t after) {
        const bool flat = piece_.shape == SectionShape::rectangle;
        const std::uint32_t n = static_cast<std::uint32_t>(outline_.size());
        for (std::uint32_t j = 0; j < n; j += flat ? 2 : 1) {
            const std::uint32_t next = (j + 1) % n;
            mesh_.triangles.emplace_back(before + j, before + next, after + next);
            mesh_.triangles.emplace_back(before + j, after + next, after + j);
        }
    }

    void cap(std::size_t k, bool round, std::uint32_t atom, bool end) {
        const glm::dvec3 out = end ? frames_[k].tangent : -frames_[k].tangent;
        if (round && piece_.shape == SectionShape::oval)
            roundCap(k, atom, out, end);
        else
            flatCap(k, atom, out, end);
    }

    void flatCap(std::size_t k, std::uint32_t atom, const glm::dvec3& out, bool end) {
        const std::size_t step = piece_.shape == SectionShape::rectangle ? 2 : 1;
        const std::uint32_t first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (std::size_t j = 0; j < outline_.size(); j += step)
            addVertex(mesh_, place(k, outline_[j]) - origin_, out, atom);
        const std::uint32_t last = static_cast<std::uint32_t>(mesh_.positions.size()) - 1;
        for (std::uint32_t v = first + 1; v < last; ++v)
            mesh_.triangles.emplace_back(first, end ? v : v + 1, end ? v + 1 : v);
    }

    /// From the equator, which is the piece's own last ring again, to the pole.
    void roundCap(std::size_t k, std::uint32_t atom, const glm::dvec3& out, bool end) {
        const double reach = std::min(section(k).width, section(k).thickness);
        const Frame& frame = frames_[k];
        const std::uint32_t n = static_cast<std::uint32_t>(outline_.size());
        std::uint32_t before = 0;
        for (int i = 0; i < kEndRings; ++i) {
            const double latitude = std::numbers::pi / 2 * i / kEndRings;
            const std::uint32_t ring = static_cast<std::uint32_t>(mesh_.positions.size());
            for (const OutlinePoint& point : outline_) {
                const glm::dvec3 away = place(k, point) - frame.center;
                addVertex(mesh_,
                          frame.center + away * std::cos(latitude) + out * (reach * std::sin(latitude)) - origin_,
                          unitOr(unitOr(away, out) * std::cos(latitude) + out * std::sin(latitude), out), atom);
            }
            for (std::uint32_t j = 0; i > 0 && j < n; ++j) {
                const std::uint32_t a = before + j, b = before + (j + 1) % n, c = ring + j, d = ring + (j + 1) % n;
                addTurned(a, b, d, end);
                addTurned(a, d, c, end);
            }
            before = ring;
        }
        const std::uint32_t pole = addVertex(mesh_, frame.center + out * reach - origin_, out, atom);
        for (std::uint32_t j = 0; j < n; ++j) addTurned(before + j, before + (j + 1) % n, pole, end);
    }

    void addTurned(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool asItIs) {
        mesh_.triangles.emplace_back(a, asItIs ? b : c, asItIs ? c : b);
    }

    Mesh& mesh_;
    std::span<const Frame> frames_;
    const SweepPiece& piece_;
    std::span<const std::uint32_t> owners_;
    glm::dvec3 origin_;
    std::vector<OutlinePoint> outline_;
};

}  // namespace

void sweep(Mesh& mesh, std::span<const Frame> frames, const SweepPiece& piece, std::span<const std::uint32_t> owners,
           const glm::dvec3& origin, int sides) {
    Sweeper(mesh, frames, piece, owners, origin, sides).run();
}

}  // namespace nacre
