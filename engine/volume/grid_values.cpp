#include "engine/volume/grid_values.h"

namespace nacre {

GridValues::GridValues(const std::string& name, const glm::ivec3& size, const MapLimits& limits, std::size_t perNode)
    : name_(name), size_(size), perNode_(perNode), values_(checkedNodes(name, size, limits)) {}

void GridValues::read(std::string_view text, std::uint64_t line) {
    const char *at = text.data(), *end = at + text.size();
    const auto next = [&]() -> std::string_view {
        while (at != end && isBlank(*at)) line += *at++ == '\n';
        const char* first = at;
        while (at != end && !isBlank(*at)) ++at;
        return {first, static_cast<std::size_t>(at - first)};
    };
    std::size_t count = 0;
    for (int x = 0; x < size_.x; ++x)
        for (int y = 0; y < size_.y; ++y)
            for (int z = 0; z < size_.z; ++z, ++count)
                for (std::size_t i = 0; i < perNode_; ++i) {
                    const std::string_view word = next();
                    const auto parsed = parseNumber(word);
                    if (!parsed)
                        cannotReadMap(name_,
                                      word.empty() ? "it is cut short: " + std::to_string(count) + " of its " +
                                                         std::to_string(values_.size()) + " values are there"
                                                   : "expected a number instead of \"" + printable(word) + "\"",
                                      word.empty() ? 0 : line);
                    if (i == 0)
                        values_[(static_cast<std::size_t>(z) * size_.y + y) * size_.x + x] =
                            static_cast<float>(*parsed);
                }
}

}  // namespace nacre
