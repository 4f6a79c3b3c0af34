#include "app/viewer/advice.h"

#include <initializer_list>
#include <utility>

namespace nacre::app {

std::string adviceFor(const std::string& error) {
    const auto says = [&](std::initializer_list<const char*> words) {
        for (const char* word : words)
            if (error.find(word) != std::string::npos) return true;
        return false;
    };
    if (says({"resolve", "connect", "timed out", "timeout", "network", "certificate"}))
        return "Check that this computer is online, then open it once more.";
    if (says({"no such file", "No such file", "does not exist"}))
        return "Check the name, or whether the file was moved or renamed.";
    if (says({"not found", "404", "no such entry"}))
        return "Check the identifier: a PDB entry has four signs, as 1BNA.";
    if (says({"ermission"})) return "Ask whoever owns the file or folder, or choose another one.";
    if (says({"memory"})) return "Close other programs, or show less of the molecule.";
    if (says({"cannot read molecule", "cannot read"}))
        return "The file may be damaged, or no structure: PDB, mmCIF, BinaryCIF, SDF, MOL2, XYZ and others are read.";
    return "What was there before is unchanged.";
}

}  // namespace nacre::app
