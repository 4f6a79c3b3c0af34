#pragma once
// One primitive's patch of the occlusion atlas while its open texels are found.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/occlusion/open_texels.h"

namespace nacre {

/// Keeps its memory from patch to patch.
class OpenPatch {
public:
    static constexpr std::uint32_t kMostEdge = 56;  ///< texels of a row

    /// @param sphere  folded beyond its edges as an octahedral map, else closed around as a cylinder's
    void begin(const glm::ivec2& size, bool sphere);
    /// @param entry  less that of the patch's first
    void open(std::uint32_t texel, std::uint16_t entry);

    /// Appends the words that have a source. @param address  of the patch's first texel @param width  of the atlas
    void addWords(std::uint32_t address, std::uint32_t width, std::uint32_t base, std::vector<AtlasWord>& words);

private:
    static constexpr std::size_t kAround = 4;  // two steps of two texels
    static constexpr std::uint16_t kBuried = AtlasWord::kNone;

    void surround();
    std::uint64_t findSources(std::size_t y);

    glm::ivec2 size_{};
    bool sphere_ = true, any_ = false;
    std::vector<std::uint16_t> entries_;     // of the patch, or kBuried, which follows them as well
    std::vector<std::uint16_t> places_;      // in entries_, of the patch with kAround folded texels about it
    std::vector<std::uint16_t> surrounded_;  // the entries there, so that no search folds
    std::vector<std::uint64_t> openInRow_;   // of surrounded_: a bit per texel
    std::size_t row_ = 0;                    // of surrounded_
    AtlasWord::Source sources_[kMostEdge];   // of a row
};

}  // namespace nacre
