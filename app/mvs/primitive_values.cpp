#include "app/mvs/primitive_values.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "app/mvs/scene_primitives.h"
#include "engine/molecule/text.h"
#include "engine/scene/build/primitives.h"

namespace nacre::app::mvs {
namespace {

std::size_t countPrimitives(const Primitives& p) {
    std::size_t count = p.lines.size() + p.arrows.size() + p.balls.size() + p.ellipsoids.size() + p.ellipses.size() +
                        p.boxes.size() + p.labels.size();
    for (const Primitives::Mesh& mesh : p.meshes) count += mesh.positions.size();
    return count;
}

/// Moves primitives. Radii stay.
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

}  // namespace

void refusePrimitive(const std::string& why) { throw std::invalid_argument(why); }

double number(const Node& node, const char* name, double otherwise) {
    const Json* value = node.param(name);
    if (!value) return otherwise;
    if (!value->is_number() || !(std::abs(value->get<double>()) <= kFarthestPrimitive))
        refusePrimitive(std::string(name) + " is no number within 1e6");
    return value->get<double>();
}

bool flag(const Node& node, const char* name, bool otherwise) {
    const Json* value = node.param(name);
    return value && value->is_boolean() ? value->get<bool>() : otherwise;
}

std::vector<double> numbersIn(const std::string& name, const Json& value, std::size_t count) {
    if (!value.is_array() || value.size() != count)
        refusePrimitive(name + " is no list of " + (count == 3 ? "three" : std::to_string(count)) + " numbers");
    std::vector<double> numbers;
    for (const Json& each : value) {
        if (!each.is_number() || !(std::abs(each.get<double>()) <= kFarthestPrimitive))
            refusePrimitive(name + " has a value that is no number within 1e6");
        numbers.push_back(each.get<double>());
    }
    return numbers;
}

glm::dvec3 vectorIn(const char* name, const Json& value) {
    const std::vector<double> v = numbersIn(name, value, 3);
    return {v[0], v[1], v[2]};
}

std::vector<double> numbers(const Node& node, const char* name) {
    const Json* value = node.param(name);
    if (!value) return {};
    if (!value->is_array()) refusePrimitive(std::string(name) + " is no list");
    std::vector<double> list;
    list.reserve(value->size());
    for (const Json& each : *value) {
        if (!each.is_number() || !(std::abs(each.get<double>()) <= 1e9))
            refusePrimitive(std::string(name) + " has a value that is no number");
        list.push_back(each.get<double>());
    }
    return list;
}

std::string roundedText(double value) {
    std::string plain = formatted("%.2f", value);
    plain.erase(plain.find_last_not_of('0') + 1);
    if (plain.ends_with('.')) plain.pop_back();
    return plain;
}

std::string replaced(std::string text, std::string_view what, const std::string& by) {
    if (const std::size_t at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
    return text;
}

Primitives atInstances(const Node& group, Primitives primitives) {
    const Json* matrices = group.param("instances");
    if (!matrices) return primitives;
    if (!matrices->is_array()) refusePrimitive("instances is no list");
    if (matrices->size() * countPrimitives(primitives) > kMostPrimitives)
        refusePrimitive("its instances have more than " + std::to_string(kMostPrimitives) + " primitives");
    Primitives result;
    for (const Json& matrix : *matrices) {
        const std::vector<double> m = numbersIn("an instance", matrix, 16);
        result.append(moved(primitives, glm::dmat4x3(glm::make_mat4(m.data()))));
    }
    return result;
}

}  // namespace nacre::app::mvs
