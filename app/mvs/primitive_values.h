#pragma once
// The parameters of a primitive's node, checked. All throw Error with the node's place.

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/mvs/scene_tree.h"

namespace nacre::app::mvs {

[[noreturn]] void refusePrimitive(const Node& node, const std::string& why);

double number(const Node& node, const char* name, double otherwise);
/// A list of numbers; empty if the node has none.
std::vector<double> numbers(const Node& node, const char* name);
/// What is neither true nor false is taken as not given.
bool flag(const Node& node, const char* name, bool otherwise);
/// @param name  of the parameter, for errors
glm::dvec3 vectorOf(const Node& node, const char* name, const Json& value);

}  // namespace nacre::app::mvs
