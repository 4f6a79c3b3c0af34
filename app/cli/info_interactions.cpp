#include "app/cli/info_interactions.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/files/printable.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/representation.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

namespace {

double rounded(double value, double steps) { return std::round(value * steps) / steps; }

bool severalModels(const Molecule& molecule) {
    return std::any_of(molecule.chains.begin(), molecule.chains.end(),
                       [&](const Chain& chain) { return chain.model != molecule.chains.front().model; });
}

/// The residue of an end and its atoms: all fields of one side, as text.
struct EndFields {
    std::string chain, residue, insertion;
    int model = 1, number = 0;
    std::vector<std::string> atoms;
    std::vector<std::uint32_t> ids;
};

EndFields fieldsOf(const Molecule& molecule, const std::vector<std::uint32_t>& atoms) {
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

Json endJson(const Molecule& molecule, const std::vector<std::uint32_t>& atoms, bool several, bool image) {
    EndFields fields = fieldsOf(molecule, atoms);
    Json json{{"chain", std::move(fields.chain)}};
    if (several) json["model"] = fields.model;
    json["residue"] = std::move(fields.residue);
    json["number"] = fields.number;
    json["insertion"] = std::move(fields.insertion);
    json["atoms"] = std::move(fields.atoms);
    json["ids"] = std::move(fields.ids);
    if (image) json["other_copy"] = true;
    return json;
}

template <typename Value>
std::string joined(const std::vector<Value>& values) {
    std::ostringstream text;
    for (std::size_t i = 0; i < values.size(); ++i) text << (i ? " " : "") << values[i];
    return text.str();
}

std::string endCells(const Molecule& molecule, const InteractionEnd& end) {
    const EndFields fields = fieldsOf(molecule, end.atoms);
    return csvCell(fields.chain) + "," + std::to_string(fields.model) + "," + csvCell(fields.residue) + "," +
           std::to_string(fields.number) + "," + csvCell(fields.insertion) + "," + csvCell(joined(fields.atoms)) + "," +
           joined(fields.ids) + "," + (end.image ? "1" : "0");
}

const char* donorName(const Interaction& interaction) {
    return interaction.donor == DonorSide::a ? "a" : interaction.donor == DonorSide::b ? "b" : "";
}

std::vector<bool> matched(const Molecule& molecule, const Selection& selection) {
    std::vector<bool> atoms = selectAtoms(molecule, selection);
    if (std::find(atoms.begin(), atoms.end(), true) == atoms.end())
        throw Error("cannot find interactions", "--interactions", "'" + selection.text + "' matches no atoms");
    return atoms;
}

}  // namespace

std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string decimals(double value, int digits) {
    std::ostringstream text;
    text.setf(std::ios::fixed);
    text.precision(digits);
    text << value;
    return text.str();
}

double thousandths(double value) { return rounded(value, 1000); }

std::string endName(const Molecule& molecule, const std::vector<std::uint32_t>& atoms) {
    const EndFields fields = fieldsOf(molecule, atoms);
    return printable(fields.chain + "/" + fields.residue + " " + std::to_string(fields.number) + fields.insertion +
                     " " + joined(fields.atoms));
}

InteractionQuery interactionQuery(const Molecule& molecule, const ContactOptions& contacts) {
    InteractionQuery query{matched(molecule, *contacts.of), {}, contacts.kinds};
    if (contacts.with) query.b = matched(molecule, *contacts.with);
    return query;
}

std::vector<Interaction> interactionsOf(const Molecule& molecule, const ContactOptions& contacts,
                                        const std::string& assembly) {
    const InteractionQuery query = interactionQuery(molecule, contacts);
    if (assembly.empty()) return InteractionFinder(molecule, contacts.rules).find(molecule, query);
    RepresentationOptions look;
    look.style = Style::licorice;
    look.contacts = contacts;
    look.assembly = assembly;
    std::vector<Interaction> found;
    for (DrawnContact& contact :
         represent(molecule, drawnAtoms(molecule, {.water = true, .hydrogens = true}), look).contacts)
        found.push_back(std::move(contact.interaction));
    return found;
}

Json interactionList(const Molecule& molecule, const std::vector<Interaction>& interactions) {
    const bool several = severalModels(molecule);
    Json list = Json::array();
    for (const Interaction& interaction : interactions) {
        Json json{{"kind", interactionKindName(interaction.kind)},
                  {"a", endJson(molecule, interaction.a.atoms, several, interaction.a.image)},
                  {"b", endJson(molecule, interaction.b.atoms, several, interaction.b.image)},
                  {"distance", rounded(interaction.distance, 1000)}};
        json["angles"] = Json::object();
        for (const InteractionAngle& angle : interaction.angles)
            json["angles"][angle.name] = rounded(angle.degrees, 10);
        if (interaction.offset >= 0) json["offset"] = rounded(interaction.offset, 1000);
        if (interaction.donor != DonorSide::none) json["donor"] = donorName(interaction);
        if (!interaction.waters.empty()) {
            json["waters"] = Json::array();
            for (const std::uint32_t water : interaction.waters)
                json["waters"].push_back(endJson(molecule, {water}, several, interaction.waterImage));
        }
        list.push_back(std::move(json));
    }
    return list;
}

std::string interactionCsv(const Molecule& molecule, const std::vector<Interaction>& interactions) {
    std::string text = "kind";
    for (const char* side : {"a", "b"})
        for (const char* field : {"chain", "model", "residue", "number", "insertion", "atoms", "ids", "other_copy"})
            text += std::string(",") + side + "_" + field;
    text += ",distance,angles,offset,donor,waters\n";
    for (const Interaction& interaction : interactions) {
        std::string angles;
        for (const InteractionAngle& angle : interaction.angles)
            angles += (angles.empty() ? "" : " ") + std::string(angle.name) + "=" + decimals(angle.degrees, 1);
        std::vector<std::uint32_t> waters;
        for (const std::uint32_t water : interaction.waters) waters.push_back(water + 1);
        text += std::string(interactionKindName(interaction.kind)) + "," + endCells(molecule, interaction.a) + "," +
                endCells(molecule, interaction.b) + "," + decimals(interaction.distance, 3) + "," + angles + "," +
                (interaction.offset >= 0 ? decimals(interaction.offset, 3) : "") + "," + donorName(interaction) + "," +
                joined(waters) + "\n";
    }
    return text;
}

std::string interactionText(const Molecule& molecule, const std::vector<Interaction>& interactions) {
    std::string text = "  interactions\n";
    for (const Interaction& interaction : interactions) {
        std::string line = "    " + std::string(interactionKindName(interaction.kind));
        line.resize(std::max<std::size_t>(line.size(), 19), ' ');
        const auto named = [&](const InteractionEnd& end) {
            return endName(molecule, end.atoms) + (end.image ? " of another copy" : "");
        };
        line += decimals(interaction.distance, 2) + " Å  " + named(interaction.a) + "  -  " + named(interaction.b);
        for (const std::uint32_t water : interaction.waters) line += "  by " + endName(molecule, {water});
        text += line + "\n";
    }
    return text;
}

}  // namespace nacre::app
