#include "app/annotation/measurement.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>

#include "engine/molecule/element.h"
#include "engine/molecule/text.h"
#include "engine/scene/build/contacts.h"

namespace nacre::app {
namespace {

constexpr std::string_view kElementNames[] = {
    "Atom",         "Hydrogen",    "Helium",    "Lithium",      "Beryllium",   "Boron",        "Carbon",
    "Nitrogen",     "Oxygen",      "Fluorine",  "Neon",         "Sodium",      "Magnesium",    "Aluminium",
    "Silicon",      "Phosphorus",  "Sulfur",    "Chlorine",     "Argon",       "Potassium",    "Calcium",
    "Scandium",     "Titanium",    "Vanadium",  "Chromium",     "Manganese",   "Iron",         "Cobalt",
    "Nickel",       "Copper",      "Zinc",      "Gallium",      "Germanium",   "Arsenic",      "Selenium",
    "Bromine",      "Krypton",     "Rubidium",  "Strontium",    "Yttrium",     "Zirconium",    "Niobium",
    "Molybdenum",   "Technetium",  "Ruthenium", "Rhodium",      "Palladium",   "Silver",       "Cadmium",
    "Indium",       "Tin",         "Antimony",  "Tellurium",    "Iodine",      "Xenon",        "Caesium",
    "Barium",       "Lanthanum",   "Cerium",    "Praseodymium", "Neodymium",   "Promethium",   "Samarium",
    "Europium",     "Gadolinium",  "Terbium",   "Dysprosium",   "Holmium",     "Erbium",       "Thulium",
    "Ytterbium",    "Lutetium",    "Hafnium",   "Tantalum",     "Tungsten",    "Rhenium",      "Osmium",
    "Iridium",      "Platinum",    "Gold",      "Mercury",      "Thallium",    "Lead",         "Bismuth",
    "Polonium",     "Astatine",    "Radon",     "Francium",     "Radium",      "Actinium",     "Thorium",
    "Protactinium", "Uranium",     "Neptunium", "Plutonium",    "Americium",   "Curium",       "Berkelium",
    "Californium",  "Einsteinium", "Fermium",   "Mendelevium",  "Nobelium",    "Lawrencium",   "Rutherfordium",
    "Dubnium",      "Seaborgium",  "Bohrium",   "Hassium",      "Meitnerium",  "Darmstadtium", "Roentgenium",
    "Copernicium",  "Nihonium",    "Flerovium", "Moscovium",    "Livermorium", "Tennessine",   "Oganesson",
    "Deuterium"};
static_assert(std::size(kElementNames) == 120);

}  // namespace

std::string_view elementName(Element element) {
    return element < std::size(kElementNames) ? kElementNames[element] : kElementNames[0];
}

double measureDistance(const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b); }

double measureAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 u = a - b, v = c - b;
    return glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
}

double measureTorsion(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const glm::dvec3 u = b - a, v = c - b, w = d - c;
    const glm::dvec3 left = glm::cross(u, v), right = glm::cross(v, w);
    return glm::degrees(std::atan2(glm::length(v) * glm::dot(u, right), glm::dot(left, right)));
}

std::string measuredValue(std::span<const glm::dvec3> p) {
    switch (p.size()) {
        case 2:
            return formatted("%.2f Å", measureDistance(p[0], p[1]));
        case 3:
            return formatted("%.1f°", measureAngle(p[0], p[1], p[2]));
        case 4:
            return formatted("%.1f°", measureTorsion(p[0], p[1], p[2], p[3]));
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

std::string shortAtomText(const Molecule& molecule, std::uint32_t index) {
    const Atom& atom = molecule.atoms[index];
    const Residue& residue = molecule.residues[atom.residue];
    std::string text;
    if (!residue.name.view().empty()) text = std::string(residue.name.view()) + " " + std::to_string(residue.number);
    if (residue.insertionCode) text += residue.insertionCode;
    const std::string name(atom.name.view());
    if (name.empty()) return text + (text.empty() ? "atom " : ", atom ") + std::to_string(index + 1);
    return text + (text.empty() ? "" : " ") + name;
}

namespace {

/// An atom, or the residue of a group.
std::string endText(const Molecule& molecule, const InteractionEnd& end) {
    const bool one =
        end.atoms.size() == 1 || (end.atoms.size() == 2 && isHydrogen(molecule.atoms[end.atoms[1]].element));
    std::string text = shortAtomText(molecule, end.atoms.front());
    const std::string_view name = molecule.atoms[end.atoms.front()].name.view();
    if (!one && text.size() > name.size() + 1 && !name.empty()) text.resize(text.size() - name.size() - 1);
    return end.image ? text + " of the next copy" : text;
}

}  // namespace

std::string contactText(const Molecule& molecule, const Interaction& contact) {
    std::string text = contactLook(contact.kind).label + formatted(" %.2f Å, ", contact.distance) +
                       endText(molecule, contact.a) + " to " + endText(molecule, contact.b);
    for (const std::uint32_t water : contact.waters) text += " by " + shortAtomText(molecule, water);
    return text;
}

}  // namespace nacre::app
