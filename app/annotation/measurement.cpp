#include "app/annotation/measurement.h"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/annotation/element_names.h"

namespace nacre::app {
namespace {

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

double distanceOf(const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b); }

double angleOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 u = a - b, v = c - b;
    return glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
}

double torsionOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const glm::dvec3 u = b - a, v = c - b, w = d - c;
    const glm::dvec3 left = glm::cross(u, v), right = glm::cross(v, w);
    return glm::degrees(std::atan2(glm::length(v) * glm::dot(u, right), glm::dot(left, right)));
}

std::string measuredValue(std::span<const glm::dvec3> p) {
    switch (p.size()) {
        case 2:
            return formatted("%.2f Å", distanceOf(p[0], p[1]));
        case 3:
            return formatted("%.1f°", angleOf(p[0], p[1], p[2]));
        case 4:
            return formatted("%.1f°", torsionOf(p[0], p[1], p[2], p[3]));
        default:
            return "";
    }
}

std::string measurementText(std::span<const glm::dvec3> p) {
    constexpr const char* kNames[] = {"distance ", "angle ", "torsion "};
    return p.size() < 2 || p.size() > 4 ? "" : kNames[p.size() - 2] + measuredValue(p);
}

std::string atomText(const Molecule& molecule, std::uint32_t index) {
    const Atom& atom = molecule.atoms[index];
    const Residue& residue = molecule.residues[atom.residue];
    std::string text(elementName(atom.element));
    if (!atom.name.view().empty()) text += " " + std::string(atom.name.view());
    if (!residue.name.view().empty()) {
        text += ", residue " + std::string(residue.name.view()) + " " + std::to_string(residue.number);
        if (residue.insertionCode) text += residue.insertionCode;
        if (const auto name = molecule.file.componentNames.find(std::string(residue.name.view()));
            name != molecule.file.componentNames.end())
            text += " (" + name->second + ")";
    }
    if (const std::string& chain = molecule.chains[residue.chain].name; !chain.empty()) text += ", chain " + chain;
    return text + ", atom " + std::to_string(index + 1);
}

}  // namespace nacre::app
