#include "app/annotation/element_names.h"

#include <iterator>

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

}  // namespace nacre::app
