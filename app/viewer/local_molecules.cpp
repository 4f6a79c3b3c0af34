#include "app/viewer/local_molecules.h"

#include "app/input/read_input.h"

namespace nacre::app {

Sources localMolecules(std::function<std::string(const std::string&)> readFile) {
    return {[readFile = std::move(readFile)](const PictureDescription& view) {
        return readLocally(inputOf(view), memoryShare(4), readFile);
    }};
}

}  // namespace nacre::app
