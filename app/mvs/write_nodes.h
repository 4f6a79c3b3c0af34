#pragma once
// Nodes of a scene to be written.

#include <cstdint>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/picture/description.h"
#include "engine/molecule/residue_facts.h"
#include "engine/scene/build/scene_guide.h"

namespace nacre::app::mvs {

using Out = nlohmann::ordered_json;

Out makeNode(const char* kind, Out params);
/// A node with one child.
Out makeNode(const char* kind, Out params, Out child);
Out toList(const glm::dvec3& v);
Out cameraNode(const SceneCamera& camera);
Out canvasNode(const PictureDescription& picture);

/// Expressions for atoms by the authors' names: whole residues as ranges of numbers, other atoms by index.
class Expressions {
public:
    explicit Expressions(const Molecule& molecule) : molecule_(molecule) {}
    Out of(const std::vector<std::uint32_t>& atoms) const;

private:
    void addResidue(const Residue& residue, Out& list) const;
    const Molecule& molecule_;
};

/// A download node of a map, with its representations. @param address  of its file
Out volumeNode(const SceneVolume& volume, const std::string& address);

/// The measurements of a picture as primitives; null: none. @param left  counts omitted ones
Out measureNode(const ResidueFacts& facts, const PictureDescription& picture, std::size_t& left);

}  // namespace nacre::app::mvs
