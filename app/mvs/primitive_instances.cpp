// Instances of a group of primitives: all of it, once per matrix.

#include <cmath>

#include "app/mvs/primitive_values.h"
#include "app/mvs/scene_primitives.h"

namespace nacre::app::mvs {
namespace {

std::size_t countOf(const Primitives& p) {
    std::size_t count = p.lines.size() + p.arrows.size() + p.balls.size() + p.ellipsoids.size() + p.ellipses.size() +
                        p.boxes.size() + p.labels.size();
    for (const Primitives::Mesh& mesh : p.meshes) count += mesh.positions.size();
    return count;
}

/// The same elsewhere. Radii stay.
Primitives moved(Primitives p, const glm::dmat4x3& motion) {
    const auto place = [&](glm::dvec3& at) { at = motion * glm::dvec4(at, 1.0); };
    const auto turn = [&](glm::dvec3& direction) { direction = motion * glm::dvec4(direction, 0.0); };
    for (Primitives::Line& line : p.lines) place(line.a), place(line.b);
    for (Primitives::Arrow& arrow : p.arrows) place(arrow.from), place(arrow.to);
    for (Primitives::Ball& ball : p.balls) place(ball.center);
    for (Primitives::Ellipsoid& ellipsoid : p.ellipsoids) {
        place(ellipsoid.center);
        for (glm::dvec3& axis : ellipsoid.axes) turn(axis);
    }
    for (Primitives::Ellipse& ellipse : p.ellipses) place(ellipse.center), turn(ellipse.major), turn(ellipse.minor);
    for (Primitives::Box& box : p.boxes) {
        place(box.center);
        for (glm::dvec3& axis : box.axes) turn(axis);
    }
    for (Primitives::Mesh& mesh : p.meshes)
        for (glm::dvec3& position : mesh.positions) place(position);
    for (Primitives::Label& label : p.labels) place(label.at);
    return p;
}

/// 16 numbers, column by column.
glm::dmat4x3 motionIn(const Json& matrix) {
    if (!matrix.is_array() || matrix.size() != 16) refusePrimitive("an instance is no list of 16 numbers");
    glm::dmat4x3 motion(1.0);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) {
            const Json& each = matrix[static_cast<std::size_t>(4 * column + row)];
            if (!each.is_number() || !(std::abs(each.get<double>()) <= kFarthestPrimitive))
                refusePrimitive("an instance has a value that is no number within 1e6");
            motion[column][row] = each.get<double>();
        }
    return motion;
}

}  // namespace

Primitives atInstances(const Node& group, Primitives primitives) {
    const Json* matrices = group.param("instances");
    if (!matrices) return primitives;
    if (!matrices->is_array()) refusePrimitive("instances is no list");
    if (matrices->size() * countOf(primitives) > kMostPrimitives)
        refusePrimitive("its instances have more than " + std::to_string(kMostPrimitives) + " primitives");
    Primitives result;
    for (const Json& matrix : *matrices) result.append(moved(primitives, motionIn(matrix)));
    return result;
}

}  // namespace nacre::app::mvs
