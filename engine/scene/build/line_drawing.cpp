#include "engine/scene/build/line_drawing.h"

#include "engine/error.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

constexpr std::uint32_t kNoLine = 0xffffffffu;

class LineDrawing {
public:
    LineDrawing(const Molecule& molecule, const Appearance& appearance, double width, AssemblyScene* assembly,
                Representation& result)
        : molecule_(molecule),
          lines_(appearance.lines),
          radius_(static_cast<float>(-width / 2)),
          assembly_(assembly),
          result_(result),
          slots_(molecule.atoms.size(), kNoLine),
          balls_(molecule.atoms.size()) {
        for (std::uint32_t i = 0; i < lines_.atoms.size(); ++i) slots_[lines_.atoms[i]] = i;
        for (const std::uint32_t atom : appearance.atoms) balls_[atom] = true;
    }

    void run() {
        std::vector<bool> bonded(molecule_.atoms.size());
        for (const Bond& bond : molecule_.bonds) {
            const bool a = slots_[bond.a] != kNoLine, b = slots_[bond.b] != kNoLine;
            if ((!a && !b) || !(a || balls_[bond.a]) || !(b || balls_[bond.b])) continue;
            bonded[bond.a] = bonded[bond.b] = true;
            const glm::dvec3 middle = (at(bond.a) + at(bond.b)) / 2.0;
            if (a && b)
                add(bond.a, at(bond.a), bond.b, at(bond.b));
            else
                add(a ? bond.a : bond.b, at(a ? bond.a : bond.b), a ? bond.a : bond.b, middle);
        }
        constexpr double kArm = 0.3;  // Å
        for (const std::uint32_t atom : lines_.atoms)
            for (int axis = 0; axis < 3 && !bonded[atom]; ++axis)
                for (const double way : {-kArm, kArm}) {
                    glm::dvec3 end = at(atom);
                    end[axis] += way;
                    add(atom, at(atom), atom, end);
                }
    }

private:
    glm::dvec3 at(std::uint32_t atom) const { return glm::dvec3(molecule_.atoms[atom].position) - result_.center; }

    /// @param from  of atom a @param to  of atom b
    void add(std::uint32_t a, const glm::dvec3& from, std::uint32_t b, const glm::dvec3& to) {
        if (!assembly_) return put(from, to, a, b, lineColor(a, 0), lineColor(b, 0));
        assembly_->eachCopy(a, b, result_.center, [&](const glm::dmat4x3& transform, std::uint32_t copy) {
            put(transform * glm::dvec4(from, 1.0), transform * glm::dvec4(to, 1.0), a, b, lineColor(a, copy),
                lineColor(b, copy));
        });
    }
    std::uint32_t lineColor(std::uint32_t atom, std::uint32_t copy) const {
        const std::uint32_t slot = slots_[atom], tint = lines_.tints[slot];
        return assembly_ && tint != 0 ? assembly_->tintColor(tint, copy) : lines_.colors[slot];
    }
    void put(const glm::dvec3& from, const glm::dvec3& to, std::uint32_t a, std::uint32_t b, std::uint32_t colorA,
             std::uint32_t colorB) {
        constexpr std::size_t kMostLines = 4'000'000;
        if (result_.wires.size() >= kMostLines)
            throw Error("cannot draw molecule", "",
                        "it has more than " + std::to_string(kMostLines) + " lines in all its copies");
        if (glm::vec3(from) == glm::vec3(to)) return;
        result_.wires.push_back({glm::vec3(from), radius_, glm::vec3(to), 0});
        result_.wireLooks.push_back({colorA, colorB, a + 1, b + 1});
    }

    const Molecule& molecule_;
    const MeshAtoms& lines_;
    float radius_;
    AssemblyScene* assembly_;
    Representation& result_;
    std::vector<std::uint32_t> slots_;  ///< index in lines_ by atom, or kNoLine
    std::vector<bool> balls_;           ///< atoms in other styles with balls or sticks
};

}  // namespace

void addLines(const Molecule& molecule, const Appearance& appearance, double width, AssemblyScene* assembly,
              Representation& result) {
    if (!appearance.lines.atoms.empty()) LineDrawing(molecule, appearance, width, assembly, result).run();
}

}  // namespace nacre
