#include "app/mvs/primitive_values.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "engine/scene/primitives.h"

namespace nacre::app::mvs {

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

glm::dvec3 vectorIn(const char* name, const Json& value) {
    glm::dvec3 v(0);
    if (!value.is_array() || value.size() != 3) refusePrimitive(std::string(name) + " is no list of three numbers");
    for (int i = 0; i < 3; ++i) {
        const Json& each = value[static_cast<std::size_t>(i)];
        if (!each.is_number() || !(std::abs(each.get<double>()) <= kFarthestPrimitive))
            refusePrimitive(std::string(name) + " has a value that is no number within 1e6");
        v[i] = each.get<double>();
    }
    return v;
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
    char text[40];
    std::snprintf(text, sizeof text, "%.2f", value);
    std::string plain = text;
    plain.erase(plain.find_last_not_of('0') + 1);
    if (plain.ends_with('.')) plain.pop_back();
    return plain;
}

std::string replaced(std::string text, std::string_view what, const std::string& by) {
    if (const std::size_t at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
    return text;
}

}  // namespace nacre::app::mvs
