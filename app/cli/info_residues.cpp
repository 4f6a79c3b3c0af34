#include <algorithm>
#include <iomanip>
#include <sstream>

#include "app/cli/info_command.h"
#include "app/files/printable.h"
#include "engine/molecule/residue_facts.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

namespace {

const char* structureName(SecondaryStructure secondary) {
    switch (secondary) {
        case SecondaryStructure::helix:
            return "helix";
        case SecondaryStructure::strand:
            return "strand";
        case SecondaryStructure::none:
            break;
    }
    return "coil";
}

}  // namespace

Json residueList(const Molecule& molecule) {
    const ResidueFacts facts(molecule);
    Json list = Json::array();
    for (std::size_t i = 0; i < molecule.residues.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        const Chain& chain = molecule.chains[residue.chain];
        list.push_back(
            {{"chain", chain.name},
             {"model", chain.model},
             {"number", residue.number},
             {"insertion", residue.insertionCode ? std::string(1, residue.insertionCode) : ""},
             {"name", residue.name.view()},
             {"secondary", facts.kinds()[i] == ResidueKind::protein ? Json(structureName(facts.folds()[i])) : Json()}});
    }
    return list;
}

std::string residueText(const Json& residues) {
    std::ostringstream out;
    out << "  residues\n";
    const bool several = std::ranges::any_of(
        residues, [&](const Json& residue) { return residue["model"] != residues.front()["model"]; });
    for (const Json& residue : residues) {
        const std::string chain = residue["chain"], name = residue["name"];
        const std::string place =
            std::to_string(residue["number"].get<int>()) + residue["insertion"].get<std::string>();
        const std::string model = several ? residue["model"].dump() + "  " : "";
        out << "    " << model << std::left << std::setw(5) << printable(chain.empty() ? "-" : chain) << std::right
            << std::setw(6) << printable(place) << "  " << std::left << std::setw(4) << printable(name);
        if (!residue["secondary"].is_null()) out << "  " << residue["secondary"].get<std::string>();
        out << '\n';
    }
    return out.str();
}

}  // namespace nacre::app
