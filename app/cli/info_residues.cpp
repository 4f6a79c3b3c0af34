#include <algorithm>
#include <iomanip>
#include <sstream>

#include "app/cli/info_command.h"
#include "app/files/printable.h"
#include "engine/molecule/residue_facts.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

namespace {

const char* nameOf(SecondaryStructure secondary) {
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
    const bool several = std::any_of(molecule.chains.begin(), molecule.chains.end(),
                                     [&](const Chain& chain) { return chain.model != molecule.chains.front().model; });
    Json list = Json::array();
    for (std::size_t i = 0; i < molecule.residues.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        const Chain& chain = molecule.chains[residue.chain];
        Json entry{{"chain", chain.name}};
        if (several) entry["model"] = chain.model;
        entry["number"] = residue.number;
        entry["insertion"] = residue.insertionCode ? std::string(1, residue.insertionCode) : "";
        entry["name"] = residue.name.view();
        if (facts.kinds()[i] == ResidueKind::protein) entry["secondary"] = nameOf(facts.folds()[i]);
        list.push_back(std::move(entry));
    }
    return list;
}

std::string residueText(const Json& residues) {
    std::ostringstream out;
    out << "  residues\n";
    for (const Json& residue : residues) {
        const std::string chain = residue["chain"], name = residue["name"];
        const std::string place =
            std::to_string(residue["number"].get<int>()) + residue["insertion"].get<std::string>();
        const std::string model = residue.contains("model") ? std::to_string(residue["model"].get<int>()) + "  " : "";
        out << "    " << model << std::left << std::setw(5) << printable(chain.empty() ? "-" : chain) << std::right
            << std::setw(6) << printable(place) << "  " << std::left << std::setw(4) << printable(name);
        if (residue.contains("secondary")) out << "  " << residue["secondary"].get<std::string>();
        out << '\n';
    }
    return out.str();
}

}  // namespace nacre::app
