#include "engine/mesh/cartoon_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/mesh/mesh_levels.h"
#include "engine/mesh/solids.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

/// Number of rings of a tube's round end, besides its pole.
constexpr int kEndRings = 3;

/// A corner of a cross-section: position, from -1 to 1 along side and normal, and direction of the outline there.
struct OutlinePoint {
    double x = 0, y = 0;
    double alongX = 0, alongY = 0;
};

/// Counter-clockwise seen from the curve's end. A rectangle's corners are duplicated for its faces.
std::vector<OutlinePoint> makeOutline(SectionShape shape, int sides) {
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
          outline_(makeOutline(piece.shape, sides)) {
        for (const OutlinePoint& point : outline_) round_.emplace_back(point.x, point.y);
        for (std::size_t k = piece.first; k <= piece.last; ++k) {
            sides_.push_back(frames[k].side * section(k).width);
            normals_.push_back(frames[k].normal * section(k).thickness);
        }
    }

    void run() {
        const Picks all = allPicks(outline_.size());
        begin_.vertex = nextVertex();
        cap(piece_.first, piece_.roundBegin, owners_[piece_.first], false);
        rings_.push_back({addRing(piece_.first, owners_[piece_.first])});
        rings_[0].after = rings_[0].before;
        for (std::size_t k = piece_.first + 1; k <= piece_.last; ++k) {
            Ring ring{addRing(k, owners_[k - 1])};
            join(mesh_.triangles, rings_.back().after, ring.before, all);
            ring.divides = k == piece_.last || owners_[k] != owners_[k - 1];
            ring.after = k < piece_.last && ring.divides ? addRing(k, owners_[k]) : ring.before;
            leastRings_ += ring.divides;
            rings_.push_back(ring);
        }
        end_.vertex = nextVertex();
        cap(piece_.last, piece_.roundEnd, owners_[piece_.last - 1], true);
        for (MeshLevel& level : mesh_.coarser) addCoarser(level);
    }

private:
    /// First vertices of a ring: for the stretch before it, and for the one after it.
    struct Ring {
        std::uint32_t before = 0, after = 0;
        bool divides = false;  ///< the residue ends here, so every level keeps the ring
    };

    std::uint32_t nextVertex() const { return static_cast<std::uint32_t>(mesh_.positions.size()); }

    /// Largest distance of the outline points of the rings from a polygon of some of them.
    double measureSideError(const Picks& picks) const {
        double most = 0;
        const Section* last = nullptr;
        for (const Section& s : piece_.sections) {
            if (!last || s.width != last->width || s.thickness != last->thickness)
                most = std::max(most, sideError(round_, picks, {s.width, s.thickness}));
            last = &s;
        }
        return most;
    }

    /// For each outline point, a nearby point on the polygon.
    std::vector<glm::dvec2> nearestOn(const Picks& picks) const {
        glm::dvec2 axes(0);
        for (const Section& s : piece_.sections) axes = glm::max(axes, glm::dvec2(s.width, s.thickness));
        std::vector<glm::dvec2> nearest = round_;
        for (std::size_t i = 0; i < picks.size(); ++i) {
            const std::size_t n = round_.size(), to = i + 1 < picks.size() ? picks[i + 1] : picks[0] + n;
            const glm::dvec2 a = round_[picks[i]], along = round_[to % n] - a, scaled = along * axes;
            for (std::size_t k = picks[i] + 1; k < to; ++k) {
                const double t = glm::dot((round_[k % n] - a) * axes, scaled) / glm::dot(scaled, scaled);
                nearest[k % n] = a + along * std::clamp(t, 0.0, 1.0);
            }
        }
        return nearest;
    }

    /// Whether the part between two rings deviates from straight polygons by more than an error. Everything is linear
    /// between rings and points, so the maximum is at a point. Includes folds of non-planar quads.
    bool bends(std::size_t from, std::size_t to, const std::vector<glm::dvec2>& nearest,
               const std::vector<glm::dvec2>& edges, double error) const {
        const glm::dvec3 turnX = sides_[to] - sides_[from], turnY = normals_[to] - normals_[from];
        double fold = 0;
        for (const glm::dvec2& edge : edges) fold = std::max(fold, glm::length(turnX * edge.x + turnY * edge.y));
        const double most = error - fold / 4;
        if (most < 0) return true;
        for (std::size_t k = from; k <= to; ++k) {
            const double t = static_cast<double>(k - from) / static_cast<double>(to - from);
            const auto middle = [&](std::size_t i) { return frames_[piece_.first + i].center; };
            const glm::dvec3 center = middle(k) - (middle(from) * (1 - t) + middle(to) * t);
            const glm::dvec3 x = sides_[from] + turnX * t, y = normals_[from] + turnY * t;
            for (std::size_t i = 0; i < round_.size(); ++i) {
                const glm::dvec2 &p = round_[i], &q = nearest[i];
                const glm::dvec3 away = center + (sides_[k] * p.x - x * q.x) + (normals_[k] * p.y - y * q.y);
                if (glm::dot(away, away) > most * most) return true;
            }
        }
        return false;
    }

    /// Edge vectors of a polygon, in half axes.
    std::vector<glm::dvec2> listEdges(const Picks& picks) const {
        std::vector<glm::dvec2> edges;
        const bool flat = piece_.shape == SectionShape::rectangle;
        for (std::size_t i = 0; i < picks.size(); i += flat ? 2 : 1)
            edges.push_back(round_[picks[(i + 1) % picks.size()]] - round_[picks[i]]);
        return edges;
    }

    /// A coarser form: points per ring, its rings, and the additional error of its ends.
    struct Form {
        Picks picks;
        std::vector<std::size_t> rings;  // indices into rings_
        double rest = 0;
        std::size_t quads() const { return (rings.size() - 1) * picks.size(); }
    };

    /// The form with the fewest rings for an error.
    Form findForm(Picks picks, double error, double rest) const {
        const std::vector<glm::dvec2> nearest = nearestOn(picks), edges = listEdges(picks);
        Form form{std::move(picks), {0}, rest};
        for (std::size_t from = 0, to = 1; from + 1 < rings_.size(); from = to++) {
            while (!rings_[to].divides && !bends(from, to + 1, nearest, edges, error)) ++to;
            form.rings.push_back(to);
        }
        return form;
    }

    /// Fewer sides need more rings: picks the polygon that gives the fewest triangles.
    Form fewest(double error) const {
        if (piece_.shape == SectionShape::rectangle) return findForm(allPicks(outline_.size()), error, error);
        std::optional<Form> best;
        for (Picks& picks : makePolygons(outline_.size())) {
            if (best && picks.size() * leastRings_ >= best->quads()) break;
            const double ofSides = picks.size() < outline_.size() ? measureSideError(picks) : 0;
            if (ofSides > 0.9 * error) continue;
            Form form = findForm(std::move(picks), error, error - ofSides);
            if (!best || form.quads() < best->quads()) best = std::move(form);
        }
        return *best;
    }

    void addCoarser(MeshLevel& level) const {
        const Form form = fewest(static_cast<double>(level.error));
        for (std::size_t i = 1; i < form.rings.size(); ++i)
            join(level.triangles, rings_[form.rings[i - 1]].after, rings_[form.rings[i]].before, form.picks);
        addCoarserCap(level, begin_, piece_.first, form.rest, form.picks, false);
        addCoarserCap(level, end_, piece_.last, form.rest, form.picks, true);
    }

    struct Cap {
        std::uint32_t vertex = 0;  ///< first vertex
        bool round = false;
    };

    void addCoarserCap(MeshLevel& level, const Cap& cap, std::size_t k, double rest, const Picks& picks,
                       bool end) const {
        const std::uint32_t n = static_cast<std::uint32_t>(outline_.size());
        if (!cap.round) return addFan(level.triangles, cap.vertex, picks, end);
        const bool cone = kConeError * std::max(section(k).width, section(k).thickness) <= rest;
        std::uint32_t ring = cap.vertex;
        for (int i = 1; i < kEndRings && !cone; ++i, ring += n) addBand(level.triangles, ring, ring + n, picks, end);
        addTip(level.triangles, ring, cap.vertex + kEndRings * n, picks, end);
    }

    const Section& section(std::size_t k) const { return piece_.sections[k - piece_.first]; }

    glm::dvec3 place(std::size_t k, const OutlinePoint& point) const {
        const Frame& frame = frames_[k];
        return frame.center + frame.side * (point.x * section(k).width) +
               frame.normal * (point.y * section(k).thickness);
    }

    /// Perpendicular to the outline and to the direction in which this corner moves along the curve, so that arrows and
    /// tapers get slanted normals. Where the curve folds onto itself: straight outward.
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

    using Triangles = std::vector<glm::uvec3>;

    /// The wall between two rings.
    void join(Triangles& triangles, std::uint32_t before, std::uint32_t after, const Picks& picks) const {
        const bool flat = piece_.shape == SectionShape::rectangle;
        for (std::size_t i = 0; i < picks.size(); i += flat ? 2 : 1) {
            const std::uint32_t j = picks[i], next = picks[(i + 1) % picks.size()];
            triangles.emplace_back(before + j, before + next, after + next);
            triangles.emplace_back(before + j, after + next, after + j);
        }
    }

    void cap(std::size_t k, bool round, std::uint32_t atom, bool end) {
        const glm::dvec3 out = end ? frames_[k].tangent : -frames_[k].tangent;
        (end ? end_ : begin_).round = round && piece_.shape == SectionShape::oval;
        if ((end ? end_ : begin_).round)
            roundCap(k, atom, out, end);
        else
            flatCap(k, atom, out, end);
    }

    void flatCap(std::size_t k, std::uint32_t atom, const glm::dvec3& out, bool end) {
        const std::size_t step = piece_.shape == SectionShape::rectangle ? 2 : 1;
        const std::uint32_t first = nextVertex();
        for (std::size_t j = 0; j < outline_.size(); j += step)
            addVertex(mesh_, place(k, outline_[j]) - origin_, out, atom);
        addFan(mesh_.triangles, first, allPicks(outline_.size()), end);
    }

    /// A flat end. A rectangle has one vertex for every second outline point.
    void addFan(Triangles& triangles, std::uint32_t first, const Picks& picks, bool end) const {
        const bool flat = piece_.shape == SectionShape::rectangle;
        const std::uint32_t step = flat ? 2 : 1;
        for (std::size_t i = step; i + step < picks.size(); i += step)
            addTurned(triangles, first + picks[0] / step, first + picks[i] / step, first + picks[i + step] / step, end);
    }

    /// From the equator, a copy of the piece's last ring, to the pole.
    void roundCap(std::size_t k, std::uint32_t atom, const glm::dvec3& out, bool end) {
        const double reach = std::min(section(k).width, section(k).thickness);
        const Frame& frame = frames_[k];
        const Picks all = allPicks(outline_.size());
        std::uint32_t before = 0;
        for (int i = 0; i < kEndRings; ++i) {
            const double latitude = std::numbers::pi / 2 * i / kEndRings;
            const std::uint32_t ring = nextVertex();
            for (const OutlinePoint& point : outline_) {
                const glm::dvec3 away = place(k, point) - frame.center;
                addVertex(mesh_,
                          frame.center + away * std::cos(latitude) + out * (reach * std::sin(latitude)) - origin_,
                          unitOr(unitOr(away, out) * std::cos(latitude) + out * std::sin(latitude), out), atom);
            }
            if (i > 0) addBand(mesh_.triangles, before, ring, all, end);
            before = ring;
        }
        const std::uint32_t pole = addVertex(mesh_, frame.center + out * reach - origin_, out, atom);
        addTip(mesh_.triangles, before, pole, all, end);
    }

    static void addBand(Triangles& triangles, std::uint32_t before, std::uint32_t ring, const Picks& picks, bool end) {
        for (std::size_t i = 0; i < picks.size(); ++i) {
            const std::uint32_t j = picks[i], next = picks[(i + 1) % picks.size()];
            addTurned(triangles, before + j, before + next, ring + next, end);
            addTurned(triangles, before + j, ring + next, ring + j, end);
        }
    }

    static void addTip(Triangles& triangles, std::uint32_t ring, std::uint32_t pole, const Picks& picks, bool end) {
        for (std::size_t i = 0; i < picks.size(); ++i)
            addTurned(triangles, ring + picks[i], ring + picks[(i + 1) % picks.size()], pole, end);
    }

    static void addTurned(Triangles& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c, bool asItIs) {
        triangles.emplace_back(a, asItIs ? b : c, asItIs ? c : b);
    }

    Mesh& mesh_;
    std::span<const Frame> frames_;
    const SweepPiece& piece_;
    std::span<const std::uint32_t> owners_;
    glm::dvec3 origin_;
    std::vector<OutlinePoint> outline_;
    std::vector<glm::dvec2> round_;            // outline points only
    std::vector<glm::dvec3> sides_, normals_;  // half axes of the rings, Å
    std::vector<Ring> rings_;                  // starting with frame piece.first
    std::size_t leastRings_ = 0;               // number of rings that end residues
    Cap begin_, end_;
};

}  // namespace

void sweep(Mesh& mesh, std::span<const Frame> frames, const SweepPiece& piece, std::span<const std::uint32_t> owners,
           const glm::dvec3& origin, int sides) {
    Sweeper(mesh, frames, piece, owners, origin, sides).run();
}

}  // namespace nacre
