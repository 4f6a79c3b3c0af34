#pragma once

#include "engine/scene/build/representation.h"

namespace nacre {

/// Drops some spheres of a scene without copies. @param keep  receives the index of each
template <typename Keep>
void keepSpheres(Representation& r, const Keep& keep) {
    const bool ellipsoids = !r.ellipsoids.empty();
    if (ellipsoids) r.ellipsoids.resize(r.spheres.size());  // spheres beyond the table are plain
    std::size_t kept = 0;
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        if (!keep(i)) continue;
        r.spheres[kept] = r.spheres[i];
        if (ellipsoids) r.ellipsoids[kept] = r.ellipsoids[i];
        r.sphereLooks[kept++] = r.sphereLooks[i];
    }
    r.spheres.resize(kept);
    if (ellipsoids) r.ellipsoids.resize(kept);
    r.sphereLooks.resize(kept);
}

}  // namespace nacre
