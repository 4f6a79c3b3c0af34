#include "app/input/interaction_list.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {
namespace {

using Json = nlohmann::ordered_json;

double inSteps(double value, double steps) { return std::round(value * steps) / steps; }

std::vector<bool> matched(const Molecule& molecule, const Selection& selection) {
    std::vector<bool> atoms = selectAtoms(molecule, selection);
    if (std::find(atoms.begin(), atoms.end(), true) == atoms.end())
        throw Error("cannot find interactions", "--interactions", "'" + selection.text + "' matches no atoms");
    return atoms;
}

Json endJson(const Molecule& molecule, const std::vector<std::uint32_t>& atoms, bool image) {
    EndFields fields = endFields(molecule, atoms);
    return {{"chain", std::move(fields.chain)},
            {"model", fields.model},
            {"residue", std::move(fields.residue)},
            {"number", fields.number},
            {"insertion", std::move(fields.insertion)},
            {"atoms", std::move(fields.atoms)},
            {"ids", std::move(fields.ids)},
            {"other_copy", image}};
}

}  // namespace

EndFields endFields(const Molecule& molecule, const std::vector<std::uint32_t>& atoms) {
    const Residue& residue = molecule.residues[molecule.atoms[atoms.front()].residue];
    const Chain& chain = molecule.chains[residue.chain];
    EndFields fields{chain.name,
                     std::string(residue.name.view()),
                     residue.insertionCode ? std::string(1, residue.insertionCode) : "",
                     chain.model,
                     residue.number,
                     {},
                     {}};
    for (const std::uint32_t atom : atoms) {
        fields.atoms.emplace_back(molecule.atoms[atom].name.view());
        fields.ids.push_back(atom + 1);
    }
    return fields;
}

const char* donorName(const Interaction& interaction) {
    return interaction.donor == DonorSide::a ? "a" : interaction.donor == DonorSide::b ? "b" : "";
}

double thousandths(double value) { return inSteps(value, 1000); }

InteractionQuery interactionQuery(const Molecule& molecule, const ContactOptions& contacts) {
    InteractionQuery query{matched(molecule, *contacts.of), {}, contacts.kinds};
    if (contacts.with) query.b = matched(molecule, *contacts.with);
    return query;
}

std::vector<Interaction> listInteractions(const Molecule& molecule, const ContactOptions& contacts,
                                          const std::string& assembly) {
    const InteractionQuery query = interactionQuery(molecule, contacts);
    if (assembly.empty()) return InteractionFinder(molecule, contacts.rules).find(molecule, query);
    RepresentationOptions look{.style = Style::licorice, .assembly = assembly, .contacts = contacts};
    std::vector<Interaction> found;
    for (DrawnContact& contact :
         represent(molecule, drawnAtoms(molecule, {.water = true, .hydrogens = true}), look).contacts)
        found.push_back(std::move(contact.interaction));
    return found;
}

Json interactionList(const Molecule& molecule, const std::vector<Interaction>& interactions) {
    Json list = Json::array();
    for (const Interaction& interaction : interactions) {
        Json angles = Json::object(), waters = Json::array();
        for (const InteractionAngle& angle : interaction.angles) angles[angle.name] = inSteps(angle.degrees, 10);
        for (const std::uint32_t water : interaction.waters)
            waters.push_back(endJson(molecule, {water}, interaction.waterImage));
        list.push_back({{"kind", interactionKindName(interaction.kind)},
                        {"a", endJson(molecule, interaction.a.atoms, interaction.a.image)},
                        {"b", endJson(molecule, interaction.b.atoms, interaction.b.image)},
                        {"distance", thousandths(interaction.distance)},
                        {"angles", std::move(angles)},
                        {"offset", interaction.offset >= 0 ? Json(thousandths(interaction.offset)) : Json()},
                        {"donor", interaction.donor == DonorSide::none ? Json() : Json(donorName(interaction))},
                        {"waters", std::move(waters)}});
    }
    return list;
}

}  // namespace nacre::app
