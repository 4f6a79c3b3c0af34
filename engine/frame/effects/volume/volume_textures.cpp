#include "engine/frame/effects/volume/volume_textures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/frame/picture.h"
#include "engine/passes/read_back.h"

namespace nacre::passes {
namespace {

layout::BrickConstants makeConstants(const Volume& volume, const VolumeBrick& brick) {
    layout::BrickConstants c{};
    glm::vec4* const rows[] = {&c.nodeX, &c.nodeY, &c.nodeZ};
    for (int i = 0; i < 3; ++i)
        *rows[i] = glm::vec4(volume.toNode[0][i], volume.toNode[1][i], volume.toNode[2][i],
                             volume.toNode[3][i] - brick.first[i]);
    c.first = glm::vec4(0, 0, 0, volume.levels.size());
    c.last = glm::vec4(brick.size - 1, brick.masked ? 1 : 0);
    c.perSize = glm::vec4(1.0 / glm::dvec3(brick.size), volume.step);
    static_assert(kMostVolumeLevels == std::size_t{layout::kMostLevels});
    for (std::size_t i = 0; i < volume.levels.size(); ++i) {
        const VolumeLevel& level = volume.levels[i];
        const double to = i + 1 < volume.levels.size() ? volume.levels[i + 1].value - level.value : 0;
        constexpr double kLeast = 1e-12, kDensest = 0.9999;
        c.levels[i] = glm::vec4(level.value, 1 / std::max(to, kLeast), 0, 0);
        c.colors[i] = linearColor(level.color, std::min(level.opacity, kDensest));
    }
    return c;
}

}  // namespace

VolumeTextures::VolumeTextures(const gpu::Device& device, gpu::Executor& executor, std::shared_ptr<const Volume> volume)
    : volume_(std::move(volume)), flat_(makeWhiteTexture(device, executor)) {
    for (const VolumeBrick& brick : volume_->bricks) {
        const auto side = [&](int axis) { return static_cast<std::uint32_t>(brick.size[axis]); };
        const graph::ImageDesc desc{
            brick.masked ? VK_FORMAT_R16G16_SFLOAT : VK_FORMAT_R16_SFLOAT, {side(0), side(1)}, 1, 1, side(2)};
        const auto bytes = std::as_bytes(std::span(brick.texels));
        const std::string name = "density map, brick " + std::to_string(bricks_.size() + 1);
        const layout::BrickConstants constants = makeConstants(*volume_, brick);
        bricks_.push_back({brick.place,
                           makeTexture(device, executor, desc,
                                       {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, name),
                           gpu::makeBuffer(device, std::span(&constants, 1), vk::BufferUsageFlagBits::eUniformBuffer,
                                           name + ", constants")});
    }
}

std::vector<const VolumeTextures::Brick*> VolumeTextures::farthestFirst(const glm::dvec4& eye) const {
    const double cells = volume_->brickCells;
    const auto away = [&](const Brick& brick) {
        double sum = 0;
        for (int i = 0; i < 3; ++i)
            sum += eye.w > 0 ? std::abs(brick.place[i] - std::floor(eye[i] / cells))
                             : brick.place[i] * (eye[i] > 0 ? -1 : 1);
        return sum;
    };
    std::vector<const Brick*> sorted;
    for (const Brick& brick : bricks_) sorted.push_back(&brick);
    std::ranges::stable_sort(sorted, [&](const Brick* a, const Brick* b) { return away(*a) > away(*b); });
    return sorted;
}

}  // namespace nacre::passes

namespace nacre {

std::shared_ptr<const passes::VolumeTextures> Volumes::findTextures(const std::shared_ptr<const Volume>& volume) {
    if (volume == volume_) return textures_;
    textures_ = nullptr, volume_ = nullptr;
    if (volume) textures_ = std::make_shared<const passes::VolumeTextures>(device_, executor_, volume);
    volume_ = volume;
    return textures_;
}

}  // namespace nacre
