#include "engine/scene/front_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/threads.h"

namespace nacre {
namespace {

constexpr double kStep = 0x1p-23;
constexpr std::size_t kTogether = 64;  // shapes
constexpr std::uint32_t kNumber = ~(FrontShape::kStick | FrontShape::kDoubt);

/// From a copy's coordinates to pixels, along the view as well.
glm::dvec3 placeOf(const TileView& view, const glm::vec4* rows, const glm::vec3& p) {
    glm::dvec3 at;
    for (int i = 0; i < 3; ++i)
        at[i] = double{rows[i].x} * p.x + double{rows[i].y} * p.y + double{rows[i].z} * p.z + rows[i].w;
    const double x = at.x * view.pixels, y = -at.y * view.pixels;  // as pixelOf()
    const glm::dvec2 turned[4] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
    return {turned[view.quarterTurns & 3] + glm::dvec2(view.axis), (view.origin - at.z) * view.pixels};
}

/// Bound of the terms of a position: a product with a unit vector, and a shift.
float termsOf(const glm::vec4* rows, const glm::vec3& p) {
    return std::sqrt(glm::dot(p, p)) + std::max({std::abs(rows[0].w), std::abs(rows[1].w), std::abs(rows[2].w)});
}

float f(double x) { return static_cast<float>(x); }

}  // namespace

bool FrontShapes::tells(const TileView& view) {
    return view.centers && !view.perspective && view.layers == 1 && view.contour == 0 && !view.clips() && !view.mask;
}

void FrontShapes::begin(const TileView& view) {
    across_ = (view.width + kBlock - 1) / kBlock;
    down_ = (view.height + kBlock - 1) / kBlock;
    pitch_ = (across_ + 1) * kBlock;
    const std::size_t pixels = std::size_t{pitch_} * down_ * kBlock;
    if (behind_.size() < pixels) {
        before_.resize(pixels);
        number_.resize(pixels);
        behind_.resize(pixels, ShapeBand::kNothing);
    }
    shapes_.clear();
    marks_.assign(std::size_t{across_} * down_, 0);
    // Each step has a relative error of half a unit of the last place. Devices take six for a position, or three, and
    // four for a pixel; two for a depth, and two for where it is in the range.
    const glm::dvec2 axis(view.axis), size(view.width, view.height);
    fixed_ = 2 * glm::length(glm::max(glm::abs(axis), glm::abs(size - axis))) * kStep;
    fixedDepth_ = 1.5 * double{std::abs(view.origin) + view.range + std::abs(view.nearest)} * kStep * view.pixels;
}

/// @param low, high  of the pixels that may show it
void FrontShapes::add(const TileView& view, FrontShape& shape, glm::dvec2 low, glm::dvec2 high) {
    const auto first = [](double at) { return std::max(std::ceil(at - 0.5), 0.0); };
    const auto end = [](double at, std::uint32_t size) { return std::min(std::floor(at - 0.5) + 1, double(size)); };
    const double left = first(low.x), top = first(low.y), right = end(high.x, view.width),
                 bottom = end(high.y, view.height);
    if (!(left < right) || !(top < bottom)) return;
    shape.left = static_cast<std::uint16_t>(left), shape.right = static_cast<std::uint16_t>(right);
    shape.top = static_cast<std::uint16_t>(top), shape.bottom = static_cast<std::uint16_t>(bottom);
    for (std::uint32_t y = shape.top / kBlock; y <= (shape.bottom - 1u) / kBlock; ++y)
        for (std::uint32_t x = shape.left / kBlock; x <= (shape.right - 1u) / kBlock; ++x)
            marks_[std::size_t{y} * across_ + x] = 1;
    shapes_.push_back(shape);
    // While they are in the nearest cache.
    if (bands_.size() == 1 && shapes_.size() == kTogether) flush();
}

void FrontShapes::addSphere(const TileView& view, const Sphere& sphere, const glm::vec4* rows, std::uint32_t number) {
    const glm::dvec3 at = placeOf(view, rows, sphere.center);
    const double r = double{sphere.radius} * view.pixels;
    const double moved = fixed_ + 3 * termsOf(rows, sphere.center) * kStep * view.pixels;
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
    s.x = f(at.x - std::max(std::ceil(low.x - 0.5), 0.0) - 0.5);
    s.y = f(at.y - std::max(std::ceil(low.y - 0.5), 0.0) - 0.5);
    s.Z = f(at.z);
    add(view, s, low, high);
}

void FrontShapes::addCylinder(const TileView& view, const Cylinder& c, const glm::vec4* rows, std::uint32_t number) {
    constexpr double kSteep = 0.1;  // sine or cosine from which on rounding may do anything
    const glm::dvec3 a = placeOf(view, rows, c.a), b = placeOf(view, rows, c.b), span = b - a;
    const double r = double{c.radius} * view.pixels, length = glm::length(span);
    const double moved = fixed_ + 3 * std::max(termsOf(rows, c.a), termsOf(rows, c.b)) * kStep * view.pixels;
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
    s.x = f(a.x - std::max(std::ceil(low.x - 0.5), 0.0) - 0.5);
    s.y = f(a.y - std::max(std::ceil(low.y - 0.5), 0.0) - 0.5);
    s.Z = s.whole ? s.front : f(a.z);
    add(view, s, low, high);
}

/// Finds the pixels that the device decides, each with all that it may show.
void FrontShapes::settle(Part& part) {
    part.doubts.clear();
    part.firsts.clear();
    part.nexts.resize(part.meetings.size());
    constexpr std::uint32_t kNone = ~0u;
    for (std::uint32_t i = 0; i < part.meetings.size(); ++i) {
        const ShapeMeeting& m = part.meetings[i];
        if (m.before > behind_[m.at]) continue;
        std::uint32_t& number = number_[m.at];
        std::uint32_t index = number & ~FrontShape::kDoubt;
        // What is left of an earlier frame is no index of this pixel.
        if ((number & FrontShape::kDoubt) == 0 || index >= part.doubts.size() || part.doubts[index] != m.at) {
            index = static_cast<std::uint32_t>(part.doubts.size());
            part.doubts.push_back(m.at);
            part.firsts.push_back({behind_[m.at] < ShapeBand::kNothing ? number & kNumber : 0, kNone});
            number = FrontShape::kDoubt | index;
        }
        part.nexts[i] = std::exchange(part.firsts[index].meeting, i);
    }
    part.begins.clear();
    part.candidates.clear();
    for (std::size_t i = 0; i < part.doubts.size(); ++i) {
        part.begins.push_back(static_cast<std::uint32_t>(part.candidates.size()));
        if (part.firsts[i].number != 0) part.candidates.push_back(part.firsts[i].number);
        for (std::uint32_t m = part.firsts[i].meeting; m != kNone; m = part.nexts[m])
            part.candidates.push_back(part.meetings[m].number & kNumber);
        part.doubts[i] = part.doubts[i] % pitch_ | part.doubts[i] / pitch_ << 16;
    }
}

void FrontShapes::flush() {
    lanes_.shapes(parts_[0].band, shapes_.data(), shapes_.size());
    shapes_.clear();
}

void FrontShapes::tell(Part& part) {
    settle(part);
    std::size_t most = 32;
    for (std::uint32_t y = part.band.first; y < part.band.end; ++y)
        for (std::uint32_t x = 0; x < across_; ++x) most += isSeen(y / kBlock * std::size_t{across_} + x) ? kBlock : 0;
    for (auto* pixels : {&part.balls, &part.sticks})
        for (auto* words : {&pixels->on, &pixels->number}) words->resize(std::max(words->size(), most));
    // By blocks: the device reads the same shapes again while caches have them.
    for (std::uint32_t top = part.band.first; top < part.band.end;) {
        const std::uint32_t end = std::min((top / kBlock + 1) * kBlock, part.band.end);
        for (std::uint32_t x = 0; x < across_; ++x)
            for (std::uint32_t y = top; y < end && isSeen(top / kBlock * std::size_t{across_} + x); ++y)
                lanes_.tell(part.band, x * kBlock, y, part.balls, part.sticks);
        top = end;
    }
}

void FrontShapes::draw(const TileView& view, std::span<const Sphere> spheres, std::span<const TileCall> sphereCalls,
                       std::span<const Cylinder> cylinders, std::span<const TileCall> cylinderCalls) {
    constexpr std::size_t kWorth = 5'000;  // shapes that are worth another thread
    begin(view);
    std::size_t count = 0;
    for (const std::span<const TileCall> calls : {sphereCalls, cylinderCalls})
        for (const TileCall& call : calls) count += call.count;
    const std::size_t threads = std::min<std::size_t>(count / kWorth + 1, threadsPerTask());
    if (parts_.size() < threads) parts_.resize(threads);
    bands_.assign(threads > 1 ? 0 : 1, {0, view.height});
    const auto start = [&](std::size_t b) {
        Part& part = parts_[b];
        part.meetings.clear();
        part.balls.count = part.sticks.count = 0;
        part.band = {bands_[b].first, bands_[b].end,  pitch_,        before_.data(),
                     behind_.data(),  number_.data(), &part.meetings};
    };
    if (threads == 1) start(0);
    // Spheres first: they hide the caps of the cylinders between them.
    for (const TileCall& call : sphereCalls)
        for (std::uint32_t i = call.first; i < call.first + call.count; ++i)
            addSphere(view, spheres[i], call.rows, call.number + i);
    for (const TileCall& call : cylinderCalls)
        for (std::uint32_t i = call.first; i < call.first + call.count; ++i)
            addCylinder(view, cylinders[i], call.rows, call.number + i);
    if (threads == 1) {
        flush();
        return tell(parts_[0]);
    }
    partRows(
        view.height, threads, shapes_, [](const FrontShape& s) { return (s.top + std::uint32_t{s.bottom}) / 2; },
        inRow_, bands_);
    inParallel(bands_.size(), [&](std::size_t b) {
        start(b);
        lanes_.shapes(parts_[b].band, shapes_.data(), shapes_.size());
        tell(parts_[b]);
    });
}

std::size_t FrontShapes::balls() const {
    std::size_t count = 0;
    for (std::size_t b = 0; b < bands_.size(); ++b) count += parts_[b].balls.count;
    return count;
}
std::size_t FrontShapes::sticks() const {
    std::size_t count = 0;
    for (std::size_t b = 0; b < bands_.size(); ++b) count += parts_[b].sticks.count;
    return count;
}
std::size_t FrontShapes::doubts() const {
    std::size_t count = 0;
    for (std::size_t b = 0; b < bands_.size(); ++b) count += parts_[b].doubts.size();
    return count;
}

std::size_t FrontShapes::words() const {
    std::size_t candidates = 0;
    for (std::size_t b = 0; b < bands_.size(); ++b) candidates += parts_[b].candidates.size();
    return kHeader + 2 * (balls() + sticks() + doubts()) + 1 + candidates;
}

void FrontShapes::write(std::uint32_t* to) const {
    const std::span<const Part> parts(parts_.data(), bands_.size());
    *to++ = static_cast<std::uint32_t>(balls());
    *to++ = static_cast<std::uint32_t>(sticks());
    *to++ = static_cast<std::uint32_t>(doubts());
    *to++ = 0;
    for (const Part& p : parts) to = std::copy_n(p.balls.on.data(), p.balls.count, to);
    for (const Part& p : parts) to = std::copy_n(p.balls.number.data(), p.balls.count, to);
    for (const Part& p : parts) to = std::copy_n(p.sticks.on.data(), p.sticks.count, to);
    for (const Part& p : parts) to = std::copy_n(p.sticks.number.data(), p.sticks.count, to);
    for (const Part& p : parts) to = std::copy(p.doubts.begin(), p.doubts.end(), to);
    std::uint32_t before = 0;
    for (const Part& p : parts) {
        for (const std::uint32_t begin : p.begins) *to++ = before + begin;
        before += static_cast<std::uint32_t>(p.candidates.size());
    }
    *to++ = before;
    for (const Part& p : parts) to = std::copy(p.candidates.begin(), p.candidates.end(), to);
}

}  // namespace nacre
