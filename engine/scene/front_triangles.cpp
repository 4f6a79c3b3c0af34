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
constexpr std::int32_t kAround = 2;  // a pixel whose centre is beside a box, and its neighbour
constexpr float kBehindAll = -std::numeric_limits<float>::max();

}  // namespace

/// The nearest triangle of each pixel.
struct FrontTriangles::Picture {
    // Bounds of the key of the nearest triangle that certainly contains the centre.
    std::vector<float> behind, before;
    std::vector<std::uint32_t> index;
    std::vector<std::uint8_t> rows;  // that hold anything
    std::size_t pitch = 0;  // pixels per row: with room for lanes beyond it, since the next may be another thread's

    void begin(const TriangleLens& lens) {
        pitch = std::size_t{lens.width} + kLanes;
        const std::size_t pixels = pitch * lens.height;
        for (auto* plane : {&behind, &before}) plane->resize(std::max(plane->size(), pixels));
        index.resize(std::max(index.size(), pixels));
        rows.assign(lens.height, 0);
    }

    void beginRow(std::size_t y) {
        if (rows[y]) return;
        rows[y] = 1;
        for (auto* plane : {&behind, &before}) std::fill_n(plane->data() + y * pitch, pitch, kBehindAll);
        std::fill_n(index.data() + y * pitch, pitch, kNone);
    }

    /// The certain triangle of a pixel; kNone: none.
    std::uint32_t at(std::size_t x, std::size_t y) const { return rows[y] ? index[y * pitch + x] : kNone; }

    /// Whether the nearest point of a box is certainly behind each of its pixels.
    bool isHidden(const TriangleLens& lens, const Box& box) const {
        if (lens.perspective && !(box.nearest > 0)) return false;
        const float nearest = lens.keyOf(box.nearest);
        const Lanes key = Lanes{} + (nearest + lens.errorOfKey(nearest));
        for (std::int32_t y = box.top; y < box.bottom; ++y) {
            if (!rows[static_cast<std::size_t>(y)]) return false;
            const float* row = &behind[static_cast<std::size_t>(y) * pitch];
            for (std::int32_t x = box.left; x < box.right; x += static_cast<std::int32_t>(kLanes)) {
                const Lanes within = static_cast<float>(box.right - x) - 0.5f - Lanes{0, 1, 2, 3};
                if (signsOf(bitsOf(key - loadLanes(row + x)) | bitsOf(within)) != (1u << kLanes) - 1) return false;
            }
        }
        return true;
    }

    /// Whether all samples of the pixels that a box meets, and those of their neighbours' centres, show what is nearer.
    bool covers(const TriangleLens& lens, Box box) const {
        box.left = std::max(box.left - kAround, 0);
        box.top = std::max(box.top - kAround, 0);
        box.right = std::min(box.right + kAround, static_cast<std::int32_t>(lens.width));
        box.bottom = std::min(box.bottom + kAround, static_cast<std::int32_t>(lens.height));
        return isHidden(lens, box);
    }
};

/// What one thread draws: rows of the picture.
class FrontTriangles::Band {
public:
    explicit Band(Picture& picture) : picture_(picture) {}

    void begin() {
        doubts_.clear();
        drawn_.clear();
    }
    void take(const RowBand& rows) {
        first_ = static_cast<std::int32_t>(rows.first);
        end_ = static_cast<std::int32_t>(rows.end);
    }

    /// Draws the groups of these rows, in their order. @param corners  of all vertices @param keeps  whether to keep
    /// boxes
    void draw(const TriangleLens& lens, std::span<const Group> groups, std::span<const Placed> sorted,
              const glm::vec4* corners, bool keeps) {
        mine_.clear();
        for (const Placed& placed : sorted)
            if (placed.top < end_ && placed.bottom > first_) mine_.push_back(&placed);
        for (std::size_t i = 0; i < mine_.size(); ++i) {
            if (i + 2 < mine_.size()) fetch(groups[mine_[i + 2]->group]);
            if (i + 1 < mine_.size()) fetch(groups[mine_[i + 1]->group], corners);
            draw(lens, groups[mine_[i]->group], mine_[i]->group, corners, keeps);
        }
    }

    /// Triangles that may be nearer than those of the pixels, some of them several times.
    const std::vector<std::uint32_t>& doubts() const { return doubts_; }
    struct Drawn {
        std::uint32_t group;
        decltype(TriangleShapes::boxes) boxes;
    };
    const std::vector<Drawn>& drawn() const { return drawn_; }

private:
    Box within(Box box) const {
        box.top = std::max(box.top, first_);
        box.bottom = std::min(box.bottom, end_);
        return box;
    }
    void doubt(std::uint32_t index) {
        if (doubts_.empty() || doubts_.back() != index) doubts_.push_back(index);
    }

    // Groups are apart in memory, and a thread goes through them in an order of its own.
    static void fetch(const Group& group) {
        constexpr std::uint32_t kOfLine = 64 / sizeof(Triangle);
        for (std::uint32_t i = 0; i < group.count; i += kOfLine) __builtin_prefetch(group.triangles + i);
    }
    static void fetch(const Group& group, const glm::vec4* corners) {
        for (std::uint32_t i = 0; i < group.count; ++i) __builtin_prefetch(corners + group.triangles[i].a);
    }

    void draw(const TriangleLens& lens, const Group& group, std::uint32_t number, const glm::vec4* corners,
              bool keeps) {
        shapes_.place(lens, group.triangles, group.count, corners);
        if (keeps) drawn_.push_back({number, shapes_.boxes});
        // Front faces of a solid are in front of its back faces.
        std::array<std::uint32_t, 2 * kGroup> order;
        std::size_t begin = kGroup, end = kGroup;
        const std::uint32_t index = number * kGroup;
        for (std::uint32_t first = 0; first < group.count; first += kLanes) {
            if (picture_.isHidden(lens, within(shapes_.boxes[first / kLanes]))) continue;
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

    /// Whether a triangle is fully in front of the eye; another one is in doubt.
    bool isBeforeEye(std::uint32_t i, std::uint32_t index) {
        if (shapes_.nearest[i] > 0) return true;
        doubt(index + i);
        return false;
    }

    /// Draws a triangle that certainly contains the centre, between two keys, and is not certainly hidden.
    void meet(std::size_t at, float behind, float before, std::uint32_t index) {
        if (before < picture_.behind[at]) return;
        const bool wins = behind > picture_.before[at];
        const bool nearer = behind + before > picture_.behind[at] + picture_.before[at];
        if (!wins) doubt(nearer ? picture_.index[at] : index);
        if (!wins && !nearer) return;
        picture_.behind[at] = behind;
        picture_.before[at] = before;
        picture_.index[at] = index;
    }

    /// Draws a triangle that certainly contains these centres, where it is certainly the nearest. @returns where it is
    std::uint32_t takeCertain(std::size_t at, Lanes behind, Lanes before, std::uint32_t index, std::uint32_t lanes) {
        constexpr Mask kBit = {1, 2, 4, 8};
        const Lanes ofBehind = loadLanes(&picture_.behind[at]), ofBefore = loadLanes(&picture_.before[at]);
        const Mask wins = ((kBit & static_cast<std::int32_t>(lanes)) != 0) & (behind > ofBefore);
        Mask ofIndex;
        std::memcpy(&ofIndex, &picture_.index[at], sizeof ofIndex);
        storeLanes(wins ? behind : ofBehind, &picture_.behind[at]);
        storeLanes(wins ? before : ofBefore, &picture_.before[at]);
        ofIndex = wins ? Mask{} + static_cast<std::int32_t>(index) : ofIndex;
        std::memcpy(&picture_.index[at], &ofIndex, sizeof ofIndex);
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
            meet(at, before - 2 * error, before, index);
        else
            doubt(index);
    }

    void draw(const TriangleLens& lens, std::uint32_t i, std::uint32_t index);

    Picture& picture_;
    std::int32_t first_ = 0, end_ = 0;  // rows
    TriangleShapes shapes_;
    std::vector<std::uint32_t> doubts_;
    std::vector<Drawn> drawn_;
    std::vector<const Placed*> mine_;
};

NACRE_CLONED void FrontTriangles::Band::draw(const TriangleLens& lens, std::uint32_t i, std::uint32_t index) {
    const TriangleShapes& s = shapes_;
    const std::int32_t left = s.left[i], right = s.right[i], top = std::max(s.top[i], first_),
                       bottom = std::min(s.bottom[i], end_);
    for (std::int32_t y = top; y < bottom; ++y) picture_.beginRow(static_cast<std::size_t>(y));
    const Lanes inside[] = {Lanes{} + s.inside[0][i], Lanes{} + s.inside[1][i], Lanes{} + s.inside[2][i]};
    for (std::int32_t x = left; x < right; x += static_cast<std::int32_t>(kLanes)) {
        const Lanes columns = Lanes{0, 1, 2, 3} + static_cast<float>(x - left);
        const auto inRow = [&](const TriangleShapes::Plane& p) { return p.start[i] + p.right[i] * columns; };
        const Lanes a = inRow(s.edges[0]), b = inRow(s.edges[1]), c = inRow(s.edges[2]),
                    key = inRow(s.key) + s.error[i];
        const Mask within = bitsOf(static_cast<float>(right - left) - 0.5f - columns);
        std::size_t at = static_cast<std::size_t>(top) * picture_.pitch + static_cast<std::size_t>(x);
        auto down = static_cast<float>(top - s.top[i]);
        for (std::int32_t y = top; y < bottom; ++y, ++down, at += picture_.pitch) {
            const Lanes ofA = a + s.edges[0].down[i] * down, ofB = b + s.edges[1].down[i] * down,
                        ofC = c + s.edges[2].down[i] * down, before = key + s.key.down[i] * down;
            const Mask outside =
                bitsOf(ofA) | bitsOf(ofB) | bitsOf(ofC) | bitsOf(before - loadLanes(&picture_.behind[at]));
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

FrontTriangles::FrontTriangles() : picture_(std::make_unique<Picture>()) {}
FrontTriangles::~FrontTriangles() = default;

void FrontTriangles::begin(const TileView& view) {
    view_ = view;
    lens_ = TriangleLens(view);
    groups_.clear();
    numbers_.clear();
    picture_->begin(lens_);
    for (Band& band : bands_) band.begin();
}

/// Where a ball may show. Without one: anywhere.
FrontTriangles::Placed FrontTriangles::place(const Group& group, std::uint32_t number) const {
    constexpr float kRoom = 1.0f / 16;  // pixels, for rounding
    const auto height = static_cast<float>(lens_.height);
    Placed placed{-std::numeric_limits<float>::max(), number, 0, static_cast<std::int32_t>(lens_.height)};
    if (!group.ball) return placed;
    const glm::vec3 center = nacre::placed(group.rows, group.ball->center);
    const float Z = view_.origin - center.z - group.ball->radius - 2 * lens_.errorOfZ;
    if (view_.perspective && !(Z > 0)) return placed;
    const Disc disc = discOf(view_, center, group.ball->radius);
    const glm::vec2 at = pixelOf(view_, disc.center);
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
    constexpr std::uint32_t kDepths = 128;  // within one, neighbours in memory follow each other
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
    while (bands_.size() < rows_.size()) bands_.emplace_back(*picture_);
    inParallel(rows_.size(), [&](std::size_t b) {
        bands_[b].take(rows_[b]);
        bands_[b].draw(lens_, groups_, sorted_, corners.data(), view_.edges);
    });
}

/// All triangles that samples between centres may see.
void FrontTriangles::doubtUncovered(const Band& band) {
    constexpr std::size_t kSlice = 256;  // groups
    const auto& drawn = band.drawn();
    inParallel((drawn.size() + kSlice - 1) / kSlice, [&](std::size_t slice) {
        for (std::size_t i = slice * kSlice; i < std::min((slice + 1) * kSlice, drawn.size()); ++i)
            for (std::uint32_t four = 0; four * kLanes < groups_[drawn[i].group].count; ++four) {
                const Box& box = drawn[i].boxes[four];
                if (box.away != kAllAway && !picture_->covers(lens_, box))
                    marks_[drawn[i].group] |= (kAllAway & ~box.away) << four * kLanes;
            }
    });
}

void FrontTriangles::end() {
    marks_.assign(groups_.size(), 0);
    for (const Band& band : bands_) {
        for (const std::uint32_t index : band.doubts()) marks_[index / kGroup] |= 1u << index % kGroup;
        if (view_.edges) doubtUncovered(band);
    }
    doubts_.clear();
    for (std::size_t group = 0; group < groups_.size(); ++group)
        for (std::uint32_t bits = marks_[group]; bits != 0; bits &= bits - 1) {
            const auto i = static_cast<std::uint32_t>(std::countr_zero(bits));
            if (i < groups_[group].count) doubts_.push_back(static_cast<std::uint32_t>(group) * kGroup + i);
        }
}

std::uint32_t FrontTriangles::numberOf(std::uint32_t index) const { return numbers_[index / kGroup] + index % kGroup; }

const Triangle& FrontTriangles::doubt(std::size_t index, const glm::vec4*& rows, std::uint32_t& number) const {
    const Group& group = groups_[doubts_[index] / kGroup];
    rows = group.rows;
    number = numberOf(doubts_[index]);
    return group.triangles[doubts_[index] % kGroup];
}

bool FrontTriangles::isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const {
    for (; y < std::min(endY, lens_.height); ++y) {
        if (!picture_->rows[y]) continue;
        for (std::uint32_t at = x; at < std::min(endX, lens_.width); ++at)
            if (picture_->at(at, y) != kNone) return true;
    }
    return false;
}

void FrontTriangles::write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
    const bool any = y < lens_.height && picture_->rows[y];
    const std::uint32_t end = any ? std::clamp(lens_.width, x, x + count) : x;
    const std::uint32_t* row = picture_->index.data() + y * picture_->pitch;
    for (std::uint32_t at = x; at < end; ++at) *to++ = row[at] == kNone ? 0 : numberOf(row[at]);
    std::fill_n(to, x + count - end, 0u);
}

}  // namespace nacre
