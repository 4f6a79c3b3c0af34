#include "engine/mesh/cartoon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/mesh/cartoon_bases.h"
#include "engine/mesh/cartoon_curve.h"
#include "engine/mesh/cartoon_sweep.h"
#include "engine/mesh/cartoon_trace.h"
#include "engine/mesh/mesh_levels.h"
#include "engine/mesh/solids.h"

namespace nacre {
namespace {

// Å. PyMOL's ribbons have half-widths of 1.35 and half-thicknesses of 0.25 in helices, 1.4 and 0.2 in strands, loops of
// radius 0.2, nucleic acids of 0.5 and cylinders of 2.25; Mol*'s are 1.0 and 0.2 throughout, with arrow heads of 1.5
// times the width; ChimeraX's the same with arrows of twice the width.
constexpr Section kCoil{0.25, 0.25};
constexpr Section kHelixRibbon{1.3, 0.25};
constexpr Section kStrand{1.2, 0.25};
constexpr double kArrowScale = 1.5;
constexpr Section kHelixTube{2.0, 2.0};
constexpr Section kHelixCylinder{2.25, 2.25};
constexpr Section kNucleicTube{0.5, 0.5};
constexpr double kPuttyRadius = 0.4;

double smoothStep(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Distribution of B factors: mean and standard deviation over everything drawn.
struct PuttyScale {
    double mean = 0, deviation = 0;

    explicit PuttyScale(const std::vector<Trace>& traces) {
        double sum = 0, squares = 0, count = 0;
        for (const Trace& trace : traces)
            for (std::size_t i = 0; i < trace.shown.size(); ++i)
                if (trace.shown[i]) sum += trace.temperatures[i], ++count;
        mean = count > 0 ? sum / count : 0;
        for (const Trace& trace : traces)
            for (std::size_t i = 0; i < trace.shown.size(); ++i)
                if (trace.shown[i]) squares += (trace.temperatures[i] - mean) * (trace.temperatures[i] - mean);
        deviation = count > 0 ? std::sqrt(squares / count) : 0;
    }

    double radius(double temperature) const {
        const double z = deviation > 1e-6 ? (temperature - mean) / deviation : 0;
        return kPuttyRadius * std::clamp(std::pow(std::max(0.0, (z + 2) / 2), 1.5), 0.6, 4.0);
    }
};

/// The cartoon of one trace.
class TraceDrawer {
public:
    TraceDrawer(Mesh& mesh, const Trace& trace, const CartoonOptions& options, const PuttyScale& putty,
                const glm::dvec3& origin)
        : mesh_(mesh), trace_(trace), options_(options), putty_(putty), origin_(origin) {
        if (trace.points.size() < 2) return;
        runs_ = foldRuns(trace);
        if (options.helices != HelixForm::ribbon) runs_ = splitAtKinks(trace, std::move(runs_));
        frames_ = cartoonFrames(trace, runs_, options.helices, options.putty, options.segments);
        for (std::size_t k = 0; k + 1 < frames_.size(); ++k) owners_.push_back(trace.atoms[findOwner(k)]);
        if (options.putty) runs_.clear();
    }

    void draw() {
        if (frames_.empty())
            return addBall(mesh_, trace_.points[0] - origin_, coil(0).width * options_.scale, trace_.atoms[0], sides());
        std::size_t done = 0;  // number of finished frames
        for (const FoldRun& run : runs_) {
            const bool helix = run.kind == SecondaryStructure::helix;
            if (helix && options_.helices == HelixForm::ribbon) continue;  // the ribbon grows out of the coil
            const auto [begin, last] = frameRange(run);
            const std::size_t first = std::max(begin, done);
            drawCoil(done, first);
            if (helix)
                drawHelixSolid(first, last);
            else
                drawStrand(first, last);
            done = last;
        }
        drawCoil(done, frames_.size() - 1);
    }

    /// Adds the ribbon's position at each drawn residue; for a nucleotide, the middle of its stretch, near its sugar.
    void addPlaces(std::vector<RibbonPlace>& places) const {
        for (std::size_t i = 0; i < trace_.residues.size(); ++i) {
            if (!trace_.shown[i]) continue;
            const std::size_t k = i * step() + (trace_.shift == 0 ? step() / 2 : 0);
            places.push_back({trace_.residues[i], k < frames_.size() ? frames_[k].center : trace_.points[i]});
        }
    }

private:
    std::size_t step() const { return static_cast<std::size_t>(options_.segments); }
    int sides() const { return options_.sides; }

    /// The frames between which a run is drawn.
    std::pair<std::size_t, std::size_t> frameRange(const FoldRun& run) const {
        const bool solid = run.kind == SecondaryStructure::helix && options_.helices != HelixForm::ribbon;
        // solids start beside the coil's path
        const double share = solid ? 0 : std::clamp(options_.overhang, 0.0, 0.5);
        const auto over = static_cast<std::size_t>(share * options_.segments);
        const std::size_t first = run.first * step(), last = run.last * step() + over;
        return {first > over ? first - over : 0, std::min(last, frames_.size() - 1)};
    }

    /// The atom that owns the stretch from frame k to the next.
    std::size_t findOwner(std::size_t k) const {
        const double u = (static_cast<double>(k) + 0.5) / options_.segments + trace_.shift;
        return std::min(static_cast<std::size_t>(u), trace_.atoms.size() - 1);
    }

    Section coil(std::size_t k) const {
        if (!options_.putty) return trace_.nucleic ? kNucleicTube : kCoil;
        const double slope = options_.tubePerTemperature;
        if (options_.tube > 0 && slope == 0) return {options_.tube, options_.tube};
        const std::size_t last = trace_.temperatures.size() - 1, i = std::min(k / step(), last);
        const double f = static_cast<double>(k % step()) / options_.segments;
        const auto radiusOf = [&](double temperature) {
            return slope == 0 ? putty_.radius(temperature)
                              : std::clamp(options_.tube + slope * temperature, 0.05, 20.0);
        };
        const double a = radiusOf(trace_.temperatures[i]), b = radiusOf(trace_.temperatures[std::min(i + 1, last)]);
        const double radius = a + (b - a) * smoothStep(f);
        return {radius, radius};
    }

    /// Sections of a coil; in a helix, those of its ribbon, which tapers within its first and last residue.
    std::vector<Section> coilSections(std::size_t first, std::size_t last) const {
        std::vector<Section> sections;
        for (std::size_t k = first; k <= last; ++k) sections.push_back(coil(k));
        for (const FoldRun& run : runs_) {
            if (run.kind != SecondaryStructure::helix || options_.helices != HelixForm::ribbon) continue;
            const auto [from, to] = frameRange(run);
            for (std::size_t k = std::max(from, first); k <= std::min(to, last); ++k) {
                const double grown = smoothStep(static_cast<double>(std::min(k - from, to - k)) / options_.segments);
                Section& section = sections[k - first];
                section.width += (kHelixRibbon.width - section.width) * grown;
                section.thickness += (kHelixRibbon.thickness - section.thickness) * grown;
            }
        }
        return sections;
    }

    void drawCoil(std::size_t first, std::size_t last) {
        if (first >= last) return;
        const std::vector<Section> sections = coilSections(first, last);
        drawShown({first, last, SectionShape::oval, first == 0, last + 1 == frames_.size(), sections});
    }

    void drawHelixSolid(std::size_t first, std::size_t last) {
        const Section section = options_.helices == HelixForm::tube ? kHelixTube : kHelixCylinder;
        drawShown({first, last, SectionShape::oval, false, false, std::vector<Section>(last - first + 1, section)});
    }

    /// A shaft with an arrow head over the last residue. The tip is as wide as the following coil.
    void drawStrand(std::size_t first, std::size_t last) {
        const std::size_t neck = last - step();
        if (neck > first)
            drawShown(
                {first, neck, SectionShape::rectangle, false, false, std::vector<Section>(neck - first + 1, kStrand)});
        std::vector<Section> head;
        for (std::size_t k = neck; k <= last; ++k) {
            const double wide = static_cast<double>(last - k) / options_.segments;
            head.push_back({kCoil.width + (kArrowScale * kStrand.width - kCoil.width) * wide, kStrand.thickness});
        }
        drawShown({neck, last, SectionShape::rectangle, false, false, std::move(head)});
    }

    /// Draws the stretches of a piece whose residues are visible.
    void drawShown(const SweepPiece& piece) {
        std::size_t k = piece.first;
        while (k < piece.last) {
            while (k < piece.last && !trace_.shown[findOwner(k)]) ++k;
            const std::size_t begin = k;
            while (k < piece.last && trace_.shown[findOwner(k)]) ++k;
            if (begin == k) continue;
            SweepPiece part{
                begin, k, piece.shape, piece.roundBegin && begin == piece.first, piece.roundEnd && k == piece.last, {}};
            part.sections.assign(piece.sections.begin() + static_cast<std::ptrdiff_t>(begin - piece.first),
                                 piece.sections.begin() + static_cast<std::ptrdiff_t>(k - piece.first + 1));
            for (Section& section : part.sections) section.width *= options_.scale, section.thickness *= options_.scale;
            sweep(mesh_, frames_, part, owners_, origin_, sides());
        }
    }

    Mesh& mesh_;
    const Trace& trace_;
    const CartoonOptions& options_;
    const PuttyScale& putty_;
    glm::dvec3 origin_;
    std::vector<FoldRun> runs_;
    std::vector<Frame> frames_;
    std::vector<std::uint32_t> owners_;
};

}  // namespace

CartoonOptions settledCartoon(const CartoonOptions& options, std::size_t residues) {
    CartoonOptions settled = options;
    const bool many = residues > 20000, tooMany = residues > 60000;
    if (settled.segments <= 0) settled.segments = tooMany ? 4 : many ? 6 : 8;
    if (settled.sides <= 0) settled.sides = tooMany ? 8 : many ? 10 : 12;
    settled.segments += settled.segments % 2;
    settled.sides = std::max(4, settled.sides + settled.sides % 2);
    return settled;
}

Mesh cartoon(const ResidueFacts& facts, std::span<const std::uint32_t> atoms,
             std::span<const SecondaryStructure> secondary, const CartoonOptions& options, const glm::dvec3& origin) {
    return cartoon(ChainStretches(facts), atoms, secondary, options, origin);
}

Mesh cartoon(const ChainStretches& stretches, std::span<const std::uint32_t> atoms,
             std::span<const SecondaryStructure> secondary, const CartoonOptions& options, const glm::dvec3& origin) {
    const ResidueFacts& facts = stretches.facts();
    const std::vector<Trace> traces = stretches.traces(atoms, secondary);
    std::size_t residues = 0;
    for (const Trace& trace : traces) residues += trace.residues.size();
    const CartoonOptions settled = settledCartoon(options, residues);
    const PuttyScale putty(traces);
    Mesh mesh;
    mesh.coarser = cartoonLevels();
    std::vector<RibbonPlace> nucleotides, aminoAcids;
    for (const Trace& trace : traces) {
        TraceDrawer drawer(mesh, trace, settled, putty, origin);
        drawer.draw();
        drawer.addPlaces(trace.nucleic ? nucleotides : aminoAcids);
    }
    for (auto* places : {&nucleotides, &aminoAcids})
        std::sort(places->begin(), places->end(),
                  [](const RibbonPlace& a, const RibbonPlace& b) { return a.residue < b.residue; });
    addBases(mesh, facts, nucleotides, settled, origin);
    if (settled.disulfides) addDisulfides(mesh, facts, aminoAcids, settled, origin);
    dropFineLevels(mesh);
    return mesh;
}

CartoonAtoms atomsOfCartoon(const ResidueFacts& facts, std::span<const std::uint32_t> atoms) {
    const Molecule& molecule = facts.molecule();
    std::vector<bool> drawn(molecule.residues.size()), fused(molecule.residues.size());
    for (const Trace& trace : cartoonTraces(facts, atoms, {}))
        for (std::size_t i = 0; i < trace.residues.size(); ++i) {
            if (!trace.shown[i]) continue;
            drawn[trace.residues[i]] = true;
            fused[trace.residues[i]] = trace.fused[i];
        }
    CartoonAtoms found;
    for (const std::uint32_t atom : atoms) {
        const std::uint32_t residue = facts.positions()[molecule.atoms[atom].residue];
        if (drawn[residue]) found.drawn.push_back(atom);
        if (fused[residue]) found.beside.push_back(atom);
    }
    return found;
}

}  // namespace nacre
