#include "engine/software/front_spheres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "engine/threads.h"

namespace nacre {
namespace {

constexpr float kNoDepth = std::numeric_limits<float>::max();
constexpr float kHidesAll = -kNoDepth;
constexpr std::uint32_t kMostLanes = 16;

/// Computed anew wherever needed: there may be millions of copies of single atoms.
FrontPlace makePlace(const TileView& view, const TileCall& call) {
    const glm::vec4* rows = call.rows;
    // As toPixel().
    const glm::vec4 turned[4][2] = {{rows[0], -rows[1]}, {rows[1], rows[0]}, {-rows[0], rows[1]}, {-rows[1], -rows[0]}};
    const auto& [right, down] = turned[view.quarterTurns & 3];
    FrontPlace p{right * view.pixels, down * view.pixels, -rows[2], {}, {}, {}, right, down, rows[2]};
    p.x.w += view.axis.x;
    p.y.w += view.axis.y;
    p.z.w += view.origin;
    p.spanX = glm::abs(glm::vec3(p.x));
    p.spanY = glm::abs(glm::vec3(p.y));
    p.spanZ = glm::abs(glm::vec3(p.z));
    return p;
}

}  // namespace

void FrontSpheres::begin(const TileView& view, const Scenery& s) {
    width_ = view.width;
    height_ = view.height;
    pitch_ = (width_ + kMostLanes - 1) / kMostLanes * kMostLanes + kMostLanes;
    shared_.width = width_;
    shared_.pitch = pitch_;
    shared_.pixels = view.pixels;
    float far = 0;  // Å from the origin, of anything
    for (const TileCall& call : s.calls)
        far = std::max({far, std::abs(call.rows[0].w), std::abs(call.rows[1].w), std::abs(call.rows[2].w)});
    // Bound of a position's terms: three products with a unit vector, and a shift; half the picture.
    far += 1.75f * s.boxes.reach;
    const float wide = (static_cast<float>(std::max(width_, height_)) + std::abs(view.axis.x) + std::abs(view.axis.y)) *
                       0.5f / view.pixels;
    // Each step has a relative error: five for a position, three for a pixel.
    constexpr float kStep = 0x1p-23f;
    shared_.room = (6 * far + 5 * wide) * kStep * view.pixels;
    shared_.margin = (18 * far + 12 * (std::abs(view.origin) + view.range)) * kStep / view.range;
    shared_.axis = view.axis;
    shared_.pixel = view.pixel;
    shared_.origin = view.origin;
    shared_.perRange = view.perRange;
    shared_.start = view.nearest * view.perRange;
}

/// Replaces calls by their whole runs: in the order of the boxes, a part of a run is scattered. Spheres of a run in no
/// call lie outside the picture.
std::span<const TileCall> FrontSpheres::wholeRuns(const SphereBoxes& boxes, std::span<const TileCall> calls) {
    const std::vector<std::uint32_t>& starts = boxes.starts;
    runs_.clear();
    for (const TileCall& call : calls) {
        if (call.count == 0) continue;
        const std::uint32_t first = *std::prev(std::upper_bound(starts.begin(), starts.end(), call.first));
        const std::uint32_t end = *std::lower_bound(starts.begin(), starts.end(), call.first + call.count);
        if (runs_.empty() || runs_.back().number != call.number || runs_.back().first > first ||
            runs_.back().first + runs_.back().count < first)
            runs_.push_back({call.rows, first, 0, call.number});
        runs_.back().count = std::max(runs_.back().count, end - runs_.back().first);
    }
    return runs_;
}

void FrontSpheres::list(const TileView& view, const Scenery& s) {
    constexpr std::uint32_t kOfGroup = SphereBoxes::kSpheres * SphereBoxes::kBoxes;
    std::array<SphereBox, kMostLanes> boxes;
    std::array<FrontRectangle, kMostLanes> found;
    groups_.clear();
    const auto count = static_cast<std::uint32_t>(s.boxes.groups.size());
    for (std::uint32_t c = 0; c < s.calls.size(); ++c) {
        const TileCall& call = s.calls[c];
        const FrontPlace place = makePlace(view, call);
        const std::uint32_t end = (call.first + call.count + kOfGroup - 1) / kOfGroup;
        for (std::uint32_t g = call.first / kOfGroup; g < end; g += lanes_.lanes) {
            for (std::uint32_t k = 0; k < lanes_.lanes; ++k) boxes[k] = s.boxes.groups[std::min(g + k, count - 1)];
            lanes_.rectangles(shared_, place, boxes.data(), found.data());
            for (std::uint32_t k = 0; k < lanes_.lanes && g + k < end; ++k) {
                const FrontRectangle& r = found[k];
                if (r.right > 0 && r.bottom > 0 && r.left < static_cast<float>(width_) &&
                    r.top < static_cast<float>(height_))
                    groups_.push_back({r.near, r.left, r.top, r.right, r.bottom, c, g + k});
            }
        }
    }
}

void FrontSpheres::draw(const TileView& view, std::span<const Sphere> spheres, const SphereBoxes& boxes,
                        std::span<const TileCall> calls) {
    constexpr std::size_t kWorth = 512;  // groups per additional thread
    const bool own = !boxes.spheres.empty();
    const Scenery s{own ? boxes.spheres : spheres, boxes, own ? wholeRuns(boxes, calls) : calls};
    begin(view, s);
    list(view, s);
    sortNearFirst<2048>(ScreenView{}, std::span(&groups_, 1), sorted_);  // `near` is a depth
    partRows(
        height_, std::min<std::size_t>(groups_.size() / kWorth + 1, threadsPerTask()), groups_,
        [&](const FrontGroup& group) { return pixelAt((group.top + group.bottom) * 0.5f, 0, height_ - 1); }, inRow_,
        bands_);
    depth_.resize(std::max(depth_.size(), std::size_t{pitch_} * height_));
    number_.resize(depth_.size());
    inParallel(bands_.size(), [&](std::size_t b) {
        FrontBand band = shared_;
        band.first = bands_[b].first, band.end = bands_[b].end;
        band.depth = depth_.data(), band.number = number_.data();
        for (std::size_t y = band.first; y < band.end; ++y) {
            std::fill_n(depth_.data() + y * pitch_, width_, kNoDepth);
            std::fill_n(depth_.data() + y * pitch_ + width_, pitch_ - width_, kHidesAll);
        }
        const auto top = static_cast<float>(band.first), bottom = static_cast<float>(band.end);
        for (const FrontGroup& group : sorted_) {
            if (group.bottom < top || group.top > bottom) continue;
            if (!band.isHidden({group.near, group.left, group.top, group.right, group.bottom}))
                lanes_.draw(band, s.spheres, s.boxes, s.calls[group.call], makePlace(view, s.calls[group.call]),
                            group.group);
        }
    });
}

bool FrontSpheres::isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const {
    for (; y < std::min(endY, height_); ++y) {
        const float* row = depth_.data() + std::size_t{y} * pitch_;
        for (std::uint32_t at = x; at < std::min(endX, width_); ++at)
            if (row[at] != kNoDepth) return true;
    }
    return false;
}

void FrontSpheres::write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
    for (const std::uint32_t end = x + count; x < end; ++x) {
        const std::size_t at = std::size_t{y} * pitch_ + x;
        *to++ = y < height_ && x < width_ && depth_[at] != kNoDepth ? number_[at] : 0;
    }
}

}  // namespace nacre
