#include "app/annotation/layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "app/annotation/room.h"
#include "engine/molecule/text.h"

namespace nacre::app {

struct WordMemory::Lists {
    std::vector<Held> labels, measures;
};

namespace {

void layTitle(Room& room, const std::string& text) {
    if (text.empty()) return;
    double em = 1.45 * room.size;
    const double most = room.view.width - 2 * room.margin;
    const double wide = room.widthOfRuns(text, em);
    if (wide > most) em *= most / wide;
    const double left = (room.view.width - room.widthOfRuns(text, em)) / 2;
    room.put(text, {left, room.margin + kRise * em}, em);
    room.titleDepth = 2.1 * room.size;
}

/// A length of 1, 2 or 5 times a power of ten that takes at most a fifth of the picture.
void layScaleBar(Room& room, ScaleBar unit) {
    if (unit == ScaleBar::off) return;
    const double most = room.view.width / 5.0 / room.view.pixelsPerAngstrom;  // Å
    const double ten = std::pow(10.0, std::floor(std::log10(most)));
    const double length = most >= 5 * ten ? 5 * ten : most >= 2 * ten ? 2 * ten : ten;
    const std::string text =
        unit == ScaleBar::nanometre ? formatted("%.12g nm", length / 10) : formatted("%.12g Å", length);
    const double pixels = length * room.view.pixelsPerAngstrom, tick = 0.28 * room.size;
    const glm::dvec2 right(room.view.width - room.margin, room.view.height - room.margin - tick);
    const glm::dvec2 left = right - glm::dvec2(pixels, 0);
    const double width = std::max(1.5, 0.11 * room.size);
    room.marks.lines.push_back({{left - glm::dvec2(0, tick), left + glm::dvec2(0, tick)}, width});
    room.marks.lines.push_back({{right - glm::dvec2(0, tick), right + glm::dvec2(0, tick)}, width});
    room.marks.lines.push_back({{left, right}, width});
    room.taken.push_back(Area{left - tick, right + tick}.grown(width));
    const double wide = room.widthOfRuns(text, room.size);
    room.put(text, {std::min(right.x - wide, (left.x + right.x - wide) / 2), left.y - tick - (kDrop + 0.2) * room.size},
             room.size);
}

/// @param held  positions in the previous and in this picture
void layMeasures(Room& room, const std::vector<PlacedMeasure>& measures, std::vector<Held>& held) {
    held.resize(measures.size());
    for (std::size_t m = 0; m < measures.size(); ++m) {
        const PlacedMeasure& measure = measures[m];
        std::vector<Room::Seen> points;
        std::vector<glm::dvec2> path;
        for (const glm::dvec3& p : measure.points) {
            points.push_back(room.seen(p));
            path.push_back(points.back().at);
        }
        if (std::none_of(points.begin(), points.end(), [](const Room::Seen& s) { return s.inPicture; })) continue;
        room.dashed(path);
        glm::dvec2 anchor = (path[0] + path[1]) / 2.0, way = path[1] - path[0];
        if (path.size() == 3) {
            // The arc of the angle in space, so that perspective applies to it.
            const glm::dvec3 corner = measure.points[1];
            const glm::dvec3 u = measure.points[0] - corner, v = measure.points[2] - corner;
            const double radius = 0.45 * std::min(glm::length(u), glm::length(v));
            const double angle = std::acos(std::clamp(glm::dot(glm::normalize(u), glm::normalize(v)), -1.0, 1.0));
            LineMark arc{{}, std::max(1.0, 0.07 * room.size)};
            for (int i = 0; i <= 16 && angle > 1e-3 && angle < std::numbers::pi - 1e-3; ++i) {
                const double t = angle * i / 16;
                const glm::dvec3 across = glm::normalize(v - u * (glm::dot(u, v) / glm::dot(u, u)));
                arc.points.push_back(
                    room.seen(corner + radius * (std::cos(t) * glm::normalize(u) + std::sin(t) * across)).at);
            }
            if (!arc.points.empty()) {
                anchor = arc.points[8];
                way = arc.points[16] - arc.points[0];
                room.marks.lines.push_back(std::move(arc));
            }
        } else if (path.size() == 4) {
            anchor = (path[1] + path[2]) / 2.0, way = path[2] - path[1];
        }
        const double length = glm::length(way);
        const glm::dvec2 side = length > 1e-6 ? glm::dvec2(-way.y, way.x) / length : glm::dvec2(0, -1);
        const glm::dvec2 half(room.widthOfRuns(measure.text, room.size) / 2, (kRise + kDrop) / 2 * room.size);
        const double off = glm::dot(glm::abs(side), half) + 0.25 * room.size;
        const glm::dvec2 up = side.y <= 0 ? side : -side;
        room.place(measure.text, anchor, {up * off, -up * off, up * (1.6 * off), -up * (1.6 * off)}, path, held[m]);
    }
}

/// Order in which labels are placed: those with a position keep it, then nearer ones first.
std::vector<std::size_t> choosingOrder(const std::vector<Room::Seen>& anchors, const std::vector<Held>& held) {
    std::vector<std::size_t> order(anchors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const bool first = held[a].placed, second = held[b].placed;
        if (first != second) return first;
        return first ? held[a].rank < held[b].rank : anchors[a].z > anchors[b].z;
    });
    return order;
}

/// Marks labels whose atoms are hidden by others. A visible label stays until almost all of its atoms are hidden.
void judgeSight(const PlacedWords& words, const View& view, const Clip& clip, std::vector<Held>& held) {
    constexpr double kSeen = 0.25, kHardly = 0.1;
    std::vector<double> shares(words.labels.size(), 1);
    if (words.sight) {
        std::vector<const LabelSight::Named*> named;
        for (const PlacedLabel& label : words.labels) named.push_back(&label.named);
        shares = words.sight->openShares(named, view, clip);
    }
    for (std::size_t i = 0; i < shares.size(); ++i) held[i].shown = shares[i] >= (held[i].shown ? kHardly : kSeen);
}

/// Offsets of a text's centre at which it covers none of its atoms, nearest first. None if the atoms fill most of the
/// picture: then the text goes on top.
/// @param half  half size of the text
std::vector<glm::dvec2> besideNamed(const Room& room, const LabelSight::Named& named, const glm::dvec2& anchor,
                                    const glm::dvec2& half) {
    constexpr int kWays = 12;
    constexpr double kRoom = 1.2;  // radii; some atoms of large groups are skipped
    constexpr double kMost = 0.6;  // of the picture's shorter side
    std::vector<DiscMark> discs;
    Area all{anchor, anchor};
    for (std::size_t i = 0; i < named.places.size(); ++i) {
        const Room::Seen seen = room.seen(named.places[i]);
        discs.push_back({seen.at, kRoom * named.radii[i] * seen.scale, 0});
        all.low = glm::min(all.low, seen.at - discs.back().radius);
        all.high = glm::max(all.high, seen.at + discs.back().radius);
    }
    const glm::dvec2 extent = all.high - all.low;
    if (std::max(extent.x, extent.y) > kMost * std::min(room.view.width, room.view.height)) return {};
    std::vector<glm::dvec2> offsets;
    for (int way = 0; way < kWays; ++way) {
        const double angle = 2 * std::numbers::pi * way / kWays;
        const auto covers = [&](const glm::dvec2& offset) {
            const Area area = Area{anchor + offset - half, anchor + offset + half}.grown(0.1 * room.size);
            return std::any_of(discs.begin(), discs.end(), [&](const DiscMark& disc) {
                return glm::distance(area.nearest(disc.at), disc.at) < disc.radius;
            });
        };
        glm::dvec2 offset(0);
        while (covers(offset)) offset += 0.4 * room.size * glm::dvec2(std::cos(angle), std::sin(angle));
        offsets.push_back(offset);
    }
    std::stable_sort(offsets.begin(), offsets.end(),
                     [](const glm::dvec2& a, const glm::dvec2& b) { return glm::dot(a, a) < glm::dot(b, b); });
    return offsets;
}

// Background of a label and its wedge, in em: half its height, its margins, and the base of the wedge.
constexpr double kPlateHalf = 0.667, kPlateBase = 0.5;
constexpr glm::dvec2 kPlateMargin(0.3, 0.133);

/// @param at  the label's point @param offset  of the text's centre @param half  size of the text, all in pixels, y up
PlateMark makePlate(const Primitives::LabelPlate& plate, const glm::dvec2& at, const glm::dvec2& offset,
                    const glm::dvec2& half, double em) {
    const auto place = [&](double x, double y) { return at + glm::dvec2(x, -y); };
    const glm::dvec2 low = offset - half - kPlateMargin * em, high = offset + half + kPlateMargin * em;
    PlateMark mark{{}, plate.color};
    if (plate.background)
        mark.parts.push_back({place(low.x, high.y), place(high.x, high.y), place(high.x, low.y), place(low.x, low.y)});
    if (plate.tether <= 0 || plate.side == glm::ivec2(0)) return mark;
    // The point of the background that is nearest to the tip; the base lies on its edges beside it.
    const glm::dvec2 side(plate.side), near = glm::clamp(glm::dvec2(0), low, high);
    const glm::dvec2 x(kPlateBase / 2 * em, 0), y(0, kPlateBase / 2 * em);
    const auto wedge = [&](const glm::dvec2& a, const glm::dvec2& b) {
        mark.parts.push_back({at, place(a.x, a.y), place(b.x, b.y)});
    };
    if (side.x != 0 && side.y != 0) {
        wedge(near, near + side.x * x);
        wedge(near, near + side.y * y);
    } else if (side.x != 0) {
        wedge(near - y, near + y);
    } else {
        wedge(near - x, near + x);
    }
    return mark;
}

/// Centres a label with a size in space on its point, or beside it, over anything there.
void putInSpace(Room& room, const PlacedLabel& label, const Room::Seen& seen) {
    constexpr double kLeast = 3, kMost = 2000;  // pixels
    const double em = std::min(label.size * seen.scale, kMost);
    if (em < kLeast) return;
    const double wide = room.widthOfRuns(label.text, em);
    const Primitives::LabelPlate& plate = label.plate;
    const glm::dvec2 half(wide / 2, kPlateHalf * em), side(plate.side);
    glm::dvec2 offset = side * half;
    if (plate.tether > 0 && plate.side != glm::ivec2(0)) {
        const double share = side.x != 0 && side.y != 0 ? 0.5 : 1;
        offset += side * (share * plate.tether + kPlateMargin) * em;
    }
    if (plate.background || plate.tether > 0) {
        PlateMark mark = makePlate(plate, seen.at, offset, half, em);
        if (!mark.parts.empty()) room.marks.plates.push_back(std::move(mark));
    }
    const glm::dvec2 middle = seen.at + glm::dvec2(offset.x, -offset.y);
    room.put(label.text, middle + glm::dvec2(-wide / 2, (kRise - kDrop) / 2 * em), em);
}

/// Puts a label at the offset of its rule, with a leader line if that is away from its anchor.
void putAt(Room& room, const PlacedLabel& label, const glm::dvec2& anchor) {
    const glm::dvec2 middle = anchor + glm::dvec2(label.offset->x, -label.offset->y) * room.size;
    const glm::dvec2 half(room.widthOfRuns(label.text, room.size) / 2, (kRise + kDrop) / 2 * room.size);
    const Area area{middle - half, middle + half};
    const glm::dvec2 end = area.nearest(anchor);
    if (glm::distance(end, anchor) > 0.6 * room.size) room.lead(anchor, end);
    room.put(label.text, {area.low.x, area.low.y + kRise * room.size}, room.size);
}

/// @param held  positions in the previous and in this picture
void layLabels(Room& room, const PlacedWords& words, const Clip& clip, std::vector<Held>& held) {
    const std::vector<PlacedLabel>& labels = words.labels;
    held.resize(labels.size());
    judgeSight(words, room.view, clip, held);
    std::vector<Room::Seen> anchors;
    std::vector<glm::dvec2> points;
    for (const PlacedLabel& label : labels) {
        anchors.push_back(room.seen(label.at));
        points.push_back(anchors.back().at);
    }
    std::size_t rank = 0;
    for (const std::size_t i : choosingOrder(anchors, held)) {
        const bool clipped = -anchors[i].z < clip.near || -anchors[i].z > clip.far;
        // Clipping planes remove labels with a size in space. Labels of atoms stay.
        if (!anchors[i].inPicture || !held[i].shown || (labels[i].size > 0 && clipped)) {
            held[i].placed = false;
            continue;
        }
        room.ink = labels[i].color;
        if (labels[i].size > 0) {
            putInSpace(room, labels[i], anchors[i]);
            continue;
        }
        if (labels[i].offset) {
            putAt(room, labels[i], anchors[i].at);
            continue;
        }
        std::vector<glm::dvec2> wishes{{0, 0}};
        const glm::dvec2 half(room.widthOfRuns(labels[i].text, room.size) / 2, (kRise + kDrop) / 2 * room.size);
        const double radius = labels[i].radius * anchors[i].scale, beside = radius + 0.25 * room.size;
        const double corner = 0.72 * beside;
        // A label that fits inside its atom goes there.
        if (labels[i].ofAtom && radius < half.x + 0.3 * room.size)
            wishes = {{corner + half.x, -corner - 0.5 * half.y},
                      {beside + half.x, 0},
                      {-corner - half.x, -corner - 0.5 * half.y},
                      {-beside - half.x, 0},
                      {0, -beside - half.y},
                      {0, beside + half.y}};
        if (!labels[i].ofAtom) {
            const std::vector<glm::dvec2> clear = besideNamed(room, labels[i].named, anchors[i].at, half);
            if (!clear.empty()) wishes = clear;
        }
        std::vector<glm::dvec2> others = points;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        held[i].rank = rank++;
        if (!room.place(labels[i].text, anchors[i].at, wishes, others, held[i])) ++room.marks.crowded;
    }
    room.ink = 0;
    std::ranges::reverse(room.marks.plates);  // nearer labels were placed first
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

void layBlocks(Room& room, const PlacedWords& words) {
    layTitle(room, words.title);
    layScaleBar(room, words.scaleBar);
    layLegends(room, words.legends);
    layAxes(room, words.axes);
}

double usualTextSize(std::uint32_t width, std::uint32_t height) {
    return std::max(9.0, std::min(width, height) / 42.0);
}

WordMemory::WordMemory() : held_(std::make_unique<Lists>()) {}
WordMemory::~WordMemory() = default;
std::vector<Held>& WordMemory::labels() { return held_->labels; }
std::vector<Held>& WordMemory::measures() { return held_->measures; }

namespace {

/// Gives discs of a legend that hardly differ from the background a grey border.
void ringPaleDiscs(Marks& marks, const std::array<float, 3>& ground) {
    constexpr double kLeastContrast = 1.5, kFlare = 0.05;  // ratio of luminances, as of WCAG
    constexpr std::uint32_t kRing = 0x8a9099;
    for (DiscMark& disc : marks.discs) {
        if (disc.color == 0) continue;
        const auto part = [&](int shift) { return static_cast<float>(disc.color >> shift & 255) / 255; };
        const double own = luminance({part(0), part(8), part(16)}) + kFlare, behind = luminance(ground) + kFlare;
        if (std::max(own, behind) / std::min(own, behind) < kLeastContrast) disc.ring = packedColor(kRing);
    }
}

}  // namespace

Marks layOut(const PlacedWords& words, const View& view, double size, const std::optional<std::array<float, 3>>& color,
             const std::array<float, 4>& background, const TextWidth& measureWidth, const Clip& clip,
             WordMemory* memory) {
    const double em = size > 0 ? size : usualTextSize(view.width, view.height);
    Room room(view, em, measureWidth);
    WordMemory none;
    if (!memory) memory = &none;
    layBlocks(room, words);
    layMeasures(room, words.measures, memory->measures());
    layLabels(room, words, clip, memory->labels());
    Marks marks = std::move(room.marks);
    // A transparent background counts as white paper.
    const float a = background[3];
    const std::array<float, 3> ground{background[0] * a + 1 - a, background[1] * a + 1 - a, background[2] * a + 1 - a};
    constexpr double kMiddleGray = 0.18;
    const bool dark = color ? luminance(*color) < kMiddleGray : luminance(ground) >= kMiddleGray;
    marks.color = color ? packed(*color) : packedColor(dark ? 0x1c1e22 : 0xf4f5f6);
    marks.halo = packedColor(dark ? 0xffffff : 0x101114);
    marks.haloWidth = std::max(1.2, 0.115 * em);
    ringPaleDiscs(marks, ground);
    return marks;
}

}  // namespace nacre::app
