// Prints what is read of a file as JSON, for judges: read_report FILE [MODEL].
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/molecule/chemistry/drawn_orders.h"
#include "engine/molecule/element.h"
#include "engine/molecule/read.h"

int main(int count, char** arguments) try {
    nacre::ReadOptions options;
    if (count > 2) options.model = std::stoi(arguments[2]);
    const nacre::Molecule molecule = nacre::readMoleculeFile(arguments[1], options);
    nlohmann::json report;
    for (const nacre::Atom& atom : molecule.atoms) {
        const nacre::Residue& residue = molecule.residues[atom.residue];
        report["names"].push_back(atom.name.view());
        report["elements"].push_back(atom.element ? nacre::elementSymbol(atom.element) : "");
        report["positions"].push_back({atom.position.x, atom.position.y, atom.position.z});
        report["resnames"].push_back(residue.name.view());
        report["resids"].push_back(residue.number);
        report["segids"].push_back(residue.segment.view());
        report["radii"].push_back(atom.radius);
    }
    report["bonds"] = nlohmann::json::array();
    for (const nacre::Bond& bond : molecule.bonds)
        if (bond.source == nacre::BondSource::file) report["bonds"].push_back({bond.a, bond.b});
    report["charges"] = molecule.partialCharges;
    report["masses"] = molecule.masses;
    for (const nacre::Name& type : molecule.types) report["types"].push_back(type.view());
    if (molecule.file.box)
        for (const glm::vec3& edge : *molecule.file.box) report["box"].push_back({edge.x, edge.y, edge.z});
    if (molecule.file.box) report["periodic"] = molecule.file.boxRepeats;
    const glm::vec3& origin = molecule.file.boxOrigin;
    report["box_origin"] = {origin.x, origin.y, origin.z};
    report["models"] = molecule.file.models.value_or(molecule.file.records.value_or(1));
    report["warnings"] = molecule.warnings;
    for (const nacre::ReadNote& note : nacre::listReadNotes(molecule, nacre::drawnOrders(molecule)))
        report["reading"].push_back(nacre::describeNote(note));
    std::cout << report.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) << '\n';
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
