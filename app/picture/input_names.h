#pragma once
// Names of several molecules in one picture, for selections.

#include <functional>
#include <string>
#include <vector>

#include "app/picture/description.h"
#include "engine/scene/build/appearance.h"

namespace nacre::app {

constexpr std::size_t kMostInputs = 100;

/// "NAME=INPUT", or INPUT, named after its file: "receptor=a.pdb", "1crn.cif.gz" is named 1crn. A name has letters,
/// digits, - and _. Adds it to the inputs. @throws std::invalid_argument
void addInput(InputOptions& input, const std::string& text);

/// Unique names of the INPUTs, in order.
std::vector<std::string> inputNames(const InputOptions& input);

/// Letters, digits, - and _.
bool isInputName(const std::string& text);

/// Turns `/ligand`, which parses as a chain, into the INPUT of that name. INPUTs are distinguished as models.
void nameInputs(const std::vector<std::string>& names, Selection& selection);
/// As above for all selections of a description with several inputs.
void nameInputs(PictureDescription& description);

/// Removes one of several inputs, with the rules, labels and fits that name it. @param number  from 0
void removeInput(PictureDescription& description, std::size_t number);
/// Makes the further inputs conformations of the first, without rules, labels and fits that name an input; or
/// molecules, each with its own colour.
void setConformations(PictureDescription& description, bool conformations);
/// Renames an input, also in all selections. @param number  from 0 @throws std::invalid_argument
void renameInput(PictureDescription& description, std::size_t number, const std::string& name);

/// By default, gives the carbons of each INPUT but the first a different colour.
/// @param from  the first to be coloured, counted from 0
void colorApart(const std::vector<std::string>& names, RepresentationOptions& look, std::size_t from = 1);

}  // namespace nacre::app
