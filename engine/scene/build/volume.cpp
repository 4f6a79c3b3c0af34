#include "engine/scene/build/volume.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/matrix.hpp>

#include "engine/error.h"
#include "engine/threads.h"

namespace nacre {
namespace {

constexpr float kUnknown = -1000;  // of the second channel: hides every cell at the node
constexpr double kMostHalf = 60000;

/// Lowest and highest corner of a brick's visible part.
struct NodeBox {
    glm::ivec3 first{1 << 30}, last{-1};
    bool empty() const { return last.x < 0; }
};

class VolumeMaker {
public:
    VolumeMaker(const MapRegion& region, std::span<const VolumeLevel> levels, int brickCells)
        : region_(region), cells_(brickCells), levels_(levels.begin(), levels.end()) {
        std::stable_sort(levels_.begin(), levels_.end(),
                         [](const VolumeLevel& a, const VolumeLevel& b) { return a.value < b.value; });
        const MapStatistics& s = region.map().statistics;
        mean_ = s.mean;
        scale_ = s.rms > 0 ? 1 / s.rms : 1;
    }

    std::shared_ptr<const Volume> make(const glm::dvec3& center) {
        const DensityMap& map = region_.map();
        const auto volume = std::make_shared<Volume>();
        volume->brickCells = cells_;
        const glm::ivec3 bricks = (region_.size() - 2) / cells_ + 1;
        std::size_t bytes = 0;
        for (glm::ivec3 at(0); at.z < bricks.z; ++at.z)
            for (at.y = 0; at.y < bricks.y; ++at.y)
                for (at.x = 0; at.x < bricks.x; ++at.x) {
                    const NodeBox box = shownIn(at);
                    if (box.empty()) continue;
                    VolumeBrick brick{at, box.first, box.last - box.first + 1, false, {}};
                    brick.masked = !region_.places().empty() || anyUnknown(brick);
                    bytes += std::size_t{2} * brick.size.x * brick.size.y * brick.size.z * (brick.masked ? 2 : 1);
                    if (bytes > kMostVolumeBytes)
                        throw Error("cannot draw map", map.name,
                                    "as a volume it takes more than 1 GB (--map-around SEL, or raise the first level)");
                    volume->bricks.push_back(std::move(brick));
                }
        if (volume->bricks.empty()) return nullptr;
        inParallel(volume->bricks.size(), [&](std::size_t i) { fill(volume->bricks[i]); });

        const glm::dmat3 toNodes = glm::inverse(map.step);
        const glm::dvec3 shift = toNodes * (center - map.origin) - glm::dvec3(region_.first());
        volume->toNode = glm::dmat4x3(toNodes[0], toNodes[1], toNodes[2], shift);
        volume->step = 0.5 * std::min({glm::length(map.step[0]), glm::length(map.step[1]), glm::length(map.step[2])});
        for (const VolumeBrick& brick : volume->bricks)
            for (int corner = 0; corner < 8; ++corner) {
                const glm::ivec3 node =
                    brick.first + (brick.size - 1) * glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
                const glm::dvec3 place = map.place(glm::dvec3(region_.first() + node)) - center;
                volume->radius = std::max(volume->radius, glm::length(place));
            }
        for (VolumeLevel& level : levels_) level.value = stored(level.value);
        volume->levels = std::move(levels_);
        return volume;
    }

private:
    double stored(double value) const { return std::clamp((value - mean_) * scale_, -kMostHalf, kMostHalf); }
    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * region_.size().y + y) * region_.size().x + x;
    }

    double opacityAt(double value) const {
        if (value <= levels_.front().value) return levels_.front().opacity;
        for (std::size_t i = 1; i < levels_.size(); ++i) {
            const VolumeLevel &a = levels_[i - 1], &b = levels_[i];
            if (value < b.value) return a.opacity + (b.opacity - a.opacity) * (value - a.value) / (b.value - a.value);
        }
        return levels_.back().opacity;
    }
    /// Whether any value between these is visible.
    bool shows(const MapRegion::Range& range) const {
        if (range.low > range.high) return false;
        if (opacityAt(range.low) > 0 || opacityAt(range.high) > 0) return true;
        return std::ranges::any_of(levels_, [&](const VolumeLevel& level) {
            return level.opacity > 0 && level.value >= range.low && level.value <= range.high;
        });
    }

    /// The nodes of a brick's blocks that may be visible.
    NodeBox shownIn(const glm::ivec3& place) const {
        constexpr int kBlock = MapRegion::kBlock;
        const glm::ivec3 from = place * (cells_ / kBlock), to = glm::min(from + cells_ / kBlock, region_.blocks());
        NodeBox box;
        for (glm::ivec3 at = from; at.z < to.z; ++at.z)
            for (at.y = from.y; at.y < to.y; ++at.y)
                for (at.x = from.x; at.x < to.x; ++at.x) {
                    if (!shows(region_.blockRange(at))) continue;
                    box.first = glm::min(box.first, at * kBlock);
                    box.last = glm::max(box.last, glm::min((at + 1) * kBlock, region_.size() - 1));
                }
        return box;
    }

    template <typename Visit>
    void eachRow(const VolumeBrick& brick, const Visit& visit) const {
        for (int z = 0; z < brick.size.z; ++z)
            for (int y = 0; y < brick.size.y; ++y)
                visit(region_.values() + index(brick.first.x, brick.first.y + y, brick.first.z + z), y, z);
    }

    bool anyUnknown(const VolumeBrick& brick) const {
        bool any = false;
        eachRow(brick, [&](const float* row, int, int) {
            any = any || std::any_of(row, row + brick.size.x, [](float value) { return std::isnan(value); });
        });
        return any;
    }

    void fill(VolumeBrick& brick) const {
        const std::size_t nodes = std::size_t{1} * brick.size.x * brick.size.y * brick.size.z;
        brick.texels.resize(nodes * (brick.masked ? 2 : 1));
        const std::vector<float> near = brick.masked ? nearness(brick) : std::vector<float>();
        std::size_t to = 0, node = 0;
        eachRow(brick, [&](const float* row, int, int) {
            for (int x = 0; x < brick.size.x; ++x, ++node) {
                const bool known = !std::isnan(row[x]);
                const auto value = static_cast<float>(known ? stored(static_cast<double>(row[x])) : 0);
                brick.texels[to++] = glm::packHalf1x16(value);
                if (brick.masked) brick.texels[to++] = glm::packHalf1x16(known ? near[node] : kUnknown);
            }
        });
    }

    /// 1 within reach of a place, 0 beyond, and linear over a voxel in between. 1 everywhere without places.
    std::vector<float> nearness(const VolumeBrick& brick) const {
        const glm::ivec3& size = brick.size;
        std::vector<float> near(std::size_t{1} * size.x * size.y * size.z, region_.places().empty() ? 1.0f : 0.0f);
        const DensityMap& map = region_.map();
        const double voxel = std::cbrt(std::abs(glm::determinant(map.step))), reach = region_.reach() + voxel;
        const glm::dmat3 toNodes = glm::transpose(glm::inverse(map.step));
        const glm::dvec3 ball =
            reach * glm::dvec3(glm::length(toNodes[0]), glm::length(toNodes[1]), glm::length(toNodes[2]));
        for (const glm::dvec3& place : region_.places()) {
            const glm::dvec3 middle = map.nodeAt(place) - glm::dvec3(region_.first() + brick.first);
            const glm::ivec3 from(glm::max(glm::ceil(middle - ball), 0.0)),
                to(glm::min(glm::floor(middle + ball), glm::dvec3(size - 1)));
            for (glm::ivec3 at = from; at.z <= to.z; ++at.z)
                for (at.y = from.y; at.y <= to.y; ++at.y)
                    for (at.x = from.x; at.x <= to.x; ++at.x) {
                        const double away = glm::length(map.step * (glm::dvec3(at) - middle));
                        const double here = std::clamp(0.5 + (region_.reach() - away) / voxel, 0.0, 1.0);
                        float& kept = near[(static_cast<std::size_t>(at.z) * size.y + at.y) * size.x + at.x];
                        kept = std::max(kept, static_cast<float>(here));
                    }
        }
        return near;
    }

    const MapRegion& region_;
    int cells_;
    std::vector<VolumeLevel> levels_;
    double mean_ = 0, scale_ = 1;
};

}  // namespace

std::shared_ptr<const Volume> makeVolume(const MapRegion& region, std::span<const VolumeLevel> levels,
                                         const glm::dvec3& center, int brickCells) {
    if (region.empty() || levels.empty() || levels.size() > kMostVolumeLevels) return nullptr;
    return VolumeMaker(region, levels, brickCells).make(center);
}

}  // namespace nacre
