#pragma once
// The models of a file's content: one, or all over each other.

#include <optional>
#include <string>

#include "engine/molecule/formats/content.h"
#include "engine/molecule/molecule.h"

namespace nacre {

/// The model that the options name, with all its bonds; with the places of the others, if they ask for those.
/// @throws Error
Molecule readModel(const std::string& name, const FileContent& content, const ReadOptions& options);

/// All of them as one molecule. @throws Error
Molecule readAllModels(const std::string& name, const FileContent& content, const ReadOptions& options);

/// readModel() of a text that is read model by model and never held whole. Nothing if that cannot be, or if there is
/// something to say that wants the whole text.
std::optional<Molecule> readModelAlone(const std::string& name, TextContent content, const ReadOptions& options);

}  // namespace nacre
