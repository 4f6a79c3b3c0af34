#include "engine/lists/seen_copies.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/scene/color/colors.h"
#include "engine/threads.h"

namespace nacre {
namespace {

constexpr float kNoDepth = std::numeric_limits<float>::max();

/// The same view with more places per pixel.
ScreenView finer(ScreenView view, std::uint32_t grid) {
    const auto times = static_cast<float>(grid);
    view.width *= grid;
    view.height *= grid;
    view.axis *= times;
    view.pixels *= times;
    return view;
}

glm::vec3 seen(const SeenCopies::Scenery& s, const glm::dmat4x3& transform, const glm::vec3& p) {
    return s.rotation * (transform * glm::dvec4(glm::dvec3(p), 1.0)) + s.shift;
}

/// Inverse of toPixel().
glm::vec2 toPlanePoint(const ScreenView& view, const glm::vec2& place) {
    const glm::vec2 p = (place - view.axis) / view.pixels;
    switch (view.quarterTurns & 3) {
        case 1:
            return {p.y, p.x};
        case 2:
            return {-p.x, p.y};
        case 3:
            return {-p.y, -p.x};
        default:
            return {p.x, -p.y};
    }
}

/// Where the ray through a place meets a sphere in perspective. @returns Z; kNoDepth: nowhere
float hitFromEye(const ScreenView& view, const glm::vec3& center, float radius, const glm::vec2& place) {
    const glm::vec3 way(toPlanePoint(view, place), -view.origin), from(center.x, center.y, center.z - view.origin);
    const float squared = glm::dot(way, way), along = glm::dot(way, from) / squared;
    const glm::vec3 aside = from - way * along;
    const float h = radius * radius - glm::dot(aside, aside);
    return h < 0 ? kNoDepth : (along - std::sqrt(h / squared)) * view.origin;
}

std::size_t chooseLevel(const LeveledPart& part, float error) {
    std::size_t level = 0;
    while (level + 1 < part.levels.size() && SphereLevels::levelError(part.levels[level + 1].step) <= error) ++level;
    return level;
}

}  // namespace

/// Lists the parts inside the picture, from near to far.
void SeenCopies::placeAll(const ScreenView& view, const Scenery& s) {
    constexpr std::size_t kSlice = 16384;
    struct Slice {
        std::uint32_t part;
        std::span<const std::uint32_t> copies;
    };
    std::vector<Slice> slices;
    for (std::uint32_t p = 0; p < s.levels.parts.size(); ++p) {
        const std::span<const std::uint32_t> all = s.copies.lists[s.levels.parts[p].list];
        for (std::size_t first = 0; first < all.size(); first += kSlice)
            slices.push_back({p, all.subspan(first, std::min(kSlice, all.size() - first))});
    }
    // There may be hundreds of small parts: each task takes several.
    const std::size_t hands = std::min<std::size_t>(slices.size(), 8 * threadsPerTask());
    placedOfSlices_.resize(std::max(placedOfSlices_.size(), hands));
    const auto wide = static_cast<float>(view.width), high = static_cast<float>(view.height);
    inParallel(hands, [&](std::size_t hand) {
        std::vector<Placed>& to = placedOfSlices_[hand];
        const std::size_t first = hand * slices.size() / hands, end = (hand + 1) * slices.size() / hands;
        const std::span<const Slice> own = std::span(slices).subspan(first, end - first);
        to.clear();
        std::size_t most = 0;
        for (const Slice& slice : own) most += slice.copies.size();
        to.reserve(most);  // unused pages are never touched and take no memory
        for (const Slice& slice : own) {
            const LeveledPart& part = s.levels.parts[slice.part];
            for (const std::uint32_t copy : slice.copies) {
                const glm::vec3 center = seen(s, s.copies.transforms[copy], part.center);
                const float Z = view.origin - center.z;
                if (Z + part.radius < view.clipNear || Z - part.radius > view.clipFar) continue;
                const float nearest = Z - part.radius;
                if (view.perspective && nearest <= 0) {  // contains the eye: a part may be in front
                    to.push_back({nearest, wide / 2, high / 2, kNoDepth, slice.part, copy});
                    continue;
                }
                const Disc disc = boundingDisc(view, center, part.radius);
                const glm::vec2 at = toPixel(view, disc.center);
                const float reach = disc.radius * view.pixels;
                if (!(at.x + reach > 0 && at.y + reach > 0 && at.x - reach < wide && at.y - reach < high)) continue;
                to.push_back({nearest, at.x, at.y, reach, slice.part, copy});
            }
        }
    });
    sortNearFirst<2048>(view, std::span(placedOfSlices_).first(hands), sorted_);
}

bool SeenCopies::isHidden(const Band& band, float near, float left, float top, float right, float bottom) const {
    const float room = between_ ? 1 : 0;
    const std::uint32_t x0 = pixelAt(left - room, 0, width_), x1 = pixelAt(right + room, 0, width_);
    const std::uint32_t y1 = pixelAt(bottom + room, band.first, band.end);
    for (std::uint32_t y = pixelAt(top - room, band.first, band.end); y < y1; ++y) {
        const float* row = z_.data() + std::size_t{y} * width_;
        for (std::uint32_t x = x0; x < x1; ++x)
            if (row[x] > near) return false;
    }
    return true;
}

void SeenCopies::drawSphere(const ScreenView& view, const glm::vec3& center, float radius, const Found& what,
                            Band& band) {
    const float Z = view.origin - center.z, nearest = Z - radius;
    const Disc disc = boundingDisc(view, center, radius);
    const glm::vec2 at = toPixel(view, disc.center);
    const float reach = disc.radius * view.pixels, squared = reach * reach;
    const std::uint32_t x0 = pixelAt(at.x - reach, 0, width_), x1 = pixelAt(at.x + reach, 0, width_);
    const std::uint32_t y1 = pixelAt(at.y + reach, band.first, band.end);
    const float perPixel = radius / reach;
    const auto number = static_cast<std::uint32_t>(band.found.size());
    // A sphere that a plane cuts may show surfaces behind it.
    const bool cut = nearest < view.clipNear;
    if (between_) {
        const Reach r{nearest, at.x - reach, at.y - reach, at.x + reach, at.y + reach};
        if (!cut && isHidden(band, r.near, r.left, r.top, r.right, r.bottom)) return;
        band.found.push_back(what);
        band.seen.push_back(cut ? 1 : 0);
        band.reaches.push_back(r);
        if (cut) return;
    }
    for (std::uint32_t y = pixelAt(at.y - reach, band.first, band.end); y < y1; ++y) {
        const float above = static_cast<float>(y) + 0.5f - at.y, within = squared - above * above;
        for (std::uint32_t x = x0; x < x1; ++x) {
            const std::size_t i = std::size_t{y} * width_ + x;
            if (nearest >= z_[i]) continue;
            const float aside = static_cast<float>(x) + 0.5f - at.x, h = within - aside * aside;
            if (h < 0) continue;
            // In perspective the disc holds an ellipse.
            const glm::vec2 place(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const float hit = cut                ? nearest
                              : view.perspective ? hitFromEye(view, center, radius, place)
                                                 : Z - std::sqrt(h) * perPixel;
            if (hit >= z_[i]) continue;
            if (number == band.found.size()) band.found.push_back(what), band.seen.push_back(cut ? 1 : 0);
            if (cut) return;
            z_[i] = hit;
            nearest_[i] = number;
        }
    }
}

void SeenCopies::drawPlaced(const ScreenView& view, const Scenery& s, const Placed& placed, float error, Band& band) {
    constexpr std::uint32_t kSpheres = SphereLevels::kSpheres;
    const float before = view.perspective ? std::max(view.clipNear, 0.0f) : view.clipNear;
    const float left = placed.x - placed.reach, right = placed.x + placed.reach;
    const float top = placed.y - placed.reach, bottom = placed.y + placed.reach;
    if (placed.near > before && isHidden(band, placed.near, left, top, right, bottom)) return;
    const bool aboutTheEye = view.perspective && placed.near <= 0;
    const float pixels = aboutTheEye        ? kNoDepth
                         : view.perspective ? view.pixels * view.origin / placed.near
                                            : view.pixels;
    const LeveledPart& part = s.levels.parts[placed.part];
    const SphereLevel& level = part.levels[chooseLevel(part, error / pixels)];
    const glm::dmat4x3& transform = s.copies.transforms[placed.copy];
    const glm::mat3 turn = s.rotation * glm::dmat3(transform[0], transform[1], transform[2]);
    const glm::vec3 shift = s.rotation * transform[3] + s.shift;
    if (band.copiesOfStep.size() <= level.step) band.copiesOfStep.resize(level.step + 1);
    ++band.copiesOfStep[level.step];
    for (std::uint32_t first = level.first; first < level.first + level.count; first += kSpheres) {
        const std::uint32_t end = std::min(first + kSpheres, level.first + level.count);
        if (level.count > kSpheres) {
            const SphereLevels::Ball& ball = s.levels.balls[first / kSpheres];
            const glm::vec3 center = turn * ball.center + shift;
            const float nearest = view.origin - center.z - ball.radius;
            if (nearest > before) {
                const Disc disc = boundingDisc(view, center, ball.radius);
                const glm::vec2 at = toPixel(view, disc.center);
                const float reach = disc.radius * view.pixels;
                if (isHidden(band, nearest, at.x - reach, at.y - reach, at.x + reach, at.y + reach)) continue;
            }
        }
        for (std::uint32_t i = first; i < end; ++i) {
            const glm::vec3 center = turn * s.levels.spheres[i].center + shift;
            const float radius = s.levels.spheres[i].radius, Z = view.origin - center.z;
            if (Z + radius < view.clipNear || Z - radius > view.clipFar) continue;
            if (view.perspective && Z - radius <= 0) continue;  // about the eye
            drawSphere(view, center, radius, {placed.copy, i, level.step}, band);
        }
    }
}

/// Writes the spheres that are nearest somewhere in the band.
void SeenCopies::write(const Scenery& s, Band& band) {
    for (std::size_t i = std::size_t{band.first} * width_; i < std::size_t{band.end} * width_; ++i)
        if (z_[i] != kNoDepth) band.seen[nearest_[i]] = 1;
    for (std::size_t i = 0; i < band.reaches.size(); ++i) {
        const Reach& r = band.reaches[i];
        if (!isHidden(band, r.near, r.left, r.top, r.right, r.bottom)) band.seen[i] = 1;
    }
    for (std::size_t i = 0; i < band.found.size(); ++i) {
        if (!band.seen[i]) continue;
        const Found& f = band.found[i];
        const Sphere& sphere = s.levels.spheres[f.sphere];
        spheres_.push_back({s.copies.transforms[f.copy] * glm::dvec4(glm::dvec3(sphere.center), 1.0), sphere.radius});
        looks_.push_back(s.levels.looks[f.sphere]);
        std::uint32_t& color = looks_.back().color;
        if (isCopyTint(color) && !s.copies.colors.empty())
            color = tintedColor(s.copies.colors[f.copy % s.copies.colors.size()], color);
        ++levelCounts_[f.step].spheres;
    }
    for (std::size_t step = 0; step < band.copiesOfStep.size(); ++step)
        levelCounts_[step].copies += band.copiesOfStep[step];
}

void SeenCopies::draw(const ScreenView& asked, const Scenery& s, float error, std::uint32_t grid, bool between) {
    constexpr std::size_t kWorth = 4096;  // places per additional thread
    const ScreenView view = finer(asked, grid);
    between_ = between;
    width_ = view.width;
    height_ = view.height;
    placeAll(view, s);
    partRows(
        height_, std::min<std::size_t>(sorted_.size() / kWorth + 1, threadsPerTask()), sorted_,
        [&](const Placed& p) { return pixelAt(p.y, 0, height_ - 1); }, inRow_, rows_);
    bands_.resize(std::max(bands_.size(), rows_.size()));
    z_.resize(std::max(z_.size(), std::size_t{width_} * height_));
    nearest_.resize(z_.size());
    inParallel(rows_.size(), [&](std::size_t b) {
        Band& band = bands_[b];
        band.first = rows_[b].first, band.end = rows_[b].end;
        band.found.clear(), band.copiesOfStep.clear(), band.seen.clear(), band.reaches.clear();
        std::fill(z_.begin() + static_cast<std::ptrdiff_t>(std::size_t{band.first} * width_),
                  z_.begin() + static_cast<std::ptrdiff_t>(std::size_t{band.end} * width_), kNoDepth);
        for (const Placed& placed : sorted_) drawPlaced(view, s, placed, error * static_cast<float>(grid), band);
    });
    spheres_.clear();
    looks_.clear();
    std::uint32_t last = 0;
    for (const LeveledPart& part : s.levels.parts) last = std::max(last, part.levels.back().step);
    levelCounts_.clear();
    for (std::uint32_t step = 0; step <= last; ++step) levelCounts_.push_back({SphereLevels::levelError(step), 0, 0});
    for (std::size_t b = 0; b < rows_.size(); ++b) write(s, bands_[b]);
    std::erase_if(levelCounts_, [](const LevelCount& c) { return c.copies == 0; });
}

}  // namespace nacre
