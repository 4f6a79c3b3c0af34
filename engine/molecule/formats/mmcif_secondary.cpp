#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/secondary_structure.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

/// One end of a range in the columns that both categories share; empty if it has no number.
struct End {
    std::string chain;
    std::int32_t number = 0;
    char code = '\0';
};

std::optional<End> readEnd(const MmcifTable& table, std::size_t row, bool first) {
    const auto text = [&](const char* beginName, const char* endName) {
        return table.get(row, {first ? beginName : endName});
    };
    const auto either = [](std::optional<std::string_view> a, std::optional<std::string_view> b) { return a ? a : b; };
    const auto number = parseInteger(
        either(text("beg_auth_seq_id", "end_auth_seq_id"), text("beg_label_seq_id", "end_label_seq_id")).value_or(""));
    if (!number || *number < INT32_MIN || *number > INT32_MAX) return std::nullopt;
    End end;
    end.number = static_cast<std::int32_t>(*number);
    end.chain =
        std::string(either(text("beg_auth_asym_id", "end_auth_asym_id"), text("beg_label_asym_id", "end_label_asym_id"))
                        .value_or(""));
    const auto code = text("pdbx_beg_pdb_ins_code", "pdbx_end_pdb_ins_code");
    if (code && !code->empty() && code->front() != ' ') end.code = code->front();
    return end;
}

/// Predicted models also list strands in struct_conf; turns and bends are not drawn.
SecondaryStructure parseKind(std::string_view type) {
    const std::string lower = lowerCase(type);
    if (startsWith(lower, "helx")) return SecondaryStructure::helix;
    return startsWith(lower, "strn") ? SecondaryStructure::strand : SecondaryStructure::none;
}

}  // namespace

void addSecondaryStructure(MoleculeBuilder& builder, const MmcifTable& conformations, const MmcifTable& strands) {
    std::vector<SecondaryRange> ranges;
    const auto add = [&](const MmcifTable& table, std::size_t row, SecondaryStructure kind) {
        const auto first = readEnd(table, row, true), last = readEnd(table, row, false);
        if (kind == SecondaryStructure::none || !first || !last || first->chain != last->chain) return;
        ranges.push_back(
            {kind, first->chain, first->number, last->number, first->code, last->code, table.lineNumber(row)});
    };
    for (std::size_t row = 0; row < conformations.rows(); ++row)
        add(conformations, row, parseKind(conformations.get(row, {"conf_type_id"}).value_or("")));
    for (std::size_t row = 0; row < strands.rows(); ++row) add(strands, row, SecondaryStructure::strand);
    applySecondaryStructure(builder.molecule(), ranges);
}

}  // namespace nacre
