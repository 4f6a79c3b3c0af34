#include "engine/scene/view/shared_frame.h"

#include <functional>
#include <span>
#include <vector>

#include "engine/error.h"
#include "engine/molecule/other_models.h"
#include "engine/scene/instances/assembly_scene.h"

namespace nacre {
namespace {

using VisitBall = std::function<void(const glm::dvec3&, double)>;

/// Visits everything drawn of a model.
void eachBall(const ResidueFacts& facts, const DrawnAtomsOptions& drawnOptions, const RepresentationOptions& options,
              const VisitBall& visit) {
    const Molecule& model = facts.molecule();
    const std::vector<std::uint32_t> all = drawnAtoms(model, drawnOptions);
    std::span<const std::uint32_t> drawn = all;
    std::optional<AssemblyScene> assembly;
    if (!options.assembly.empty()) {
        assembly.emplace(model, options.assembly);
        drawn = assembly->place(drawn);
    }
    Appearance appearance = makeAppearance(facts, drawn, options);
    if (assembly) assembly->sortByCopies(appearance);
    const SeenBalls seen = seenBalls(model, appearance);
    if (assembly) return assembly->eachBall(seen, visit);
    for (const glm::dvec4& ball : seen.balls) visit(glm::dvec3(ball), ball.w);
}

/// The balls of a file's models, for repeated visits.
class ModelBalls {
public:
    ModelBalls(const ResidueFacts& facts, const DrawnAtomsOptions& drawn, const RepresentationOptions& options)
        : facts_(facts), molecule_(facts.molecule()), drawn_(drawn), options_(options) {
        const std::vector<std::uint32_t> all = drawnAtoms(molecule_, drawn);
        std::span<const std::uint32_t> placed = all;
        std::optional<AssemblyScene> assembly;
        if (!options.assembly.empty()) {
            assembly.emplace(molecule_, options.assembly);
            placed = assembly->place(placed);
        }
        Appearance own = makeAppearance(facts, placed, options);
        options_.style = own.style;  // models also share that
        options_.color = ColorScheme::element;
        std::erase_if(options_.rules, [](const Rule& rule) { return rule.action == Rule::Action::color; });
        simple_ = options_.rules.empty() && options_.assembly.empty();
        seen_ = seenBalls(molecule_, own);
    }

    void eachBall(const VisitBall& visit) const {
        nacre::eachBall(facts_, drawn_, options_, visit);
        Molecule placed;
        for (std::size_t i = 0; i < molecule_.others.size(); ++i) {
            const OtherModel other = molecule_.others[i];
            if (simple_ && !other.whole) {
                for (std::size_t k = 0; k < seen_.atoms.size(); ++k)
                    visit(other.positions[seen_.atoms[k]], seen_.balls[k].w);
                continue;
            }
            place(molecule_, other, placed);
            try {
                nacre::eachBall(placed, drawn_, options_, visit);
            } catch (const Error&) {
                // The assembly contains none of the model's atoms.
            }
        }
    }

private:
    ResidueFacts facts_;
    const Molecule& molecule_;
    DrawnAtomsOptions drawn_;
    RepresentationOptions options_;
    bool simple_ = false;  // the same atoms are drawn in every model
    SeenBalls seen_;
};

}  // namespace

std::optional<Bounds> sharedFrame(const ResidueFacts& facts, const DrawnAtomsOptions& drawn,
                                  const RepresentationOptions& options) {
    if (facts.molecule().others.empty() || options.ownFrame) return std::nullopt;
    const ModelBalls models(facts, drawn, options);
    return boundsOfEach([&](const auto& visit) { models.eachBall(visit); }, options.center);
}

}  // namespace nacre
