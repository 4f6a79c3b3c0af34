// Gaussian cube files: densities, potentials and orbitals. Format: gaussian.com/cubegen.
#include <cmath>

#include "engine/volume/map_grid.h"

namespace nacre {
namespace {

constexpr double kBohr = 0.529177210903;  // Å, CODATA 2018
constexpr std::int64_t kMostAtoms = 1'000'000, kMostOrbitals = 10'000;

class CubeReader {
public:
    CubeReader(const std::string& name, std::string_view text, const MapLimits& limits)
        : name_(name), limits_(limits), lines_(text) {}

    DensityMap read() {
        for (int i = 0; i < 2; ++i) next();  // title lines
        const Words first = next();
        const std::int64_t atoms = integer(first[0]);
        glm::dvec3 origin = three(first);
        std::int64_t perNode = first.count > 4 ? integer(first[4]) : 1;
        glm::ivec3 size;
        glm::dmat3 step;
        double unit = kBohr;
        for (int i = 0; i < 3; ++i) {
            const Words words = next();
            const std::int64_t count = integer(words[0]);
            if (count < 0) unit = 1;  // Å
            if (count == 0 || std::abs(count) > 1 << 24) fail("a grid of " + std::to_string(count) + " nodes");
            size[i] = static_cast<int>(std::abs(count));
            step[i] = three(words);
        }
        if (std::abs(atoms) > kMostAtoms) fail("more than a million atoms");
        const std::uint64_t lineOfAtoms = lines_.number() + 1;
        for (std::int64_t i = 0; i < std::abs(atoms); ++i) next();
        if (atoms < 0) perNode = orbitals();
        if (perNode < 1 || perNode > kMostOrbitals) fail(std::to_string(perNode) + " values at each node");
        GridValues values(name_, size, limits_, lines_.rest(), static_cast<std::size_t>(perNode));
        values.read(lines_.number() + 1);
        DensityMap map = completed(name_, "cube", size, origin * unit, step * unit, values.done());
        // Orbitals and potentials have positive and negative values. Some programs do not mark orbitals.
        constexpr double kSecondSign = 0.1;  // of the larger extreme; densities fall below zero by less
        const double least = map.statistics.min, most = map.statistics.max;
        map.difference = map.difference || atoms < 0 || -least > kSecondSign * most;
        addNote(map.notes, ReadAction::leftOut, "atoms", "a map shows its values alone", std::abs(atoms), lineOfAtoms);
        addNote(map.notes, ReadAction::leftOut, "values", "beyond the first at each node",
                (perNode - 1) * static_cast<std::int64_t>(map.statistics.known));
        if (perNode > 1)
            map.warnings.push_back("the map has " + std::to_string(perNode) +
                                   " values at each node: the first is drawn");
        return map;
    }

private:
    [[noreturn]] void fail(const std::string& why) const { cannotReadMap(name_, why, lines_.number()); }
    Words next() {
        if (!lines_.next()) fail("it is cut short in its header");
        apart_ = numbersApart(lines_.line());
        return splitWords(apart_);
    }
    std::int64_t integer(std::string_view word) const {
        const auto value = parseInteger(word);
        if (!value) fail("expected a whole number instead of \"" + printable(word) + "\"");
        return *value;
    }
    glm::dvec3 three(const Words& words) const {
        glm::dvec3 result;
        for (int i = 0; i < 3; ++i) {
            const auto value = parseNumber(words[static_cast<std::size_t>(i + 1)]);
            if (!value) fail("expected three numbers");
            result[i] = *value;
        }
        return result;
    }
    /// The number of orbitals and their indices, which may take several lines.
    std::int64_t orbitals() {
        Words words = next();
        const std::int64_t count = integer(words[0]);
        auto found = static_cast<std::int64_t>(words.count) - 1;
        while (found < count && count <= kMostOrbitals) found += static_cast<std::int64_t>(next().count);
        return count;
    }

    const std::string& name_;
    MapLimits limits_;
    LineReader lines_;
    std::string apart_;  ///< the current line, with its numbers separated
};

}  // namespace

DensityMap readCube(const std::string& name, std::string_view text, const MapLimits& limits) {
    return CubeReader(name, text, limits).read();
}

}  // namespace nacre
