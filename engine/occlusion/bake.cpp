#include "engine/occlusion/bake.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/occlusion/directions.h"
#include "engine/passes/read_back.h"

namespace nacre::occlusion {
namespace {

using Usage = vk::BufferUsageFlagBits;

/// Whether all transforms are rigid and accurate enough to derive the third row of a rotation from the other two.
bool allTurn(const std::vector<std::vector<glm::dmat4x3>>& groups) {
    constexpr double kMost = 1e-5;
    for (const std::vector<glm::dmat4x3>& places : groups)
        for (const glm::dmat4x3& place : places) {
            const glm::dmat3 rows = glm::transpose(glm::dmat3(place[0], place[1], place[2]));
            if (glm::length(glm::cross(rows[0], rows[1]) - rows[2]) > kMost ||
                std::abs(glm::length(rows[0]) - 1) > kMost)
                return false;
        }
    return true;
}

}  // namespace

Bake::Bake(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
           const BakeOptions& options, BakePreparation&& preparation)
    : device_(device),
      scene_(scene),
      directions_(occlusionDirections(options.directions)),
      maps_(device, scene, representation, options.path, preparation.maps, std::move(preparation.occluders)),
      layout_(preparation.layout),
      copies_(std::move(preparation.copies)),
      doneOf_(maps_.models(), 0),
      budgetBytes_(options.budgetBytes) {
    makeBuffers(preparation.open);
}

Bake::Bake(const gpu::Device& device, gpu::Executor& executor, const passes::SceneBuffers& scene,
           const Representation& representation, const BakeOptions& options, const FinishedOcclusion& finished)
    : device_(device),
      scene_(scene),
      directions_(occlusionDirections(options.directions)),
      maps_(device, scene, representation, options.path, {}),
      layout_(finished.layout),
      texelCount_(finished.openTexels),
      seenSpheres_(finished.seenSpheres),
      doneOf_(1, options.directions),
      budgetBytes_(options.budgetBytes) {
    maps_.release();
    if (!finished.bounced) makeCells(finished.atlas);
    const VkFormat format = finished.bounced ? VK_FORMAT_R8G8B8A8_UNORM : VK_FORMAT_R8_UNORM;
    const std::uint32_t height = layout_.height * (finished.bounced ? 2 : 1);
    atlas_ =
        passes::makeTexture(device, executor, {format, {layout_.width, height}}, finished.atlas, "occlusion atlas");
    atlasDefined_ = true;
    bounced_ = finished.bounced;
}

std::vector<std::uint8_t> Bake::atlasTexels() const {
    bytes_.invalidate();
    const auto* texels = reinterpret_cast<const std::uint8_t*>(bytes_.mapped);
    return {texels, texels + std::size_t{layout_.width} * layout_.height};
}

void Bake::makeBuffers(OpenTexels& open) {
    texelCount_ = open.texels.size();
    wordCount_ = open.words.size();
    firstOfSphere_ = open.firstOfSphere;
    narrow_ = device_.caps().plan.loadsUniforms && !maps_.tiles() && allTurn(copies_.groups);
    batchDirections_ = gpu::makeBuffer(device_, kGroupBytes * copies_.groups.size(),
                                       Usage::eUniformBuffer | Usage::eUniformTexelBuffer, gpu::Access::upload,
                                       "occlusion directions");
    if (maps_.tiles() && maps_.tiles()->texels())
        directionTexels_ =
            gpu::makeTexelView(device_, batchDirections_, vk::Format::eR32G32B32A32Sfloat, "occlusion directions");
    // The host reads all four: the first three to drop deep texels, the last to store the atlas on disk.
    const auto shared = [&](std::uint64_t bytes, vk::BufferUsageFlags usage, const char* name) {
        return gpu::makeBuffer(device_, bytes, usage, gpu::Access::readback, name);
    };
    bytes_ = shared(std::uint64_t{layout_.width} * layout_.height, Usage::eStorageBuffer | Usage::eTransferSrc,
                    "occlusion bytes");
    apart_ = device_.caps().apartMemory;
    const auto worked = [&](std::uint64_t bytes, vk::BufferUsageFlags usage, const char* name) {
        return gpu::makeBuffer(device_, bytes, usage, apart_ ? gpu::Access::upload : gpu::Access::readback, name);
    };
    const std::size_t listBytes = texelCount_ * sizeof(std::uint32_t), wordBytes = wordCount_ * sizeof(AtlasWord);
    list_ = worked(listBytes, Usage::eStorageBuffer, "occlusion texels");
    if (listBytes) std::memcpy(list_.mapped, open.texels.data(), listBytes);
    words_ = worked(wordBytes, Usage::eStorageBuffer, "occlusion words");
    if (wordBytes) std::memcpy(words_.mapped, open.words.data(), wordBytes);
    sums_ = worked(texelCount_ * 8, Usage::eStorageBuffer | Usage::eTransferSrc, "occlusion sums");
    std::memset(sums_.mapped, 0, sums_.size);
    std::memset(bytes_.mapped, 0, bytes_.size);
    if (apart_) {
        sumsRead_ = shared(sums_.size, Usage::eTransferDst, "occlusion sums, read");
        hostList_ = std::move(open.texels);
        hostWords_ = std::move(open.words);
    }
    for (const gpu::Buffer* buffer : {&list_, &words_, &sums_, &bytes_}) buffer->flush();
    atlas_ = gpu::makeImage(device_, {VK_FORMAT_R8_UNORM, {layout_.width, layout_.height}},
                            vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst, false,
                            "occlusion atlas");
}

int Bake::directionsDone() const { return *std::min_element(doneOf_.begin(), doneOf_.end()); }

std::uint64_t Bake::mapsDone() const {
    std::uint64_t sum = 0;
    for (const int done : doneOf_) sum += static_cast<std::uint64_t>(done);
    return sum;
}

std::size_t Bake::countTexels(std::uint32_t model) const {
    std::size_t sum = 0;
    for (const OcclusionCopies::Run& run : copies_.runs) sum += run.model == model ? run.count : 0;
    return sum;
}

std::uint64_t Bake::bytes() const { return bakeBytes(layout_, texelCount_, wordCount_) + maps_.bytes(); }

void Bake::release() {
    hostSums().invalidate();
    bytes_.invalidate();
    const auto* sums = reinterpret_cast<const float*>(hostSums().mapped);
    seenSpheres_.assign(layout_.sphereCount, false);
    for (std::size_t i = 0; i < seenSpheres_.size(); ++i)
        for (std::size_t k = firstOfSphere_[i]; k < firstOfSphere_[i + 1] && !seenSpheres_[i]; ++k)
            seenSpheres_[i] = sums[2 * k] > 0;
    maps_.release();
    directionTexels_ = nullptr;
    batchDirections_ = {};
    list_ = {};
    words_ = {};
    sums_ = {};
    sumsRead_ = {};
    hostList_ = {};
    hostWords_ = {};
    makeCells({reinterpret_cast<const std::uint8_t*>(bytes_.mapped), std::size_t{layout_.width} * layout_.height});
    bytes_ = {};
    firstOfSphere_.clear();
}

/// Patches in the form that shaders of software devices read: rows of words of four texels, sphere patches first. The
/// last texel of a word repeats the first one of the next word (shaders/common/color.glsl).
void Bake::makeCells(std::span<const std::uint8_t> texels) {
    const OcclusionLayout& l = layout_;
    if (!device_.caps().gathersTexels || l.sphereEdge < 2) return;
    constexpr auto countWords = [](std::uint32_t across) { return (across + 1) / 3; };
    const std::uint64_t words = std::uint64_t{l.sphereCount} * countWords(l.sphereEdge) * l.sphereEdge +
                                std::uint64_t{l.cylinderCount} * countWords(l.around) * l.along +
                                (std::uint64_t{l.vertexCount} + 1) / 2;
    const std::uint64_t bytes = words * sizeof(std::uint32_t);
    if (bytes + 2 * texels.size() > budgetBytes_ || bytes > device_.caps().maxStorageBufferBytes) return;
    cells_ = gpu::makeBuffer(device_, bytes, Usage::eUniformTexelBuffer, gpu::Access::upload, "occlusion cells");
    cellTexels_ = gpu::makeTexelView(device_, cells_, vk::Format::eR32Uint, "occlusion cells");
    auto* word = reinterpret_cast<std::uint32_t*>(cells_.mapped);
    const auto add = [&](std::uint32_t patch, std::uint32_t inRow, std::uint32_t top, std::uint32_t across,
                         std::uint32_t down) {
        const std::uint8_t* row =
            texels.data() + (top + std::size_t{patch / inRow} * down) * l.width + std::size_t{patch % inRow} * across;
        for (std::uint32_t y = 0; y < down; ++y, row += l.width)
            for (std::uint32_t x = 0; x + 1 < across; x += 3) {
                const std::uint32_t here = std::min(across - x, 4u);
                std::uint32_t four = 0;
                for (std::uint32_t i = 0; i < here; ++i) four |= std::uint32_t{row[x + i]} << 8 * i;
                *word++ = four;
            }
    };
    for (std::uint32_t i = 0; i < l.sphereCount; ++i) add(i, l.spherePatches(), 0, l.sphereEdge, l.sphereEdge);
    for (std::uint32_t i = 0; i < l.cylinderCount; ++i) add(i, l.cylinderPatches(), l.sphereRows, l.around, l.along);
    if (l.vertexCount > 0)
        std::memcpy(word, texels.data() + std::size_t{l.sphereRows + l.cylinderRows} * l.width,
                    2 * std::size_t{l.vertexCount});
}

/// Removes texels that no direction has lit so far from the list, and compacts it.
void Bake::dropDeepTexels() {
    hostSums().invalidate();  // only the host writes the other two
    auto* list = apart_ ? hostList_.data() : reinterpret_cast<std::uint32_t*>(list_.mapped);
    auto* sums = reinterpret_cast<glm::vec2*>(hostSums().mapped);
    std::vector<std::uint32_t> keptBefore(texelCount_ + 1);
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < texelCount_; ++i) {
        keptBefore[i] = kept;
        if (sums[i].x == 0) continue;
        list[kept] = list[i];
        sums[kept++] = sums[i];
    }
    keptBefore[texelCount_] = kept;
    followKept({apart_ ? hostWords_.data() : reinterpret_cast<AtlasWord*>(words_.mapped), wordCount_}, keptBefore);
    for (std::uint32_t& first : firstOfSphere_) first = keptBefore[first];
    for (OcclusionCopies::Run& run : copies_.runs) {
        const std::uint32_t end = keptBefore[run.first + run.count];
        run.first = keptBefore[run.first];
        run.count = end - run.first;
    }
    texelCount_ = kept;
    if (apart_ && !hostWords_.empty()) {
        std::memcpy(list_.mapped, list, kept * sizeof *list);
        std::memcpy(sums_.mapped, sums, kept * sizeof *sums);
        std::memcpy(words_.mapped, hostWords_.data(), wordCount_ * sizeof(AtlasWord));
    }
    for (const gpu::Buffer* buffer : {&list_, &sums_, &words_}) buffer->flush();
}

}  // namespace nacre::occlusion
