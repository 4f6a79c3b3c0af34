#include "engine/volume/density_map.h"

#include <algorithm>

namespace nacre {

MapStatistics computeStatistics(const std::vector<float>& values) {
    MapStatistics s;
    s.min = std::numeric_limits<double>::infinity();
    s.max = -s.min;
    double sum = 0;
    for (const float value : values) {
        if (std::isnan(value)) continue;
        const auto v = static_cast<double>(value);
        s.min = std::min(s.min, v);
        s.max = std::max(s.max, v);
        sum += v;
        ++s.known;
    }
    if (s.known == 0) return {};
    s.mean = sum / static_cast<double>(s.known);
    double squares = 0;
    for (const float value : values)
        if (!std::isnan(value))
            squares += (static_cast<double>(value) - s.mean) * (static_cast<double>(value) - s.mean);
    s.rms = std::sqrt(squares / static_cast<double>(s.known));
    return s;
}

double valueAt(const DensityMap& map, const glm::dvec3& position) {
    const glm::dvec3 at = map.nodeAt(position), low = glm::floor(at), share = at - low;
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        glm::ivec3 node(low);
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const bool upper = corner >> axis & 1;
            weight *= upper ? share[axis] : 1 - share[axis];
            node[axis] += upper;
            if (map.periodic) node[axis] = ((node[axis] % map.size[axis]) + map.size[axis]) % map.size[axis];
        }
        if (weight == 0) continue;
        for (int axis = 0; axis < 3; ++axis)
            if (node[axis] < 0 || node[axis] >= map.size[axis]) return static_cast<double>(kUnknownDensity);
        sum += weight * static_cast<double>(map.values[map.index(node)]);
    }
    return sum;
}

double levelOfTopShare(const DensityMap& map, double share, bool ofBothSigns) {
    constexpr std::size_t kBins = std::size_t{1} << 20;
    const MapStatistics& s = map.statistics;
    const double low = ofBothSigns ? 0 : s.min, high = ofBothSigns ? std::max(-s.min, s.max) : s.max;
    if (!(high > low)) return high;
    std::vector<std::uint32_t> bins(kBins, 0);
    const double perBin = static_cast<double>(kBins) / (high - low);
    for (const float value : map.values) {
        if (std::isnan(value)) continue;
        const auto size = static_cast<double>(ofBothSigns ? std::abs(value) : value);
        ++bins[std::min(kBins - 1, static_cast<std::size_t>((size - low) * perBin))];
    }
    const double wanted = share * static_cast<double>(s.known);
    double above = 0;
    for (std::size_t i = kBins; i-- > 0;) {
        above += bins[i];
        if (above >= wanted) return low + static_cast<double>(i) / perBin;
    }
    return low;
}

}  // namespace nacre
