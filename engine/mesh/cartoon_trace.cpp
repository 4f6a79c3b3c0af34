#include "engine/mesh/cartoon_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/molecule/disjoint_sets.h"

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
    bool fused = false;
    /// Atoms of the bonds to the neighbours along the chain.
    std::uint32_t begin() const { return atoms[nucleic ? kGuideP : kGuideN]; }
    std::uint32_t end() const { return atoms[nucleic ? kGuideO3 : kGuideC]; }
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

int findGuideName(const Name& name) {
    Name plain = name;
    std::replace(plain.bytes.begin(), plain.bytes.end(), '*', '\'');  // files before 2007 write O5*
    const auto found = std::find(kGuideAtoms.begin(), kGuideAtoms.end(), plain.view());
    return static_cast<int>(found - kGuideAtoms.begin());
}

/// Backbones of amino acids that have no atom CA and are bonded into a chain: several for the chromophore of GFP, which
/// three residues formed. Found by elements along the bonds from N to C.
class FusedBackbones {
public:
    /// @param candidates  by residue
    FusedBackbones(const ResidueFacts& facts, const std::vector<bool>& candidates) : molecule_(facts.molecule()) {
        for (const std::uint32_t atom : facts.conformer())
            if (candidates[molecule_.atoms[atom].residue] && isFinite(molecule_.atoms[atom].position))
                atoms_.emplace(atom, Node{});
        if (atoms_.empty()) return;
        for (const Bond& bond : molecule_.bonds)
            for (const auto& [here, there] : {std::pair(bond.a, bond.b), std::pair(bond.b, bond.a)}) {
                const auto found = atoms_.find(here);
                if (found == atoms_.end()) continue;
                const Atom &own = molecule_.atoms[here], &other = molecule_.atoms[there];
                Node& node = found->second;
                if (own.residue == other.residue) {
                    if (atoms_.contains(there)) node.bonded.push_back(there);
                } else {
                    node.begins |= own.element == kNitrogen && other.name == Name("C");
                    node.ends |= own.element == kCarbon && other.name == Name("N");
                }
            }
    }

    /// Backbones in the order of the chain; empty if none joins both neighbours.
    std::vector<Guided> of(std::uint32_t residue) {
        path_.clear(), longest_.clear();
        steps_ = 0;
        const Residue& r = molecule_.residues[residue];
        for (auto at = atoms_.lower_bound(r.firstAtom); at != atoms_.end() && at->first < r.firstAtom + r.atomCount;
             ++at)
            if (at->second.begins) follow(at->first);
        std::vector<Guided> backbones;
        for (std::size_t i = 0; i < longest_.size(); i += 3) {
            Guided& unit = backbones.emplace_back();
            unit.residue = residue;
            unit.fused = true;
            unit.atoms.fill(kNoAtom);
            unit.atoms[kGuideN] = longest_[i];
            unit.guide = unit.atoms[kGuideCa] = longest_[i + 1];
            unit.atoms[kGuideC] = longest_[i + 2];
            for (const std::uint32_t atom : atoms_[longest_[i + 2]].bonded)
                if (molecule_.atoms[atom].element == kOxygen) unit.atoms[kGuideO] = atom;
        }
        return backbones;
    }

private:
    struct Node {
        std::vector<std::uint32_t> bonded;  ///< within the residue
        bool begins = false, ends = false;  ///< N bonded to the C before, C bonded to the N after
    };
    static constexpr Element kCarbon = 6, kNitrogen = 7, kOxygen = 8;
    static constexpr std::size_t kMostFused = 4;
    static constexpr int kMostSteps = 10'000;  // files may bond anything

    void follow(std::uint32_t atom) {
        const std::size_t place = path_.size() % 3;
        if (++steps_ > kMostSteps || molecule_.atoms[atom].element != (place == 0 ? kNitrogen : kCarbon) ||
            std::find(path_.begin(), path_.end(), atom) != path_.end())
            return;
        path_.push_back(atom);
        const Node& node = atoms_[atom];
        if (place == 2 && node.ends && path_.size() > longest_.size()) longest_ = path_;
        if (path_.size() < 3 * kMostFused)
            for (const std::uint32_t next : node.bonded) follow(next);
        path_.pop_back();
    }

    const Molecule& molecule_;
    std::map<std::uint32_t, Node> atoms_;
    std::vector<std::uint32_t> path_, longest_;
    int steps_ = 0;
};

/// Replaces amino acids without a guide by their fused backbones.
void addFusedBackbones(const ResidueFacts& facts, std::vector<Guided>& guided) {
    const std::vector<std::uint32_t>& first = facts.positions();
    std::vector<bool> candidates(guided.size());
    for (std::uint32_t r = 0; r < guided.size(); ++r)
        candidates[r] = first[r] == r && facts.kinds()[r] == ResidueKind::protein && guided[r].guide == kNoAtom;
    if (std::find(candidates.begin(), candidates.end(), true) == candidates.end()) return;
    FusedBackbones fused(facts, candidates);
    std::vector<Guided> result;
    result.reserve(guided.size());
    for (std::uint32_t r = 0; r < guided.size(); ++r) {
        if (!candidates[r]) {
            result.push_back(guided[r]);
            continue;
        }
        const std::vector<Guided> backbones = fused.of(r);
        result.insert(result.end(), backbones.begin(), backbones.end());
    }
    guided = std::move(result);
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
        const int name = grain ? static_cast<int>(kGuideCa) : findGuideName(atom.name);
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
    addFusedBackbones(facts, guided);
    std::erase_if(guided, [](const Guided& residue) { return residue.guide == kNoAtom; });
    return guided;
}

class ChainLinks {
public:
    explicit ChainLinks(const Molecule& molecule) : molecule_(molecule) {}

    /// Whether a residue is bonded to the next one. Empty: atoms of the bond are missing.
    std::optional<bool> bonded(const Guided& a, const Guided& b) const {
        if (!inOneChain(a, b)) return false;
        if (a.end() == kNoAtom || b.begin() == kNoAtom) return std::nullopt;
        const double guides = distance(a.guide, b.guide);
        return guides >= kNearestGuides && guides <= kFarthestBondedGuides &&
               distance(a.end(), b.begin()) <= kLongestChainBond;
    }

    /// Whether the guides of two residues are near enough for neighbours in a chain.
    bool near(const Guided& a, const Guided& b) const {
        const double guides = distance(a.guide, b.guide);
        return inOneChain(a, b) && guides >= kNearestGuides &&
               guides <= (a.nucleic ? kFarthestPhosphate : kFarthestAlphaCarbon);
    }

private:
    bool inOneChain(const Guided& a, const Guided& b) const {
        return a.nucleic == b.nucleic && molecule_.residues[a.residue].chain == molecule_.residues[b.residue].chain;
    }

    double distance(std::uint32_t a, std::uint32_t b) const {
        return glm::distance(glm::dvec3(molecule_.atoms[a].position), glm::dvec3(molecule_.atoms[b].position));
    }

    const Molecule& molecule_;
};

using Stretch = std::vector<Guided>;

/// Finds unbroken stretches of chains. A residue is followed by the one that it is bonded to, whatever the order of the
/// file; if atoms of that bond are missing, by the next one in the file.
class Stretches {
public:
    Stretches(const Molecule& molecule, std::vector<Guided> guided)
        : molecule_(molecule),
          guided_(std::move(guided)),
          next_(guided_.size(), kNone),
          before_(guided_.size(), kNone),
          sets_(guided_.size()),
          taken_(guided_.size()) {}

    /// In the file's order of their first residues; a ring begins with its first residue in the file.
    std::vector<Stretch> find() {
        const ChainLinks links(molecule_);
        const auto count = static_cast<std::uint32_t>(guided_.size());
        for (std::uint32_t i = 1; i < count; ++i)
            if (links.bonded(guided_[i - 1], guided_[i]).value_or(false)) link(i - 1, i);
        followBonds(links);
        for (std::uint32_t i = 1; i < count; ++i)
            if (next_[i - 1] == kNone && before_[i] == kNone && !links.bonded(guided_[i - 1], guided_[i]) &&
                links.near(guided_[i - 1], guided_[i]) && sets_.findRoot(i - 1) != sets_.findRoot(i))
                link(i - 1, i);
        for (std::uint32_t i = 0; i < count; ++i)
            if (before_[i] == kNone) take(i);
        for (std::uint32_t i = 0; i < count; ++i) take(i);  // rings
        return std::move(stretches_);
    }

private:
    static constexpr std::uint32_t kNone = UINT32_MAX;

    void link(std::uint32_t a, std::uint32_t b) {
        next_[a] = b;
        before_[b] = a;
        sets_.join(a, b);
    }

    void followBonds(const ChainLinks& links) {
        std::map<std::uint32_t, std::uint32_t> begins, ends;  // by atom
        for (std::uint32_t i = 0; i < guided_.size(); ++i) {
            if (before_[i] == kNone && guided_[i].begin() != kNoAtom) begins.emplace(guided_[i].begin(), i);
            if (next_[i] == kNone && guided_[i].end() != kNoAtom) ends.emplace(guided_[i].end(), i);
        }
        for (const Bond& bond : molecule_.bonds) {
            if (molecule_.atoms[bond.a].residue == molecule_.atoms[bond.b].residue) continue;
            for (const auto& [a, b] : {std::pair(bond.a, bond.b), std::pair(bond.b, bond.a)}) {
                const auto end = ends.find(a), begin = begins.find(b);
                if (end == ends.end() || begin == begins.end()) continue;
                const std::uint32_t from = end->second, to = begin->second;
                if (next_[from] == kNone && before_[to] == kNone &&
                    links.bonded(guided_[from], guided_[to]).value_or(false))
                    link(from, to);
            }
        }
    }

    void take(std::uint32_t from) {
        if (taken_[from]) return;
        Stretch& stretch = stretches_.emplace_back();
        for (std::uint32_t i = from; i != kNone && !taken_[i]; i = next_[i]) {
            taken_[i] = true;
            stretch.push_back(guided_[i]);
        }
    }

    const Molecule& molecule_;
    std::vector<Guided> guided_;
    std::vector<std::uint32_t> next_, before_;  ///< index in guided_ or kNone
    DisjointSets sets_;
    std::vector<bool> taken_;
    std::vector<Stretch> stretches_;
};

std::vector<Stretch> findStretches(const ResidueFacts& facts) {
    return Stretches(facts.molecule(), guidedResidues(facts)).find();
}

/// Vector from C to O; 0 if one is missing.
glm::dvec3 findCarbonyl(const Molecule& molecule, const Guided& residue) {
    const std::uint32_t c = residue.atoms[kGuideC], o = residue.atoms[kGuideO];
    if (c == kNoAtom || o == kNoAtom) return {};
    return glm::dvec3(molecule.atoms[o].position) - glm::dvec3(molecule.atoms[c].position);
}

/// Adds a point after the last phosphate, so that the last nucleotide has a piece of the curve. A lone amino acid runs
/// from its N to its C.
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

struct StretchIndex {
    std::vector<Stretch> stretches;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> guides;  ///< atom and stretch, ascending
};

}  // namespace

ChainStretches::ChainStretches(const ResidueFacts& facts) : facts_(facts) {
    const auto index = std::make_shared<StretchIndex>();
    index->stretches = findStretches(facts);
    for (std::uint32_t i = 0; i < index->stretches.size(); ++i)
        for (const Guided& residue : index->stretches[i]) index->guides.emplace_back(residue.guide, i);
    std::sort(index->guides.begin(), index->guides.end());
    index_ = index;
}

std::vector<Trace> ChainStretches::traces(std::span<const std::uint32_t> atoms,
                                          std::span<const SecondaryStructure> secondary) const {
    const Molecule& molecule = facts_.molecule();
    const auto& [stretches, guides] = *static_cast<const StretchIndex*>(index_.get());
    std::vector<std::uint32_t> chosen, shown;  // guide atoms, stretches
    for (const std::uint32_t atom : atoms) {
        auto guide = std::lower_bound(guides.begin(), guides.end(), std::pair(atom, 0u));
        for (; guide != guides.end() && guide->first == atom; ++guide) {
            chosen.push_back(atom);
            shown.push_back(guide->second);
        }
    }
    std::sort(chosen.begin(), chosen.end());
    std::sort(shown.begin(), shown.end());
    shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
    std::vector<Trace> traces;
    for (const std::uint32_t number : shown) {
        const Stretch& stretch = stretches[number];
        Trace& trace = traces.emplace_back();
        trace.nucleic = stretch.front().nucleic;
        for (const Guided& residue : stretch) {
            const Atom& guide = molecule.atoms[residue.guide];
            trace.points.emplace_back(guide.position);
            trace.atoms.push_back(residue.shows());
            trace.residues.push_back(residue.residue);
            trace.kinds.push_back(residue.nucleic || residue.residue >= secondary.size() ? SecondaryStructure::none
                                                                                         : secondary[residue.residue]);
            trace.shown.push_back(std::binary_search(chosen.begin(), chosen.end(), residue.guide));
            trace.fused.push_back(residue.fused);
            trace.temperatures.push_back(std::isfinite(guide.temperatureFactor) ? guide.temperatureFactor : 0.0);
            trace.carbonyls.push_back(residue.nucleic ? glm::dvec3() : findCarbonyl(molecule, residue));
        }
        addEnds(molecule, stretch.back(), trace);
    }
    return traces;
}

std::vector<Trace> cartoonTraces(const ResidueFacts& facts, std::span<const std::uint32_t> atoms,
                                 std::span<const SecondaryStructure> secondary) {
    return ChainStretches(facts).traces(atoms, secondary);
}

std::vector<GuideTrace> guideTraces(const ResidueFacts& facts) {
    std::vector<GuideTrace> traces;
    for (const Stretch& stretch : findStretches(facts)) {
        GuideTrace& trace = traces.emplace_back();
        for (const Guided& residue : stretch) trace.atoms.push_back(residue.guide);
        const Guided& last = stretch.back();
        trace.end = last.nucleic && last.end() != kNoAtom ? last.end() : last.guide;
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
