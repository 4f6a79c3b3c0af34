#include "engine/mesh/cartoon_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

namespace nacre {
namespace {

constexpr double kLongestChainBond = 2.5;     // Å: C-N and O3'-P
constexpr double kFarthestAlphaCarbon = 5;    // Å, in models of alpha carbons only; trans 3.8, cis 2.9
constexpr double kFarthestPhosphate = 8.5;    // Å, in models of phosphates only; 5.5 to 7.5
constexpr double kFarthestBondedGuides = 12;  // Å, even if the bond is short: a guide beyond is misplaced
constexpr double kNearestGuides = 0.5;        // Å; coinciding residues have no direction

enum GuideName {
    kGuideN,
    kGuideCa,
    kGuideC,
    kGuideO,
    kGuideP,
    kGuideO5,
    kGuideC5,
    kGuideC4,
    kGuideC3,
    kGuideO3,
    kGuideNames
};
constexpr std::array<std::string_view, kGuideNames> kGuideAtoms{"N",   "CA",  "C",   "O",   "P",
                                                                "O5'", "C5'", "C4'", "C3'", "O3'"};

/// A residue of a polymer with the atoms that a cartoon needs.
struct Guided {
    std::uint32_t residue = 0;
    bool nucleic = false;
    std::array<std::uint32_t, kGuideNames> atoms{};
    std::uint32_t guide = kNoAtom;
    /// The atom that gives colour and number: preferably a carbon. With phosphorus, colours by element would differ
    /// between strands and ends without it.
    std::uint32_t shows() const {
        if (!nucleic) return guide;
        for (const GuideName name : {kGuideC4, kGuideC3, kGuideC5})
            if (atoms[name] != kNoAtom) return atoms[name];
        return guide;
    }
};

bool isFinite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

int guideNameOf(const Name& name) {
    Name plain = name;
    std::replace(plain.bytes.begin(), plain.bytes.end(), '*', '\'');  // files before 2007 write O5*
    const auto found = std::find(kGuideAtoms.begin(), kGuideAtoms.end(), plain.view());
    return static_cast<int>(found - kGuideAtoms.begin());
}

/// Residues with a guide atom, in the file's order.
std::vector<Guided> guidedResidues(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    const std::vector<std::uint32_t>& first = facts.positions();
    const std::vector<ResidueKind>& kinds = facts.kinds();
    std::vector<Guided> guided(molecule.residues.size());
    for (std::uint32_t r = 0; r < guided.size(); ++r) {
        guided[r].residue = r;
        guided[r].atoms.fill(kNoAtom);
    }
    for (const std::uint32_t index : facts.conformer()) {
        const Atom& atom = molecule.atoms[index];
        const ResidueKind kind = kinds[atom.residue];
        if ((kind != ResidueKind::protein && kind != ResidueKind::nucleic) || !isFinite(atom.position)) continue;
        // In coarse grains the backbone bead, or a residue's only bead, stands for the alpha carbon.
        const bool grain = kind == ResidueKind::protein && atom.radius > 0 &&
                           (atom.name.view() == "BB" || molecule.residues[atom.residue].atomCount == 1);
        const int name = grain ? static_cast<int>(kGuideCa) : guideNameOf(atom.name);
        if (name == kGuideNames) continue;
        Guided& residue = guided[first[atom.residue]];
        residue.nucleic = kind == ResidueKind::nucleic;
        std::uint32_t& place = residue.atoms[static_cast<std::size_t>(name)];
        if (place == kNoAtom) place = index;
    }
    for (Guided& residue : guided) {
        if (!residue.nucleic) residue.guide = residue.atoms[kGuideCa];
        for (int name = kGuideP; residue.nucleic && residue.guide == kNoAtom && name <= kGuideC3; ++name)
            residue.guide = residue.atoms[static_cast<std::size_t>(name)];
    }
    std::erase_if(guided, [](const Guided& residue) { return residue.guide == kNoAtom; });
    return guided;
}

class ChainLinks {
public:
    explicit ChainLinks(const Molecule& molecule) : molecule_(molecule) {}

    /// Whether two residues are connected.
    bool joined(const Guided& a, const Guided& b) const {
        if (a.nucleic != b.nucleic || molecule_.residues[a.residue].chain != molecule_.residues[b.residue].chain)
            return false;
        const double guides = distance(a.guide, b.guide);
        const std::uint32_t end = a.atoms[a.nucleic ? kGuideO3 : kGuideC],
                            begin = b.atoms[a.nucleic ? kGuideP : kGuideN];
        if (guides < kNearestGuides) return false;
        if (end != kNoAtom && begin != kNoAtom)
            return distance(end, begin) <= kLongestChainBond && guides <= kFarthestBondedGuides;
        return guides <= (a.nucleic ? kFarthestPhosphate : kFarthestAlphaCarbon);
    }

private:
    double distance(std::uint32_t a, std::uint32_t b) const {
        return glm::distance(glm::dvec3(molecule_.atoms[a].position), glm::dvec3(molecule_.atoms[b].position));
    }

    const Molecule& molecule_;
};

/// Turns runs around that the file has from their ends to their beginnings.
std::vector<Guided> inChainOrder(std::vector<Guided> guided, const ChainLinks& links) {
    const auto backward = [&](std::size_t i) {
        return i + 1 < guided.size() && links.joined(guided[i + 1], guided[i]) &&
               !links.joined(guided[i], guided[i + 1]);
    };
    for (std::size_t first = 0, last = 0; first < guided.size(); first = ++last) {
        while (backward(last)) ++last;
        std::reverse(guided.begin() + static_cast<std::ptrdiff_t>(first),
                     guided.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    }
    return guided;
}

/// From C to O; 0 if one is missing.
glm::dvec3 carbonylOf(const Molecule& molecule, const Guided& residue) {
    const std::uint32_t c = residue.atoms[kGuideC], o = residue.atoms[kGuideO];
    if (c == kNoAtom || o == kNoAtom) return {};
    return glm::dvec3(molecule.atoms[o].position) - glm::dvec3(molecule.atoms[c].position);
}

/// A point after the last phosphate, so that the last nucleotide has a piece of the curve. A lone amino acid runs from
/// its N to its C.
void addEnds(const Molecule& molecule, const Guided& last, Trace& trace) {
    const auto place = [&](GuideName name) { return glm::dvec3(molecule.atoms[last.atoms[name]].position); };
    if (trace.nucleic) {
        for (const GuideName name : {kGuideO3, kGuideC3, kGuideC4}) {
            if (last.atoms[name] == kNoAtom || glm::distance(place(name), trace.points.back()) < kNearestGuides)
                continue;
            trace.points.push_back(place(name));
            trace.shift = 0;
            return;
        }
    } else if (trace.points.size() == 1 && last.atoms[kGuideN] != kNoAtom && last.atoms[kGuideC] != kNoAtom) {
        const glm::dvec3 middle = trace.points[0];
        if (glm::distance(place(kGuideN), middle) < kNearestGuides ||
            glm::distance(place(kGuideC), middle) < kNearestGuides)
            return;
        trace.points = {place(kGuideN), middle, place(kGuideC)};
        trace.shift = 0;  // a single residue owns all of the curve
    }
}

}  // namespace

std::vector<Trace> cartoonTraces(const ResidueFacts& facts, std::span<const std::uint32_t> atoms,
                                 std::span<const SecondaryStructure> secondary) {
    const Molecule& molecule = facts.molecule();
    std::vector<bool> chosen(molecule.atoms.size());
    for (const std::uint32_t atom : atoms) chosen[atom] = true;
    const ChainLinks links(molecule);
    const std::vector<Guided> guided = inChainOrder(guidedResidues(facts), links);
    std::vector<Trace> traces;
    for (std::size_t i = 0; i < guided.size(); ++i) {
        const Guided& residue = guided[i];
        if (i == 0 || !links.joined(guided[i - 1], residue)) {
            if (i > 0) addEnds(molecule, guided[i - 1], traces.back());
            traces.emplace_back().nucleic = residue.nucleic;
        }
        Trace& trace = traces.back();
        const Atom& guide = molecule.atoms[residue.guide];
        trace.points.emplace_back(guide.position);
        trace.atoms.push_back(residue.shows());
        trace.residues.push_back(residue.residue);
        trace.kinds.push_back(residue.nucleic || residue.residue >= secondary.size() ? SecondaryStructure::none
                                                                                     : secondary[residue.residue]);
        trace.shown.push_back(chosen[residue.guide]);
        trace.temperatures.push_back(std::isfinite(guide.temperatureFactor) ? guide.temperatureFactor : 0.0);
        trace.carbonyls.push_back(residue.nucleic ? glm::dvec3() : carbonylOf(molecule, residue));
    }
    if (!guided.empty()) addEnds(molecule, guided.back(), traces.back());
    std::erase_if(traces, [](const Trace& trace) {
        return std::none_of(trace.shown.begin(), trace.shown.end(), [](bool shown) { return shown; });
    });
    return traces;
}

std::vector<std::vector<std::uint32_t>> guideTraces(const ResidueFacts& facts) {
    const ChainLinks links(facts.molecule());
    const std::vector<Guided> guided = inChainOrder(guidedResidues(facts), links);
    std::vector<std::vector<std::uint32_t>> traces;
    for (std::size_t i = 0; i < guided.size(); ++i) {
        if (i == 0 || !links.joined(guided[i - 1], guided[i])) traces.emplace_back();
        traces.back().push_back(guided[i].guide);
    }
    return traces;
}

std::vector<FoldRun> foldRuns(const Trace& trace) {
    std::vector<FoldRun> runs;
    for (std::uint32_t i = 0; i < trace.kinds.size(); ++i) {
        if (!runs.empty() && runs.back().kind == trace.kinds[i] && runs.back().last + 1 == i)
            runs.back().last = i;
        else
            runs.push_back({trace.kinds[i], i, i});
    }
    std::erase_if(runs, [](const FoldRun& run) {
        const std::uint32_t length = run.last - run.first + 1;
        return run.kind == SecondaryStructure::none || length < (run.kind == SecondaryStructure::helix ? 3u : 2u);
    });
    return runs;
}

}  // namespace nacre
