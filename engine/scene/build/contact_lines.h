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

/// An interaction to draw, and of an assembly where.
struct PlacedContact {
    Interaction interaction;
    std::uint32_t list = 0, copy = 0;   ///< of an assembly: the copies in whose place it is drawn, and their first
    std::optional<glm::dmat4x3> image;  ///< takes ends that are images to their place, in the file's frame
};

/// Finds the interactions that are asked for, of which every atom is seen, in whatever style. Keeps what does not move.
class ContactFinder {
public:
    /// @throws Error if a selection matches no atoms
    ContactFinder(const ResidueFacts& facts, const ContactOptions& options);
    /// @param molecule  the one that it was made for, with any positions
    std::vector<PlacedContact> find(const Molecule& molecule, const Appearance& appearance) const;
    /// Contacts between the molecule and an image of it.
    std::vector<PlacedContact> findBetween(const Molecule& molecule, const Appearance& appearance,
                                           const glm::dmat4x3& image) const;

private:
    InteractionFinder finder_;
    InteractionQuery query_;
};

/// Adds their lines, marks of ring centres and of waters that are not drawn, and their legend. A line ends at the
/// surfaces of the balls that are drawn of its atoms, or at the atoms' centres; those of rings at their middles; those
/// of charged groups at the nearest atom. Where a donor's hydrogen is drawn, the line ends there.
/// @param atoms  balls of the scene, as Appearance has them: its first spheres
void addContacts(const Molecule& molecule, const Appearance& appearance, std::vector<PlacedContact> contacts,
                 const ContactOptions& options, Representation& scene);

/// Keeps the numbers of spheres and cylinders constant while contacts change in a trajectory, so that frames need not
/// wait: adds primitives inside the first ball, if there is one.
/// @param spheres, cylinders  in: minimum numbers; out: actual numbers
void fillUp(Representation& scene, std::size_t& spheres, std::size_t& cylinders);

}  // namespace nacre
