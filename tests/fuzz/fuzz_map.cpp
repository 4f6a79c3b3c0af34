// libFuzzer target for density maps: any bytes are a map whose isosurface can be made, or an Error, and nothing else.
// The first byte chooses the name, since old files have no mark. tools/fuzz runs it.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "engine/error.h"
#include "engine/mesh/isosurface.h"
#include "engine/threads.h"
#include "engine/volume/read_map.h"

namespace {

void require(bool holds, const char* what) {
    if (holds) return;
    std::cerr << "a map was read that " << what << std::endl;
    std::abort();
}

void check(const nacre::DensityMap& map) {
    const glm::ivec3& n = map.size;
    require(n.x > 0 && n.y > 0 && n.z > 0, "has no nodes");
    require(map.values.size() == static_cast<std::size_t>(n.x) * n.y * n.z, "has values of other nodes");
    require(map.statistics.known > 0 && std::isfinite(map.statistics.mean), "has no statistics");
    for (const float value : map.values) require(!std::isinf(value), "has an infinite value");
    const nacre::MapRegion region(map, glm::ivec3(0), n - 1);
    const nacre::Isosurface surface =
        region.at(map.statistics.mean, true, nacre::IsosurfaceParts::triangles, map.origin);
    for (const glm::uvec3& t : surface.triangles)
        require(std::max({t.x, t.y, t.z}) < surface.positions.size(), "has a triangle without a vertex");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    nacre::setThreadsPerTask(1);  // starting others takes longer than their work
    if (size == 0) return 0;
    constexpr const char* kNames[] = {"a", "a.map", "a.dsn6"};
    try {
        check(nacre::readMap(kNames[data[0] % 3], std::string(reinterpret_cast<const char*>(data + 1), size - 1),
                             {std::size_t{1} << 16}));  // larger cells take their time in filling, and find nothing new
    } catch (const nacre::Error&) {
    }
    return 0;
}
