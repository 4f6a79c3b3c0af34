#pragma once
// The tree of a MolViewSpec scene: nodes with parameters and children. Its size is checked before use.
// Format: github.com/molstar/mol-view-spec, and the schema of Mol* 5.11.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace nacre::app::mvs {

using Json = nlohmann::json;

constexpr std::size_t kMostSceneBytes = std::size_t{32} << 20;  ///< of a scene's JSON
constexpr std::size_t kMostNodes = 100'000;
constexpr std::size_t kMostSnapshots = 10'000;

struct Node {
    std::string kind;
    Json params = Json::object();
    Json custom;  ///< extensions of the format: an object, or null
    std::vector<Node> children;
    std::string ref;    ///< for references from other nodes; may be empty
    std::string place;  ///< for messages: "root/download 1/parse 1"
    std::string fault;  ///< why it is invalid; such a node has no kind; empty: valid

    const Json* param(const char* name) const;
};

struct Snapshot {
    Node root;
    Node animation;  ///< without a kind: none
    std::string title;
    double lingerSeconds = 0, transitionSeconds = 0;
};

struct SceneTree {
    std::vector<Snapshot> snapshots;  ///< at least one
};

/// Whether a text may continue as a scene, by its beginning.
bool mayBeScene(std::string_view beginning);
/// Whether a text is a scene, by its first keys, without parsing it completely.
bool looksLikeScene(std::string_view text);

/// @param name  of the file, for messages @throws Error that names the place
SceneTree parseScene(const std::string& text, const std::string& name);

/// Parses a single node with its children, as in a file of primitives. @throws Error
Node parseNode(const std::string& text, const std::string& name);

}  // namespace nacre::app::mvs
