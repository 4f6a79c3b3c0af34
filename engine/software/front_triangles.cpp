#include "engine/software/front_triangles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "engine/simd/lanes.h"
#include "engine/threads.h"

namespace nacre {
namespace {

constexpr std::uint32_t kNone = TriangleBand::kNone;
constexpr std::uint32_t kGroup = TriangleShapes::kMost;
constexpr std::uint32_t kInBox = 4, kAllAway = (1u << kInBox) - 1;
constexpr std::int32_t kAround = 2;  // a pixel whose centre is beside a box, and its neighbour

}  // namespace

/// Bounds of some triangles.
struct FrontTriangles::Box {
    std::int32_t left = std::numeric_limits<std::int32_t>::max(), right = 0;
    std::int32_t top = std::numeric_limits<std::int32_t>::max(), bottom = 0;
    float nearest = TriangleShapes::kNowhere;
    std::uint32_t away = 0;  // a bit for each triangle that is invisible because it faces away

    void add(const TriangleShapes& s, std::uint32_t i) {
        left = std::min(left, s.left[i]), right = std::max(right, s.right[i]);
        top = std::min(top, s.top[i]), bottom = std::max(bottom, s.bottom[i]);
        nearest = std::min(nearest, s.nearest[i]);
        away |= static_cast<std::uint32_t>(s.nearest[i] == TriangleShapes::kNowhere) << i % kInBox;
    }
};

/// The nearest triangle of each pixel.
struct FrontTriangles::Picture {
    // Bounds of the key of the nearest triangle that certainly contains the centre.
    std::vector<float> behind, before;
    std::vector<std::uint32_t> index;
    std::vector<std::uint8_t> rows;  // rows that are not empty
    std::size_t pitch = 0;           // pixels per row, with room for reads into another thread's row

    void begin(const TriangleLens& lens) {
        pitch = std::size_t{lens.width} + TriangleBand::kRoom;
        const std::size_t pixels = pitch * lens.height;
        for (auto* plane : {&behind, &before}) plane->resize(std::max(plane->size(), pixels));
        index.resize(std::max(index.size(), pixels));
        rows.assign(lens.height, 0);
    }

    /// Whether the nearest point of a box is certainly behind each of its pixels.
    bool isHidden(const TriangleLens& lens, const Box& box) const {
        if (lens.perspective && !(box.nearest > 0)) return false;
        const float nearest = lens.depthKey(box.nearest);
        const Lanes key = Lanes{} + (nearest + lens.errorOfKey(nearest));
        for (std::int32_t y = box.top; y < box.bottom; ++y) {
            if (!rows[static_cast<std::size_t>(y)]) return false;
            const float* row = &behind[static_cast<std::size_t>(y) * pitch];
            for (std::int32_t x = box.left; x < box.right; x += static_cast<std::int32_t>(kLanes)) {
                const Lanes within = static_cast<float>(box.right - x) - 0.5f - Lanes{0, 1, 2, 3};
                if (packSigns(toBits(key - loadLanes(row + x)) | toBits(within)) != (1u << kLanes) - 1) return false;
            }
        }
        return true;
    }

    /// Whether everything in a box is behind all samples of its pixels, and of the pixels around.
    bool covers(const TriangleLens& lens, Box box) const {
        box.left = std::max(box.left - kAround, 0);
        box.top = std::max(box.top - kAround, 0);
        box.right = std::min(box.right + kAround, static_cast<std::int32_t>(lens.width));
        box.bottom = std::min(box.bottom + kAround, static_cast<std::int32_t>(lens.height));
        return isHidden(lens, box);
    }
};

/// Rows of the picture that one thread draws.
class FrontTriangles::Band {
public:
    Band(Picture& picture, const TriangleLanes& lanes) : picture_(picture), lanes_(lanes) {}

    void begin() {
        ambiguous_.clear();
        drawn_.clear();
    }

    /// Draws the groups of some rows, in their order. @param corners  of all vertices @param keeps  whether to keep the
    /// boxes
    void draw(const TriangleLens& lens, const RowBand& rows, std::span<const Group> groups,
              std::span<const Placed> sorted, const glm::vec4* corners, bool keeps) {
        const TriangleBand band = {&lens,
                                   static_cast<std::int32_t>(rows.first),
                                   static_cast<std::int32_t>(rows.end),
                                   picture_.pitch,
                                   picture_.behind.data(),
                                   picture_.before.data(),
                                   picture_.index.data(),
                                   picture_.rows.data(),
                                   &ambiguous_};
        mine_.clear();
        for (const Placed& placed : sorted)
            if (placed.top < band.end && placed.bottom > band.first) mine_.push_back(placed.group);
        for (std::size_t i = 0; i < mine_.size(); ++i) {
            if (i + 2 < mine_.size()) fetch(groups[mine_[i + 2]]);
            if (i + 1 < mine_.size()) fetch(groups[mine_[i + 1]], corners);
            const Group& group = groups[mine_[i]];
            lanes_.draw(band, shapes_, group.triangles, group.count, corners, mine_[i] * kGroup);
            if (keeps) keepBoxes(mine_[i], group.count);
        }
    }

    /// Triangles that may be nearer than those of the pixels; contains duplicates.
    const std::vector<std::uint32_t>& ambiguous() const { return ambiguous_; }
    struct Drawn {
        std::uint32_t group;
        std::array<Box, kGroup / kInBox> boxes;
    };
    const std::vector<Drawn>& drawn() const { return drawn_; }

private:
    // Groups are far apart in memory, and each thread visits them in its own order.
    static void fetch(const Group& group) {
        constexpr std::uint32_t kOfLine = 64 / sizeof(Triangle);
        for (std::uint32_t i = 0; i < group.count; i += kOfLine) __builtin_prefetch(group.triangles + i);
    }
    static void fetch(const Group& group, const glm::vec4* corners) {
        for (std::uint32_t i = 0; i < group.count; ++i) __builtin_prefetch(corners + group.triangles[i].a);
    }
    void keepBoxes(std::uint32_t group, std::uint32_t count) {
        Drawn& drawn = drawn_.emplace_back();
        drawn.group = group;
        for (std::uint32_t i = 0; i < count; ++i) drawn.boxes[i / kInBox].add(shapes_, i);
    }

    Picture& picture_;
    TriangleLanes lanes_;
    TriangleShapes shapes_;
    std::vector<std::uint32_t> ambiguous_;
    std::vector<Drawn> drawn_;
    std::vector<std::uint32_t> mine_;  // groups
};

FrontTriangles::FrontTriangles(const TriangleLanes& lanes) : lanes_(lanes), picture_(std::make_unique<Picture>()) {}
FrontTriangles::~FrontTriangles() = default;

void FrontTriangles::begin(const TileView& view) {
    view_ = view;
    lens_ = TriangleLens(view);
    groups_.clear();
    numbers_.clear();
    picture_->begin(lens_);
    for (Band& band : bands_) band.begin();
}

/// Where a ball may be visible; without one, anywhere.
FrontTriangles::Placed FrontTriangles::place(const Group& group, std::uint32_t number) const {
    constexpr float kRoom = 1.0f / 16;  // pixels, for rounding
    const auto height = static_cast<float>(lens_.height);
    Placed placed{-std::numeric_limits<float>::max(), number, 0, static_cast<std::int32_t>(lens_.height)};
    if (!group.ball) return placed;
    const glm::vec3 center = nacre::placed(group.rows, group.ball->center);
    const float Z = view_.origin - center.z - group.ball->radius - 2 * lens_.errorOfZ;
    if (view_.perspective && !(Z > 0)) return placed;
    const Disc disc = boundingDisc(view_, center, group.ball->radius);
    const glm::vec2 at = toPixel(view_, disc.center);
    const float reach = disc.radius * view_.pixels + kRoom + static_cast<float>(view_.edges ? kAround : 0);
    const auto row = [&](float y) { return static_cast<std::int32_t>(std::min(std::max(y + 0.5f, 0.0f), height)); };
    placed.near = Z;
    placed.top = row(at.y - reach);
    placed.bottom = at.x + reach < 0 || at.x - reach > static_cast<float>(lens_.width) ? placed.top : row(at.y + reach);
    return placed;
}

void FrontTriangles::addGroups(const Run& run) {
    const auto count = static_cast<std::uint32_t>(run.triangles.size());
    for (std::uint32_t first = 0, end = 0; first < count; first = end) {
        end = std::min(count, (run.first + first) / kGroup * kGroup + kGroup - run.first);
        const Chunk* ball = run.chunks.empty() ? nullptr : &run.chunks[(run.first + first) / kGroup];
        groups_.push_back({&run.triangles[first], end - first, run.rows, ball});
        numbers_.push_back(run.number + first);
    }
}

void FrontTriangles::draw(std::span<const Run> runs, std::span<const glm::vec4> corners) {
    constexpr std::size_t kGroupsOfThread = 512, kSlice = 2048;
    constexpr std::uint32_t kDepths = 128;  // within one step, neighbours in memory follow each other
    const std::size_t before = groups_.size();
    for (const Run& run : runs) addGroups(run);
    const std::size_t count = groups_.size() - before;
    placed_.resize(count);
    inParallel((count + kSlice - 1) / kSlice, [&](std::size_t slice) {
        for (std::size_t i = slice * kSlice; i < std::min((slice + 1) * kSlice, count); ++i)
            placed_[i] = place(groups_[before + i], static_cast<std::uint32_t>(before + i));
    });
    sortNearFirst<kDepths>(view_, std::span(&placed_, 1), sorted_);
    const auto threads = std::min<std::size_t>(count / kGroupsOfThread + 1, threadsPerTask());
    partRows(
        lens_.height, threads, placed_,
        [&](const Placed& p) {
            return static_cast<std::uint32_t>(
                std::min((p.top + p.bottom) / 2, static_cast<std::int32_t>(lens_.height) - 1));
        },
        inRow_, rows_);
    while (bands_.size() < rows_.size()) bands_.emplace_back(*picture_, lanes_);
    inParallel(rows_.size(),
               [&](std::size_t b) { bands_[b].draw(lens_, rows_[b], groups_, sorted_, corners.data(), view_.edges); });
}

/// Adds all triangles that samples between centres may see.
void FrontTriangles::doubtUncovered(const Band& band) {
    constexpr std::size_t kSlice = 256;  // groups
    const auto& drawn = band.drawn();
    inParallel((drawn.size() + kSlice - 1) / kSlice, [&](std::size_t slice) {
        for (std::size_t i = slice * kSlice; i < std::min((slice + 1) * kSlice, drawn.size()); ++i)
            for (std::uint32_t four = 0; four * kInBox < groups_[drawn[i].group].count; ++four) {
                const Box& box = drawn[i].boxes[four];
                if (box.away != kAllAway && !picture_->covers(lens_, box))
                    marks_[drawn[i].group] |= (kAllAway & ~box.away) << four * kInBox;
            }
    });
}

void FrontTriangles::end() {
    marks_.assign(groups_.size(), 0);
    for (const Band& band : bands_) {
        for (const std::uint32_t index : band.ambiguous()) marks_[index / kGroup] |= 1u << index % kGroup;
        if (view_.edges) doubtUncovered(band);
    }
    ambiguous_.clear();
    for (std::size_t group = 0; group < groups_.size(); ++group)
        for (std::uint32_t bits = marks_[group]; bits != 0; bits &= bits - 1) {
            const auto i = static_cast<std::uint32_t>(std::countr_zero(bits));
            if (i < groups_[group].count) ambiguous_.push_back(static_cast<std::uint32_t>(group) * kGroup + i);
        }
}

std::uint32_t FrontTriangles::triangleNumber(std::uint32_t index) const {
    return numbers_[index / kGroup] + index % kGroup;
}

const Triangle& FrontTriangles::doubt(std::size_t index, const glm::vec4*& rows, std::uint32_t& number) const {
    const Group& group = groups_[ambiguous_[index] / kGroup];
    rows = group.rows;
    number = triangleNumber(ambiguous_[index]);
    return group.triangles[ambiguous_[index] % kGroup];
}

bool FrontTriangles::isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const {
    for (; y < std::min(endY, lens_.height); ++y) {
        if (!picture_->rows[y]) continue;
        const std::uint32_t* row = &picture_->index[y * picture_->pitch];
        std::uint32_t all = kNone;  // has all bits: compilers can vectorise this
        for (std::uint32_t at = x; at < std::min(endX, lens_.width); ++at) all &= row[at];
        if (all != kNone) return true;
    }
    return false;
}

void FrontTriangles::write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
    const bool any = y < lens_.height && picture_->rows[y];
    const std::uint32_t end = any ? std::clamp(lens_.width, x, x + count) : x;
    const std::uint32_t* row = picture_->index.data() + y * picture_->pitch;
    for (std::uint32_t at = x; at < end; ++at) *to++ = row[at] == kNone ? 0 : triangleNumber(row[at]);
    std::fill_n(to, x + count - end, 0u);
}

}  // namespace nacre
