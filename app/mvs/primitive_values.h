#pragma once
// Checked access to the parameters of a node. All functions throw std::invalid_argument with the reason.

#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/mvs/scene_tree.h"

namespace nacre::app::mvs {

[[noreturn]] void refusePrimitive(const std::string& why);

double number(const Node& node, const char* name, double otherwise);
/// A list of numbers; empty if the node has none.
std::vector<double> numbers(const Node& node, const char* name);
/// Values other than true and false count as missing.
bool flag(const Node& node, const char* name, bool otherwise);
/// A list of `count` numbers within 1e6. @param name  of the parameter, for errors
std::vector<double> numbersIn(const std::string& name, const Json& value, std::size_t count);
glm::dvec3 vectorIn(const char* name, const Json& value);

/// With at most two decimals.
std::string roundedText(double value);
/// A text with the first occurrence of a word replaced.
std::string replaced(std::string text, std::string_view what, const std::string& by);

}  // namespace nacre::app::mvs
