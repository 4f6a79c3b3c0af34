#include "engine/software/front_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/threads.h"

namespace nacre {
namespace {

constexpr double kStep = 0x1p-23;
constexpr std::uint32_t kShapeNumber = ~(FrontShape::kStick | FrontShape::kDoubt);

float f(double x) { return static_cast<float>(x); }

/// The first pixel whose centre is not before a coordinate. std::ceil() may be a call.
std::uint32_t firstPixel(double at, std::uint32_t size) {
    const auto whole = static_cast<std::int32_t>(std::clamp(at - 0.5, -1.0, double(size)));
    return static_cast<std::uint32_t>(std::max(whole + (whole < at - 0.5 ? 1 : 0), 0));
}

}  // namespace

FrontShapes::Placing::Placing(const TileView& view, const glm::vec4* rows)
    : terms(std::max({std::abs(rows[0].w), std::abs(rows[1].w), std::abs(rows[2].w)})) {
    const glm::dvec4 x = glm::dvec4(rows[0]) * double{view.pixels}, y = glm::dvec4(rows[1]) * -double{view.pixels};
    const glm::dvec4 turned[4][2] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};  // as pixelOf()
    X = turned[view.quarterTurns & 3][0], Y = turned[view.quarterTurns & 3][1];
    Z = glm::dvec4(rows[2]) * -double{view.pixels};
    X.w += view.axis.x, Y.w += view.axis.y, Z.w += double{view.origin} * view.pixels;
}

glm::dvec3 FrontShapes::Placing::operator()(const glm::vec3& p) const {
    const double x = p.x, y = p.y, z = p.z;
    return {X.x * x + X.y * y + X.z * z + X.w, Y.x * x + Y.y * y + Y.z * z + Y.w, Z.x * x + Z.y * y + Z.z * z + Z.w};
}

bool FrontShapes::tells(const TileView& view) {
    return view.centers && !view.perspective && view.layers == 1 && view.contour == 0 && !view.clips() && !view.mask;
}

void FrontShapes::begin(const TileView& view) {
    across_ = (view.width + kBlock - 1) / kBlock;
    down_ = (view.height + kBlock - 1) / kBlock;
    pitch_ = (across_ + 1) * kBlock;
    shapes_.clear();
    strips_.clear();
    marks_.assign(std::size_t{across_} * down_, 0);
    // Each step has a relative error of half a unit of the last place. Devices take six for a position, or three, and
    // four for a pixel; two for a depth, and two for where it is in the range.
    const glm::dvec2 axis(view.axis), size(view.width, view.height);
    fixed_ = 2 * glm::length(glm::max(glm::abs(axis), glm::abs(size - axis))) * kStep;
    fixedDepth_ = 1.5 * double{std::abs(view.origin) + view.range + std::abs(view.nearest)} * kStep * view.pixels;
}

/// @param at  its place, which it keeps from its first pixel @param low, high  of the pixels that may show it
void FrontShapes::add(const TileView& view, FrontShape& shape, glm::dvec2 at, glm::dvec2 low, glm::dvec2 high) {
    // None for a place that is no number.
    if (!(low.x < view.width) || !(low.y < view.height) || !(high.x > 0) || !(high.y > 0)) return;
    const std::uint32_t left = firstPixel(low.x, view.width),
                        right = std::min(firstPixel(high.x, view.width), view.width);
    const std::uint32_t top = firstPixel(low.y, view.height),
                        bottom = std::min(firstPixel(high.y, view.height), view.height);
    if (left >= right || top >= bottom) return;
    shape.x = f(at.x - left - 0.5), shape.y = f(at.y - top - 0.5);
    shape.left = static_cast<std::uint16_t>(left), shape.right = static_cast<std::uint16_t>(right);
    shape.top = static_cast<std::uint16_t>(top), shape.bottom = static_cast<std::uint16_t>(bottom);
    for (std::uint32_t y = shape.top / kBlock; y <= (shape.bottom - 1u) / kBlock; ++y)
        for (std::uint32_t x = shape.left / kBlock; x <= (shape.right - 1u) / kBlock; ++x)
            marks_[std::size_t{y} * across_ + x] = 1;
    shapes_.push_back(shape);
    const Strips strips{static_cast<std::uint16_t>(top / rows_), static_cast<std::uint16_t>((bottom - 1) / rows_)};
    for (std::uint32_t strip = strips.first; strip <= strips.last; ++strip) ++begins_[strip];
    strips_.push_back(strips);
}

void FrontShapes::addSphere(const TileView& view, const Sphere& sphere, const Placing& placing, std::uint32_t number) {
    const glm::dvec3 at = placing(sphere.center);
    const double r = double{sphere.radius} * view.pixels;
    const double moved =
        fixed_ + 3 * (std::sqrt(glm::dot(sphere.center, sphere.center)) + placing.terms) * kStep * view.pixels;
    FrontShape s;
    s.number = number;
    s.square = f(r * r);
    s.slack = f(3 * r * moved + 2 * kStep * r * r + moved * moved);
    s.room = f(fixedDepth_ + moved + 4 * kStep * (std::abs(at.z) + r));
    s.perRoot = 0.6f * s.slack;
    s.edgeRoom = s.room + 2.3f * std::sqrt(s.slack);
    const double reach = r + moved + 0.01;
    const glm::dvec2 low = glm::dvec2(at) - reach, high = glm::dvec2(at) + reach;
    s.front = f(at.z - r) - s.room;
    s.Z = f(at.z);
    add(view, s, glm::dvec2(at), low, high);
}

void FrontShapes::addCylinder(const TileView& view, const Cylinder& c, const Placing& placing, std::uint32_t number) {
    constexpr double kSteep = 0.1;  // sine or cosine from which on rounding may do anything
    const glm::dvec3 a = placing(c.a), b = placing(c.b), span = b - a;
    const double r = double{c.radius} * view.pixels, length = glm::length(span);
    const double moved = fixed_ + 3 * (std::sqrt(std::max(glm::dot(c.a, c.a), glm::dot(c.b, c.b))) + placing.terms) *
                                      kStep * view.pixels;
    const double per = 1 / std::max(length, 1e-9);
    const glm::dvec3 axis = span * per;
    const double sine = glm::length(glm::dvec2(axis)), perSine = 1 / std::max(sine, 1e-9), fall = -axis.z;
    const double turned = 2 * moved * per;  // of the axis
    const double size = length + r;
    FrontShape s;
    s.number = number | FrontShape::kStick;
    s.square = f(r * r);
    // The error in between both ends' is none of them; beyond an end it grows.
    const double beside = 1.5 * moved * (1 + 2 * r * per * perSine) + 2 * kStep * size;
    s.slack = f(2 * r * beside + 2 * kStep * r * r + beside * beside);
    const double along = (2 * moved * (1 + r * per * perSine) + 2 * kStep * size) * 2 * perSine;
    const double steep = fall * perSine;
    s.alongRoom = f(2 * along + r * (turned + 2 * kStep) * perSine * perSine);
    s.steepRoom = f(2.3 * std::abs(steep)) * s.slack;
    s.room = f(fixedDepth_ + 2 * moved + 4 * kStep * (std::abs(a.z) + size) + along +
               r * (turned + 2 * kStep) * perSine * perSine);
    s.perRoot = f(0.6 * perSine) * s.slack;
    s.edgeRoom = s.room + f(2.3 * perSine) * std::sqrt(s.slack);
    s.aheadX = f(axis.x * perSine), s.aheadY = f(axis.y * perSine);
    s.perSine = f(perSine), s.steep = f(steep), s.fall = f(fall), s.length = f(length);
    const bool slopes = std::abs(fall) > kSteep;
    const double capAt = fall < 0 ? 0 : length, slope = slopes ? sine / fall : 0;
    s.capAt = f(capAt);
    s.capReach = f(r * std::abs(steep) + 2 * along + 1e-3);
    s.capSlope = f(slope), s.capSink = f(sine);
    s.capZ = f(a.z - fall * capAt - (slopes ? 0 : r * sine));
    s.capSlack = f(4 * r * std::abs(slope) * 2 * along + 4 * slope * slope * along * along) + 2 * s.slack;
    s.capRoom = s.room + f(2 * sine * std::abs(slope) * along);
    s.whole = !(sine > kSteep) || !(length > 0.01 * r);
    const glm::dvec2 reach =
        r * glm::sqrt(glm::max(1.0 - glm::dvec2(axis.x * axis.x, axis.y * axis.y), 0.0)) + 2 * moved + 0.01;
    const glm::dvec2 low = glm::dvec2(glm::min(a, b)) - reach, high = glm::dvec2(glm::max(a, b)) + reach;
    s.front = f(std::min(a.z, b.z) - r - 0.01) - s.room;
    s.Z = s.whole ? s.front : f(a.z);
    add(view, s, glm::dvec2(a), low, high);
}

/// How many rows a strip has. @param threads  that share the strips
void FrontShapes::part(std::uint32_t height, std::size_t threads) {
    constexpr std::uint32_t kBytes = 400'000, kStrips = 4;  // that a processor's own cache holds; least of a thread
    const auto share = static_cast<std::uint32_t>(height / (kStrips * threads));
    rows_ = std::max(std::min(kBytes / (ShapeBand::kPixelBytes * pitch_), share) / kBlock, 1u) * kBlock;
    begins_.assign((height + rows_ - 1) / rows_ + 1, 0);
    parts_.resize(threads);
}

/// Lists the shapes of each strip, in their order.
void FrontShapes::sort() {
    std::uint32_t total = 0;
    for (std::uint32_t& begin : begins_) total += std::exchange(begin, total);
    ofStrips_.resize(total);
    ends_.assign(begins_.begin(), begins_.end());
    for (std::uint32_t i = 0; i < strips_.size(); ++i)
        for (std::uint32_t strip = strips_[i].first; strip <= strips_[i].last; ++strip) ofStrips_[ends_[strip]++] = i;
}

/// Finds the pixels that the device decides, each with all that it may show.
void FrontShapes::settle(Part& part) const {
    const ShapeBand& band = part.band;
    constexpr std::uint32_t kNone = ~0u;
    part.firsts.clear();
    part.nexts.resize(part.meetings.size());
    for (std::uint32_t i = 0; i < part.meetings.size(); ++i) {
        const ShapeMeeting& m = part.meetings[i];
        if (m.before > band.behind[m.at]) continue;
        std::uint32_t& number = band.number[m.at];
        std::uint32_t index = number & ~FrontShape::kDoubt;
        // What is left of an earlier strip is no index of this pixel.
        if ((number & FrontShape::kDoubt) == 0 || index >= part.firsts.size() || part.firsts[index].at != m.at) {
            index = static_cast<std::uint32_t>(part.firsts.size());
            part.firsts.push_back({m.at, band.behind[m.at] < ShapeBand::kNothing ? number & kShapeNumber : 0, kNone});
            number = FrontShape::kDoubt | index;
        }
        part.nexts[i] = std::exchange(part.firsts[index].meeting, i);
    }
    for (const Part::First& first : part.firsts) {
        part.doubts.push_back(first.at % pitch_ | (first.at / pitch_ + band.first) << 16);
        part.begins.push_back(static_cast<std::uint32_t>(part.candidates.size()));
        if (first.number != 0) part.candidates.push_back(first.number);
        for (std::uint32_t m = first.meeting; m != kNone; m = part.nexts[m])
            part.candidates.push_back(part.meetings[m].number & kShapeNumber);
    }
}

/// Lists what the pixels of a strip show, and clears them.
void FrontShapes::tell(Part& part) const {
    settle(part);
    const auto blocks = std::span(marks_).subspan(std::size_t{part.band.first} / kBlock * across_,
                                                  (part.band.end - part.band.first + kBlock - 1) / kBlock * across_);
    const auto seen = static_cast<std::size_t>(std::ranges::count(blocks, 1));
    for (auto* pixels : {&part.balls, &part.sticks})
        pixels->words.resize(std::max(pixels->words.size(), 2 * (pixels->count + seen * kBlock * kBlock + 32)));
    // By blocks: the device reads the same shapes again while caches have them.
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        const auto x = static_cast<std::uint32_t>(block % across_) * kBlock;
        const auto top = part.band.first + static_cast<std::uint32_t>(block / across_) * kBlock;
        for (std::uint32_t y = top; y < std::min(top + kBlock, part.band.end) && blocks[block] != 0; ++y)
            lanes_.tell(part.band, x, y, part.balls, part.sticks);
    }
}

/// Draws some strips, one after another: their pixels stay in a processor's own cache.
void FrontShapes::drawStrips(Part& part, std::size_t first, std::size_t end, std::uint32_t height) const {
    part.balls.count = part.sticks.count = 0;
    for (auto* words : {&part.doubts, &part.begins, &part.candidates}) words->clear();
    const std::size_t pixels = std::size_t{pitch_} * (rows_ + 1);  // a row below may be read and written back
    if (part.behind.size() < pixels) {
        part.before.resize(pixels);
        part.number.resize(pixels);
        part.behind.resize(pixels, ShapeBand::kNothing);
    }
    for (std::size_t strip = first; strip < end; ++strip) {
        const std::uint32_t top = static_cast<std::uint32_t>(strip) * rows_, begin = begins_[strip];
        if (begins_[strip + 1] == begin) continue;
        part.meetings.clear();
        part.band = {top,
                     std::min(top + rows_, height),
                     pitch_,
                     part.before.data(),
                     part.behind.data(),
                     part.number.data(),
                     &part.meetings};
        lanes_.shapes(part.band, shapes_.data(), ofStrips_.data() + begin, begins_[strip + 1] - begin);
        tell(part);
    }
}

void FrontShapes::draw(const TileView& view, std::span<const Sphere> spheres, std::span<const TileCall> sphereCalls,
                       std::span<const Cylinder> cylinders, std::span<const TileCall> cylinderCalls) {
    constexpr std::size_t kWorth = 5'000;  // shapes that are worth another thread
    begin(view);
    std::size_t count = 0;
    for (const std::span<const TileCall> calls : {sphereCalls, cylinderCalls})
        for (const TileCall& call : calls) count += call.count;
    part(view.height, std::min<std::size_t>(count / kWorth + 1, threadsPerTask()));
    // Spheres first: they hide the caps of the cylinders between them.
    for (const TileCall& call : sphereCalls) {
        const Placing placing(view, call.rows);
        for (std::uint32_t i = call.first; i < call.first + call.count; ++i)
            addSphere(view, spheres[i], placing, call.number + i);
    }
    for (const TileCall& call : cylinderCalls) {
        const Placing placing(view, call.rows);
        for (std::uint32_t i = call.first; i < call.first + call.count; ++i)
            addCylinder(view, cylinders[i], placing, call.number + i);
    }
    sort();
    const auto firstOf = [&](std::size_t part) {
        const std::size_t before = part * ofStrips_.size() / parts_.size();
        return part == 0 ? 0 : std::ranges::lower_bound(begins_, before) - begins_.begin();
    };
    inParallel(parts_.size(), [&](std::size_t i) {
        const std::size_t strips = begins_.size() - 1;
        const auto first = static_cast<std::size_t>(firstOf(i));
        drawStrips(parts_[i], first, i + 1 < parts_.size() ? static_cast<std::size_t>(firstOf(i + 1)) : strips,
                   view.height);
    });
}

std::size_t FrontShapes::balls() const {
    std::size_t count = 0;
    for (const Part& p : parts_) count += p.balls.count;
    return count;
}
std::size_t FrontShapes::sticks() const {
    std::size_t count = 0;
    for (const Part& p : parts_) count += p.sticks.count;
    return count;
}
std::size_t FrontShapes::doubts() const {
    std::size_t count = 0;
    for (const Part& p : parts_) count += p.doubts.size();
    return count;
}

std::size_t FrontShapes::words() const {
    std::size_t candidates = 0;
    for (const Part& p : parts_) candidates += p.candidates.size();
    return kHeader + 2 * (balls() + sticks() + doubts() + 1) + (candidates + 1) / 2 * 2;
}

void FrontShapes::write(std::uint32_t* to) const {
    *to++ = static_cast<std::uint32_t>(balls());
    *to++ = static_cast<std::uint32_t>(sticks());
    *to++ = static_cast<std::uint32_t>(doubts());
    *to++ = 0;
    for (const auto pixels : {&Part::balls, &Part::sticks})
        for (const Part& p : parts_) to = std::copy_n((p.*pixels).words.data(), 2 * (p.*pixels).count, to);
    std::uint32_t before = 0;
    for (const Part& p : parts_) {
        for (std::size_t i = 0; i < p.doubts.size(); ++i) {
            *to++ = p.doubts[i];
            *to++ = before + p.begins[i];
        }
        before += static_cast<std::uint32_t>(p.candidates.size());
    }
    *to++ = 0;
    *to++ = before;
    for (const Part& p : parts_) to = std::copy(p.candidates.begin(), p.candidates.end(), to);
}

}  // namespace nacre
