#pragma once
// Turns interactions into the dashed lines of a scene. Used by representation.cpp.

#include <glm/mat4x3.hpp>
#include <optional>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/scene/build/appearance.h"
#include "engine/scene/build/contacts.h"

namespace nacre {

struct Representation;

/// An interaction to draw, and its place in an assembly.
struct PlacedContact {
    Interaction interaction;
    std::uint32_t list = 0, copy = 0;   ///< in an assembly: the copies in whose place it is drawn, and their first
    std::optional<glm::dmat4x3> image;  ///< moves ends that are images into place, in the file's frame
};

/// Finds the requested interactions whose atoms are all seen, in any style. Keeps data that does not depend on
/// positions.
class ContactFinder {
public:
    /// @throws Error if a selection matches no atoms
    ContactFinder(const ResidueFacts& facts, const ContactOptions& options);
    /// @param molecule  the one of the constructor, with any positions
    std::vector<PlacedContact> find(const Molecule& molecule, const Appearance& appearance) const;
    /// Contacts between the molecule and an image of it.
    std::vector<PlacedContact> findBetween(const Molecule& molecule, const Appearance& appearance,
                                           const glm::dmat4x3& image) const;

private:
    InteractionFinder finder_;
    InteractionQuery query_;
};

/// Adds the contacts' lines, marks of ring centres and of waters that are not drawn, and the legend. A line ends at the
/// drawn balls of its atoms, or at the atoms' centres; for rings, at their middles; for charged groups, at the nearest
/// atom. Where a donor's hydrogen is drawn, the line ends there.
/// @param atoms  balls of the scene, as Appearance has them: its first spheres
void addContacts(const Molecule& molecule, const Appearance& appearance, std::vector<PlacedContact> contacts,
                 const ContactOptions& options, Representation& scene);

/// Keeps the numbers of spheres and cylinders constant while contacts change in a trajectory, so that frames need not
/// wait: adds primitives inside the first ball, if there is one.
/// @param spheres, cylinders  in: minimum numbers; out: actual numbers
void fillUp(Representation& scene, std::size_t& spheres, std::size_t& cylinders);

}  // namespace nacre
