#include "app/shared/word_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

#include "engine/scene/palettes.h"

namespace nacre::app {
namespace {

// In ems of the font (DejaVu Sans): what stands above and below the baseline.
constexpr double kRise = 0.76, kDrop = 0.24, kMiddle = 0.36;
constexpr double kSmall = 0.68, kRaised = 0.36, kLowered = 0.16;  // sub- and superscripts

struct Area {
    glm::dvec2 low{}, high{};
    bool overlaps(const Area& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
    bool within(const Area& other) const {
        return low.x >= other.low.x && low.y >= other.low.y && high.x <= other.high.x && high.y <= other.high.y;
    }
    bool holds(const glm::dvec2& p) const { return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y; }
    Area grown(double by) const { return {low - by, high + by}; }
    glm::dvec2 middle() const { return (low + high) / 2.0; }
    glm::dvec2 nearest(const glm::dvec2& p) const { return glm::clamp(p, low, high); }
};

/// Whether a segment comes into an area: clipped by one side after the other (Liang and Barsky 1984).
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

struct LegendRow {
    std::string text;
    std::uint32_t color = 0;  // 0: a heading
    bool gapBefore = false;
    const Legend* ramp = nullptr;
    std::size_t stop = 0;  // of the ramp, from the top
};

class Layout {
public:
    Layout(const View& view, double size, const TextWidth& widthOf)
        : view_(view), size_(size), margin_(0.9 * size), widthOf_(widthOf) {
        frame_ = {glm::dvec2(margin_ / 2), glm::dvec2(view.width, view.height) - margin_ / 2};
    }

    void title(const std::string& text) {
        if (text.empty()) return;
        double size = 1.45 * size_;
        const double room = view_.width - 2 * margin_;
        const double wide = widthOfRuns(text, size);
        if (wide > room) size *= room / wide;
        const double left = (view_.width - widthOfRuns(text, size)) / 2;
        put(text, {left, margin_ + kRise * size}, size);
        titleDepth_ = 2.1 * size_;
    }

    /// A length of 1, 2 or 5 times a power of ten that takes at most a fifth of the picture.
    void scaleBar(ScaleBar unit) {
        if (unit == ScaleBar::off) return;
        const double room = view_.width / 5.0 / view_.pixelsPerAngstrom;  // Å
        const double ten = std::pow(10.0, std::floor(std::log10(room)));
        const double length = room >= 5 * ten ? 5 * ten : room >= 2 * ten ? 2 * ten : ten;
        char number[32];
        std::snprintf(number, sizeof number, "%.12g", unit == ScaleBar::nanometre ? length / 10 : length);
        const std::string text = std::string(number) + (unit == ScaleBar::nanometre ? " nm" : " Å");
        const double pixels = length * view_.pixelsPerAngstrom, tick = 0.28 * size_;
        const glm::dvec2 right(view_.width - margin_, view_.height - margin_ - tick);
        const glm::dvec2 left = right - glm::dvec2(pixels, 0);
        const double width = std::max(1.5, 0.11 * size_);
        marks_.lines.push_back({{left - glm::dvec2(0, tick), left + glm::dvec2(0, tick)}, width});
        marks_.lines.push_back({{right - glm::dvec2(0, tick), right + glm::dvec2(0, tick)}, width});
        marks_.lines.push_back({{left, right}, width});
        taken_.push_back(Area{left - tick, right + tick}.grown(width));
        const double wide = widthOfRuns(text, size_);
        put(text, {std::min(right.x - wide, (left.x + right.x - wide) / 2), left.y - tick - (kDrop + 0.2) * size_},
            size_);
    }

    void legends(const std::vector<Legend>& legends);
    void measures(const std::vector<PlacedMeasure>& measures);
    void labels(const std::vector<PlacedLabel>& labels);

    Marks take() { return std::move(marks_); }

private:
    struct Seen {
        glm::dvec2 at{};
        double z = 0, scale = 1;  ///< pixels an Å there
        bool inPicture = false;
    };

    Seen seen(const glm::dvec3& place) const {
        const glm::dvec3 v = view_.rotation * place;
        const bool perspective = view_.projection == Projection::perspective;
        const double before = perspective ? view_.eyeDistance - v.z : 1;
        const double magnify = perspective ? view_.eyeDistance / before : 1;
        const glm::dvec2 q = (glm::dvec2(v) * magnify + view_.pan) * view_.pixelsPerAngstrom;
        Seen s{{view_.width / 2.0 + q.x, view_.height / 2.0 - q.y}, v.z, magnify * view_.pixelsPerAngstrom, false};
        s.inPicture = before > 0 && s.at.x >= 0 && s.at.y >= 0 && s.at.x < view_.width && s.at.y < view_.height;
        return s;
    }

    double widthOfRuns(const std::string& text, double size) const {
        double width = 0;
        for (const TextRun& run : runsOf(text)) width += widthOf_(run.text, run.level == 0 ? size : kSmall * size);
        return width;
    }

    Area areaOf(const glm::dvec2& baseline, double width, double size) const {
        return {baseline - glm::dvec2(0, kRise * size), baseline + glm::dvec2(width, kDrop * size)};
    }

    /// Sets a text, which takes its place.
    void put(const std::string& text, glm::dvec2 at, double size) {
        const glm::dvec2 begin = at;
        for (const TextRun& run : runsOf(text)) {
            const double own = run.level == 0 ? size : kSmall * size;
            const double shift = run.level > 0 ? -kRaised * size : run.level < 0 ? kLowered * size : 0;
            marks_.texts.push_back({at + glm::dvec2(0, shift), own, run.text});
            at.x += widthOf_(run.text, own);
        }
        taken_.push_back(areaOf(begin, at.x - begin.x, size).grown(0.12 * size));
    }

    bool isFree(const Area& area) const {
        return area.within(frame_) &&
               std::none_of(taken_.begin(), taken_.end(), [&](const Area& other) { return area.overlaps(other); });
    }

    /// Looks for a place for a text near an anchor, the first of `wishes` (offsets of its middle) if it is free, else
    /// farther and farther away. @returns whether there is one
    bool place(const std::string& text, const glm::dvec2& anchor, const std::vector<glm::dvec2>& wishes, bool leader,
               const std::vector<glm::dvec2>& avoided);
    void dashed(const std::vector<glm::dvec2>& points);
    void legendSwatch(const LegendRow& row, const glm::dvec2& middle, double radius, double line);

    const View& view_;
    double size_, margin_, titleDepth_ = 0;
    const TextWidth& widthOf_;
    Area frame_;
    std::vector<Area> taken_;
    std::vector<std::pair<glm::dvec2, glm::dvec2>> leaders_;
    Marks marks_;
};

bool Layout::place(const std::string& text, const glm::dvec2& anchor, const std::vector<glm::dvec2>& wishes,
                   bool leader, const std::vector<glm::dvec2>& avoided) {
    const double width = widthOfRuns(text, size_);
    const glm::dvec2 half(width / 2, (kRise + kDrop) / 2 * size_);
    Area best;
    double least = std::numeric_limits<double>::infinity();
    glm::dvec2 to{};
    const auto consider = [&](const glm::dvec2& offset, double cost, bool led) {
        const Area area{anchor + offset - half, anchor + offset + half};
        const Area room = area.grown(0.12 * size_);
        if (cost >= least || !isFree(room)) return;
        const glm::dvec2 end = area.nearest(anchor);
        for (const glm::dvec2& other : avoided)
            if (area.holds(other)) cost += 1.5;
        for (const auto& [a, b] : leaders_)
            if (crosses(a, b, room)) cost += 4;
        if (led)
            for (const Area& other : taken_)
                if (crosses(anchor, end, other)) cost += 4;
        if (cost >= least) return;
        least = cost;
        best = area;
        to = led ? end : anchor;
    };
    for (std::size_t i = 0; i < wishes.size(); ++i) consider(wishes[i], 0.2 * static_cast<double>(i), false);
    for (int ring = 1; leader && ring <= 8 && least > 1; ++ring)
        for (int i = 0; i < 24; ++i) {
            const double angle = 2 * std::numbers::pi * i / 24;
            const glm::dvec2 way(std::cos(angle), std::sin(angle));
            const double reach = (0.6 + 1.1 * ring) * size_;
            consider(way * (reach + glm::abs(way) * half), 0.8 + 0.8 * ring, true);
        }
    if (least == std::numeric_limits<double>::infinity()) return false;
    if (glm::distance(to, anchor) > 0.5 * size_) {
        marks_.lines.push_back({{anchor, to}, std::max(1.0, 0.07 * size_)});
        marks_.discs.push_back({anchor, std::max(1.5, 0.13 * size_), 0});
        leaders_.emplace_back(anchor, to);
    }
    put(text, {best.low.x, best.low.y + kRise * size_}, size_);
    return true;
}

void Layout::dashed(const std::vector<glm::dvec2>& points) {
    const double dash = 0.38 * size_, gap = 0.26 * size_, width = std::max(1.2, 0.1 * size_);
    double along = 0;  // since a dash began
    LineMark line{{}, width};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 a = points[i - 1], b = points[i];
        const double length = glm::distance(a, b);
        if (length > 100 * static_cast<double>(view_.width + view_.height)) return;  // the eye is at an end
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
                marks_.lines.push_back(line);
                line.points.clear();
            }
            if (along >= dash + gap - 1e-9) along = 0;
        }
    }
    if (line.points.size() > 1) marks_.lines.push_back(line);
}

void Layout::measures(const std::vector<PlacedMeasure>& measures) {
    for (const PlacedMeasure& measure : measures) {
        std::vector<Seen> points;
        std::vector<glm::dvec2> path;
        for (const glm::dvec3& p : measure.points) {
            points.push_back(seen(p));
            path.push_back(points.back().at);
        }
        if (std::none_of(points.begin(), points.end(), [](const Seen& s) { return s.inPicture; })) continue;
        dashed(path);
        glm::dvec2 anchor = (path[0] + path[1]) / 2.0, way = path[1] - path[0];
        if (path.size() == 3) {
            // An arc in the angle, in space, so that it is seen as the angle is.
            const glm::dvec3 corner = measure.points[1];
            const glm::dvec3 u = measure.points[0] - corner, v = measure.points[2] - corner;
            const double radius = 0.45 * std::min(glm::length(u), glm::length(v));
            const double angle = std::acos(std::clamp(glm::dot(glm::normalize(u), glm::normalize(v)), -1.0, 1.0));
            LineMark arc{{}, std::max(1.0, 0.07 * size_)};
            for (int i = 0; i <= 16 && angle > 1e-3 && angle < std::numbers::pi - 1e-3; ++i) {
                const double t = angle * i / 16;
                const glm::dvec3 across = glm::normalize(v - u * (glm::dot(u, v) / glm::dot(u, u)));
                arc.points.push_back(
                    seen(corner + radius * (std::cos(t) * glm::normalize(u) + std::sin(t) * across)).at);
            }
            if (!arc.points.empty()) {
                anchor = arc.points[8];
                way = arc.points[16] - arc.points[0];
                marks_.lines.push_back(std::move(arc));
            }
        } else if (path.size() == 4) {
            anchor = (path[1] + path[2]) / 2.0, way = path[2] - path[1];
        }
        const double length = glm::length(way);
        const glm::dvec2 side = length > 1e-6 ? glm::dvec2(-way.y, way.x) / length : glm::dvec2(0, -1);
        const glm::dvec2 half(widthOfRuns(measure.text, size_) / 2, (kRise + kDrop) / 2 * size_);
        const double off = glm::dot(glm::abs(side), half) + 0.25 * size_;
        const glm::dvec2 up = side.y <= 0 ? side : -side;
        place(measure.text, anchor, {up * off, -up * off, up * (1.6 * off), -up * (1.6 * off)}, true, path);
    }
}

void Layout::labels(const std::vector<PlacedLabel>& labels) {
    std::vector<Seen> anchors;
    std::vector<glm::dvec2> points;
    for (const PlacedLabel& label : labels) {
        anchors.push_back(seen(label.at));
        points.push_back(anchors.back().at);
    }
    std::vector<std::size_t> order(labels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return anchors[a].z > anchors[b].z;  // what is nearer chooses first
    });
    for (const std::size_t i : order) {
        if (!anchors[i].inPicture) continue;
        std::vector<glm::dvec2> wishes{{0, 0}};
        const glm::dvec2 half(widthOfRuns(labels[i].text, size_) / 2, (kRise + kDrop) / 2 * size_);
        const double radius = labels[i].radius * anchors[i].scale, beside = radius + 0.25 * size_;
        const double corner = 0.72 * beside;
        // An atom whose picture has room for its label wears it.
        if (labels[i].ofAtom && radius < half.x + 0.3 * size_)
            wishes = {{corner + half.x, -corner - 0.5 * half.y},
                      {beside + half.x, 0},
                      {-corner - half.x, -corner - 0.5 * half.y},
                      {-beside - half.x, 0},
                      {0, -beside - half.y},
                      {0, beside + half.y}};
        std::vector<glm::dvec2> others = points;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        if (!place(labels[i].text, anchors[i].at, wishes, true, others)) ++marks_.crowded;
    }
}

std::string headingOf(const Legend& legend) {
    const std::string scheme = legend.scheme.substr(0, legend.scheme.find(':'));
    constexpr std::pair<const char*, const char*> kNames[] = {{"b-factor", "B factor (Å²)"},
                                                              {"plddt", "Confidence (pLDDT)"},
                                                              {"hydrophobicity", "Hydropathy (Kyte–Doolittle)"},
                                                              {"secondary-structure", "Secondary structure"},
                                                              {"chain-carbons", "Carbons by chain"},
                                                              {"copy", "Copy"},
                                                              {"rainbow", "Along the chain"}};
    std::string heading;
    for (const auto& [name, text] : kNames)
        if (scheme == name) heading = text;
    if (heading.empty() && !scheme.empty() && scheme[0] != '#') {
        heading = scheme;
        if (heading[0] >= 'a' && heading[0] <= 'z') heading[0] = static_cast<char>(heading[0] - 'a' + 'A');
    }
    if (legend.selection == "all") return heading;
    return heading.empty() ? "" : heading + ", " + legend.selection;
}

/// A text of the program or the file, safe from being read as markup.
std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '_' || c == '^' || c == '\\') safe += '\\';
        safe += c;
    }
    return safe;
}

/// Headings and entries of all legends, one below the other.
std::vector<LegendRow> rowsOf(const std::vector<Legend>& legends) {
    std::vector<LegendRow> rows;
    for (const Legend& legend : legends) {
        const std::string heading = headingOf(legend);
        if (!heading.empty()) rows.push_back({escaped(heading), 0, !rows.empty()});
        // One colour alone is named by what it colours.
        const bool named = legend.entries.size() == 1 && heading.empty() && legend.selection != "all";
        for (std::size_t i = 0; i < legend.entries.size(); ++i) {
            // The end of a ramp on top, as on an axis.
            const bool ramp = i < legend.stops;
            const LegendEntry& entry = legend.entries[ramp ? legend.stops - 1 - i : i];
            const bool first = !rows.empty() && i == 0 && heading.empty();
            rows.push_back(
                {escaped(named ? legend.selection : entry.label), entry.color, first, ramp ? &legend : nullptr, i});
        }
    }
    return rows;
}

/// A row's swatch: a disc, or its part of a ramp, about its middle.
void Layout::legendSwatch(const LegendRow& row, const glm::dvec2& middle, double radius, double line) {
    if (!row.ramp) {
        marks_.discs.push_back({middle, radius, row.color});
        return;
    }
    RampMark ramp{middle - glm::dvec2(radius, line / 2), middle + glm::dvec2(radius, line / 2), {}};
    const double last = static_cast<double>(row.ramp->stops - 1), stop = static_cast<double>(row.stop);
    for (int k = 0; k <= 8; ++k) ramp.colors.push_back(paletteColor(row.ramp->ramp, 1 - (stop - 0.5 + k / 8.0) / last));
    marks_.ramps.push_back(std::move(ramp));
}

/// In columns from the right edge on, as many as are needed, three at most.
void Layout::legends(const std::vector<Legend>& legends) {
    constexpr std::size_t kColumns = 3;
    const double size = 0.92 * size_, line = 1.42 * size, swatch = 0.36 * size, indent = 1.25 * size;
    std::vector<LegendRow> rows = rowsOf(legends);
    if (rows.empty()) return;
    const double top = margin_ + titleDepth_;
    const double bottom = view_.height - margin_ - 2.6 * size_;
    const auto perColumn = static_cast<std::size_t>(std::max(3.0, (bottom - top) / line - 1));
    if (rows.size() > kColumns * perColumn) {
        const std::size_t left = rows.size() - kColumns * perColumn + 1;
        rows.resize(kColumns * perColumn - 1);
        rows.push_back({"and " + std::to_string(left) + " more"});
    }
    double right = view_.width - margin_;
    for (std::size_t column = (rows.size() + perColumn - 1) / perColumn; column-- > 0;) {
        const auto part =
            std::span(rows).subspan(column * perColumn).first(std::min(perColumn, rows.size() - column * perColumn));
        double width = 0;
        for (const LegendRow& row : part)
            width = std::max(width, widthOfRuns(row.text, size) + (row.color ? indent : 0));
        const double left = right - width;
        double y = top;
        for (const LegendRow& row : part) {
            if (row.gapBefore && &row != part.data()) y += 0.7 * line;
            const double baseline = y + kRise * size;
            put(row.text, {left + (row.color ? indent : 0), baseline}, size);
            if (row.color) legendSwatch(row, {left + swatch, baseline - kMiddle * size}, swatch, line);
            y += line;
        }
        taken_.push_back({{left - 0.3 * size, top}, {right, y}});
        right = left - 1.2 * size;
    }
}

double luminance(const std::array<float, 3>& c) {
    const auto linear = [](float v) {
        return static_cast<double>(v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f));
    };
    return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
}

std::uint32_t packed(const std::array<float, 3>& c) {
    std::uint32_t rgb = 0;
    for (const float v : c) rgb = rgb << 8 | static_cast<std::uint32_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255));
    return packedColor(rgb);
}

}  // namespace

double usualTextSize(std::uint32_t width, std::uint32_t height) {
    return std::max(9.0, std::min(width, height) / 42.0);
}

Marks layOut(const PlacedWords& words, const View& view, double size, const std::optional<std::array<float, 3>>& color,
             const std::array<float, 4>& background, const TextWidth& widthOf) {
    const double em = size > 0 ? size : usualTextSize(view.width, view.height);
    Layout layout(view, em, widthOf);
    layout.title(words.title);
    layout.scaleBar(words.scaleBar);
    layout.legends(words.legends);
    layout.measures(words.measures);
    layout.labels(words.labels);
    Marks marks = layout.take();
    // Where the background shows through, paper is white.
    const float a = background[3];
    const std::array<float, 3> ground{background[0] * a + 1 - a, background[1] * a + 1 - a, background[2] * a + 1 - a};
    constexpr double kMiddleGray = 0.18;
    const bool dark = color ? luminance(*color) < kMiddleGray : luminance(ground) >= kMiddleGray;
    marks.color = color ? packed(*color) : packedColor(dark ? 0x1c1e22 : 0xf4f5f6);
    marks.halo = packedColor(dark ? 0xffffff : 0x101114);
    marks.haloWidth = std::max(1.2, 0.115 * em);
    return marks;
}

}  // namespace nacre::app
