#include "tests/frame/choices.h"

#include <sstream>

namespace nacre::test {

std::string withoutMotion(const std::string& table) {
    std::istringstream lines(table);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("motion,")) kept += line + "\n";
    return kept;
}

const std::map<std::string, std::string>& statedChoices() {
    static const std::map<std::string, std::string> stated{};
    return stated;
}

}  // namespace nacre::test
