#include "app/viewer/parts.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <tuple>

#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

/// Words of the selection grammar (selection.h).
constexpr const char* kWords[] = {
    "all",        "altloc ", "and ",   "around ",   "backbone",  "byres ",     "chain ", "elem ",
    "entity ",    "helix",   "hetatm", "hydrogens", "id ",       "ion",        "ligand", "loop",
    "mainligand", "name ",   "none",   "not ",      "nucleic",   "occupancy ", "or ",    "polymer",
    "protein",    "resi ",   "resn ",  "sequence ", "sidechain", "strand",     "water",  "within 5 of "};

bool isWordByte(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '\''; }

bool startsAlike(const std::string& word, const std::string& beginning) {
    return word.size() > beginning.size() &&
           std::equal(beginning.begin(), beginning.end(), word.begin(), [](char a, char b) {
               return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
           });
}

/// Residues of one name.
struct Group {
    std::size_t atoms = 0;
    std::vector<std::uint32_t> residues{};
};

/// Groups the residues that match a test by the name from another function.
template <typename Test, typename FindName>
std::vector<std::pair<std::string, Group>> listGroups(const Molecule& m, Test test, FindName findName) {
    std::vector<std::pair<std::string, Group>> groups;
    std::map<std::string, std::size_t> places;
    for (std::uint32_t r = 0; r < m.residues.size(); ++r) {
        const Residue& residue = m.residues[r];
        if (!test(r)) continue;
        const std::string name = findName(residue);
        const auto [at, isNew] = places.emplace(name, groups.size());
        if (isNew) groups.push_back({name, {}});
        Group& group = groups[at->second].second;
        group.residues.push_back(r);
        group.atoms += residue.atomCount;
    }
    return groups;
}

/// The file's name for an identifier; the identifier if it has none.
std::string findName(const std::string& identifier, const std::map<std::string, std::string>& names) {
    const auto found = names.find(identifier);
    return found == names.end() ? identifier : found->second;
}

/// Words of a name, without punctuation: "HEMOGLOBIN (ALPHA CHAIN)" has three.
std::vector<std::string> nameWords(const std::string& name) {
    std::vector<std::string> words(1);
    for (const char c : name) {
        const bool in = std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0 || c == '-' || c == '\'';
        if (in)
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

/// Number of words shared by the beginnings, or ends, of all names; leaves at least one word of each.
std::size_t sharedWords(const std::vector<std::vector<std::string>>& names, bool atEnd) {
    const auto word = [&](const std::vector<std::string>& name, std::size_t n) {
        return lowerCase(name[atEnd ? name.size() - 1 - n : n]);
    };
    std::size_t shared = 0;
    while (std::all_of(names.begin(), names.end(), [&](const auto& name) {
        return name.size() > shared + 1 && names.front().size() > shared + 1 &&
               word(name, shared) == word(names.front(), shared);
    }))
        ++shared;
    return shared;
}

/// Labels parts; chains by the distinguishing part of their names.
/// @param from  the first of a molecule
void labelParts(std::vector<Part>& parts, std::size_t from) {
    std::vector<std::vector<std::string>> names;
    std::vector<Part*> chains;
    for (std::size_t i = from; i < parts.size(); ++i) {
        Part& part = parts[i];
        part.label = part.chainName.empty() ? part.name : part.chainName;
        if (part.title.empty()) continue;
        names.push_back(nameWords(part.title));
        chains.push_back(&part);
    }
    const bool differ = std::ranges::any_of(names, [&](const auto& name) { return name != names.front(); });
    const std::size_t begin = differ ? sharedWords(names, false) : 0, end = differ ? sharedWords(names, true) : 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string text;
        const std::size_t last = std::max(names[i].size() - std::min(end, names[i].size()), begin + 1);
        for (std::size_t w = begin; w < std::min(last, names[i].size()); ++w)
            text += (text.empty() ? "  " : " ") + names[i][w];
        chains[i]->label += text;
    }
}

bool isPolymer(ResidueKind kind) { return kind == ResidueKind::protein || kind == ResidueKind::nucleic; }

/// The parts of a molecule, and the part of each residue.
struct Parts {
    std::vector<Part> parts;
    std::vector<std::uint32_t> ofResidue;

    void add(Part part, const Group& group) {
        part.residues = group.residues.size();
        part.atoms = group.atoms;
        for (const std::uint32_t r : group.residues) ofResidue[r] = static_cast<std::uint32_t>(parts.size());
        parts.push_back(std::move(part));
    }
};

/// For a packed scene: its compartments, if there are several, and its entities.
void addPackedParts(const Molecule& m, Parts& parts) {
    const auto groups = [&](const auto& nameOfEntity) {
        return listGroups(
            m, [&](std::uint32_t r) { return m.residues[r].entity > 0; },
            [&](const Residue& r) { return nameOfEntity(m.entities[r.entity - 1]); });
    };
    const auto add = [&](const std::string& name, const std::string& selected, const Group& group) {
        parts.add({Part::Kind::all, name, "entity '" + selected + "'"}, group);
    };
    const auto compartments = groups([&](const std::string& id) {
        const std::string name = findName(id, m.file.entityNames);
        const std::size_t point = name.find_last_of('.');
        return point == std::string::npos ? std::string() : name.substr(0, point);
    });
    for (const auto& [name, group] : compartments)
        if (compartments.size() > 1 && !name.empty()) add("Compartment " + name, name + ".*", group);
    for (const auto& [id, group] : groups([](const std::string& identifier) { return identifier; }))
        add(findName(id, m.file.entityNames), id, group);
}

/// The summary of an input's file. @param model  its number among several; 0: there is one input
const FileSummary& findSummary(const Molecule& m, int model) {
    const auto input = static_cast<std::size_t>(model - 1);
    return model > 0 && input < m.inputFiles.size() ? m.inputFiles[input] : m.file;
}

/// Adds the parts of one molecule. @param model  its number among several
void addParts(const Molecule& m, const std::vector<ResidueKind>& kinds, const std::string& input, int model,
              Parts& parts) {
    const std::size_t before = parts.parts.size();
    const FileSummary& file = findSummary(m, model);
    const std::string of = input.empty() ? "" : "/" + input + " and ";
    const auto ours = [&](std::uint32_t r) { return input.empty() || m.chains[m.residues[r].chain].model == model; };
    const auto ofKind = [&](ResidueKind kind) {
        return [&, kind](std::uint32_t r) { return kinds[r] == kind && ours(r); };
    };
    const auto residueName = [](const Residue& r) { return std::string(r.name.view()); };
    for (const auto& [name, group] : listGroups(
             m, [&](std::uint32_t r) { return isPolymer(kinds[r]) && ours(r); },
             [&](const Residue& r) { return m.chains[r.chain].name; })) {
        Part part{Part::Kind::chain, name.empty() ? "Polymer" : "Chain " + name,
                  of + (name.empty() ? "polymer" : "chain " + quotedName(name) + " and polymer")};
        part.chain = m.residues[group.residues.front()].chain;
        part.input = input;
        part.chainName = name;
        // Several files may each have a chain A.
        const auto title = file.chainNames.find(name);
        if (!name.empty() && title != file.chainNames.end()) part.title = title->second;
        if (!part.title.empty()) part.name += ", " + part.title;
        parts.add(std::move(part), group);
    }
    for (const auto& [kind, partKind, word] : {std::tuple(ResidueKind::ligand, Part::Kind::ligand, " and ligand"),
                                               {ResidueKind::ion, Part::Kind::ion, " and ion"}})
        for (const auto& [name, group] : listGroups(m, ofKind(kind), residueName)) {
            if (name.empty()) continue;
            Part part{partKind, findName(name, file.componentNames), of + "resn " + quotedName(name) + word};
            part.input = input;
            parts.add(std::move(part), group);
        }
    if (parts.parts.size() == before) {
        Part all{Part::Kind::all, "All atoms", input.empty() ? "all" : "/" + input};
        all.input = input;
        Group group;
        for (std::uint32_t r = 0; r < m.residues.size(); ++r)
            if (ours(r)) group.residues.push_back(r), group.atoms += m.residues[r].atomCount;
        parts.add(std::move(all), group);
    }
    labelParts(parts.parts, before);
}

}  // namespace

std::vector<Part> listParts(const ResidueFacts& facts, const std::vector<std::string>& inputs,
                            std::vector<std::uint32_t>* ofResidue) {
    const Molecule& m = facts.molecule();
    Parts parts{{}, std::vector<std::uint32_t>(m.residues.size(), kNoPart)};
    const std::vector<ResidueKind>& kinds = facts.kinds();
    if (m.atoms.empty()) return {};
    if (!m.file.packed.empty() && inputs.empty()) addPackedParts(m, parts);
    if (inputs.empty() && parts.parts.empty()) addParts(m, kinds, "", 0, parts);
    for (std::size_t i = 0; i < inputs.size(); ++i) addParts(m, kinds, inputs[i], static_cast<int>(i + 1), parts);
    if (parts.parts.size() > kMostParts) parts.parts.resize(kMostParts);
    for (std::uint32_t& part : parts.ofResidue)
        if (part >= parts.parts.size()) part = kNoPart;
    Group water;
    for (std::uint32_t r = 0; r < m.residues.size(); ++r)
        if (kinds[r] == ResidueKind::water) water.residues.push_back(r), water.atoms += m.residues[r].atomCount;
    Part part{Part::Kind::water, "Water", "water"};
    part.label = part.name;
    if (!water.residues.empty()) parts.add(std::move(part), water);
    if (ofResidue) *ofResidue = std::move(parts.ofResidue);
    return std::move(parts.parts);
}

PartLook findLook(const PictureDescription& view, const Part& part) {
    PartLook look;
    if (part.kind == Part::Kind::water) look.seen = view.drawn.water;
    for (const Rule& rule : view.look.rules) {
        if (!rule.on || rule.selection.text != part.selection) continue;
        if (rule.action == Rule::Action::show) look.style = rule.style, look.seen = true;
        if (rule.action == Rule::Action::hide) look.seen = false;
        if (rule.action == Rule::Action::color) look.coloring = rule.coloring;
    }
    return look;
}

void setPartLook(PictureDescription& view, const Part& part, const PartLook& look) {
    std::vector<Rule>& rules = view.look.rules;
    std::erase_if(rules, [&](const Rule& rule) { return rule.on && rule.selection.text == part.selection; });
    const auto add = [&](Rule::Action action) -> Rule& {
        Rule& rule = rules.emplace_back();
        rule.action = action;
        rule.selection = parseSelection(part.selection);
        return rule;
    };
    if (look.style) add(Rule::Action::show).style = *look.style;
    if (look.coloring) add(Rule::Action::color).coloring = *look.coloring;
    if (part.kind == Part::Kind::water)
        view.drawn.water = look.seen;
    else if (!look.seen)
        add(Rule::Action::hide);
}

std::string quotedName(const std::string& name) {
    const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0;
    });
    return plain ? name : "'" + name + "'";
}

std::vector<std::uint32_t> findSequence(const ResidueFacts& facts, std::uint32_t chain) {
    const Molecule& m = facts.molecule();
    std::vector<std::uint32_t> residues;
    for (std::uint32_t r = 0; r < m.residues.size(); ++r) {
        const Residue& residue = m.residues[r];
        const Chain& of = m.chains[residue.chain];
        if (of.name == m.chains[chain].name && of.model == m.chains[chain].model && facts.isPolymer(r))
            residues.push_back(r);
    }
    return residues;
}

char residueLetter(const Residue& residue) {
    if (const char letter = aminoAcidLetter(residue.name)) return letter;
    if (const char letter = nucleotideLetter(residue.name)) return letter;
    return 'X';
}

std::string residuesText(const Molecule& m, std::uint32_t first, std::uint32_t last, const std::string& input) {
    const auto number = [&](std::uint32_t r) {
        std::string text = std::to_string(m.residues[r].number);
        if (m.residues[r].insertionCode != '\0') text += m.residues[r].insertionCode;
        return text;
    };
    const std::string& chain = m.chains[m.residues[first].chain].name;
    std::string text = input.empty() ? "" : "/" + input + " and ";
    if (!chain.empty()) text += "chain " + quotedName(chain) + " and ";
    text += "resi " + number(first);
    if (last != first) text += "-" + number(last);
    return text;
}

std::string meantSelection(const std::string& typed, const Molecule& molecule) {
    const std::size_t from = typed.find_first_not_of(' '), to = typed.find_last_not_of(' ');
    if (from == std::string::npos) return {};
    const std::string text = typed.substr(from, to - from + 1), capital = upperCase(text);
    const std::size_t digits = capital.find_first_of("0123456789");
    const bool numbered =
        digits != std::string::npos && capital.find_first_not_of("0123456789", digits) == std::string::npos;
    const std::string name = numbered ? capital.substr(0, capital.find_last_not_of(" -0123456789") + 1) : capital;
    const std::string number = numbered ? capital.substr(digits) : "";
    const auto is = [&](const Residue& residue) {
        const std::string own(residue.name.view());
        const bool named =
            upperCase(own) == name || (name.size() == 1 && std::string(1, residueLetter(residue)) == name);
        return (name.empty() || named) && (number.empty() || std::to_string(residue.number) == number) &&
               !(name.empty() && number.empty());
    };
    // Finds a component by its name in the file, "heme".
    for (const auto& [id, called] : molecule.file.componentNames)
        if (upperCase(called) == capital) return "resn " + quotedName(id);
    for (const Residue& residue : molecule.residues)
        if (is(residue) && (numbered || name.size() > 1))
            return (name.empty() ? "" : "resn " + quotedName(std::string(residue.name.view()))) +
                   (name.empty() || number.empty() ? "" : " and ") + (number.empty() ? "" : "resi " + number);
    for (const Chain& chain : molecule.chains)
        if (chain.name == text || chain.name == capital) return "chain " + quotedName(chain.name);
    return {};
}

std::vector<std::string> completions(const std::string& typed, const Molecule& m, std::size_t most) {
    std::size_t start = typed.size();
    while (start > 0 && isWordByte(typed[start - 1])) --start;
    const std::string head = typed.substr(0, start), word = typed.substr(start);
    // Kind of completion after the previous word: names of chains or of residues.
    std::size_t end = head.find_last_not_of(' ');
    std::size_t begin = end == std::string::npos ? 0 : end + 1;
    while (begin > 0 && isWordByte(head[begin - 1])) --begin;
    const std::string before = end == std::string::npos ? "" : head.substr(begin, end + 1 - begin);
    std::set<std::string> names;
    if (before == "chain")
        for (const Chain& chain : m.chains)
            if (!chain.name.empty()) names.insert(quotedName(chain.name));
    if (before == "resn")
        for (const Residue& residue : m.residues)
            if (!residue.name.view().empty()) names.insert(quotedName(std::string(residue.name.view())));
    std::vector<std::string> found;
    const auto offer = [&](const std::string& candidate) {
        if (found.size() < most && startsAlike(candidate, word)) found.push_back(head + candidate);
    };
    if (!names.empty())
        for (const std::string& name : names) offer(name);
    else if (!word.empty())
        for (const char* candidate : kWords) offer(candidate);
    return found;
}

}  // namespace nacre::app
