#include <cmath>

#include "engine/molecule/assemblies.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

TransformsById readOperators(const MmcifTable& table) {
    static constexpr const char* kColumns[12] = {"matrix[1][1]", "matrix[1][2]", "matrix[1][3]", "vector[1]",
                                                 "matrix[2][1]", "matrix[2][2]", "matrix[2][3]", "vector[2]",
                                                 "matrix[3][1]", "matrix[3][2]", "matrix[3][3]", "vector[3]"};
    TransformsById operators;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto id = table.get(row, {"id"});
        if (!id) continue;
        TransformRows rows{};
        for (std::size_t i = 0; i < rows.size(); ++i)  // invalid numbers show when the operator is used
            rows[i] = parseNumber(table.get(row, {kColumns[i]}).value_or("")).value_or(HUGE_VAL);
        operators.emplace(std::string(*id), rows);
    }
    return operators;
}

/// @param model  whose chains are listed, in a packed scene
std::vector<std::uint32_t> findSubchains(std::string_view list, std::optional<std::string_view> model,
                                         const MoleculeBuilder& builder, AssemblyLimits& limits) {
    std::vector<std::uint32_t> subchains;
    for (;;) {
        const std::size_t comma = list.find(',');
        limits.spend(0, 1);
        // Subchains without atoms in this model cannot be drawn.
        const std::string_view chain = trim(list.substr(0, comma));
        const auto index = model ? builder.subchain(packedChainName(*model, chain)) : builder.subchain(chain);
        if (index) subchains.push_back(*index);
        if (comma == std::string_view::npos) return subchains;
        list.remove_prefix(comma + 1);
    }
}

}  // namespace

void addMmcifAssemblies(MoleculeBuilder& builder, const MmcifTable& assemblies, const MmcifTable& generators,
                        const MmcifTable& operators, MmcifAtoms::Models models) {
    std::vector<Assembly> found;
    std::map<std::string, std::size_t, std::less<>> byId;
    std::map<std::string, std::string, std::less<>> faults;
    // Files of packed cells list how to generate assemblies, but not the assemblies.
    const bool listed = assemblies.rows() > 0;
    const MmcifTable& ids = listed ? assemblies : generators;
    for (std::size_t row = 0; row < ids.rows(); ++row) {
        const std::string id(ids.get(row, {listed ? "id" : "assembly_id"}).value_or(""));
        if (found.size() == AssemblyLimits::kMaxAssemblies) {
            builder.warn("more than " + std::to_string(AssemblyLimits::kMaxAssemblies) +
                         " assemblies; the rest is left out");
            break;
        }
        if (!byId.emplace(id, found.size()).second) continue;
        found.push_back({id, listed ? std::string(ids.get(row, {"details"}).value_or("")) : std::string(), {}});
    }

    const bool packed = models == MmcifAtoms::Models::packed;
    const TransformsById transforms = readOperators(operators);
    AssemblyLimits limits(builder.maxAtoms());
    for (std::size_t row = 0; row < generators.rows(); ++row) {
        const auto assembly = byId.find(generators.get(row, {"assembly_id"}).value_or(""));
        if (assembly == byId.end()) continue;
        try {
            AssemblyPart part =
                expandOperators(generators.get(row, {"oper_expression"}).value_or(""), transforms, limits);
            part.subchains =
                findSubchains(generators.get(row, {"asym_id_list"}).value_or(""),
                              packed ? generators.get(row, {"pdb_model_num"}) : std::nullopt, builder, limits);
            addPart(found[assembly->second], std::move(part));
        } catch (const AssemblyFault& fault) {
            faults.emplace(assembly->first, fault.what());
        }
    }

    for (Assembly& assembly : found) {
        const auto fault = faults.find(assembly.id);
        if (fault == faults.end() && !assembly.parts.empty())
            builder.molecule().assemblies.push_back(std::move(assembly));
        else
            builder.warn(leftOutWarning(assembly.id, fault == faults.end()
                                                         ? "the file does not say how to place any of its chains"
                                                         : fault->second));
    }
}

}  // namespace nacre
