// B-DNA, d(CGCGAATTCGCG)2, from the fibre model.

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>
#include <string_view>

#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/samples/samples.h"

namespace nacre {
namespace {

/// Cylindrical coordinates about the helix axis: Å, degrees, Å.
struct TableAtom {
    std::string_view name;
    std::string_view element;
    double radius;
    double angle;
    double height;
};

// S. Arnott, D. W. L. Hukins, Optimised parameters for A-DNA and B-DNA, Biochem. Biophys. Res. Commun. 47 (1972)
// 1504-1509. One nucleotide of one strand; the dyad between the strands lies along angle 0 at height 0.
constexpr TableAtom kPhosphate[] = {
    {"P", "P", 8.91, 95.2, 2.08},
    {"OP1", "O", 10.20, 91.1, 1.86},
    {"OP2", "O", 8.82, 103.3, 1.29},
};
// The source lists O3' as O1 of the next phosphate group; addNucleotide() moves it.
constexpr TableAtom kSugar[] = {
    {"O5'", "O", 7.73, 88.0, 1.83},  {"C5'", "C", 7.70, 79.8, 2.77}, {"C4'", "C", 7.59, 69.9, 2.04},
    {"O4'", "O", 6.22, 66.0, 1.83},  {"C3'", "C", 8.20, 69.9, 0.64}, {"O3'", "O", 8.75, 97.4, 3.63},
    {"C2'", "C", 7.04, 73.2, -0.24}, {"C1'", "C", 5.86, 67.4, 0.47},
};
constexpr TableAtom kAdenine[] = {
    {"N9", "N", 4.63, 76.6, 0.42}, {"C8", "C", 4.84, 93.0, 0.50},  {"N7", "N", 3.95, 105.4, 0.43},
    {"C5", "C", 2.74, 94.0, 0.28}, {"C6", "C", 1.41, 107.2, 0.15}, {"N6", "N", 1.83, 154.0, 0.14},
    {"N1", "N", 0.86, 40.1, 0.03}, {"C2", "C", 2.17, 30.6, 0.04},  {"N3", "N", 3.24, 47.0, 0.16},
    {"C4", "C", 3.33, 70.5, 0.28},
};
constexpr TableAtom kCytosine[] = {
    {"N1", "N", 4.63, 76.6, 0.42},  {"C2", "C", 3.40, 67.4, 0.27},  {"O2", "O", 3.69, 47.9, 0.18},
    {"N3", "N", 2.31, 83.9, 0.22},  {"C4", "C", 2.94, 110.0, 0.32}, {"N4", "N", 2.76, 136.6, 0.27},
    {"C5", "C", 4.35, 107.0, 0.47}, {"C6", "C", 4.99, 92.2, 0.52},
};
constexpr TableAtom kGuanine[] = {
    {"N9", "N", 4.63, 76.6, 0.42}, {"C8", "C", 4.82, 93.2, 0.50},  {"N7", "N", 3.92, 105.7, 0.42},
    {"C5", "C", 2.70, 94.0, 0.28}, {"C6", "C", 1.39, 109.3, 0.15}, {"O6", "O", 1.71, 154.6, 0.13},
    {"N1", "N", 0.92, 37.9, 0.03}, {"C2", "C", 2.28, 28.7, 0.03},  {"N2", "N", 3.01, 4.2, -0.10},
    {"N3", "N", 3.29, 46.7, 0.16}, {"C4", "C", 3.33, 70.3, 0.28},
};
constexpr TableAtom kThymine[] = {
    {"N1", "N", 4.63, 76.6, 0.42},  {"C2", "C", 3.42, 67.3, 0.27},  {"O2", "O", 3.64, 47.8, 0.18},
    {"N3", "N", 2.36, 85.2, 0.23},  {"C4", "C", 2.98, 111.9, 0.32}, {"O4", "O", 2.82, 136.3, 0.27},
    {"C5", "C", 4.38, 106.9, 0.47}, {"C7", "C", 5.40, 119.8, 0.58}, {"C6", "C", 5.01, 92.3, 0.52},
};
constexpr double kTwist = 36.0;  // degrees from one base pair to the next
constexpr double kRise = 3.38;   // Å
constexpr std::string_view kSequence = "CGCGAATTCGCG";

struct Base {
    std::string_view residue;
    std::span<const TableAtom> atoms;
};

Base findBase(char letter) {
    switch (letter) {
        case 'A':
            return {"DA", kAdenine};
        case 'C':
            return {"DC", kCytosine};
        case 'G':
            return {"DG", kGuanine};
        default:
            return {"DT", kThymine};
    }
}

/// Frame of a nucleotide: `step` base pairs up the axis, on the table's strand or its dyad mate.
struct Frame {
    double step;
    bool opposite;
};

/// The helix axis becomes y, upright in the unrotated view.
glm::dvec3 place(const TableAtom& atom, const Frame& frame, double extraSteps = 0) {
    const double step = frame.step + extraSteps;
    const double sign = frame.opposite ? -1 : 1;
    const double angle = sign * (atom.angle + kTwist * step) * std::numbers::pi / 180;
    const double height = sign * (atom.height + kRise * step);
    return {atom.radius * std::sin(angle), height, atom.radius * std::cos(angle)};
}

void addNucleotide(SampleBuilder& builder, const Base& base, std::int32_t number, const Frame& frame, bool phosphate) {
    builder.residue(base.residue, number, false);
    if (phosphate)
        for (const TableAtom& atom : kPhosphate) builder.atom(atom.name, atom.element, place(atom, frame));
    for (const TableAtom& atom : kSugar) {
        // The table's O3' belongs to the phosphate in the table, so to the neighbour one step up.
        const double extraSteps = atom.name == "O3'" ? -1 : 0;
        builder.atom(atom.name, atom.element, place(atom, frame, extraSteps));
    }
    for (const TableAtom& atom : base.atoms) builder.atom(atom.name, atom.element, place(atom, frame));
}

}  // namespace

Molecule sampleDna() {
    SampleBuilder builder("B-DNA dodecamer CGCGAATTCGCG, fibre model of Arnott and Hukins (1972)");
    const int length = static_cast<int>(kSequence.size());
    // The sequence is its own complement, so both strands have it; each runs 5' to 3' against its own axis. Steps
    // counted from the middle put the dyad of the whole duplex on the table's dyad.
    for (const bool opposite : {false, true}) {
        builder.chain(opposite ? "B" : "A");
        for (int i = 0; i < length; ++i) {
            const Frame frame{0.5 * (length - 1) - i, opposite};
            const std::int32_t number = i + 1 + (opposite ? length : 0);
            addNucleotide(builder, findBase(kSequence[static_cast<std::size_t>(i)]), number, frame, i > 0);
        }
    }
    Molecule molecule = builder.finish();
    perceiveBonds(molecule);
    return molecule;
}

}  // namespace nacre
