#pragma once
// Several molecules in one picture: their names, which stand for them in selections.

#include <string>
#include <vector>

#include "app/picture/description.h"
#include "engine/scene/appearance.h"

namespace nacre::app {

constexpr std::size_t kMostInputs = 100;

/// "NAME=INPUT", or INPUT, whose name is then that of the file: "receptor=a.pdb", "1crn.cif.gz" is named 1crn.
/// A name has letters, digits, - and _. Adds it to what is read. @throws std::invalid_argument
void addInput(InputOptions& input, const std::string& text);

/// Of the INPUTs, in their order; each differs from those before it.
std::vector<std::string> inputNames(const InputOptions& input);

/// Letters, digits, - and _.
bool isInputName(const std::string& text);

/// `/ligand`, which the grammar takes for a chain, means the INPUT of that name. INPUTs are told apart as models.
void nameInputs(const std::vector<std::string>& names, Selection& selection);
/// The same in all selections of a description that has several.
void nameInputs(PictureDescription& description);

/// Where nothing else is asked for, each INPUT but the first has carbons of a colour of its own.
/// @param from  the first to be coloured, counted from 0
void colorApart(const std::vector<std::string>& names, RepresentationOptions& look, std::size_t from = 1);

}  // namespace nacre::app
