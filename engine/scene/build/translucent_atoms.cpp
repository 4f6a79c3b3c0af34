#include "engine/scene/build/translucent_atoms.h"

#include <algorithm>

#include "engine/scene/build/join_parts.h"
#include "engine/scene/build/primitive_meshes.h"

namespace nacre {
namespace {

/// The opacity of an atom by its number from 1.
class Opacities {
public:
    explicit Opacities(const SceneLayer& layer) : layer_(layer) {}
    double of(std::uint32_t atom) const {
        const auto found = std::lower_bound(layer_.atoms.begin(), layer_.atoms.end(), atom - 1);
        if (found == layer_.atoms.end() || *found != atom - 1) return 1;
        return static_cast<double>(layer_.opacity[static_cast<std::size_t>(found - layer_.atoms.begin())]);
    }

private:
    const SceneLayer& layer_;
};

}  // namespace

void meshTranslucentAtoms(const SceneLayer& layer, Representation& part) {
    if (layer.opacity.empty() || layer.atoms.size() > kMostTranslucentAtoms) return;
    const Opacities opacities(layer);
    Representation meshed;
    Primitives balls;  // as many as decide how fine they are
    balls.ellipsoids.resize(part.spheres.size());
    PrimitiveMeshes meshes(meshed, balls);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < part.spheres.size(); ++i) {
        const SphereLook& look = part.sphereLooks[i];
        const double opacity = opacities.of(look.atom), r = static_cast<double>(part.spheres[i].radius);
        if (opacity < 1) {
            meshes.ellipsoid(glm::dvec3(part.spheres[i].center), {{{r, 0, 0}, {0, r, 0}, {0, 0, r}}},
                             {look.color, opacity, look.atom});
            continue;
        }
        part.spheres[kept] = part.spheres[i];
        part.sphereLooks[kept++] = look;
    }
    part.spheres.resize(kept);
    part.sphereLooks.resize(kept);
    kept = 0;
    for (std::size_t i = 0; i < part.cylinders.size(); ++i) {
        const Cylinder& stick = part.cylinders[i];
        const CylinderLook& look = part.cylinderLooks[i];
        const PrimitiveLook a{look.colorA, opacities.of(look.atomA), look.atomA},
            b{look.colorB, opacities.of(look.atomB), look.atomB};
        if (a.opacity < 1 || b.opacity < 1) {
            meshes.cylinder(glm::dvec3(stick.a), glm::dvec3(stick.b), static_cast<double>(stick.radius), a, b);
            continue;
        }
        part.cylinders[kept] = stick;
        part.cylinderLooks[kept++] = look;
    }
    part.cylinders.resize(kept);
    part.cylinderLooks.resize(kept);
    meshes.finish();
    appendPart(part, meshed);
}

}  // namespace nacre
