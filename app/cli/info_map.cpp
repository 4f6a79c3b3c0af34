#include "app/cli/info_map.h"

#include <iomanip>
#include <sstream>

#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

using MapJson = nlohmann::ordered_json;

/// Nine digits: all that a float holds.
double rounded(double value) {
    std::ostringstream text;
    text << std::setprecision(9) << value;
    return std::stod(text.str());
}
MapJson wholes(const glm::ivec3& v) { return {v.x, v.y, v.z}; }

std::string joined(const MapJson& list, const char* between) {
    std::string text;
    for (const MapJson& entry : list) text += (text.empty() ? "" : between) + entry.dump();
    return text;
}

}  // namespace

MapJson mapInfoJson(const DensityMap& map) {
    const glm::dvec3 first = map.place(glm::dvec3(map.firstNode()));
    const glm::dvec3 &l = map.cell.lengths, &a = map.cell.angles;
    MapJson json;
    json["format"] = map.format;
    json["map"] = {{"grid", wholes(map.size)},
                   {"cell", {rounded(l.x), rounded(l.y), rounded(l.z), rounded(a.x), rounded(a.y), rounded(a.z)}},
                   {"origin", {rounded(first.x), rounded(first.y), rounded(first.z)}},
                   {"axes", map.axes},
                   {"space_group", map.spaceGroup},
                   {"crystal", map.periodic},
                   {"box", {{"size", wholes(map.boxSize)}, {"start", wholes(map.boxStart)}}},
                   {"min", rounded(map.statistics.min)},
                   {"max", rounded(map.statistics.max)},
                   {"mean", rounded(map.statistics.mean)},
                   {"rms", rounded(map.statistics.rms)}};
    json["warnings"] = map.warnings;
    return json;
}

std::string mapInfoText(const std::string& name, const MapJson& json) {
    const MapJson& map = json["map"];
    std::ostringstream out;
    const auto line = [&](const char* label, const std::string& text) {
        out << "  " << std::left << std::setw(12) << label << text << '\n';
    };
    const auto number = [](const MapJson& value) {
        std::ostringstream text;
        text << std::setprecision(5) << value.get<double>();
        return text.str();
    };
    out << printable(name) << " (density map, " << json["format"].get<std::string>() << ")\n";
    line("grid", joined(map["grid"], " x ") + (map["crystal"].get<bool>() ? " nodes in the unit cell" : " nodes"));
    line("cell", joined(map["cell"], ", "));
    if (map["space_group"].get<int>() > 0) line("space group", map["space_group"].dump());
    line("origin", joined(map["origin"], ", ") + " Å");
    line("values", number(map["min"]) + " to " + number(map["max"]) + ", mean " + number(map["mean"]) + ", sigma " +
                       number(map["rms"]));
    for (const MapJson& warning : json["warnings"]) line("warning", warning.get<std::string>());
    return out.str();
}

}  // namespace nacre::app
