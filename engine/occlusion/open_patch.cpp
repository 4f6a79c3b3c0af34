#include "engine/occlusion/open_patch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace nacre {
namespace {

/// Maps a texel one or two steps outside a patch to one inside: a sphere's octahedral map mirrors at its edge, a
/// cylinder wraps around.
glm::ivec2 folded(glm::ivec2 p, const glm::ivec2& size, bool sphere) {
    if (!sphere) {
        if (p.x < 0) p.x += size.x - 1;
        if (p.x >= size.x) p.x -= size.x - 1;
        return p;
    }
    for (int i = 0; i < 2; ++i) {
        if (p[i] >= 0 && p[i] < size[i]) continue;
        p[i] = p[i] < 0 ? -p[i] : 2 * (size[i] - 1) - p[i];
        p[1 - i] = size[1 - i] - 1 - p[1 - i];
    }
    return p;
}

struct Step {
    int x = 0, y = 0;
};
/// Steps to the 24 surrounding texels, nearest first.
constexpr std::array<Step, 24> nearSteps() {
    std::array<Step, 24> steps;
    std::size_t count = 0;
    for (const int squared : {1, 2, 4, 5, 8})
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x)
                if (x * x + y * y == squared) steps[count++] = {x, y};
    return steps;
}
constexpr std::array<Step, 24> kNearSteps = nearSteps();

/// The bits of a row, shifted by `places`.
std::uint64_t ahead(std::uint64_t bits, int places) { return places >= 0 ? bits >> places : bits << -places; }

template <typename Work>
void eachBit(std::uint64_t bits, const Work& work) {
    for (; bits != 0; bits &= bits - 1) work(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace

void OpenPatch::begin(const glm::ivec2& size, bool sphere) {
    any_ = false;
    entries_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) + 1, kBuried);
    if (size == size_ && sphere == sphere_) return;
    size_ = size;
    sphere_ = sphere;
    constexpr int kFar = static_cast<int>(kAround);
    row_ = static_cast<std::size_t>(size.x) + 2 * kAround;
    places_.clear();
    for (int y = -kFar; y < size.y + kFar; ++y)
        for (int x = -kFar; x < size.x + kFar; ++x) {
            const glm::ivec2 p = folded({x, y}, size, sphere);
            const bool within = p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y;
            places_.push_back(static_cast<std::uint16_t>(within ? p.y * size.x + p.x : size.x * size.y));
        }
    surrounded_.resize(places_.size());
    openInRow_.resize(places_.size() / row_);
}

void OpenPatch::open(std::uint32_t texel, std::uint16_t entry) {
    entries_[texel] = entry;
    any_ = true;
}

void OpenPatch::surround() {
    for (std::size_t y = 0, i = 0; y < openInRow_.size(); ++y) {
        std::uint64_t open = 0;
        for (std::size_t x = 0; x < row_; ++x, ++i) {
            surrounded_[i] = entries_[places_[i]];
            open |= static_cast<std::uint64_t>(surrounded_[i] != kBuried) << x;
        }
        openInRow_[y] = open;
    }
}

/// Finds the sources of a row's texels. An open texel is its own source. Others use the nearest open texel, preferably
/// one with another open texel behind it, which is the second source (else both are the same). Each step tests all
/// texels of the row at once.
/// @returns a bit for each texel that has a source
std::uint64_t OpenPatch::findSources(std::size_t y) {
    const auto at = [&](std::size_t x, const Step& step, int times) {
        return surrounded_[(y + kAround + static_cast<std::size_t>(times * step.y)) * row_ + x + kAround +
                           static_cast<std::size_t>(times * step.x)];
    };
    const std::uint64_t all = (std::uint64_t{1} << size_.x) - 1;
    const std::uint64_t own = openInRow_[y + kAround] >> kAround & all;
    eachBit(own, [&](std::size_t x) { sources_[x] = {at(x, {}, 1), at(x, {}, 1)}; });
    std::uint64_t open = all & ~own, fallback = 0;
    for (const Step& step : kNearSteps) {
        if (open == 0) break;
        const auto rowAt = [&](int times) {
            return openInRow_[y + kAround + static_cast<std::size_t>(times * step.y)];
        };
        const std::uint64_t near = ahead(rowAt(1), step.x) >> kAround & open;
        if (near == 0) continue;
        const std::uint64_t beyond = ahead(rowAt(2), 2 * step.x) >> kAround & near;
        eachBit(beyond, [&](std::size_t x) { sources_[x] = {at(x, step, 1), at(x, step, 2)}; });
        eachBit(near & ~beyond & ~fallback, [&](std::size_t x) { sources_[x] = {at(x, step, 1), at(x, step, 1)}; });
        fallback |= near & ~beyond;
        open &= ~beyond;
    }
    return (all & ~open) | fallback;
}

/// The word at an address: a new one, or the last one of this row.
AtlasWord& OpenPatch::wordAt(std::uint32_t address, std::uint32_t base, std::size_t y, std::vector<AtlasWord>& words) {
    const std::size_t last = lastOfRow_[y];
    if (last < words.size() && words[last].address == address) return words[last];
    lastOfRow_[y] = words.size();
    words.push_back({address, base, {}});
    return words.back();
}

void OpenPatch::addWords(std::uint32_t address, std::uint32_t width, std::uint32_t base,
                         std::vector<AtlasWord>& words) {
    if (!any_) return;
    surround();
    const auto across = static_cast<std::uint32_t>(size_.x);
    for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(size_.y); ++y) {
        const std::uint64_t found = findSources(y);
        const std::uint32_t row = address + y * width;
        for (std::uint32_t x = 0, count = 0; x < across; x += count) {
            const std::uint32_t first = (row + x) % 4;
            count = std::min(4 - first, across - x);
            if ((found >> x & ((1u << count) - 1)) == 0) continue;
            AtlasWord& word = wordAt((row + x) / 4, base, y, words);
            const auto shift = static_cast<std::uint16_t>(base - word.base);
            for (std::uint32_t k = 0; k < count; ++k) {
                if ((found >> (x + k) & 1) == 0) continue;
                const AtlasWord::Source& source = sources_[x + k];
                word.sources[first + k] = {static_cast<std::uint16_t>(source.entry + shift),
                                           static_cast<std::uint16_t>(source.beyond + shift)};
            }
        }
    }
}

}  // namespace nacre
