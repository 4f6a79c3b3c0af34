#pragma once
// Molecule + appearance -> the primitive streams that the GPU draws. Makes no Vulkan calls.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/scene/build/appearance.h"
#include "engine/scene/build/bond_orders.h"
#include "engine/scene/build/contact_lines.h"
#include "engine/scene/build/contacts.h"
#include "engine/scene/build/ellipsoid_rows.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/scene/instances/copies.h"
#include "engine/scene/view/bounds.h"

namespace nacre {

/// Stream A, read by geometry passes. 16 bytes.
struct Sphere {
    glm::vec3 center;  ///< Å, relative to Representation::center
    float radius;      ///< Å
};
/// Stream B, which shading passes also read. 8 bytes.
struct SphereLook {
    std::uint32_t color;  ///< sRGB, 8 bits per channel, red in the lowest byte
    std::uint32_t atom;   ///< 1-based atom in its file; higher numbers: contacts, then notes of primitives; or 0
};

/// A cylinder with flat caps from a to b. 32 bytes.
struct Cylinder {
    glm::vec3 a;   ///< Å, relative to Representation::center
    float radius;  ///< Å
    glm::vec3 b;
    float perLength = 0;  ///< 1 / Å; set on upload, for the device only
};
struct CylinderLook {
    std::uint32_t colorA, colorB;  ///< of the halves next to a and b
    std::uint32_t atomA, atomB;
};

/// Consecutive spheres, cylinders or triangles of one of several models.
struct ModelRun {
    std::uint32_t first = 0, count = 0;
    std::uint32_t model = 0;  ///< from 0
};

/// An atom inside a surface, for its caps.
struct SurfaceAtom {
    glm::vec3 center;  ///< as Sphere
    float radius;
    SphereLook look;
};

struct Volume;

struct Representation {
    std::vector<Sphere> spheres;
    std::vector<SphereLook> sphereLooks;  ///< same length as spheres
    /// Of the first spheres. Those of an ellipsoid have the longest half axis as radius; those without rows, and those
    /// beyond the end, are plain.
    std::vector<EllipsoidRows> ellipsoids;
    bool cutsOctants = false;  ///< ellipsoids open the octant that faces the viewer
    std::vector<Cylinder> cylinders;
    std::vector<CylinderLook> cylinderLooks;  ///< same length as cylinders
    /// Lines of constant screen width for density maps. `radius` is minus half the width in pixels. They have no
    /// occlusion and cast no shadow. On the device they follow the cylinders.
    std::vector<Cylinder> wires;
    std::vector<CylinderLook> wireLooks;  ///< same length as wires
    std::vector<Triangle> triangles;      ///< of cartoons and surfaces
    std::vector<MeshVertex> meshVertices;
    std::vector<MeshRun> meshes;            ///< all triangles together, in their order
    std::vector<Triangle> coarseTriangles;  ///< of the meshes' levels; their numbers follow `triangles`
    std::vector<SphereLook> meshLooks;      ///< shared by vertices
    std::vector<SurfaceAtom> surfaceAtoms;  ///< of closed surfaces (mesh_caps.h)
    /// Triangles blend the colours of their corners; otherwise a point has that of the nearest corner.
    bool blendsColors = false;
    bool ownMaterials = false;              ///< some colours have their own material (engine/scene/color/colors.h)
    std::vector<std::uint32_t> atomGroups;  ///< of the file's atoms in their order (atom_groups.h), then of contacts
    Copies copies;                          ///< of an assembly; also relative to `center`
    std::shared_ptr<const Volume> volume;   ///< a density map drawn by rays (volume.h); null: none
    /// Models that are drawn together and do not occlude each other, in the order of the primitives; together they
    /// cover all. Empty: all primitives occlude.
    std::vector<ModelRun> sphereModels, cylinderModels, triangleModels;
    /// Centre of the axis-aligned box of the drawn atoms' centres, Å, in the file's frame; of all models of the file,
    /// if they share a camera.
    glm::dvec3 center{};
    double radius = 0;           ///< max(|p - center| + r) over the same spheres and the meshes' vertices, Å
    std::size_t drawnAtoms = 0;  ///< in all copies
    std::size_t drawnBonds = 0;
    Style style = Style::spacefill;     ///< where no rule sets one
    std::vector<Legend> legends;        ///< meaning of the colours
    std::vector<std::string> warnings;  ///< rules and schemes without effect, one sentence each
    std::vector<DrawnContact> contacts;
    std::uint32_t firstContact = 0;  ///< number of the first contact in looks; above every atom's

    /// The rows of a sphere that is an ellipsoid; else null.
    const EllipsoidRows* ellipsoid(std::size_t sphere) const {
        return sphere < ellipsoids.size() && ellipsoids[sphere].any() ? &ellipsoids[sphere] : nullptr;
    }
    /// Radius of the largest ball inside a sphere or ellipsoid, Å.
    float ballRadius(std::size_t sphere) const {
        const EllipsoidRows* rows = ellipsoid(sphere);
        return rows ? rows->inner() : spheres[sphere].radius;
    }
    /// The point of a sphere or ellipsoid with a normal.
    glm::vec3 pointOfBall(std::size_t sphere, const glm::vec3& normal) const {
        const EllipsoidRows* rows = ellipsoid(sphere);
        return spheres[sphere].center + (rows ? rows->place(normal) : spheres[sphere].radius * normal);
    }

    /// The contact with a look's number; null if the number is an atom's.
    const DrawnContact* findContact(std::uint32_t number) const {
        const bool any = !contacts.empty() && number >= firstContact && number - firstContact < contacts.size();
        return any ? &contacts[number - firstContact] : nullptr;
    }
    /// The 1-based note of a primitive that was joined to this (joinScenes()), by its number; 0 if it is not a note.
    std::uint32_t noteNumber(std::uint32_t number) const {
        return number > atomGroups.size() ? number - static_cast<std::uint32_t>(atomGroups.size()) : 0;
    }
    /// The 1-based atom with a look's number; for a contact its first atom.
    std::uint32_t findAtom(std::uint32_t number) const {
        const DrawnContact* contact = findContact(number);
        return contact ? contact->interaction.a.atoms.front() + 1 : number;
    }
};

/// A bond is drawn if both its atoms are and either has a style with bonds. It takes the stouter style of the two,
/// licorice before ball-and-stick, so that no stick changes its width halfway. In a space-filling atom it just ends.
/// Cartoons and surfaces are made separately for each model and each set of copies.
/// @param drawn  indices of drawn atoms (drawn_atoms.h), ascending; rules may hide some
/// An assembly stores atoms and bonds once, sorted by their copies. A bond is drawn where both its atoms are, and never
/// joins two copies. Interactions may: such a one is stored in the frame of the first of its two copies.
/// @param frame  the view's centre and radius (shared_frame.h), which contain all that is drawn; empty: computed from
/// that
/// @throws Error if no atom is left, there is no such assembly, it has 2^32 primitives or more, or they cover one
/// another more than 10,000 times
Representation represent(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                         const RepresentationOptions& options, const std::optional<Bounds>& frame = {});

/// A molecule whose atoms move. It is selected, styled and coloured once, by the first positions, and has one camera.
/// Selections by distance keep their first atoms.
class MovingScene {
public:
    /// As represent(). @throws Error for an assembly: its copies do not move
    MovingScene(const ResidueFacts& facts, std::span<const std::uint32_t> drawn, const RepresentationOptions& options,
                const std::optional<Bounds>& frame = {});

    /// Its centre is that of the first positions, or of the frame; its radius always holds every atom.
    const Representation& scene() const { return scene_; }
    /// @param molecule  the same molecule with other positions @throws Error as represent()
    void move(const Molecule& molecule);

private:
    void moveContacts(const Molecule& molecule, std::vector<PlacedContact> contacts);

    Representation scene_;
    Appearance appearance_;
    RepresentationOptions options_;
    ResidueFacts facts_;  ///< with the first positions
    std::optional<DrawnOrders> orders_;
    std::optional<ContactFinder> finder_;
    std::size_t mostSpheres_ = 0, mostCylinders_ = 0;  ///< maxima for contacts so far
};

}  // namespace nacre
