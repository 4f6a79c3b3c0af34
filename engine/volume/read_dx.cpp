// OpenDX scalar fields on regular grids, from APBS and other Poisson-Boltzmann solvers. Å.
#include "engine/volume/map_grid.h"

namespace nacre {
namespace {

class DxReader {
public:
    DxReader(const std::string& name, std::string_view text, const MapLimits& limits)
        : name_(name), limits_(limits), lines_(text) {}

    DensityMap read() {
        while (lines_.next()) {
            const std::string_view line = trim(lines_.line());
            if (line.empty() || line.front() == '#') continue;
            const Words words = splitWords(line);
            if (words[0] == "object" && words[3] == "gridpositions")
                counts(words);
            else if (words[0] == "origin")
                origin_ = three(words, 1);
            else if (words[0] == "delta")
                delta(words);
            else if (words[0] == "object" && words[3] == "array")
                return values();
        }
        fail("it has no array of values");
    }

private:
    [[noreturn]] void fail(const std::string& why) const { cannotReadMap(name_, why, lines_.number()); }

    double number(std::string_view word) const {
        const auto value = parseNumber(word);
        if (!value) fail("expected a number instead of \"" + printable(word) + "\"");
        return *value;
    }
    glm::dvec3 three(const Words& words, std::size_t first) const {
        return {number(words[first]), number(words[first + 1]), number(words[first + 2])};
    }
    void counts(const Words& words) {
        for (int i = 0; i < 3; ++i) {
            const auto count = parseInteger(words[static_cast<std::size_t>(5 + i)]);
            if (!count || *count < 1 || *count > 1 << 24) fail("expected three numbers of nodes");
            size_[i] = static_cast<int>(*count);
        }
        checkedNodes(name_, size_, limits_);
    }
    void delta(const Words& words) {
        if (deltas_ == 3) fail("a fourth step of the grid");
        step_[deltas_++] = three(words, 1);
    }
    DensityMap values() {
        if (size_.x == 0 || deltas_ < 3) fail("an array of values before its grid");
        GridValues values(name_, size_, limits_, lines_.rest());
        values.read(lines_.number() + 1);
        return completed(name_, "dx", size_, origin_, step_, values.done());
    }

    const std::string& name_;
    MapLimits limits_;
    LineReader lines_;
    glm::ivec3 size_{};
    glm::dvec3 origin_{};
    glm::dmat3 step_{0};
    int deltas_ = 0;
};

}  // namespace

DensityMap readDx(const std::string& name, std::string_view text, const MapLimits& limits) {
    return DxReader(name, text, limits).read();
}

}  // namespace nacre
