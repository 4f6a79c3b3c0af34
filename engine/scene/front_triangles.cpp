#include "engine/scene/front_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "engine/mesh/parallel.h"
#include "engine/scene/tile_view.h"

namespace nacre {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr float kBehindAll = -std::numeric_limits<float>::max();
constexpr std::uint32_t kGroup = 32, kLanes = 4;

/// Neighbouring pixels, as processors take them at once.
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using Mask = std::int32_t __attribute__((vector_size(kLanes * sizeof(float))));

bool any(const Mask& mask) {
    std::uint64_t halves[2];
    std::memcpy(halves, &mask, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

template <typename T>
T side(T ax, T ay, T bx, T by) {
    return ax * by - ay * bx;
}
float lesser(float a, float b) { return a < b ? a : b; }
float greater(float a, float b) { return a > b ? a : b; }
float least(float a, float b, float c) { return lesser(a, lesser(b, c)); }
float most(float a, float b, float c) { return greater(a, greater(b, c)); }

}  // namespace

/// How a view looks at triangles. The key of a depth is the larger, the nearer, and linear in the picture.
struct FrontTriangles::Lens {
    std::uint32_t width = 0, height = 0;
    bool perspective = false;
    float axisX = 0, axisY = 0, error = 0;  // pixels
    float errorOfZ = 0;
    bool clips = false;
    float clipNear = 0, clipFar = 0;  // Z

    float errorOfKey(float key) const { return errorOfZ * (perspective ? key * key : 1.0f); }
};

/// Triangles of a group in the picture, counter-clockwise: each number of theirs by itself, found in loops that a
/// compiler makes vectors of.
struct FrontTriangles::Shapes {
    template <typename T>
    using Row = std::array<T, kGroup>;

    Row<float> x[3], y[3], key[3];               // of the corners
    Row<std::int32_t> left, right, top, bottom;  // pixels whose centres it may hold; right and bottom are one past
    Row<float> room[3];  // of an edge function, on the edge across from a corner: what rounding does to it
    Row<float> perArea;  // 1 / (twice its area)
    Row<float> error;    // of a key within it
    Row<float> nearest;  // key
    Row<float> nearestZ;
    Row<std::int32_t> splinter;  // so narrow that nothing about it is certain
    Row<std::int32_t> turnedAway;

    void gather(const Triangle* triangles, std::uint32_t count, std::span<const glm::vec3> corners) {
        for (std::uint32_t i = 0; i < kGroup; ++i) {
            const Triangle& t = triangles[i < count ? i : count - 1];
            const std::uint32_t at[] = {t.a, t.b, t.c};
            for (int k = 0; k < 3; ++k) {
                const glm::vec3& p = corners[at[k]];
                x[k][i] = p.x;
                y[k][i] = p.y;
                key[k][i] = p.z;
            }
        }
    }

    void find(const Lens& lens) {
        findPlaces(lens);
        findErrors(lens);
    }

    bool holdsCenter(std::uint32_t i) const { return left[i] < right[i] && top[i] < bottom[i]; }

private:
    void findPlaces(const Lens& lens) {
        constexpr float kRoom = 1.0f / 32;
        const float width = static_cast<float>(lens.width), height = static_cast<float>(lens.height);
        // Whole numbers are cut off towards 0, where the picture begins.
        const auto pixelAt = [](float place, float size) {
            return static_cast<std::int32_t>(lesser(greater(place, 0.0f), size));
        };
        for (std::uint32_t i = 0; i < kGroup; ++i) {
            left[i] = pixelAt(least(x[0][i], x[1][i], x[2][i]) + (0.5f - kRoom), width);
            right[i] = pixelAt(most(x[0][i], x[1][i], x[2][i]) + (0.5f + kRoom), width);
            top[i] = pixelAt(least(y[0][i], y[1][i], y[2][i]) + (0.5f - kRoom), height);
            bottom[i] = pixelAt(most(y[0][i], y[1][i], y[2][i]) + (0.5f + kRoom), height);
        }
        for (std::uint32_t i = 0; i < kGroup; ++i) {
            const float area = side(x[1][i] - x[0][i], y[1][i] - y[0][i], x[2][i] - x[0][i], y[2][i] - y[0][i]);
            const bool turns = area < 0;
            perArea[i] = turns ? -area : area;
            turnedAway[i] = !turns;  // rows run downwards
            nearestZ[i] = least(key[0][i], key[1][i], key[2][i]);
            for (auto* of : {&x, &y, &key}) {
                const float b = (*of)[1][i], c = (*of)[2][i];
                (*of)[1][i] = turns ? c : b;
                (*of)[2][i] = turns ? b : c;
            }
        }
    }

    void findErrors(const Lens& lens) {
        const auto length = [&](int from, int to, std::uint32_t i) {
            return std::abs(x[to][i] - x[from][i]) + std::abs(y[to][i] - y[from][i]);
        };
        for (int k = 0; k < 3; ++k)
            for (std::uint32_t i = 0; i < kGroup; ++i) key[k][i] = lens.perspective ? 1 / key[k][i] : -key[k][i];
        for (std::uint32_t i = 0; i < kGroup; ++i) {
            float off = 0;
            for (int k = 0; k < 3; ++k)
                off = greater(off, greater(std::abs(x[k][i] - lens.axisX), std::abs(y[k][i] - lens.axisY)));
            const float rounded = lens.error + 1e-6f * off;
            const float ab = length(0, 1, i), bc = length(1, 2, i), ca = length(2, 0, i), around = ab + bc + ca;
            room[0][i] = 2 * rounded * bc;
            room[1][i] = 2 * rounded * ca;
            room[2][i] = 2 * rounded * ab;
            const float area = perArea[i];
            const bool narrow = area < 16 * rounded * around;
            splinter[i] = narrow;
            perArea[i] = 1 / area;
            nearest[i] = most(key[0][i], key[1][i], key[2][i]);
            const float rise = nearest[i] - least(key[0][i], key[1][i], key[2][i]);
            // A key may be off by as much as it rises on the way that a corner is off, and by what Z is rounded.
            const float slanted = 4 * rounded * rise * around * perArea[i] + lens.errorOfKey(nearest[i]);
            error[i] = narrow ? std::numeric_limits<float>::infinity() : slanted;
        }
    }
};

/// What one thread draws.
class FrontTriangles::Layer {
public:
    void begin(const Lens& lens) {
        const std::size_t pixels = std::size_t{lens.width} * lens.height + kLanes;
        for (auto* plane : {&behind_, &before_}) plane->resize(std::max(plane->size(), pixels));
        index_.resize(std::max(index_.size(), pixels));
        rows_.assign(lens.height, 0);
        doubts_.clear();
    }

    /// @param index  of the group's first triangle
    void draw(const Lens& lens, const Group& group, std::uint32_t index, std::span<const glm::vec3> corners) {
        shapes_.gather(group.triangles, group.count, corners);
        shapes_.find(lens);
        // Of a solid what is turned to the viewer lies before what is turned away.
        std::array<std::uint32_t, 2 * kGroup> order;
        std::size_t first = kGroup, end = kGroup;
        for (std::uint32_t i = 0; i < group.count; ++i) {
            const bool holds = shapes_.holdsCenter(i), away = shapes_.turnedAway[i];
            order[end] = order[first - 1] = i;
            end += holds && away;
            first -= holds && !away;
        }
        if (lens.perspective) return drawBeforeEye(lens, group.count, index);
        for (std::size_t k = first; k < end; ++k) draw(lens, order[k], index + order[k]);
    }

    /// As if this one had drawn what the other has.
    void take(const Lens& lens, const Layer& other) {
        doubts_.insert(doubts_.end(), other.doubts_.begin(), other.doubts_.end());
        for (std::size_t y = 0; y < lens.height; ++y) {
            if (!other.rows_[y]) continue;
            beginRow(lens, y);
            for (std::size_t at = y * lens.width; at < (y + 1) * lens.width; ++at)
                if (other.index_[at] != kNone) meet(at, other.behind_[at], other.before_[at], other.index_[at]);
        }
    }

    /// What is certain of a pixel; kNone: nothing.
    std::uint32_t at(const Lens& lens, std::size_t x, std::size_t y) const {
        return rows_[y] ? index_[y * lens.width + x] : kNone;
    }
    bool anyIn(std::size_t y) const { return rows_[y] != 0; }
    const std::vector<std::uint32_t>& doubts() const { return doubts_; }

private:
    void drawBeforeEye(const Lens& lens, std::uint32_t count, std::uint32_t index) {
        for (std::uint32_t i = 0; i < count; ++i)
            if (!(shapes_.nearestZ[i] > 0))
                doubts_.push_back(index + i);
            else if (shapes_.holdsCenter(i))
                draw(lens, i, index + i);
    }

    void beginRow(const Lens& lens, std::size_t y) {
        if (rows_[y]) return;
        rows_[y] = 1;
        const std::size_t at = y * lens.width;
        for (auto* plane : {&behind_, &before_})
            std::fill_n(plane->begin() + static_cast<std::ptrdiff_t>(at), lens.width, kBehindAll);
        std::fill_n(index_.begin() + static_cast<std::ptrdiff_t>(at), lens.width, kNone);
    }

    /// A triangle that certainly holds the centre, between two keys, and is not certainly behind what is there.
    void meet(std::size_t at, float behind, float before, std::uint32_t index) {
        if (before < behind_[at]) return;
        const bool wins = behind > before_[at];
        const bool nearer = behind + before > behind_[at] + before_[at];
        if (!wins) doubts_.push_back(nearer ? index_[at] : index);
        if (!wins && !nearer) return;
        behind_[at] = behind;
        before_[at] = before;
        index_[at] = index;
    }

    void draw(const Lens& lens, std::uint32_t i, std::uint32_t index);

    Shapes shapes_;
    // Of the nearest triangle that certainly holds the centre: keys that its own lies between.
    std::vector<float> behind_, before_;
    std::vector<std::uint32_t> index_;
    std::vector<std::uint8_t> rows_;     // that hold anything
    std::vector<std::uint32_t> doubts_;  // triangles that may be nearer than those of the pixels
};

void FrontTriangles::Layer::draw(const Lens& lens, std::uint32_t i, std::uint32_t index) {
    const Shapes& s = shapes_;
    constexpr Lanes kCenters = {0.5f, 1.5f, 2.5f, 3.5f};
    const float roomA = s.room[0][i], roomB = s.room[1][i], roomC = s.room[2][i], error = s.error[i];
    for (std::int32_t y = s.top[i]; y < s.bottom[i]; ++y) {
        beginRow(lens, static_cast<std::size_t>(y));
        const std::size_t row = static_cast<std::size_t>(y) * lens.width;
        const float down = static_cast<float>(y) + 0.5f;
        const Lanes none{}, ay = none + (s.y[0][i] - down), by = none + (s.y[1][i] - down),
                            cy = none + (s.y[2][i] - down);
        for (std::int32_t x = s.left[i]; x < s.right[i]; x += static_cast<std::int32_t>(kLanes)) {
            const std::size_t at = row + static_cast<std::size_t>(x);
            const Lanes centers = kCenters + static_cast<float>(x);
            const Lanes ax = s.x[0][i] - centers, bx = s.x[1][i] - centers, cx = s.x[2][i] - centers;
            const Lanes ofA = side(bx, by, cx, cy), ofB = side(cx, cy, ax, ay), ofC = side(ax, ay, bx, by);
            const Lanes key = (ofA * s.key[0][i] + ofB * s.key[1][i] + ofC * s.key[2][i]) * s.perArea[i];
            Lanes there;
            std::memcpy(&there, &behind_[at], sizeof there);
            const Mask outside = (ofA < -roomA) | (ofB < -roomB) | (ofC < -roomC) | (key + error < there) |
                                 (centers > static_cast<float>(s.right[i]));
            if (!any(~outside)) continue;
            for (std::size_t k = 0; k < kLanes; ++k) {
                if (outside[k]) continue;
                bool certain = !s.splinter[i] && ofA[k] > roomA && ofB[k] > roomB && ofC[k] > roomC;
                if (lens.clips && !s.splinter[i]) {
                    const float Z = lens.perspective ? 1.0f / key[k] : -key[k];
                    const float room = lens.perspective ? error * Z * Z : error;
                    if (Z + room < lens.clipNear || Z - room > lens.clipFar) continue;
                    if (Z - room <= lens.clipNear || Z + room >= lens.clipFar) certain = false;
                }
                if (certain)
                    meet(at + k, key[k] - error, key[k] + error, index);
                else if (!s.splinter[i] || !(s.nearest[i] + lens.errorOfKey(s.nearest[i]) < behind_[at + k]))
                    doubts_.push_back(index);
            }
        }
    }
}

FrontTriangles::FrontTriangles() : lens_(std::make_unique<Lens>()) {}
FrontTriangles::~FrontTriangles() = default;

void FrontTriangles::begin(const TileView& view) {
    Lens& l = *lens_;
    l.width = view.width;
    l.height = view.height;
    l.perspective = view.perspective;
    l.axisX = view.axis.x;
    l.axisY = view.axis.y;
    l.clipNear = view.clipNear;
    l.clipFar = view.clipFar;
    l.clips = view.clipNear > -1e29f || view.clipFar < 1e29f;
    // Single precision has 6e-8 of the largest number, and some ten roundings follow one another.
    l.error = 5e-7f * view.range * view.pixels;
    l.errorOfZ = 1e-6f * std::max(view.range, view.origin);
    groups_.clear();
    used_ = 0;
    layer(0);
}

FrontTriangles::Layer& FrontTriangles::layer(std::size_t number) {
    while (layers_.size() <= number) layers_.push_back(std::make_unique<Layer>());
    for (; used_ <= number; ++used_) layers_[used_]->begin(*lens_);
    return *layers_[number];
}

void FrontTriangles::draw(std::span<const Run> runs, std::span<const glm::vec3> corners) {
    const std::size_t before = groups_.size();
    for (const Run& run : runs)
        for (std::size_t first = 0; first < run.triangles.size(); first += kGroup) {
            const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(kGroup, run.triangles.size() - first));
            groups_.push_back({&run.triangles[first], count, run.rows, run.number + static_cast<std::uint32_t>(first)});
        }
    const std::size_t count = groups_.size() - before;
    constexpr std::size_t kGroupsOfThread = 512, kMostThreads = 8, kMostPixels = 8'000'000;  // of all layers
    const std::size_t pixels = std::max<std::size_t>(std::size_t{lens_->width} * lens_->height, 1);
    const std::size_t threads = std::min({count / kGroupsOfThread + 1, kMostThreads, kMostPixels / pixels + 1,
                                          std::max<std::size_t>(std::thread::hardware_concurrency(), 1)});
    layer(threads - 1);
    inParallel(threads, static_cast<unsigned>(threads), [&](std::size_t thread) {
        const std::size_t first = before + count * thread / threads, end = before + count * (thread + 1) / threads;
        for (std::size_t i = first; i < end; ++i)
            layers_[thread]->draw(*lens_, groups_[i], static_cast<std::uint32_t>(i) * kGroup, corners);
    });
}

void FrontTriangles::end() {
    Layer& all = *layers_[0];
    for (std::size_t i = 1; i < used_; ++i) all.take(*lens_, *layers_[i]);
    doubts_ = all.doubts();
    std::sort(doubts_.begin(), doubts_.end());
    doubts_.erase(std::unique(doubts_.begin(), doubts_.end()), doubts_.end());
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
    for (; y < std::min(endY, lens_->height); ++y) {
        if (!all.anyIn(y)) continue;
        for (std::uint32_t at = x; at < std::min(endX, lens_->width); ++at)
            if (all.at(*lens_, at, y) != kNone) return true;
    }
    return false;
}

void FrontTriangles::write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
    const Layer& all = *layers_[0];
    const bool any = y < lens_->height && all.anyIn(y);
    for (const std::uint32_t end = x + count; x < end; ++x) {
        const std::uint32_t index = any && x < lens_->width ? all.at(*lens_, x, y) : kNone;
        *to++ = index == kNone ? 0 : numberOf(index);
    }
}

}  // namespace nacre
