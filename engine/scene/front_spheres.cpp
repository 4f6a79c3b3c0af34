#include "engine/scene/front_spheres.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/scene/lanes.h"
#include "engine/threads.h"

namespace nacre {
namespace {

constexpr float kNothing = std::numeric_limits<float>::max();
constexpr float kHidesAll = -kNothing;
constexpr Mask kLane = {0, 1, 2, 3};
constexpr Lanes kCenters = {0.5f, 1.5f, 2.5f, 3.5f};

Lanes along(const glm::vec4& row, const LanePoints& p) { return row.x * p.x + row.y * p.y + row.z * p.z + row.w; }
Lanes along(const glm::vec3& row, const LanePoints& p) { return row.x * p.x + row.y * p.y + row.z * p.z; }
Lanes toLanes(Mask mask) { return __builtin_convertvector(mask, Lanes); }
/// Truncates non-negative numbers.
Mask whole(Lanes lanes) { return __builtin_convertvector(lanes, Mask); }
Lanes rootOf(Lanes squares) {
    return Lanes{std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2]), std::sqrt(squares[3])};
}

/// As pixelAt(), of four.
Mask pixelsAt(Lanes places, Lanes first, Lanes end) { return whole(lesser(greater(places + 0.5f, first), end)); }

/// The first pixel whose centre is not before a coordinate, and one past the last that is not behind it.
std::uint32_t pixelAt(float place, std::uint32_t first, std::uint32_t end) {
    const float at = place + 0.5f;
    if (!(at > static_cast<float>(first))) return first;
    return at < static_cast<float>(end) ? static_cast<std::uint32_t>(at) : end;
}

}  // namespace

struct FrontSpheres::Rectangles {
    Lanes near, left, top, right, bottom;
};

bool FrontSpheres::tells(const TileView& view) {
    return view.centers && !view.perspective && view.layers == 1 && view.contour == 0 && !view.clips();
}

void FrontSpheres::begin(const TileView& view, const Scenery& s) {
    width_ = view.width;
    height_ = view.height;
    pitch_ = (std::size_t{width_} + kLanes - 1) / kLanes * kLanes + kLanes;
    pixels_ = view.pixels;
    perPixel_ = 1 / view.pixels;
    places_.clear();
    float far = 0;  // Å from the origin, of anything
    for (const TileCall& call : s.calls) {
        const glm::vec4* rows = call.rows;
        // As pixelOf().
        const glm::vec4 across = rows[0] * view.pixels, up = rows[1] * view.pixels;
        const glm::vec4 turned[4][2] = {{across, -up}, {up, across}, {-across, up}, {-up, -across}};
        Place p{turned[view.quarterTurns & 3][0], turned[view.quarterTurns & 3][1], -rows[2], {}, {}, {}};
        p.x.w += view.axis.x;
        p.y.w += view.axis.y;
        p.z.w += view.origin;
        p.spanX = glm::abs(glm::vec3(p.x));
        p.spanY = glm::abs(glm::vec3(p.y));
        p.spanZ = glm::abs(glm::vec3(p.z));
        places_.push_back(p);
        far = std::max({far, std::abs(rows[0].w), std::abs(rows[1].w), std::abs(rows[2].w)});
    }
    // Bound of the terms of a position: three products with a unit vector, and a shift; half the picture.
    far += 1.75f * s.boxes.reach;
    const float wide = (static_cast<float>(std::max(width_, height_)) + std::abs(view.axis.x) + std::abs(view.axis.y)) *
                       0.5f * perPixel_;
    // Each step has a relative error. Shaders take three for a position, the host five of half the size, both two or
    // three for a pixel.
    constexpr float kStep = 0x1p-23f;
    const float room = (6 * far + 5 * wide) * kStep;
    room_ = room * pixels_;
    // A square root's error grows towards the sphere's edge.
    constexpr float kLeast = 1.0f / 6;  // of a radius
    edge_ = kLeast * kLeast;
    margin_ = room / kLeast + (6 * far + 4 * (std::abs(view.origin) + view.range)) * kStep;
}

FrontSpheres::Rectangles FrontSpheres::rectanglesOf(const Place& place, const SphereBox* boxes) const {
    const LanePoints middle(loadLanes(&boxes[0].middle.x), loadLanes(&boxes[1].middle.x), loadLanes(&boxes[2].middle.x),
                            loadLanes(&boxes[3].middle.x));
    const LanePoints half(loadLanes(&boxes[0].half.x), loadLanes(&boxes[1].half.x), loadLanes(&boxes[2].half.x),
                          loadLanes(&boxes[3].half.x));
    const Lanes radius{boxes[0].radius, boxes[1].radius, boxes[2].radius, boxes[3].radius};
    const Lanes ball{boxes[0].ball, boxes[1].ball, boxes[2].ball, boxes[3].ball};
    const Lanes reach = radius * pixels_ + room_, round = ball * pixels_;
    const Lanes x = along(place.x, middle), y = along(place.y, middle), z = along(place.z, middle);
    const Lanes wide = lesser(along(place.spanX, half), round) + reach,
                high = lesser(along(place.spanY, half), round) + reach;
    return {z - lesser(along(place.spanZ, half), ball) - radius - 3 * margin_, x - wide, y - high, x + wide, y + high};
}

void FrontSpheres::list(const Scenery& s) {
    constexpr std::uint32_t kOfGroup = SphereBoxes::kSpheres * SphereBoxes::kBoxes;
    groups_.clear();
    const auto count = static_cast<std::uint32_t>(s.boxes.groups.size());
    for (std::uint32_t c = 0; c < s.calls.size(); ++c) {
        const TileCall& call = s.calls[c];
        const std::uint32_t end = (call.first + call.count + kOfGroup - 1) / kOfGroup;
        for (std::uint32_t g = call.first / kOfGroup; g < end; g += kLanes) {
            SphereBox four[kLanes];
            for (std::uint32_t k = 0; k < kLanes; ++k) four[k] = s.boxes.groups[std::min(g + k, count - 1)];
            const Rectangles r = rectanglesOf(places_[c], four);
            for (std::uint32_t k = 0; k < kLanes && g + k < end; ++k)
                if (r.right[k] > 0 && r.bottom[k] > 0 && r.left[k] < static_cast<float>(width_) &&
                    r.top[k] < static_cast<float>(height_))
                    groups_.push_back({r.near[k], r.left[k], r.top[k], r.right[k], r.bottom[k], c, g + k});
        }
    }
}

/// Whether things from a depth on are behind all that a rectangle shows: nothing without a pixel centre.
bool FrontSpheres::isHidden(const Band& band, float near, float left, float top, float right, float bottom) const {
    const std::uint32_t x0 = pixelAt(left, 0, width_), x1 = pixelAt(right, 0, width_);
    const std::uint32_t y1 = pixelAt(bottom, band.first, band.end);
    for (std::uint32_t y = pixelAt(top, band.first, band.end); y < y1; ++y) {
        const float* row = z_.data() + y * pitch_;
        for (std::uint32_t x = x0; x < x1; x += kLanes)
            if (any((loadLanes(row + x) >= near) & (kLane < static_cast<std::int32_t>(x1 - x)))) return false;
    }
    return true;
}

void FrontSpheres::drawGroup(const Band& band, const Scenery& s, const Group& group) {
    constexpr std::uint32_t kBoxes = SphereBoxes::kBoxes;
    if (isHidden(band, group.near, group.left, group.top, group.right, group.bottom)) return;
    const TileCall& call = s.calls[group.call];
    const Place& place = places_[group.call];
    struct Seen {
        float near, left, top, right, bottom;
        std::uint32_t first, end;
    };
    std::array<Seen, kBoxes> boxes;
    std::size_t count = 0;
    for (std::uint32_t b = 0; b < kBoxes; b += kLanes) {
        const std::uint32_t box = group.group * kBoxes + b;
        const Rectangles r = rectanglesOf(place, &s.boxes.boxes[box]);
        for (std::uint32_t k = 0; k < kLanes; ++k) {
            const std::uint32_t first = std::max((box + k) * SphereBoxes::kSpheres, call.first);
            const std::uint32_t end = std::min((box + k + 1) * SphereBoxes::kSpheres, call.first + call.count);
            if (first >= end || isHidden(band, r.near[k], r.left[k], r.top[k], r.right[k], r.bottom[k])) continue;
            const Seen found{r.near[k], r.left[k], r.top[k], r.right[k], r.bottom[k], first, end};
            std::size_t at = count++;
            for (; at > 0 && found.near < boxes[at - 1].near; --at) boxes[at] = boxes[at - 1];
            boxes[at] = found;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Seen& box = boxes[i];
        if (i > 0 && isHidden(band, box.near, box.left, box.top, box.right, box.bottom)) continue;
        drawSpheres(band, s, call, place, box.first, box.end);
    }
}

/// Draws a sphere that may be hit at a pixel's centre, and is not certainly hidden.
void FrontSpheres::meet(const Band& band, std::size_t at, float Z, bool certain, std::uint32_t number) {
    const float there = z_[at];
    if (!certain) {
        band.doubts.push_back(number);
    } else if (Z + 2 * margin_ < there) {
        z_[at] = Z;
        number_[at] = number;
    } else if (Z < there) {
        band.doubts.push_back(number_[at]);
        z_[at] = Z;
        number_[at] = number;
    } else {
        band.doubts.push_back(number);
    }
}

void FrontSpheres::drawSpheres(const Band& band, const Scenery& s, const TileCall& call, const Place& place,
                               std::uint32_t first, std::uint32_t end) {
    const Lanes none{}, across = none + static_cast<float>(width_), low = none + static_cast<float>(band.first),
                        high = none + static_cast<float>(band.end);
    const float behind = 2 * margin_;
    for (; first < end; first += kLanes) {
        const Sphere* four[kLanes];
        for (std::uint32_t k = 0; k < kLanes; ++k) four[k] = &s.spheres[std::min(first + k, end - 1)];
        const LanePoints centers(loadLanes(&four[0]->center.x), loadLanes(&four[1]->center.x),
                                 loadLanes(&four[2]->center.x), loadLanes(&four[3]->center.x));
        const Lanes radius{four[0]->radius, four[1]->radius, four[2]->radius, four[3]->radius};
        const Lanes x = along(place.x, centers), y = along(place.y, centers), Z = along(place.z, centers);
        const Lanes reach = radius * pixels_, squared = reach * reach;
        const Lanes touching = -(2 * reach + room_) * room_, certain = squared * edge_, edge = certain - touching;
        const Lanes near = Z - radius - behind;
        const std::uint32_t number = call.number + first;
        const std::uint32_t count = std::min(kLanes, end - first);
        if (!any(reach + room_ >= 0.5f)) {  // no more than one centre each
            const Mask inside =
                (x >= 0.0f) & (x < across) & (y >= low) & (y < high) & (kLane < static_cast<std::int32_t>(count));
            // The other lanes read within the band: only its rows belong to this thread.
            const Mask column = whole(inside ? x : none), row = whole(inside ? y : low);
            const Lanes aside = x - toLanes(column) - 0.5f, above = y - toLanes(row) - 0.5f;
            const Lanes h = squared - aside * aside - above * above;
            std::size_t at[kLanes];
            Lanes there;
            for (std::uint32_t k = 0; k < kLanes; ++k) {
                at[k] = static_cast<std::size_t>(row[k]) * pitch_ + static_cast<std::size_t>(column[k]);
                there[k] = z_[at[k]];
            }
            Mask meets = inside & (h > touching) & (near <= there);
            if (!any(meets)) continue;
            const Mask safe = h > certain;
            const Lanes hit = Z - rootOf(safe ? h : edge) * perPixel_;
            meets &= hit - behind <= there;
            for (std::uint32_t k = 0; k < kLanes; ++k)
                if (meets[k]) {
                    if (hit[k] - behind > z_[at[k]]) continue;  // another one of the four was there
                    meet(band, at[k], hit[k], safe[k] != 0, number + k);
                }
            continue;
        }
        const Lanes out = reach + room_;
        const Mask left = pixelsAt(x - out, none, across), right = pixelsAt(x + out, none, across);
        const Mask top = pixelsAt(y - out, low, high), bottom = pixelsAt(y + out, low, high);
        for (std::uint32_t k = 0; k < count; ++k) {
            const auto x0 = static_cast<std::uint32_t>(left[k]), x1 = static_cast<std::uint32_t>(right[k]);
            const auto y0 = static_cast<std::uint32_t>(top[k]), y1 = static_cast<std::uint32_t>(bottom[k]);
            Mask open{};
            for (std::uint32_t row = y0; row < y1; ++row)
                for (std::uint32_t column = x0; column < x1; column += kLanes)
                    open |= loadLanes(&z_[row * pitch_ + column]) >= near[k];
            if (!any(open)) continue;
            for (std::uint32_t row = y0; row < y1; ++row) {
                const float above = static_cast<float>(row) + 0.5f - y[k], within = squared[k] - above * above;
                for (std::uint32_t column = x0; column < x1; column += kLanes) {
                    const std::size_t at = row * pitch_ + column;
                    const Lanes there = loadLanes(&z_[at]);
                    const Lanes aside = kCenters + (static_cast<float>(column) - x[k]);
                    const Lanes h = within - aside * aside;
                    Mask meets = (h > touching[k]) & (near[k] <= there);
                    if (!any(meets)) continue;
                    const Mask safe = h > certain[k];
                    const Lanes hit = Z[k] - rootOf(safe ? h : none + edge[k]) * perPixel_;
                    meets &= hit - behind <= there;
                    if (!any(meets)) continue;
                    for (std::uint32_t i = 0; i < kLanes; ++i)
                        if (meets[i]) meet(band, at + i, hit[i], safe[i] != 0, number + k);
                }
            }
        }
    }
}

void FrontSpheres::listDoubts(const Scenery& s) {
    std::uint32_t most = 0;
    for (const TileCall& call : s.calls) most = std::max(most, call.number + call.first + call.count);
    marks_.assign(most / 64 + 1, 0);
    const auto mark = [&](std::uint32_t number) { marks_[number / 64] |= std::uint64_t{1} << number % 64; };
    for (std::size_t b = 0; b < bands_.size(); ++b) std::for_each(doubts_[b].begin(), doubts_[b].end(), mark);
    doubtCalls_.clear();
    for (const TileCall& call : s.calls) {
        const std::uint32_t end = call.number + call.first + call.count;
        for (std::uint32_t at = call.number + call.first; at < end;) {
            const std::uint64_t rest = marks_[at / 64] >> at % 64;
            if (rest == 0) {
                at = (at / 64 + 1) * 64;
                continue;
            }
            at += static_cast<std::uint32_t>(std::countr_zero(rest));
            if (at >= end) break;
            const std::uint32_t first = at;
            while (at < end && (marks_[at / 64] >> at % 64 & 1)) ++at;
            doubtCalls_.push_back({call.rows, first - call.number, at - first, call.number});
        }
    }
    for (std::uint32_t y = 0; y < height_; ++y) {
        const float* z = z_.data() + y * pitch_;
        const std::uint32_t* number = number_.data() + y * pitch_;
        for (std::uint32_t x = 0; x < width_; ++x)
            if (z[x] != kNothing && (x == 0 || number[x] != number[x - 1])) mark(number[x]);
    }
    shown_ = 0;
    for (const std::uint64_t word : marks_) shown_ += static_cast<std::size_t>(std::popcount(word));
}

void FrontSpheres::draw(const TileView& view, std::span<const Sphere> spheres, const SphereBoxes& boxes,
                        std::span<const TileCall> calls) {
    constexpr std::size_t kWorth = 512;  // groups that are worth another thread
    const Scenery s{spheres, boxes, calls};
    begin(view, s);
    list(s);
    orderNearFirst<2048>(view, groups_, order_);
    partRows(
        height_, std::min<std::size_t>(groups_.size() / kWorth + 1, threadsPerTask()), groups_,
        [&](const Group& group) { return pixelAt((group.top + group.bottom) * 0.5f, 0, height_ - 1); }, inRow_, bands_);
    if (doubts_.size() < bands_.size()) doubts_.resize(bands_.size());
    z_.resize(std::max(z_.size(), pitch_ * height_));
    number_.resize(std::max(number_.size(), pitch_ * height_));
    inParallel(bands_.size(), [&](std::size_t b) {
        const Band band{bands_[b].first, bands_[b].end, doubts_[b]};
        band.doubts.clear();
        for (std::size_t y = band.first; y < band.end; ++y) {
            std::fill_n(z_.data() + y * pitch_, width_, kNothing);
            std::fill_n(z_.data() + y * pitch_ + width_, pitch_ - width_, kHidesAll);
        }
        for (const std::uint32_t i : order_) drawGroup(band, s, groups_[i]);
    });
    listDoubts(s);
}

bool FrontSpheres::isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const {
    for (; y < std::min(endY, height_); ++y) {
        const float* row = z_.data() + y * pitch_;
        for (std::uint32_t at = x; at < std::min(endX, width_); ++at)
            if (row[at] != kNothing) return true;
    }
    return false;
}

void FrontSpheres::write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
    for (const std::uint32_t end = x + count; x < end; ++x) {
        const std::size_t at = y * pitch_ + x;
        *to++ = y < height_ && x < width_ && z_[at] != kNothing ? number_[at] : 0;
    }
}

}  // namespace nacre
