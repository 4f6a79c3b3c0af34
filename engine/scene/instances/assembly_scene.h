#pragma once
// Applies an assembly to a representation. Used by representation.cpp.

#include <cstdint>
#include <functional>
#include <glm/mat4x3.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/build/contact_lines.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/bounds.h"

namespace nacre {

class AssemblyScene {
public:
    /// @throws Error if the molecule has no such assembly
    AssemblyScene(const Molecule& molecule, const std::string& id);

    /// The given atoms that are in the assembly. The span lives as long as this. @throws Error if there are none
    std::span<const std::uint32_t> place(std::span<const std::uint32_t> atoms);
    /// Turns the colours of atoms coloured by copy into tints, and lists the copies' colours in the legend. If several
    /// palettes are requested, the first one is used.
    void colorByCopy(Appearance& appearance);
    /// Groups atoms by their copies; otherwise they keep their order.
    void sortByCopies(Appearance& appearance) const;
    /// As above for bonds, without those whose atoms are never drawn together.
    void sortByCopies(std::vector<Bond>& bonds);
    /// Drops interactions of atoms that are never drawn together, adds those between copies, and sorts them by the
    /// copies in whose place they are drawn. @param warnings  receives the reason if those between copies are omitted
    void placeContacts(const ContactFinder& finder, const Appearance& appearance, std::vector<PlacedContact>& contacts,
                       std::vector<std::string>& warnings);
    /// Visits the balls in all their copies.
    void eachBall(const SeenBalls& seen, const std::function<void(const glm::dvec3&, double)>& visit) const;
    /// Bounds of the balls in all copies.
    Bounds bounds(const SeenBalls& seen, const std::optional<glm::dvec3>& about = {}) const;
    /// Index of an atom's list of copies; atoms with the same copies share a list.
    std::uint32_t copyList(std::uint32_t atom) const;
    /// Visits the copies that contain two atoms: their transforms about a centre, and their indices.
    void eachCopy(std::uint32_t atomA, std::uint32_t atomB, const glm::dvec3& center,
                  const std::function<void(const glm::dmat4x3&, std::uint32_t)>& visit);
    /// The colour of a tint (copyTint()) in a copy.
    std::uint32_t tintColor(std::uint32_t tint, std::uint32_t copy) const;
    /// Number of atoms in all their copies.
    std::size_t countCopies(std::span<const std::uint32_t> atoms) const;
    /// Sets the copies of a representation that has its primitives but no copies yet. @throws Error if there are too
    /// many
    void finish(Representation& representation);

private:
    std::uint32_t findCommonList(std::uint32_t atomA, std::uint32_t atomB);
    void addBetweenCopies(const ContactFinder& finder, const Appearance& appearance,
                          std::vector<PlacedContact>& contacts, std::vector<std::string>& warnings);
    Bounds roughBounds(const SeenBalls& seen) const;
    void spread(std::size_t colors);
    void checkNumber(std::size_t primitives) const;
    static void keepWholeMeshes(Representation& representation);

    const Molecule& molecule_;
    std::string id_;
    Placement placement_;
    CopyLists lists_;  ///< of the placement
    std::vector<std::uint32_t> atoms_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> common_;  ///< lists that were asked for
    std::vector<std::uint32_t> listOfContact_;
    std::size_t bondsOfCopies_ = 0;
    std::vector<std::uint32_t> copyColors_;
};

}  // namespace nacre
