#include "app/cli/info_interactions.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <utility>

#include "app/files/printable.h"
#include "app/input/read_input.h"

namespace nacre::app {
namespace {

using Json = nlohmann::ordered_json;

/// Counts the interactions of single models or frames.
class Counter {
public:
    explicit Counter(const Molecule& molecule) : molecule_(molecule) {}

    void add(const Interaction& contact, int occasion) {
        std::string first = makeName(contact.a), second = makeName(contact.b);
        if (second < first) std::swap(first, second);
        const std::string key = std::string(interactionKindName(contact.kind)) + "\t" + first + "\t" + second;
        const auto [place, added] = index_.emplace(key, counted_.size());
        if (added) counted_.push_back({{contact, 0, 0, contact.distance, contact.distance}, occasion - 1, 0});
        Counted& counted = counted_[place->second];
        if (counted.last != occasion) {
            counted.last = occasion;
            counted.here = contact.distance;
            ++counted.frequency.count;
            counted.frequency.sum += contact.distance;
        } else if (contact.distance < counted.here) {
            counted.frequency.sum += contact.distance - counted.here;
            counted.here = contact.distance;
        }
        counted.frequency.least = std::min(counted.frequency.least, contact.distance);
        counted.frequency.most = std::max(counted.frequency.most, counted.here);
    }

    std::vector<ContactFrequency> sorted() const {
        std::vector<ContactFrequency> all;
        for (const Counted& counted : counted_) all.push_back(counted.frequency);
        std::stable_sort(all.begin(), all.end(),
                         [](const ContactFrequency& l, const ContactFrequency& r) { return l.count > r.count; });
        return all;
    }

private:
    /// A name independent of a ring's or group's first atom.
    std::string makeName(const InteractionEnd& end) const {
        std::vector<std::uint32_t> atoms = end.atoms;
        std::sort(atoms.begin(), atoms.end(), [&](std::uint32_t l, std::uint32_t r) {
            return molecule_.atoms[l].name.view() < molecule_.atoms[r].name.view();
        });
        return endName(molecule_, atoms);
    }

    struct Counted {
        ContactFrequency frequency;
        int last;     ///< the last model or frame that has it
        double here;  ///< shortest distance there
    };
    const Molecule& molecule_;
    std::map<std::string, std::size_t> index_;
    std::vector<Counted> counted_;
};

std::string percent(std::size_t count, std::size_t of) {
    return decimals(100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(of, 1)), 1);
}

double mean(const ContactFrequency& frequency) { return frequency.sum / static_cast<double>(frequency.count); }

template <typename Value>
std::string joined(const std::vector<Value>& values) {
    std::ostringstream text;
    for (std::size_t i = 0; i < values.size(); ++i) text << (i ? " " : "") << values[i];
    return text.str();
}

/// Quoted if needed.
std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string endCells(const Molecule& molecule, const InteractionEnd& end) {
    const EndFields fields = endFields(molecule, end.atoms);
    return csvCell(fields.chain) + "," + std::to_string(fields.model) + "," + csvCell(fields.residue) + "," +
           std::to_string(fields.number) + "," + csvCell(fields.insertion) + "," + csvCell(joined(fields.atoms)) + "," +
           joined(fields.ids) + "," + (end.image ? "1" : "0");
}

}  // namespace

std::string decimals(double value, int digits) {
    std::ostringstream text;
    text.setf(std::ios::fixed);
    text.precision(digits);
    text << value;
    return text.str();
}

std::string endName(const Molecule& molecule, const std::vector<std::uint32_t>& atoms) {
    const EndFields fields = endFields(molecule, atoms);
    return printable(fields.chain + "/" + fields.residue + " " + std::to_string(fields.number) + fields.insertion +
                     " " + joined(fields.atoms));
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

ContactFrequencies contactFrequencies(const Molecule& molecule, const ContactOptions& contacts,
                                      const TrajectoryOptions& trajectory) {
    const InteractionQuery query = interactionQuery(molecule, contacts);
    const InteractionFinder finder(molecule, contacts.rules);
    Counter counter(molecule);
    if (!trajectory.path.empty()) {
        const std::unique_ptr<Motion> motion = openMotion(trajectory, molecule);
        Molecule moved = molecule;
        const std::size_t frames = motion->frames();
        for (std::size_t frame = 0; frame < frames; ++frame) {
            movePositions(moved, motion->positions(frame));
            for (const Interaction& contact : finder.find(moved, query)) counter.add(contact, static_cast<int>(frame));
        }
        return {counter.sorted(), frames};
    }
    const auto findModel = [&](std::uint32_t atom) {
        return molecule.chains[molecule.residues[molecule.atoms[atom].residue].chain].model;
    };
    std::set<int> models;
    for (const Chain& chain : molecule.chains) models.insert(chain.model);
    std::vector<Interaction> found = finder.find(molecule, query);
    std::stable_sort(found.begin(), found.end(), [&](const Interaction& l, const Interaction& r) {
        return findModel(l.a.atoms.front()) < findModel(r.a.atoms.front());
    });
    for (const Interaction& contact : found) counter.add(contact, findModel(contact.a.atoms.front()));
    return {counter.sorted(), molecule.modelsAreInputs ? 1 : models.size()};
}

Json frequencyList(const Molecule& molecule, const ContactFrequencies& frequencies) {
    Json list = Json::array();
    for (const ContactFrequency& frequency : frequencies.contacts) {
        Json json = interactionList(molecule, {frequency.first}).front();
        list.push_back({{"kind", json["kind"]},
                        {"a", json["a"]},
                        {"b", json["b"]},
                        {"count", frequency.count},
                        {"share", static_cast<double>(frequency.count) / static_cast<double>(frequencies.of)},
                        {"distance",
                         {{"mean", thousandths(mean(frequency))},
                          {"min", thousandths(frequency.least)},
                          {"max", thousandths(frequency.most)}}}});
    }
    return list;
}

std::string frequencyCsv(const Molecule& molecule, const ContactFrequencies& frequencies) {
    std::string text = "kind,a,b,count,of,percent,mean_distance,min_distance,max_distance\n";
    for (const ContactFrequency& frequency : frequencies.contacts)
        text += std::string(interactionKindName(frequency.first.kind)) + "," +
                csvCell(endName(molecule, frequency.first.a.atoms)) + "," +
                csvCell(endName(molecule, frequency.first.b.atoms)) + "," + std::to_string(frequency.count) + "," +
                std::to_string(frequencies.of) + "," + percent(frequency.count, frequencies.of) + "," +
                decimals(mean(frequency), 3) + "," + decimals(frequency.least, 3) + "," + decimals(frequency.most, 3) +
                "\n";
    return text;
}

std::string frequencyText(const Molecule& molecule, const ContactFrequencies& frequencies) {
    std::string text = "  interactions in " + std::to_string(frequencies.of) + " models or frames\n";
    for (const ContactFrequency& frequency : frequencies.contacts) {
        std::string share = percent(frequency.count, frequencies.of) + " %";
        share.insert(0, share.size() < 7 ? 7 - share.size() : 0, ' ');
        std::string line = "    " + share + "  " + std::string(interactionKindName(frequency.first.kind));
        line.resize(std::max<std::size_t>(line.size(), 28), ' ');
        text += line + decimals(mean(frequency), 2) + " Å  " + endName(molecule, frequency.first.a.atoms) + "  -  " +
                endName(molecule, frequency.first.b.atoms) + "\n";
    }
    return text;
}

}  // namespace nacre::app
