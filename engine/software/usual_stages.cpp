#include "engine/software/usual_stages.h"

#include <algorithm>
#include <span>

namespace nacre::passes {

bool isUsual(const gpu::Specialization& constants, bool rims) {
    const vk::SpecializationInfo info = constants.info();
    const auto* values = static_cast<const std::uint32_t*>(info.pData);
    return std::ranges::all_of(std::span(info.pMapEntries, info.mapEntryCount), [&](const auto& entry) {
        const auto usual = std::ranges::find(kUsualConstants, static_cast<int>(entry.constantID), &UsualConstant::id);
        if (usual == std::end(kUsualConstants)) return true;
        const std::uint32_t value = rims && usual->id == layout::kContoursId ? 1 : usual->value;
        return values[entry.offset / sizeof(std::uint32_t)] == value;
    });
}

}  // namespace nacre::passes
