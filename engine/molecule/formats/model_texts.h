#pragma once
// A text of many models, cut so that each can be read alone.

#include <string_view>
#include <vector>

#include "engine/molecule/read.h"

namespace nacre {

/// `before`, one of the models, and `after` are a text of that model alone. No models: the text is not cut.
struct ModelTexts {
    std::string_view before, after;
    std::vector<std::string_view> models;
};

/// Cuts what is written as programs write it: MODEL and ENDMDL, or END between whole frames (PDB, PDBQT, PQR), records
/// (SDF, MOL2), frames (XYZ, GRO). Looks at no other syntax, so that whoever reads a part has to check that it holds
/// one model, and that there are as many as a reader finds.
ModelTexts modelTexts(Format format, std::string_view text);

}  // namespace nacre
