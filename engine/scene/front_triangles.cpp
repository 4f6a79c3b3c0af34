#include "engine/scene/front_triangles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "engine/scene/lanes.h"
#include "engine/threads.h"

namespace nacre {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::uint32_t kGroup = TriangleShapes::kMost;
constexpr std::uint32_t kAllAway = (1u << kLanes) - 1;
constexpr float kBehindAll = -std::numeric_limits<float>::max();

}  // namespace

/// Triangles drawn by one thread.
class FrontTriangles::Layer {
public:
    void begin(const TriangleLens& lens) {
        const std::size_t pixels = std::size_t{lens.width} * lens.height + kLanes;
        for (auto* plane : {&behind_, &before_}) plane->resize(std::max(plane->size(), pixels));
        index_.resize(std::max(index_.size(), pixels));
        rows_.assign(lens.height, 0);
        doubts_.clear();
    }

    /// Makes room for the doubts about so many groups.
    void expect(std::size_t groups) { doubts_.resize(groups); }

    /// @param index  of the group's first triangle
    /// @param boxes  receives bounds of each four triangles; null: none
    void draw(const TriangleLens& lens, const Group& group, std::uint32_t index, const glm::vec4* corners, Box* boxes) {
        shapes_.place(lens, group.triangles, group.count, corners);
        if (boxes) std::copy(shapes_.boxes.begin(), shapes_.boxes.end(), boxes);
        // Front faces of a solid are in front of its back faces.
        std::array<std::uint32_t, 2 * kGroup> order;
        std::size_t begin = kGroup, end = kGroup;
        for (std::uint32_t first = 0; first < group.count; first += kLanes) {
            if (isHidden(lens, shapes_.boxes[first / kLanes])) continue;
            shapes_.findPlanes(lens, first);
            for (std::uint32_t i = first; i < std::min(first + kLanes, group.count); ++i) {
                if (lens.perspective && !isBeforeEye(i, index)) continue;
                const bool holds = shapes_.holdsCenter(i), away = shapes_.turnedAway[i];
                order[end] = order[begin - 1] = i;
                end += holds && away;
                begin -= holds && !away;
            }
        }
        for (std::size_t k = begin; k < end; ++k) draw(lens, order[k], index + order[k]);
    }

    /// Merges a row of pixels of another layer into this one. @param doubtful  receives triangles that become doubtful
    /// now
    template <typename Doubtful>
    void takeRow(const TriangleLens& lens, const Layer& other, std::size_t y, const Doubtful& doubtful) {
        if (!other.rows_[y]) return;
        beginRow(lens, y);
        for (std::size_t at = y * lens.width; at < (y + 1) * lens.width; ++at)
            if (other.index_[at] != kNone) meet(at, other.behind_[at], other.before_[at], other.index_[at], doubtful);
    }
    void takeDoubts(const Layer& other) {
        doubts_.resize(std::max(doubts_.size(), other.doubts_.size()));
        for (std::size_t group = 0; group < other.doubts_.size(); ++group) doubts_[group] |= other.doubts_[group];
    }
    void doubt(std::uint32_t index) { doubts_[index / kGroup] |= 1u << index % kGroup; }

    /// The certain triangle of a pixel; kNone: none.
    std::uint32_t at(const TriangleLens& lens, std::size_t x, std::size_t y) const {
        return rows_[y] ? index_[y * lens.width + x] : kNone;
    }
    bool anyIn(std::size_t y) const { return rows_[y] != 0; }

    /// Whether all samples of the pixels that a box meets, and those of their neighbours' centres, show what is nearer.
    bool covers(const TriangleLens& lens, Box box) const {
        constexpr std::int32_t kAround = 2;  // a pixel whose centre is beside the box, and its neighbour
        box.left = std::max(box.left - kAround, 0);
        box.top = std::max(box.top - kAround, 0);
        box.right = std::min(box.right + kAround, static_cast<std::int32_t>(lens.width));
        box.bottom = std::min(box.bottom + kAround, static_cast<std::int32_t>(lens.height));
        return isHidden(lens, box);
    }
    /// For each group the triangles that may be nearer than those of the pixels, one bit each.
    const std::vector<std::uint32_t>& doubts() const { return doubts_; }

private:
    /// Whether a triangle is fully in front of the eye; another one is in doubt.
    bool isBeforeEye(std::uint32_t i, std::uint32_t index) {
        if (shapes_.nearest[i] > 0) return true;
        doubt(index + i);
        return false;
    }

    /// Whether the nearest point of a box is certainly behind each of its pixels.
    bool isHidden(const TriangleLens& lens, const Box& box) const {
        if (lens.perspective && !(box.nearest > 0)) return false;
        const float nearest = lens.keyOf(box.nearest);
        const Lanes key = Lanes{} + (nearest + lens.errorOfKey(nearest));
        for (std::int32_t y = box.top; y < box.bottom; ++y) {
            if (!rows_[static_cast<std::size_t>(y)]) return false;
            const float* behind = &behind_[static_cast<std::size_t>(y) * lens.width];
            for (std::int32_t x = box.left; x < box.right; x += static_cast<std::int32_t>(kLanes)) {
                const Lanes within = static_cast<float>(box.right - x) - 0.5f - Lanes{0, 1, 2, 3};
                if (signsOf(bitsOf(key - loadLanes(behind + x)) | bitsOf(within)) != (1u << kLanes) - 1) return false;
            }
        }
        return true;
    }

    void beginRow(const TriangleLens& lens, std::size_t y) {
        if (rows_[y]) return;
        rows_[y] = 1;
        const std::size_t at = y * lens.width;
        for (auto* plane : {&behind_, &before_})
            std::fill_n(plane->begin() + static_cast<std::ptrdiff_t>(at), lens.width, kBehindAll);
        std::fill_n(index_.begin() + static_cast<std::ptrdiff_t>(at), lens.width, kNone);
    }

    /// Draws a triangle that certainly contains the centre, between two keys, and is not certainly hidden.
    template <typename Doubtful>
    void meet(std::size_t at, float behind, float before, std::uint32_t index, const Doubtful& doubtful) {
        if (before < behind_[at]) return;
        const bool wins = behind > before_[at];
        const bool nearer = behind + before > behind_[at] + before_[at];
        if (!wins) doubtful(nearer ? index_[at] : index);
        if (!wins && !nearer) return;
        behind_[at] = behind;
        before_[at] = before;
        index_[at] = index;
    }

    /// Draws a triangle that certainly contains these centres, where it is certainly the nearest. @returns where it is
    std::uint32_t takeCertain(std::size_t at, Lanes behind, Lanes before, std::uint32_t index, std::uint32_t lanes) {
        constexpr Mask kBit = {1, 2, 4, 8};
        const Lanes ofBehind = loadLanes(&behind_[at]), ofBefore = loadLanes(&before_[at]);
        const Mask wins = ((kBit & static_cast<std::int32_t>(lanes)) != 0) & (behind > ofBefore);
        Mask ofIndex;
        std::memcpy(&ofIndex, &index_[at], sizeof ofIndex);
        storeLanes(wins ? behind : ofBehind, &behind_[at]);
        storeLanes(wins ? before : ofBefore, &before_[at]);
        ofIndex = wins ? Mask{} + static_cast<std::int32_t>(index) : ofIndex;
        std::memcpy(&index_[at], &ofIndex, sizeof ofIndex);
        return signsOf(wins);
    }

    /// One that may hold a centre, with the largest key that it may have there.
    void hold(const TriangleLens& lens, std::uint32_t i, std::uint32_t index, std::size_t at, float before,
              bool certain) {
        const float error = shapes_.error[i];
        if (lens.clips && !shapes_.splinter[i]) {
            const float key = before - error, Z = lens.perspective ? 1.0f / key : -key;
            const float room = lens.perspective ? error * Z * Z : error;
            if (Z + room < lens.clipNear || Z - room > lens.clipFar) return;
            if (Z - room <= lens.clipNear || Z + room >= lens.clipFar) certain = false;
        }
        if (certain)
            meet(at, before - 2 * error, before, index, [&](std::uint32_t other) { doubt(other); });
        else
            doubt(index);
    }

    void draw(const TriangleLens& lens, std::uint32_t i, std::uint32_t index);

    TriangleShapes shapes_;
    // Bounds of the key of the nearest triangle that certainly contains the centre.
    std::vector<float> behind_, before_;
    std::vector<std::uint32_t> index_;
    std::vector<std::uint8_t> rows_;     // that hold anything
    std::vector<std::uint32_t> doubts_;  // doubts()
};

NACRE_CLONED void FrontTriangles::Layer::draw(const TriangleLens& lens, std::uint32_t i, std::uint32_t index) {
    const TriangleShapes& s = shapes_;
    const std::int32_t left = s.left[i], right = s.right[i], top = s.top[i], bottom = s.bottom[i];
    for (std::int32_t y = top; y < bottom; ++y) beginRow(lens, static_cast<std::size_t>(y));
    const Lanes inside[] = {Lanes{} + s.inside[0][i], Lanes{} + s.inside[1][i], Lanes{} + s.inside[2][i]};
    for (std::int32_t x = left; x < right; x += static_cast<std::int32_t>(kLanes)) {
        const Lanes columns = Lanes{0, 1, 2, 3} + static_cast<float>(x - left);
        const auto inRow = [&](const TriangleShapes::Plane& p) { return p.start[i] + p.right[i] * columns; };
        const Lanes a = inRow(s.edges[0]), b = inRow(s.edges[1]), c = inRow(s.edges[2]),
                    key = inRow(s.key) + s.error[i];
        const Mask within = bitsOf(static_cast<float>(right - left) - 0.5f - columns);
        std::size_t at = static_cast<std::size_t>(top) * lens.width + static_cast<std::size_t>(x);
        float down = 0;
        for (std::int32_t y = top; y < bottom; ++y, ++down, at += lens.width) {
            const Lanes ofA = a + s.edges[0].down[i] * down, ofB = b + s.edges[1].down[i] * down,
                        ofC = c + s.edges[2].down[i] * down, before = key + s.key.down[i] * down;
            const Mask outside = bitsOf(ofA) | bitsOf(ofB) | bitsOf(ofC) | bitsOf(before - loadLanes(&behind_[at]));
            std::uint32_t held = ~signsOf(outside | within) & ((1u << kLanes) - 1);
            if (held == 0) continue;
            const std::uint32_t certain =
                signsOf(bitsOf(inside[0] - ofA) & bitsOf(inside[1] - ofB) & bitsOf(inside[2] - ofC));
            if (!lens.clips) held &= ~takeCertain(at, before - 2 * s.error[i], before, index, held & certain);
            for (; held != 0; held &= held - 1) {
                const auto k = static_cast<std::uint32_t>(std::countr_zero(held));
                hold(lens, i, index, at + k, before[k], (certain >> k & 1) != 0);
            }
        }
    }
}

FrontTriangles::FrontTriangles() = default;
FrontTriangles::~FrontTriangles() = default;

void FrontTriangles::begin(const TileView& view) {
    lens_ = TriangleLens(view);
    edges_ = view.edges;
    groups_.clear();
    used_ = 0;
    layer(0);
}

FrontTriangles::Layer& FrontTriangles::layer(std::size_t number) {
    while (layers_.size() <= number) layers_.push_back(std::make_unique<Layer>());
    for (; used_ <= number; ++used_) layers_[used_]->begin(lens_);
    return *layers_[number];
}

void FrontTriangles::draw(std::span<const Run> runs, std::span<const glm::vec4> corners) {
    const std::size_t before = groups_.size();
    for (const Run& run : runs)
        for (std::size_t first = 0; first < run.triangles.size(); first += kGroup) {
            const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(kGroup, run.triangles.size() - first));
            groups_.push_back({&run.triangles[first], count, run.rows, run.number + static_cast<std::uint32_t>(first)});
        }
    const std::size_t count = groups_.size() - before;
    constexpr std::size_t kGroupsOfThread = 512, kMostThreads = 8, kMostPixels = 8'000'000;  // of all layers
    const std::size_t pixels = std::max<std::size_t>(std::size_t{lens_.width} * lens_.height, 1);
    const std::size_t threads =
        std::min({count / kGroupsOfThread + 1, kMostThreads, kMostPixels / pixels + 1, std::size_t{threadsPerTask()}});
    layer(threads - 1);
    for (std::size_t i = 0; i < threads; ++i) layers_[i]->expect(groups_.size());
    if (edges_) boxes_.resize(groups_.size());
    // In turns: neighbouring groups take about as long.
    constexpr std::size_t kTurn = 64;
    inParallel(threads, [&](std::size_t thread) {
        for (std::size_t turn = before + thread * kTurn; turn < groups_.size(); turn += threads * kTurn)
            for (std::size_t i = turn; i < std::min(turn + kTurn, groups_.size()); ++i)
                layers_[thread]->draw(lens_, groups_[i], static_cast<std::uint32_t>(i) * kGroup, corners.data(),
                                      edges_ ? boxes_[i].data() : nullptr);
    });
}

/// Puts what the threads drew into the first layer.
void FrontTriangles::merge() {
    constexpr std::size_t kRows = 64;  // of a slice
    Layer& all = *layers_[0];
    if (used_ == 1) return;
    const std::size_t slices = (lens_.height + kRows - 1) / kRows;
    doubtsOfSlices_.resize(std::max(doubtsOfSlices_.size(), slices));
    inParallel(slices, [&](std::size_t slice) {
        std::vector<std::uint32_t>& doubts = doubtsOfSlices_[slice];
        doubts.clear();
        for (std::size_t i = 1; i < used_; ++i)
            for (std::size_t y = slice * kRows; y < std::min<std::size_t>((slice + 1) * kRows, lens_.height); ++y)
                all.takeRow(lens_, *layers_[i], y, [&](std::uint32_t index) { doubts.push_back(index); });
    });
    for (std::size_t i = 1; i < used_; ++i) all.takeDoubts(*layers_[i]);
    for (std::size_t slice = 0; slice < slices; ++slice)
        for (const std::uint32_t index : doubtsOfSlices_[slice]) all.doubt(index);
}

/// All triangles that samples between centres may see.
void FrontTriangles::doubtUncovered() {
    constexpr std::size_t kSlice = 256;  // groups
    Layer& all = *layers_[0];
    inParallel((groups_.size() + kSlice - 1) / kSlice, [&](std::size_t slice) {
        for (std::size_t i = slice * kSlice; i < std::min((slice + 1) * kSlice, groups_.size()); ++i)
            for (std::uint32_t first = 0; first < groups_[i].count; first += kLanes) {
                const Box& box = boxes_[i][first / kLanes];
                if (box.away == kAllAway || all.covers(lens_, box)) continue;
                for (std::uint32_t k = first; k < std::min(first + kLanes, groups_[i].count); ++k)
                    if ((box.away >> (k - first) & 1) == 0) all.doubt(static_cast<std::uint32_t>(i) * kGroup + k);
            }
    });
}

void FrontTriangles::end() {
    const Layer& all = *layers_[0];
    merge();
    if (edges_) doubtUncovered();
    doubts_.clear();
    for (std::size_t group = 0; group < all.doubts().size(); ++group)
        for (std::uint32_t bits = all.doubts()[group]; bits != 0; bits &= bits - 1)
            doubts_.push_back(static_cast<std::uint32_t>(group) * kGroup +
                              static_cast<std::uint32_t>(std::countr_zero(bits)));
}

std::uint32_t FrontTriangles::numberOf(std::uint32_t index) const {
    return groups_[index / kGroup].number + index % kGroup;
}

const Triangle& FrontTriangles::doubt(std::size_t index, const glm::vec4*& rows, std::uint32_t& number) const {
    const Group& group = groups_[doubts_[index] / kGroup];
    rows = group.rows;
    number = numberOf(doubts_[index]);
    return group.triangles[doubts_[index] % kGroup];
}

bool FrontTriangles::isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const {
    const Layer& all = *layers_[0];
    for (; y < std::min(endY, lens_.height); ++y) {
        if (!all.anyIn(y)) continue;
        for (std::uint32_t at = x; at < std::min(endX, lens_.width); ++at)
            if (all.at(lens_, at, y) != kNone) return true;
    }
    return false;
}

void FrontTriangles::write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
    const Layer& all = *layers_[0];
    const bool any = y < lens_.height && all.anyIn(y);
    for (const std::uint32_t end = x + count; x < end; ++x) {
        const std::uint32_t index = any && x < lens_.width ? all.at(lens_, x, y) : kNone;
        *to++ = index == kNone ? 0 : numberOf(index);
    }
}

}  // namespace nacre
