#pragma once
// An mmCIF file of many models, cut so that each can be read alone. Must also compile as C++17.

#include <string_view>
#include <vector>

namespace nacre {

/// The text is `before`, then the rows of each model, then `after`; or there are no models and it is not cut.
struct MmcifModelTexts {
    std::string_view before, after;
    std::vector<std::string_view> models;
};

/// Cuts where _atom_site is written as databases do: one loop, one line a row, model after model. Looks at no other
/// syntax, so that whoever reads a part has to check that it holds one model.
/// One written otherwise is not cut.
MmcifModelTexts mmcifModelTexts(std::string_view text);

}  // namespace nacre
