#include "engine/mesh/cartoon_curve.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

using glm::dvec3;

// fraction of the chord between the neighbours; limits tangents where a chain turns back sharply
constexpr double kLongestTangent = 1.0;
constexpr double kSharpTurn = 0.8;         // radians, between two helices' axes
constexpr double kFarthestFromAxis = 1.5;  // largest distance of a helix's axis from its straight cylinder, Å

/// Guides of the curve, after processing helices and strands.
struct Guides {
    std::vector<dvec3> points, tangents;
    std::vector<dvec3> sides;  ///< for residues in helices and strands; zero elsewhere
};

double angleBetween(const dvec3& a, const dvec3& b) {
    const double lengths = glm::length(a) * glm::length(b);
    return lengths > 0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)) : 0;
}

/// A window of four alpha carbons on a helix. The bisectors at the two inner ones are perpendicular to the axis; their
/// cross product is parallel to it.
dvec3 axisOfFour(const std::vector<dvec3>& p, std::size_t i) {
    const dvec3 a = p[i] + p[i + 2] - 2.0 * p[i + 1], b = p[i + 1] + p[i + 3] - 2.0 * p[i + 2];
    return unitOr(glm::cross(a, b), {});
}

/// Axis direction at each residue of a helix: the mean over all windows that contain it.
std::vector<dvec3> helixAxes(const std::vector<dvec3>& points, const FoldRun& run) {
    const std::size_t length = run.last - run.first + 1;
    // Three residues are too few for a window: include the neighbours.
    const std::size_t from = length >= 4 || run.first == 0 ? run.first : run.first - 1;
    const std::size_t to = std::min<std::size_t>(length >= 4 ? run.last : run.last + 1, points.size() - 1);
    std::vector<dvec3> sums(length);
    dvec3 before{};
    for (std::size_t i = from; i + 3 <= to; ++i) {
        dvec3 axis = axisOfFour(points, i);
        if (glm::dot(axis, before) < 0) axis = -axis;
        if (axis != dvec3()) before = axis;
        for (std::size_t k = std::max<std::size_t>(i, run.first); k <= std::min<std::size_t>(i + 3, run.last); ++k)
            sums[k - run.first] += axis;
    }
    const dvec3 along = unitOr(points[run.last] - points[run.first], dvec3(0, 0, 1));
    for (dvec3& axis : sums) axis = unitOr(axis, along);
    // A left-handed helix, or a bad window, must not reverse the axis.
    if (glm::dot(sums[length / 2], along) < 0)
        for (dvec3& axis : sums) axis = -axis;
    return sums;
}

/// Points on the axis of a helix, one per residue. The weights cancel the turn of 100 degrees per residue exactly.
std::vector<dvec3> axisPoints(const std::vector<dvec3>& points, const FoldRun& run, const std::vector<dvec3>& axes) {
    static constexpr double kWeights[] = {0.347, 1, 1, 1, 0.347};
    const std::size_t length = run.last - run.first + 1;
    std::vector<dvec3> axis(length);
    if (length < 5) {
        dvec3 middle{};
        for (std::size_t i = run.first; i <= run.last; ++i) middle += points[i] / static_cast<double>(length);
        for (std::size_t i = 0; i < length; ++i)
            axis[i] = middle + axes[i] * glm::dot(points[run.first + i] - middle, axes[i]);
        return axis;
    }
    for (std::size_t i = 2; i + 2 < length; ++i) {
        for (std::size_t k = 0; k < 5; ++k) axis[i] += kWeights[k] * points[run.first + i + k - 2];
        axis[i] /= 3.694;
    }
    const auto extend = [&](std::size_t to, std::size_t from) {
        axis[to] = axis[from] + axes[from] * glm::dot(points[run.first + to] - axis[from], axes[from]);
    };
    for (const std::size_t i : {std::size_t{1}, std::size_t{0}}) extend(i, 2);
    for (const std::size_t i : {length - 2, length - 1}) extend(i, length - 3);
    // Smooths the remaining turn.
    std::vector<dvec3> smooth = axis;
    for (std::size_t i = 1; i + 1 < length; ++i) smooth[i] = (axis[i - 1] + 2.0 * axis[i] + axis[i + 1]) / 4.0;
    return smooth;
}

/// Straightens the points from first to last: one line through the mean along the mean direction, or two lines that
/// meet where one would leave the axis by too much.
void straighten(std::vector<dvec3>& axis, std::size_t first, std::size_t last) {
    const dvec3 a = axis[first], along = unitOr(axis[last] - a, dvec3(0, 0, 1));
    std::size_t farthest = first;
    double most = 0;
    for (std::size_t i = first; i <= last; ++i) {
        const dvec3 offset = axis[i] - a;
        const double away = glm::length(offset - along * glm::dot(offset, along));
        if (away > most) most = away, farthest = i;
    }
    if (most > kFarthestFromAxis && farthest >= first + 3 && farthest + 3 <= last) {
        straighten(axis, first, farthest);
        straighten(axis, farthest, last);
        return;
    }
    for (std::size_t i = first + 1; i < last; ++i) axis[i] = a + along * glm::dot(axis[i] - a, along);
}

/// For two adjacent helices: the largest sharp turn of the axis, from the four residues before a position to the four
/// after it.
std::uint32_t findKink(const std::vector<dvec3>& points, const FoldRun& run) {
    double sharpest = kSharpTurn;
    std::uint32_t kink = run.last;
    for (std::uint32_t i = run.first + 3; i + 4 <= run.last; ++i) {
        const double turn = angleBetween(axisOfFour(points, i - 3), axisOfFour(points, i + 1));
        if (turn > sharpest) sharpest = turn, kink = i;
    }
    return kink;
}

void guideHelix(const std::vector<dvec3>& raw, const FoldRun& run, HelixForm form, Guides& guides) {
    const std::vector<dvec3> axes = helixAxes(raw, run);
    for (std::size_t i = run.first; i <= run.last; ++i) guides.sides[i] = axes[i - run.first];
    if (form == HelixForm::ribbon) return;
    std::vector<dvec3> axis = axisPoints(raw, run, axes);
    if (form == HelixForm::cylinder) straighten(axis, 0, axis.size() - 1);
    for (std::size_t i = run.first; i <= run.last; ++i) {
        guides.points[i] = axis[i - run.first];
        guides.sides[i] = {};
    }
}

/// Removes the zigzag of the alpha carbons, which is perpendicular to the sheet.
void smoothStrand(const FoldRun& run, std::vector<dvec3>& points) {
    for (int round = 0; round < 2; ++round) {
        const std::vector<dvec3> before = points;
        for (std::size_t i = run.first; i <= run.last; ++i)
            if (i > 0 && i + 1 < points.size())
                points[i] = (before[i - 1] + 2.0 * before[i] + before[i + 1]) / 4.0;
            else if (i == 0 && points.size() > 2)  // mirrors the zigzag at the end of the chain
                points[i] = (3.0 * before[0] + 2.0 * before[1] - before[2]) / 4.0;
            else if (points.size() > 2)
                points[i] = (3.0 * before[i] + 2.0 * before[i - 1] - before[i - 2]) / 4.0;
    }
}

void guideStrand(const Trace& trace, const FoldRun& run, Guides& guides) {
    const auto& raw = trace.points;
    dvec3 before{};
    std::vector<dvec3> sides;
    for (std::size_t i = run.first; i <= run.last; ++i) {
        const std::size_t a = i == 0 ? 0 : i - 1, b = std::min(i + 1, raw.size() - 1);
        const dvec3 along = unitOr(guides.points[b] - guides.points[a], dvec3(0, 0, 1));
        dvec3 side = unitOr(across(trace.carbonyls[i], along), {});
        if (side == dvec3()) side = unitOr(glm::cross(along, raw[a] + raw[b] - 2.0 * raw[i]), before);
        if (side == dvec3()) side = anyAcross(along);
        if (glm::dot(side, before) < 0) side = -side;
        sides.push_back(before = side);
    }
    for (int round = 0; round < 3; ++round) {
        const std::vector<dvec3> old = sides;
        for (std::size_t i = 0; i < sides.size(); ++i)
            sides[i] = unitOr(old[i == 0 ? 0 : i - 1] + 2.0 * old[i] + old[std::min(i + 1, old.size() - 1)], old[i]);
    }
    std::copy(sides.begin(), sides.end(), guides.sides.begin() + run.first);
}

/// Tangent length: half of the chord between the neighbours for a straight chain, more where it turns, so that the
/// middle of the cubic also lies on the circle through its points. For chords that turn by phi: 2 tan(phi / 4) /
/// sin(phi).
double tangentScale(double phi) {
    if (phi < 1e-3) return 0.5;
    phi = std::min(phi, 0.55 * std::numbers::pi);
    return std::min(2 * std::tan(phi / 4) / std::sin(phi), kLongestTangent);
}

void findTangents(const std::vector<bool>& wound, Guides& guides) {
    const std::vector<dvec3>& p = guides.points;
    const std::size_t n = p.size();
    guides.tangents.resize(n);
    guides.tangents.front() = p[1] - p[0];
    guides.tangents.back() = p[n - 1] - p[n - 2];
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const dvec3 chord = p[i + 1] - p[i - 1], a = p[i] - p[i - 1], b = p[i + 1] - p[i];
        if (!wound[i]) {
            // The shorter of two unequal steps limits it, which avoids loops.
            const double longest = 1.6 * std::min(glm::length(a), glm::length(b));
            const dvec3 tangent = chord * tangentScale(angleBetween(a, b));
            guides.tangents[i] = tangent * std::min(1.0, longest / std::max(glm::length(tangent), 1e-9));
            continue;
        }
        // The component along the axis is straight, the component around it a circle.
        const dvec3 axis = guides.sides[i];
        const double phi = angleBetween(across(a, axis), across(b, axis));
        guides.tangents[i] = axis * (0.5 * glm::dot(chord, axis)) + across(chord, axis) * tangentScale(phi);
    }
}

void hermite(const Guides& guides, std::size_t i, double f, Frame& frame) {
    const double f2 = f * f, f3 = f2 * f;
    const dvec3 &p = guides.points[i], &q = guides.points[i + 1], &m = guides.tangents[i], &k = guides.tangents[i + 1];
    frame.center = (2 * f3 - 3 * f2 + 1) * p + (f3 - 2 * f2 + f) * m + (3 * f2 - 2 * f3) * q + (f3 - f2) * k;
    frame.tangent =
        unitOr(6 * (f2 - f) * (p - q) + (3 * f2 - 4 * f + 1) * m + (3 * f2 - 2 * f) * k, unitOr(q - p, dvec3(0, 0, 1)));
}

/// Sides by parallel transport from the previous frame.
dvec3 transported(const dvec3& side, const Frame& to) {
    return unitOr(across(side, to.tangent), anyAcross(to.tangent));
}

/// Sides of the frames between two fixed ones: transported from the first, with the remaining angle to the second
/// spread evenly. A band is symmetric upside down, so the second may be reversed to reduce the angle. @returns whether
/// it was
bool settleBetween(std::vector<Frame>& frames, std::size_t a, std::size_t b) {
    for (std::size_t k = a + 1; k < b; ++k) frames[k].side = transported(frames[k - 1].side, frames[k]);
    const dvec3 arrived = transported(frames[b - 1].side, frames[b]);
    dvec3 wanted = frames[b].side;
    const bool reversed = glm::dot(arrived, wanted) < 0;
    if (reversed) wanted = -wanted;
    const double turn = std::atan2(glm::dot(glm::cross(arrived, wanted), frames[b].tangent), glm::dot(arrived, wanted));
    for (std::size_t k = a + 1; k < b; ++k) {
        const double angle = turn * static_cast<double>(k - a) / static_cast<double>(b - a);
        frames[k].side =
            frames[k].side * std::cos(angle) + glm::cross(frames[k].tangent, frames[k].side) * std::sin(angle);
    }
    return reversed;
}

/// @param settled  frames whose side is fixed, in whole runs
void settleSides(std::vector<Frame>& frames, const std::vector<bool>& settled) {
    const std::size_t n = frames.size();
    std::size_t first = 0;
    while (first < n && !settled[first]) ++first;
    if (first == n) frames[first = 0].side = anyAcross(frames[0].tangent);
    for (std::size_t k = first; k > 0; --k) frames[k - 1].side = transported(frames[k].side, frames[k - 1]);
    std::size_t last = first;
    bool reversed = false;
    for (std::size_t k = first + 1; k < n; ++k) {
        if (!settled[k]) continue;
        if (reversed) frames[k].side = -frames[k].side;
        if (k > last + 1 && settleBetween(frames, last, k)) {
            reversed = !reversed;
            frames[k].side = -frames[k].side;
        }
        last = k;
    }
    for (std::size_t k = last + 1; k < n; ++k) frames[k].side = transported(frames[k - 1].side, frames[k]);
}

}  // namespace

std::vector<FoldRun> splitAtKinks(const Trace& trace, std::vector<FoldRun> runs) {
    for (std::size_t r = 0; r < runs.size(); ++r) {
        if (runs[r].kind != SecondaryStructure::helix) continue;
        const std::uint32_t kink = findKink(trace.points, runs[r]);
        if (kink == runs[r].last) continue;
        FoldRun rest = runs[r];
        runs[r].last = kink;
        rest.first = kink + 1;
        runs.insert(runs.begin() + static_cast<std::ptrdiff_t>(r) + 1, rest);
        --r;  // the first part may have another helix
    }
    return runs;
}

std::vector<Frame> cartoonFrames(const Trace& trace, const std::vector<FoldRun>& runs, HelixForm helices, bool plain,
                                 int segments) {
    Guides guides{trace.points, {}, std::vector<dvec3>(trace.points.size())};
    std::vector<bool> wound(trace.points.size());
    for (const FoldRun& run : runs) {
        if (plain && run.kind == SecondaryStructure::strand) continue;
        if (run.kind == SecondaryStructure::strand) {
            smoothStrand(run, guides.points);
            continue;
        }
        guideHelix(trace.points, run, plain ? HelixForm::ribbon : helices, guides);
        for (std::size_t i = run.first; i <= run.last; ++i) wound[i] = guides.sides[i] != dvec3();
    }
    for (const FoldRun& run : runs)
        if (!plain && run.kind == SecondaryStructure::strand) guideStrand(trace, run, guides);
    findTangents(wound, guides);
    for (const FoldRun& run : runs) {
        if (plain || run.kind != SecondaryStructure::helix || helices == HelixForm::ribbon) continue;
        // The ends of a solid are perpendicular to its axis; the coil starts at their centre.
        guides.tangents[run.first] = guides.points[run.first + 1] - guides.points[run.first];
        guides.tangents[run.last] = guides.points[run.last] - guides.points[run.last - 1];
    }

    std::vector<std::uint32_t> runIndex(trace.points.size());  // numbered from 1; 0: no run
    for (std::uint32_t r = 0; r < runs.size(); ++r)
        std::fill(runIndex.begin() + runs[r].first, runIndex.begin() + runs[r].last + 1, r + 1);
    const std::size_t count = (trace.points.size() - 1) * static_cast<std::size_t>(segments) + 1;
    std::vector<Frame> frames(count);
    std::vector<bool> settled(count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = std::min(k / segments, trace.points.size() - 2);
        const double f = static_cast<double>(k - i * segments) / segments;
        hermite(guides, i, f, frames[k]);
        const dvec3 &a = guides.sides[i], &b = guides.sides[i + 1];
        const bool sameRun = runIndex[i] != 0 && runIndex[i] == runIndex[i + 1];
        const dvec3 side = f == 0 ? a : f == 1 ? b : sameRun ? (1 - f) * a + f * b : dvec3();
        frames[k].side = unitOr(across(side, frames[k].tangent), {});
        settled[k] = frames[k].side != dvec3();
    }
    settleSides(frames, settled);
    for (Frame& frame : frames) frame.normal = glm::cross(frame.tangent, frame.side);
    return frames;
}

}  // namespace nacre
