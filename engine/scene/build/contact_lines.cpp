#include "engine/scene/build/contact_lines.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

constexpr std::uint32_t rgb(std::uint32_t hex) { return 0xff000000u | (hex & 0xff) << 16 | (hex & 0xff00) | hex >> 16; }

// In the order of InteractionKind. Dashes and dots tell them apart without colour.
constexpr std::array<ContactLook, kInteractionKinds> kLooks{{{"Hydrogen bond", rgb(0x2b7fd4), {{0.30, 0.20, 0, 0}}},
                                                             {"Salt bridge", rgb(0xe0a800), {{0.60, 0.20, 0, 0}}},
                                                             {"Pi stacking", rgb(0x3d9a4a), {{0.40, 0.18, 0, 0.18}}},
                                                             {"Cation–pi", rgb(0xf07d1a), {{0.60, 0.18, 0, 0.18}}},
                                                             {"Halogen bond", rgb(0x00b8a9), {{0.20, 0.20, 0, 0}}},
                                                             {"Hydrophobic", rgb(0x8a8a8a), {{0, 0.30, 0, 0}}},
                                                             {"Metal", rgb(0x8e44ad), {{0.45, 0.14, 0, 0}}},
                                                             {"Water bridge", rgb(0x5db8ff), {{0.22, 0.18, 0, 0.18}}}}};
constexpr double kMarkWidths = 1.7;  // of marks, relative to the width of dashes

std::vector<bool> matched(const ResidueFacts& facts, const Selection& selection) {
    std::vector<bool> atoms = selectAtoms(facts, selection);
    if (std::find(atoms.begin(), atoms.end(), true) == atoms.end())
        throw Error("cannot draw interactions", selection.text, "the molecule has no such atoms");
    return atoms;
}

InteractionQuery makeQuery(const ResidueFacts& facts, const ContactOptions& options) {
    InteractionQuery query{matched(facts, *options.of), {}, options.kinds};
    if (options.with) query.b = matched(facts, *options.with);
    return query;
}

/// Whether a contact may end at each atom: the atom is drawn. If some residues of a cartoon are also drawn as atoms,
/// the others are background.
std::vector<bool> seenAtoms(const Molecule& molecule, const Appearance& appearance) {
    std::vector<bool> seen(molecule.atoms.size());
    for (const std::uint32_t atom : appearance.atoms) seen[atom] = true;
    const std::vector<std::uint32_t>& cartoon = appearance.cartoon.atoms;
    const bool both = std::any_of(cartoon.begin(), cartoon.end(), [&](std::uint32_t atom) { return seen[atom]; });
    for (const std::uint32_t atom : appearance.surface.atoms) seen[atom] = true;
    if (!both)
        for (const std::uint32_t atom : cartoon) seen[atom] = true;
    return seen;
}

std::vector<PlacedContact> selectSeen(const Molecule& molecule, const Appearance& appearance,
                                      std::vector<Interaction> found) {
    std::vector<PlacedContact> kept;
    if (found.empty()) return kept;
    const std::vector<bool> seen = seenAtoms(molecule, appearance);
    for (Interaction& interaction : found)
        if (seen[interaction.a.atoms.front()] && seen[interaction.b.atoms.front()])
            kept.push_back({std::move(interaction), 0, 0, {}});
    return kept;
}

std::uint32_t contactColor(InteractionKind kind, const ContactOptions& options) {
    const std::uint32_t own = options.colors[static_cast<std::size_t>(kind)];
    return own != 0 ? own : contactLook(kind).color;
}

class Lines {
public:
    Lines(const Molecule& molecule, const Appearance& appearance, const ContactOptions& options, Representation& scene)
        : molecule_(molecule), appearance_(appearance), options_(options), radius_(options.width / 2), scene_(scene) {}

    void add(PlacedContact contact) {
        Interaction& interaction = contact.interaction;
        image_ = contact.image ? &*contact.image : nullptr;
        const ContactLook& look = contactLook(interaction.kind);
        const auto number = static_cast<std::uint32_t>(scene_.firstContact + scene_.contacts.size());
        line_ = {{}, {}, radius_, look.pattern, {contactColor(interaction.kind, options_), number}};
        End a = makeEnd(interaction.a, interaction.b.place), b = makeEnd(interaction.b, a.at + scene_.center);
        if (interaction.kind == InteractionKind::saltBridge) a = makeEnd(interaction.a, b.at + scene_.center);
        glm::dvec3 middle = (a.at + b.at) / 2.0;
        if (interaction.waters.empty()) {
            draw(a, b);
        } else {
            const End water = waterEnd(interaction.waters.front(), interaction.waterImage);
            middle = water.at;
            draw(a, water);
            draw(water, b);
        }
        scene_.contacts.push_back({std::move(interaction), middle, contact.copy});
    }
    std::size_t buried() const { return buried_; }

private:
    struct End {
        glm::dvec3 at{};    ///< from the scene's centre
        double radius = 0;  ///< of the ball drawn there
    };

    /// Position in the file's frame.
    glm::dvec3 atomPosition(std::uint32_t atom, bool image) const {
        const glm::dvec3 place(molecule_.atoms[atom].position);
        return image && image_ ? *image_ * glm::dvec4(place, 1) : place;
    }
    glm::dvec3 at(std::uint32_t atom, bool image) const { return atomPosition(atom, image) - scene_.center; }
    /// Radius of an atom's ball; 0 if it has none.
    double atomBallRadius(std::uint32_t atom) {
        const auto found = std::lower_bound(slots().begin(), slots().end(), std::pair(atom, 0u));
        if (found == slots().end() || found->first != atom) return 0;
        return static_cast<double>(scene_.ballRadius(found->second));
    }
    /// Balls by their atoms. Those of an assembly are not in the order of their atoms.
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& slots() {
        if (slots_.empty()) {
            for (std::uint32_t i = 0; i < appearance_.atoms.size(); ++i) slots_.emplace_back(appearance_.atoms[i], i);
            std::sort(slots_.begin(), slots_.end());
        }
        return slots_;
    }

    void mark(const glm::dvec3& place) {
        scene_.spheres.push_back({glm::vec3(place), static_cast<float>(kMarkWidths * radius_)});
        scene_.sphereLooks.push_back({line_.look.color, line_.look.id});
    }

    End makeEnd(const InteractionEnd& end, const glm::dvec3& other) {
        if (end.ring) {
            const glm::dvec3 centre = glm::dvec3(end.place) - scene_.center;
            mark(centre);
            return {centre, kMarkWidths * radius_};
        }
        std::uint32_t atom = end.atoms.front();
        if (const std::uint32_t last = end.atoms.back(); end.atoms.size() == 2 && isHydrogen(last)) {
            if (atomBallRadius(last) > 0) atom = last;
        } else {
            const auto away = [&](std::uint32_t i) { return glm::distance(atomPosition(i, end.image), other); };
            for (const std::uint32_t i : end.atoms)
                if (isPolar(i) > isPolar(atom) || (isPolar(i) == isPolar(atom) && away(i) < away(atom))) atom = i;
        }
        return {at(atom, end.image), atomBallRadius(atom)};
    }
    bool isHydrogen(std::uint32_t atom) const { return nacre::isHydrogen(molecule_.atoms[atom].element); }
    /// Whether an atom of a charged group carries charge: its carbon does not.
    bool isPolar(std::uint32_t atom) const {
        constexpr Element kCarbon = 6;
        return molecule_.atoms[atom].element != kCarbon && !isHydrogen(atom);
    }

    /// A bridging water is drawn even if water is hidden: as its oxygen's ball.
    End waterEnd(std::uint32_t water, bool image) {
        const double radius = atomBallRadius(water);
        if (radius > 0) return {at(water, image), radius};
        const Atom& oxygen = molecule_.atoms[water];
        const float ball = drawnRadius(oxygen, Style::ballAndStick, appearance_.sizes);
        if (image || drawnWaters_.insert(water).second) {
            scene_.spheres.push_back({glm::vec3(at(water, image)), ball});
            scene_.sphereLooks.push_back({elementColor(oxygen.element), image ? line_.look.id : water + 1});
        }
        return {at(water, image), static_cast<double>(ball)};
    }

    void draw(const End& a, const End& b) {
        DashedLine line = line_;
        line.a = a.at;
        line.b = b.at;
        if (!shorten(line, a.radius, b.radius) || appendDashes(line, scene_) == 0) ++buried_;
    }

    const Molecule& molecule_;
    const Appearance& appearance_;
    const ContactOptions& options_;
    double radius_;
    Representation& scene_;
    DashedLine line_;
    const glm::dmat4x3* image_ = nullptr;  ///< of the current contact
    std::size_t buried_ = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> slots_;
    std::set<std::uint32_t> drawnWaters_;
};

Legend makeLegend(const std::vector<DrawnContact>& contacts, const ContactOptions& options) {
    Legend legend{"all", std::string(kContactScheme), {}};
    for (std::size_t kind = 0; kind < kInteractionKinds; ++kind)
        if (std::any_of(contacts.begin(), contacts.end(), [&](const DrawnContact& contact) {
                return contact.interaction.kind == static_cast<InteractionKind>(kind);
            }))
            legend.entries.push_back({kLooks[kind].label, contactColor(static_cast<InteractionKind>(kind), options)});
    return legend;
}

}  // namespace

const ContactLook& contactLook(InteractionKind kind) { return kLooks[static_cast<std::size_t>(kind)]; }

ContactFinder::ContactFinder(const ResidueFacts& facts, const ContactOptions& options)
    : finder_(facts.molecule(), options.rules), query_(makeQuery(facts, options)) {}

std::vector<PlacedContact> ContactFinder::find(const Molecule& molecule, const Appearance& appearance) const {
    return selectSeen(molecule, appearance, finder_.find(molecule, query_));
}

std::vector<PlacedContact> ContactFinder::findBetween(const Molecule& molecule, const Appearance& appearance,
                                                      const glm::dmat4x3& image) const {
    std::vector<PlacedContact> found = selectSeen(molecule, appearance, finder_.findBetween(molecule, image, query_));
    for (PlacedContact& contact : found) contact.image = image;
    return found;
}

void addContacts(const Molecule& molecule, const Appearance& appearance, std::vector<PlacedContact> contacts,
                 const ContactOptions& options, Representation& scene) {
    scene.firstContact = static_cast<std::uint32_t>(molecule.atoms.size() + 1);
    scene.contacts.clear();
    Lines lines(molecule, appearance, options, scene);
    for (PlacedContact& contact : contacts) lines.add(std::move(contact));
    if (scene.contacts.empty()) {
        scene.warnings.push_back("no interactions of '" + options.of->text + "' are seen");
        return;
    }
    if (lines.buried() > 0)
        scene.warnings.push_back(std::to_string(lines.buried()) + " of " + std::to_string(scene.contacts.size()) +
                                 " interactions lie within the balls of their atoms (thinner styles show them)");
    scene.legends.push_back(makeLegend(scene.contacts, options));
}

void fillUp(Representation& scene, std::size_t& spheres, std::size_t& cylinders) {
    constexpr float kHidden = 0.05f;  // Å, less than any atom's ball
    if (scene.spheres.empty() || scene.ballRadius(0) < 2 * kHidden || (scene.cutsOctants && scene.ellipsoid(0))) return;
    const Sphere ball{scene.spheres.front().center, kHidden};
    const SphereLook look = scene.sphereLooks.front();
    // Room for a quarter more, for the next frames.
    const auto room = [](std::size_t wanted, std::size_t& had) {
        if (wanted > had) had = wanted + wanted / 4;
        return had;
    };
    scene.spheres.resize(room(scene.spheres.size(), spheres), ball);
    scene.sphereLooks.resize(spheres, look);
    const Cylinder stick{ball.center - glm::vec3(0, 0, kHidden / 2), kHidden / 2,
                         ball.center + glm::vec3(0, 0, kHidden / 2), 0.0f};
    scene.cylinders.resize(room(scene.cylinders.size(), cylinders), stick);
    scene.cylinderLooks.resize(cylinders, {look.color, look.color, look.atom, look.atom});
}

}  // namespace nacre
