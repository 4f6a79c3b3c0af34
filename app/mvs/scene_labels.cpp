#include "app/mvs/scene_labels.h"

#include <cmath>

#include "engine/molecule/element.h"
#include "engine/scene/scene_camera.h"

namespace nacre::app::mvs {

glm::dmat4x3 firstMotionOf(const Structure& s) {
    const glm::dmat4x3 copy = s.transforms.empty() ? glm::dmat4x3(1.0) : s.transforms.front();
    const glm::dmat4x3 moved = joinedMotion(s.moved, copy);
    return s.instances.empty() ? moved : joinedMotion(s.instances.front(), moved);
}

Primitives::Label labelOf(const std::string& text, const std::vector<std::uint32_t>& atoms, const Structure& s,
                          std::optional<std::uint32_t> color, double* depth) {
    const glm::dmat4x3 motion = firstMotionOf(s);
    std::vector<glm::dvec4> points;
    std::size_t heavy = 0;
    for (const std::uint32_t atom : atoms) {
        points.emplace_back(motion * glm::dvec4(glm::dvec3(s.molecule->atoms[atom].position), 1.0), 0.0);
        if (!isHydrogen(s.molecule->atoms[atom].element)) ++heavy;
    }
    Primitives::Label label;
    const Bounds sphere = extremeSphere(points);
    label.at = sphere.center;
    if (depth) *depth = sphere.radius;
    label.text = withoutMarkup(text);
    label.size = kEmOfSize * std::cbrt(static_cast<double>(heavy > 0 ? heavy : atoms.size()));
    label.color = color;
    return label;
}

std::string withoutMarkup(std::string_view text) {
    std::string plain;
    for (const char c : text) {
        if (c == '_' || c == '^' || c == '\\' || c == '{' || c == '}') plain += '\\';
        plain += c == '\n' ? ' ' : c;
    }
    return plain;
}

}  // namespace nacre::app::mvs
