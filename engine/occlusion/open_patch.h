#pragma once
// One primitive's patch of the occlusion atlas, while its open texels are found.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/occlusion/open_texels.h"

namespace nacre {

/// Reuses its memory for each patch.
class OpenPatch {
public:
    static constexpr std::uint32_t kMostEdge = 56;  ///< texels of a row

    /// @param sphere  octahedral map, mirrored at its edges; else a cylinder, which wraps around
    void begin(const glm::ivec2& size, bool sphere);
    /// @param entry  relative to the patch's first entry
    void open(std::uint32_t texel, std::uint16_t entry);

    /// Appends the words that have a source, and completes words that the patch to the left began.
    /// @param address  of the patch's first texel @param width  of the atlas
    void addWords(std::uint32_t address, std::uint32_t width, std::uint32_t base, std::vector<AtlasWord>& words);

private:
    static constexpr std::size_t kAround = 4;  // two steps of two texels
    static constexpr std::uint16_t kBuried = AtlasWord::kNone;

    void surround();
    std::uint64_t findSources(std::size_t y);
    AtlasWord& wordAt(std::uint32_t address, std::uint32_t base, std::size_t y, std::vector<AtlasWord>& words);

    glm::ivec2 size_{};
    bool sphere_ = true, any_ = false;
    std::vector<std::uint16_t> entries_;     // entry of each texel, or kBuried; one kBuried follows the last
    std::vector<std::uint16_t> places_;      // index into entries_, with a border of kAround mirrored or wrapped texels
    std::vector<std::uint16_t> surrounded_;  // the entries at these places
    std::vector<std::uint64_t> openInRow_;   // a bit for each entry of surrounded_
    std::size_t row_ = 0;                    // of surrounded_
    AtlasWord::Source sources_[kMostEdge];   // of a row
    std::size_t lastOfRow_[kMostEdge] = {};  // the last word appended for each row
};

}  // namespace nacre
