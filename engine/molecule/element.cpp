#include "engine/molecule/element.h"

#include <cmath>
#include <gemmi/elem.hpp>

#include "engine/molecule/text.h"

namespace nacre {
namespace {

/// Elements come from files; numbers outside the table count as unknown.
gemmi::El known(Element element) { return static_cast<gemmi::El>(element <= 119 ? element : 0); }

}  // namespace

Element elementFromSymbol(std::string_view symbol) {
    if (symbol.empty() || symbol.size() > 2) return 0;
    // gemmi's own look-up masks bits and so accepts "C1" as "C"; compare letters instead.
    const char first = upperCase(symbol[0]);
    const char second = symbol.size() == 2 ? upperCase(symbol[1]) : '\0';
    for (int number = 1; number <= 119; ++number) {
        const char* name = gemmi::element_uppercase_name(static_cast<gemmi::El>(number));
        if (name[0] == first && name[1] == second) return static_cast<Element>(number);
    }
    return 0;
}

std::string_view elementSymbol(Element element) { return gemmi::element_name(known(element)); }

float vanDerWaalsRadius(Element element) { return gemmi::vdw_radius(known(element)); }

float covalentRadius(Element element) { return gemmi::covalent_radius(known(element)); }

bool isHydrogen(Element element) { return gemmi::is_hydrogen(known(element)); }

bool isMetal(Element element) { return gemmi::is_metal(known(element)); }

Element elementFromMass(double mass) {
    constexpr double kNear = 0.2, kHeaviestHydrogen = 4.1;  // hydrogens of up to 4 u allow longer time steps
    if (mass > 0.9 && mass < kHeaviestHydrogen && std::abs(mass - gemmi::molecular_weight(gemmi::El::He)) > 0.01)
        return 1;
    Element best = 0;
    double nearest = kNear;
    for (int number = 2; number <= 118; ++number) {
        const double apart = std::abs(gemmi::molecular_weight(static_cast<gemmi::El>(number)) - mass);
        if (apart < nearest) nearest = apart, best = static_cast<Element>(number);
    }
    return best;
}

}  // namespace nacre
