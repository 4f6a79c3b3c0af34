#include "engine/molecule/formats/pdb_assemblies.h"

#include <optional>
#include <utility>

#include "engine/molecule/text.h"

namespace nacre::pdb {

namespace {

/// The text after a phrase in a line, if it has the phrase.
std::optional<std::string_view> after(std::string_view line, std::string_view phrase) {
    const std::size_t at = line.find(phrase);
    if (at == std::string_view::npos) return std::nullopt;
    return trim(line.substr(at + phrase.size()));
}

}  // namespace

void Remark350::add(std::string_view line) {
    if (startsWith(line, "REMARK 350   BIOMT")) {
        addRow(line);
    } else if (const auto id = after(line, "BIOMOLECULE:")) {
        begin(*id);
    } else if (const auto chains = after(line, "APPLY THE FOLLOWING TO CHAINS:")) {
        if (biomolecules_.empty()) begin("1");
        biomolecules_.back().parts.emplace_back();
        addChains(*chains);
    } else if (const auto more = after(line, "AND CHAINS:")) {
        addChains(*more);
    } else if (const auto unit = after(line, "BIOLOGICAL UNIT:"); unit && !biomolecules_.empty()) {
        biomolecules_.back().details = printable(*unit);
    }
}

void Remark350::begin(std::string_view id) {
    if (biomolecules_.size() == AssemblyLimits::kMaxAssemblies) {
        ++leftOut_;
        return;
    }
    biomolecules_.emplace_back();
    biomolecules_.back().id = printable(id);
}

Remark350::Part& Remark350::part() {
    if (biomolecules_.empty()) begin("1");
    auto& parts = biomolecules_.back().parts;
    if (parts.empty()) parts.emplace_back();
    return parts.back();
}

void Remark350::addChains(std::string_view list) {
    while (!list.empty()) {
        const std::size_t comma = list.find(',');
        const std::string_view chain = trim(list.substr(0, comma));
        if (!chain.empty() && chain != "NULL") {
            try {
                limits_.spend(0, 1);
            } catch (const AssemblyFault& fault) {
                biomolecules_.back().fault = fault.what();
                return;
            }
            part().named = true;
            if (chain.size() == 1) part().chains += chain;  // chains of these files have one character
        }
        list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
    }
}

/// "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000": the row is named in column 19, the
/// transform in 20 to 23, and the numbers follow.
void Remark350::addRow(std::string_view line) {
    const char row = line.size() > 18 ? line[18] : ' ';
    if (row == '1') ++operators_;
    if (row < '1' || row > '3') return;
    if (leftOut_ > 0) return;
    Part& to = part();
    std::string& fault = biomolecules_.back().fault;
    const int index = row - '1';
    const Words words = splitWords(columns(line, 23, std::string_view::npos));
    if (index != row_ % 3) fault = "its BIOMT rows are out of order";
    row_ = index + 1;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto number = parseNumber(words[i]);
        if (!number) fault = "a BIOMT row has not four numbers";
        rows_[static_cast<std::size_t>(4 * index) + i] = number.value_or(0);
    }
    if (row != '3' || !fault.empty()) return;
    try {
        limits_.spend(1, 0);
        if (to.transforms.empty()) to.first = static_cast<std::uint32_t>(operators_);
        to.transforms.push_back(toMatrix(rows_));
    } catch (const AssemblyFault& found) {
        fault = found.what();
    }
}

void Remark350::resolve(Molecule& molecule) {
    for (Biomolecule& given : biomolecules_) {
        Assembly assembly{given.id, given.details, {}};
        try {
            for (Part& part : given.parts) {
                AssemblyPart copies{std::move(part.transforms), {}};
                for (std::size_t i = 0; i < copies.transforms.size(); ++i)
                    copies.operators.push_back(std::to_string(part.first + i));
                const auto count = static_cast<std::uint32_t>(molecule.subchains.size());
                limits_.spend(0, count);
                for (std::uint32_t i = 0; i < count; ++i)
                    if (!part.named || (molecule.subchains[i].size() == 1 &&
                                        part.chains.find(molecule.subchains[i]) != std::string::npos))
                        copies.subchains.push_back(i);
                addPart(assembly, std::move(copies));
            }
            if (!given.fault.empty()) throw AssemblyFault(given.fault);
            if (assembly.parts.empty()) throw AssemblyFault("it places no chain that is here");
            molecule.assemblies.push_back(std::move(assembly));
        } catch (const AssemblyFault& fault) {
            molecule.warnings.push_back(leftOutWarning(given.id, fault.what()));
        }
    }
    if (leftOut_ > 0) molecule.warnings.push_back("assemblies left out: " + std::to_string(leftOut_));
}

}  // namespace nacre::pdb
