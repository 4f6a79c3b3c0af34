#include "engine/software/front_spheres.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
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
    const glm::vec4 across = rows[0] * view.pixels, up = rows[1] * view.pixels;
    const glm::vec4 turned[4][2] = {{across, -up}, {up, across}, {-across, up}, {-up, -across}};
    FrontPlace p{turned[view.quarterTurns & 3][0], turned[view.quarterTurns & 3][1], -rows[2], {}, {}, {}};
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
    shared_.perPixel = 1 / view.pixels;
    float far = 0;  // Å from the origin, of anything
    for (const TileCall& call : s.calls)
        far = std::max({far, std::abs(call.rows[0].w), std::abs(call.rows[1].w), std::abs(call.rows[2].w)});
    // Bound of a position's terms: three products with a unit vector, and a shift; half the picture.
    far += 1.75f * s.boxes.reach;
    const float wide = (static_cast<float>(std::max(width_, height_)) + std::abs(view.axis.x) + std::abs(view.axis.y)) *
                       0.5f * shared_.perPixel;
    // Each step has a relative error. Shaders take three for a position, the host five of half the size, both two or
    // three for a pixel.
    constexpr float kStep = 0x1p-23f;
    const float room = (6 * far + 5 * wide) * kStep;
    shared_.room = room * view.pixels;
    // A square root's error grows towards the sphere's edge.
    constexpr float kLeast = 1.0f / 6;  // of a radius
    shared_.edge = kLeast * kLeast;
    shared_.margin = room / kLeast + (6 * far + 4 * (std::abs(view.origin) + view.range)) * kStep;
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

/// @param drawn  contains the calls as parts
void FrontSpheres::listDoubts(std::span<const TileCall> drawn, std::span<const TileCall> calls) {
    std::uint32_t most = 0;
    for (const TileCall& call : drawn) most = std::max(most, call.number + call.first + call.count);
    marks_.assign(most / 64 + 1, 0);
    shown_ = 0;
    for (std::size_t b = 0; b < bands_.size(); ++b)
        for (const std::uint32_t number : ambiguous_[b]) shown_ += mark(number);
    ambiguousCalls_.clear();
    for (const TileCall& call : calls) {
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
            ambiguousCalls_.push_back({call.rows, first - call.number, at - first, call.number});
        }
    }
}

/// Marks a sphere; thread-safe. @returns whether it was unmarked
bool FrontSpheres::mark(std::uint32_t number) {
    std::uint64_t& word = marks_[number / 64];
    const std::uint64_t bit = std::uint64_t{1} << number % 64;
    if (__atomic_load_n(&word, __ATOMIC_RELAXED) & bit) return false;
    return (__atomic_fetch_or(&word, bit, __ATOMIC_RELAXED) & bit) == 0;
}

/// Marks and counts the spheres seen at pixels, in addition to the ambiguous ones.
void FrontSpheres::countShown() {
    std::atomic<std::size_t> shown = 0;
    inParallel(bands_.size(), [&](std::size_t b) {
        std::size_t mine = 0;
        for (std::size_t y = bands_[b].first; y < bands_[b].end; ++y) {
            const float* z = z_.data() + y * pitch_;
            const std::uint32_t* number = number_.data() + y * pitch_;
            for (std::uint32_t x = 0; x < width_; ++x)
                if (z[x] != kNoDepth && (x == 0 || number[x] != number[x - 1])) mine += mark(number[x]);
        }
        shown += mine;
    });
    shown_ += shown;
}

void FrontSpheres::draw(const TileView& view, std::span<const Sphere> spheres, const SphereBoxes& boxes,
                        std::span<const TileCall> calls) {
    constexpr std::size_t kWorth = 512;  // groups per additional thread
    const bool own = !boxes.spheres.empty();
    const Scenery s{own ? boxes.spheres : spheres, boxes, own ? wholeRuns(boxes, calls) : calls};
    begin(view, s);
    list(view, s);
    sortNearFirst<2048>(view, std::span(&groups_, 1), sorted_);
    partRows(
        height_, std::min<std::size_t>(groups_.size() / kWorth + 1, threadsPerTask()), groups_,
        [&](const FrontGroup& group) { return pixelAt((group.top + group.bottom) * 0.5f, 0, height_ - 1); }, inRow_,
        bands_);
    if (ambiguous_.size() < bands_.size()) ambiguous_.resize(bands_.size());
    z_.resize(std::max(z_.size(), std::size_t{pitch_} * height_));
    number_.resize(z_.size());
    inParallel(bands_.size(), [&](std::size_t b) {
        FrontBand band = shared_;
        band.first = bands_[b].first, band.end = bands_[b].end;
        band.z = z_.data(), band.number = number_.data(), band.ambiguous = &ambiguous_[b];
        ambiguous_[b].clear();
        for (std::size_t y = band.first; y < band.end; ++y) {
            std::fill_n(z_.data() + y * pitch_, width_, kNoDepth);
            std::fill_n(z_.data() + y * pitch_ + width_, pitch_ - width_, kHidesAll);
        }
        const auto top = static_cast<float>(band.first), bottom = static_cast<float>(band.end);
        for (const FrontGroup& group : sorted_) {
            if (group.bottom < top || group.top > bottom) continue;
            if (!band.isHidden({group.near, group.left, group.top, group.right, group.bottom}))
                lanes_.draw(band, s.spheres, s.boxes, s.calls[group.call], makePlace(view, s.calls[group.call]),
                            group.group);
        }
    });
    listDoubts(s.calls, calls);
    countShown();
}

bool FrontSpheres::isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const {
    for (; y < std::min(endY, height_); ++y) {
        const float* row = z_.data() + std::size_t{y} * pitch_;
        for (std::uint32_t at = x; at < std::min(endX, width_); ++at)
            if (row[at] != kNoDepth) return true;
    }
    return false;
}

void FrontSpheres::write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
    for (const std::uint32_t end = x + count; x < end; ++x) {
        const std::size_t at = std::size_t{y} * pitch_ + x;
        *to++ = y < height_ && x < width_ && z_[at] != kNoDepth ? number_[at] : 0;
    }
}

}  // namespace nacre
