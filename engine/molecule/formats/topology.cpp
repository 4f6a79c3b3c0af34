#include "engine/molecule/formats/topology.h"

#include <cmath>

#include "engine/molecule/text.h"

namespace nacre {

Element elementOfTopology(MoleculeBuilder& builder, const TopologyAtom& stated, std::string_view name,
                          std::string_view residue) {
    if (stated.mass == 0) return 0;
    if (const Element element = stated.mass ? elementFromMass(*stated.mass) : Element{0}) {
        builder.guess("elements", "from masses");
        return element;
    }
    builder.guess("elements", "from atom names");
    return pdb::elementByLooseName(name, Name(residue));
}

std::pair<std::int32_t, char> residueNumber(std::string_view text) {
    const bool hasCode = text.size() > 1 && isLetter(text.back());
    const char code = hasCode ? text.back() : '\0';
    if (hasCode) text.remove_suffix(1);
    return {static_cast<std::int32_t>(parseInteger(text).value_or(0)), code};
}

void keepTopology(MoleculeBuilder& builder, const TopologyAtom& stated) {
    const auto usable = [](double value) { return std::abs(value) <= 1e6 ? static_cast<float>(value) : 0.0f; };
    builder.molecule().types.emplace_back(stated.type);
    builder.molecule().partialCharges.push_back(usable(stated.charge));
    builder.molecule().masses.push_back(usable(stated.mass.value_or(0)));
}

Molecule withoutPositions(MoleculeBuilder& builder, const char* format) {
    Molecule& molecule = builder.molecule();
    molecule.lacksPositions = true;
    molecule.file.format = format;
    molecule.file.models = 1;
    molecule.file.totalAtomsAllModels = static_cast<std::int64_t>(molecule.atoms.size());
    return builder.finish();
}

}  // namespace nacre
