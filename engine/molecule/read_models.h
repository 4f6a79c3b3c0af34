#pragma once
// The models of a file's content: one, or one after the other.

#include <cstddef>
#include <string>

#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

constexpr std::size_t kMaxMessage = 600;  ///< bytes of text from a file that leave a reader

/// A file's content as readers want it: inflated, text as UTF-8 with '\n' for every end of line.
struct FileContent {
    std::string bytes;
    Format format;
};

/// The model that the options name, with all its bonds; with the places of the others, if they ask for those.
/// @throws Error
Molecule readModel(const std::string& name, const FileContent& content, const ReadOptions& options);

/// All of them as one molecule. @throws Error
Molecule readAllModels(const std::string& name, const FileContent& content, const ReadOptions& options);

}  // namespace nacre
