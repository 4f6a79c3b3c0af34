#include "app/annotation/room.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace nacre::app {
namespace {

constexpr int kWays = 24;      // directions around an anchor
constexpr double kMove = 1.2;  // cost of moving a text by one em from its previous position

glm::dvec2 wayAt(int i) {
    const double angle = 2 * std::numbers::pi * i / kWays;
    return {std::cos(angle), std::sin(angle)};
}

/// Whether a segment enters an area, by clipping at each side (Liang and Barsky 1984).
bool crosses(const glm::dvec2& a, const glm::dvec2& b, const Area& area) {
    double from = 0, to = 1;
    for (int i = 0; i < 2; ++i) {
        const double way = b[i] - a[i];
        if (std::abs(way) < 1e-9) {
            if (a[i] <= area.low[i] || a[i] >= area.high[i]) return false;
            continue;
        }
        const double first = (area.low[i] - a[i]) / way, second = (area.high[i] - a[i]) / way;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
    }
    return from < to;
}

}  // namespace

Room::Room(const View& v, double em, const TextWidth& width)
    : view(v), size(em), margin(0.9 * em), measureWidth(width) {
    frame = {glm::dvec2(margin / 2), glm::dvec2(view.width, view.height) - margin / 2};
}

Room::Seen Room::seen(const glm::dvec3& place) const {
    const glm::dvec3 v = view.seen(place);
    const bool perspective = view.projection == Projection::perspective;
    const double before = perspective ? view.eyeDistance - v.z : 1;
    const double magnify = perspective ? view.eyeDistance / before : 1;
    const glm::dvec2 q = (glm::dvec2(v) * magnify + view.pan) * view.pixelsPerAngstrom;
    Seen s{{view.width / 2.0 + q.x, view.height / 2.0 - q.y}, v.z, magnify * view.pixelsPerAngstrom, false};
    s.inPicture = before > 0 && s.at.x >= 0 && s.at.y >= 0 && s.at.x < view.width && s.at.y < view.height;
    return s;
}

double Room::widthOfRuns(const std::string& text, double em) const {
    double width = 0;
    for (const TextRun& run : parseMarkup(text)) width += measureWidth(run.text, run.level == 0 ? em : kSmall * em);
    return width;
}

void Room::put(const std::string& text, glm::dvec2 at, double em) {
    const glm::dvec2 begin = at;
    for (const TextRun& run : parseMarkup(text)) {
        const double own = run.level == 0 ? em : kSmall * em;
        const double shift = run.level > 0 ? -kRaised * em : run.level < 0 ? kLowered * em : 0;
        marks.texts.push_back({at + glm::dvec2(0, shift), own, run.text, ink});
        at.x += measureWidth(run.text, own);
    }
    const Area area{begin - glm::dvec2(0, kRise * em), glm::dvec2(at.x, begin.y + kDrop * em)};
    taken.push_back(area.grown(0.12 * em));
}

bool Room::isFree(const Area& area) const {
    return area.within(frame) && std::ranges::none_of(taken, [&](const Area& other) { return area.overlaps(other); });
}

/// Cost of a free position: increases with the distance of a text from its anchor.
double Room::driftCost(const Area& area, const glm::dvec2& anchor, bool beside) const {
    return 0.5 + 0.75 * glm::distance(area.nearest(anchor), anchor) / size + (beside && area.holds(anchor) ? 1 : 0);
}

bool Room::place(const std::string& text, const glm::dvec2& anchor, const std::vector<glm::dvec2>& wishes,
                 const std::vector<glm::dvec2>& avoided, Held& held) {
    const glm::dvec2 half(widthOfRuns(text, size) / 2, (kRise + kDrop) / 2 * size);
    const double crossing = held.placed ? 2 : 4, covering = held.placed ? 0.75 : 1.5;
    Area best;
    double least = std::numeric_limits<double>::infinity();
    glm::dvec2 to{}, chosen{};
    const auto consider = [&](const glm::dvec2& offset, double cost, bool led) {
        const Area area{anchor + offset - half, anchor + offset + half};
        const Area around = area.grown(0.12 * size);
        if (held.placed) cost += kMove * glm::distance(offset, held.offset) / size;
        if (cost >= least || !isFree(around)) return;
        const glm::dvec2 end = area.nearest(anchor);
        for (const glm::dvec2& other : avoided)
            if (area.holds(other)) cost += covering;
        for (const auto& [a, b] : leaders)
            if (crosses(a, b, around)) cost += crossing;
        if (led)
            for (const Area& other : taken)
                if (crosses(anchor, end, other)) cost += crossing;
        if (cost >= least) return;
        least = cost;
        best = area;
        chosen = offset;
        to = led ? end : anchor;
    };
    double reach = 0;  // distance without a leader line
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        consider(wishes[i], 0.2 * static_cast<double>(i), false);
        reach = std::max(reach, glm::distance(Area{wishes[i] - half, wishes[i] + half}.nearest({}), {}));
    }
    const auto drift = [&](const glm::dvec2& offset) {
        const Area area{anchor + offset - half, anchor + offset + half};
        const bool led = glm::distance(area.nearest(anchor), anchor) > reach + 0.3 * size;
        consider(offset, driftCost(area, anchor, wishes[0] != glm::dvec2(0)), led);
    };
    if (held.placed) {
        drift(held.offset);
        for (const double step : {0.15, 0.4, 0.9, 1.8})
            for (int i = 0; i < kWays; i += 2) drift(held.offset + step * size * wayAt(i));
    }
    for (int ring = 1; ring <= 8 && least > 1; ++ring)
        for (int i = 0; i < kWays; ++i) {
            const glm::dvec2 way = wayAt(i);
            consider(way * ((0.6 + 1.1 * ring) * size + glm::abs(way) * half), 0.8 + 0.8 * ring, true);
        }
    held.placed = least < std::numeric_limits<double>::infinity();
    held.offset = chosen;
    if (!held.placed) return false;
    if (glm::distance(to, anchor) > 0.5 * size) lead(anchor, to);
    put(text, {best.low.x, best.low.y + kRise * size}, size);
    return true;
}

void Room::lead(const glm::dvec2& anchor, const glm::dvec2& to) {
    marks.lines.push_back({{anchor, to}, std::max(1.0, 0.07 * size)});
    marks.discs.push_back({anchor, std::max(1.5, 0.13 * size), 0});
    leaders.emplace_back(anchor, to);
}

void Room::dashed(const std::vector<glm::dvec2>& points) {
    const double dash = 0.38 * size, gap = 0.26 * size, width = std::max(1.2, 0.1 * size);
    double along = 0;  // since the start of a dash
    LineMark line{{}, width};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 a = points[i - 1], b = points[i];
        const double length = glm::distance(a, b);
        if (length > 100 * static_cast<double>(view.width + view.height)) return;  // one end is at the eye
        double at = 0;
        while (at < length) {
            const double left = (along < dash ? dash : dash + gap) - along, step = std::min(left, length - at);
            if (along < dash) {
                if (line.points.empty()) line.points.push_back(glm::mix(a, b, at / length));
                line.points.push_back(glm::mix(a, b, (at + step) / length));
            }
            at += step;
            along += step;
            if (along >= dash - 1e-9 && !line.points.empty()) {
                marks.lines.push_back(line);
                line.points.clear();
            }
            if (along >= dash + gap - 1e-9) along = 0;
        }
    }
    if (line.points.size() > 1) marks.lines.push_back(line);
}

}  // namespace nacre::app
