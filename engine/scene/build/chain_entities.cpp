#include "engine/scene/build/chain_entities.h"

#include <map>
#include <optional>

namespace nacre {
namespace {

constexpr std::size_t kMostChainsNamed = 6;

class EntityTable {
public:
    std::uint32_t indexOf(const std::string& key, const std::string& label) {
        const auto [found, added] = known_.emplace(key, static_cast<std::uint32_t>(labels_.size()));
        if (added) labels_.push_back(label);
        return found->second;
    }
    std::vector<std::string> labels_;

private:
    std::map<std::string, std::uint32_t> known_;
};

/// Residue names of each chain's polymer, in order.
std::vector<std::string> sequences(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    std::vector<std::string> result(molecule.chains.size());
    for (std::uint32_t i = 0; i < molecule.residues.size(); ++i)
        if (facts.isPolymer(i)) {
            std::string& sequence = result[molecule.residues[i].chain];
            sequence += molecule.residues[i].name.view();
            sequence += ' ';
        }
    return result;
}

/// "chain B" or "chains A, C"; long lists are cut.
std::vector<std::string> chainLabels(const Molecule& molecule, const std::vector<std::string>& sequenceOfChain) {
    std::map<std::string_view, std::vector<std::size_t>> chains;
    for (std::size_t i = 0; i < sequenceOfChain.size(); ++i) chains[sequenceOfChain[i]].push_back(i);
    std::vector<std::string> labels(sequenceOfChain.size());
    for (const auto& [sequence, same] : chains) {
        std::string label = same.size() == 1 ? "chain " : "chains ";
        for (std::size_t i = 0; i < same.size() && i < kMostChainsNamed; ++i)
            label += (i > 0 ? ", " : "") + molecule.chains[same[i]].name;
        if (same.size() > kMostChainsNamed) label += " and " + std::to_string(same.size() - kMostChainsNamed) + " more";
        for (const std::size_t chain : same) labels[chain] = label;
    }
    return labels;
}

}  // namespace

ResidueEntities residueEntities(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    const std::vector<std::string> sequenceOfChain = sequences(facts);
    const std::vector<std::string> labels = chainLabels(molecule, sequenceOfChain);
    EntityTable table;
    std::vector<std::optional<std::uint32_t>> ofChain(molecule.chains.size());  // sequences may be long
    ResidueEntities result;
    result.ofResidue.reserve(molecule.residues.size());
    // Keys start with a character for one of three cases, so that names do not collide.
    for (std::uint32_t i = 0; i < molecule.residues.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        const std::string name(residue.name.view());
        std::uint32_t index = 0;
        if (residue.entity > 0 && residue.entity <= molecule.entities.size()) {
            const std::string& identifier = molecule.entities[residue.entity - 1];
            const auto named = molecule.file.entityNames.find(identifier);
            index =
                table.indexOf("e" + identifier, named == molecule.file.entityNames.end() ? identifier : named->second);
        } else if (facts.isPolymer(i)) {
            std::optional<std::uint32_t>& known = ofChain[residue.chain];
            if (!known) known = table.indexOf("s" + sequenceOfChain[residue.chain], labels[residue.chain]);
            index = *known;
        } else if (facts.kinds()[i] == ResidueKind::water) {
            index = table.indexOf("w", "water");
        } else {
            index = table.indexOf("r" + name, name.empty() ? "(no name)" : name);
        }
        result.ofResidue.push_back(index);
    }
    result.labels = std::move(table.labels_);
    return result;
}

}  // namespace nacre
