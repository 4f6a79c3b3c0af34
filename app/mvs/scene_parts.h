#pragma once
// The parts of a scene while its tree is walked. Used by build_scene.cpp.

#include <functional>
#include <future>
#include <glm/mat4x3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/mvs/annotations.h"
#include "app/mvs/build_scene.h"
#include "app/mvs/expressions.h"
#include "app/mvs/mesh_files.h"
#include "app/mvs/node_table.h"
#include "engine/molecule/trajectory/trajectory.h"
#include "engine/scene/build/primitives.h"
#include "engine/scene/build/scene_guide.h"
#include "engine/volume/density_map.h"

namespace nacre::app::mvs {

/// Warnings of a scene, bounded in number.
class SceneWarnings {
public:
    void add(const Node& node, const std::string& why) { add(node.place + ": " + why); }
    void add(const std::string& text);
    std::vector<std::string> take();

private:
    static constexpr std::size_t kMost = 50;
    std::vector<std::string> texts_;
    std::set<std::string> known_;
    std::size_t more_ = 0;
};

/// Files, fetched once per name, even if that fails, and inflated. Limits atoms, maps and text read from them.
class SceneFiles {
public:
    explicit SceneFiles(const SceneSources& sources) : sources_(sources) {}
    /// @throws Error
    const std::string& bytes(const std::string& uri);
    /// A structure of a file. @param text  of the file, or of a part of it @throws Error
    Molecule molecule(const std::string& uri, std::string text, ReadOptions options);
    /// A map of a file, read once. @throws Error
    std::shared_ptr<const DensityMap> map(const std::string& uri, const std::string& channel);
    /// A mesh of a file. @param format  "obj", "ply" or "vtp" @throws Error
    Primitives::Mesh mesh(const std::string& uri, const std::string& format, const MeshColoring& coloring);
    /// Records the file of a coordinates node. @param ref  of the node
    void addCoordinates(const std::string& ref, const std::string& uri) { coordinates_.emplace(ref, uri); }
    bool hasCoordinates(const std::string& ref) const { return coordinates_.contains(ref); }
    /// Positions of atoms in a frame of a coordinates node. @param frame  from 0 @throws Error
    std::vector<glm::vec3> positions(const std::string& ref, std::size_t frame, std::size_t atoms);
    /// Counts atoms of a copied structure, as if they were read again. @throws Error if there are too many
    void countCopied(const Node& node, std::size_t atoms);
    /// Counts atoms of a representation, a label or a tooltip. @throws Error if there are too many
    void countShown(const std::string& place, std::size_t atoms);
    /// Call before each node.
    void step() const {
        if (sources_.onStep) sources_.onStep();
    }
    const SceneSources& sources() const { return sources_; }

private:
    void countParsed(const std::string& uri, std::size_t bytes);

    const SceneSources& sources_;
    std::map<std::string, std::shared_future<std::string>> files_;
    std::map<std::string, std::string> coordinates_;
    std::map<std::string, std::unique_ptr<Trajectory>> trajectories_;  ///< by name
    /// By name and channel.
    std::map<std::pair<std::string, std::string>, std::shared_future<std::shared_ptr<const DensityMap>>> maps_;
    std::size_t held_ = 0, parsed_ = 0, atoms_ = 0, shown_ = 0, mapBytes_ = 0;
};

/// One structure node: a separate molecule until all are joined.
struct Structure {
    std::string uri;  ///< of its file
    std::unique_ptr<Molecule> molecule;
    std::unique_ptr<StructureAtoms> atoms;
    std::vector<glm::dmat4x3> transforms;           ///< of copies; empty: it stays in place
    std::vector<std::vector<std::uint32_t>> lists;  ///< of transforms
    std::vector<std::uint32_t> listOfResidue;       ///< UINT32_MAX: not shown; empty: all residues have the first list
    /// Ids of copies, by group of copies: each group has atoms of its own, one group after the other (split_copies.h).
    std::vector<std::set<std::string>> instanceIds = std::vector<std::set<std::string>>(1);
    glm::dmat4x3 moved{1.0};              ///< by transform nodes, after `transforms`
    std::vector<glm::dmat4x3> instances;  ///< from instance nodes, applied after `moved`
    std::vector<SceneLayer> layers;       ///< of its own atoms
    std::vector<SceneLayer> framed;       ///< for the camera: before clips and opacity, without colours
    struct Text {
        std::vector<std::uint32_t> atoms;  ///< ascending
        std::string text;
        const Node* source = nullptr;  ///< of a list of texts; null: from a node of its own
    };
    std::vector<Text> labels, tooltips;
    const Node* representation = nullptr;  ///< its first one: labels have its colours
    std::string ref;
    std::optional<std::size_t> original;  ///< the structure that this one was separated from: it has the same tooltips

    /// The same atoms at the same places, without layers and texts.
    Structure copied() const;
};

/// Ratio of Mol*'s cartoon widths to those in other pictures.
constexpr double kCartoonScale = 0.8;

/// A text parameter; empty if it is none.
std::string nodeText(const Node& node, const char* name);

/// A colour as MolViewSpec writes it, packed; empty if it is none.
std::optional<std::uint32_t> readColor(const Json* value);

/// Reads the structure that a node selects. @throws Error
Structure readStructure(const Node& parse, const Node& node, const std::string& uri, SceneFiles& files,
                        SceneWarnings& warnings);

/// Reads the transform and instance nodes of a structure, or of a component. @param atoms  whose centroid they may turn
/// about, in all copies @throws Error
void takeMotions(const Node& node, Structure& structure, const std::vector<std::uint32_t>& atoms);

/// The motions of a shape or volume: by its transform nodes, then by each of its instances. @param center  of what it
/// moves @throws Error
std::vector<glm::dmat4x3> readMotions(const Node& node, const glm::dvec3& center);

/// Applies `second`, then `first`.
glm::dmat4x3 joinedMotion(const glm::dmat4x3& first, const glm::dmat4x3& second);

/// The layer of a representation node, before its clips. Adds it to those for the camera. @param atoms  of the
/// component, ascending @returns empty: there is no such representation
std::optional<SceneLayer> readRepresentation(const Node& node, const std::vector<std::uint32_t>& atoms,
                                             Structure& structure, SceneFiles& files, SceneWarnings& warnings);

/// Reads the colour and opacity nodes of a shape, or of a map's representation; others are only checked.
void takeLook(const Node& node, std::uint32_t& color, double& opacity, SceneWarnings& warnings);

/// Colours of all atoms of the structure by a representation's nodes.
std::vector<std::uint32_t> colorsOfAll(const Node& representation, const Structure& structure, SceneFiles& files);

/// The atoms of a selector: a name, an expression, or a list of expressions. By atom.
std::vector<bool> selected(const Node& node, const Json* selector, const Structure& structure, SceneWarnings& warnings);

/// The rows of an annotation node: *_from_uri or *_from_source. @param field  default for the first value @param
/// further  fields of the other values
std::vector<AnnotationRow> readRows(const Node& node, const char* field, const Structure& structure, SceneFiles& files,
                                    std::vector<std::string> further = {});
/// The column that a node uses for a field of the schema; empty: it ignores the field.
std::string findColumn(const Node& node, const std::string& field);

/// The texts of label_from_* and tooltip_from_*, with their atoms: one for each group of rows, by its first row.
/// @param field  default field of the text
std::vector<std::pair<std::string, std::vector<bool>>> readTextGroups(const Node& node, const char* field,
                                                                      const Structure& structure, SceneFiles& files,
                                                                      SceneWarnings& warnings);

/// Warns about a node that is unsupported in its place, and about unknown parameters.
void tellUnknown(const Node& node, const Node& parent, SceneWarnings& warnings);
/// Warns about parameters that the node's row does not list.
void tellUnused(const Node& node, const NodeRow& row, SceneWarnings& warnings);

/// Drops the other atoms of a layer. @param keeps  by index in the layer
void keepAtoms(SceneLayer& layer, const std::function<bool(std::size_t)>& keeps);

constexpr double kEmOfSize = 0.6;  ///< em of a label of size 1, Å: measured in Mol*'s pictures

/// The label of some atoms, in the midst of all copies, sized like Mol*'s: by the cube root of their number.
/// @param atoms  of the structure, ascending, at least one @param depth  Å from its position to the farthest atom
Primitives::Label makeLabel(const std::string& text, const std::vector<std::uint32_t>& atoms,
                            const Structure& structure, std::optional<std::uint32_t> color, double& depth);

inline bool hasCopies(const Structure& s) { return s.transforms.size() > 1 || s.instances.size() > 1; }

/// Motions of a copy of a structure: by its transforms, then by each of its instances.
std::vector<glm::dmat4x3> listMotions(const Structure& structure, const glm::dmat4x3& copy);

/// The first position of a structure's atoms: by its copies, transforms and instances.
glm::dmat4x3 findFirstMotion(const Structure& structure);

/// The copies that show a residue: an index into Structure::lists; UINT32_MAX: none.
std::uint32_t listOfCopies(const Structure& structure, std::uint32_t residue);

/// Balls around atoms, in all copies; around their extreme points if there are many.
/// @param scale  of their van der Waals radii
std::vector<glm::dvec4> placedBalls(const Structure& structure, const std::vector<std::uint32_t>& atoms, double scale);

/// Escapes plain text so that labels do not read it as markup.
std::string withoutMarkup(std::string_view text);

}  // namespace nacre::app::mvs
