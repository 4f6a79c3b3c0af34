#include "app/mvs/scene_tree.h"

#include <algorithm>

#include "app/files/json_text.h"
#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

[[noreturn]] void refuseScene(const std::string& name, const std::string& why) {
    throw Error("cannot read scene", name, why);
}

std::string textAt(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double readSeconds(const Json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return 0;
    constexpr double kLongest = 3'600'000;  // ms
    const double ms = found->get<double>();
    return ms >= 0 && ms <= kLongest ? ms / 1000 : 0;
}

/// Converts a JSON tree to nodes, and counts them.
class TreeReader {
public:
    explicit TreeReader(const std::string& name) : name_(name) {}

    /// A node with a fault has no children.
    Node read(Json& json, const std::string& place) {
        if (++count_ > kMostNodes) refuseScene(name_, "it has more than " + std::to_string(kMostNodes) + " nodes");
        Node node;
        node.place = place;
        node.fault = findFault(json);
        if (!node.fault.empty()) return node;
        node.kind = json["kind"].get<std::string>();
        node.ref = textAt(json, "ref");
        if (const auto params = json.find("params"); params != json.end() && !params->is_null())
            node.params = std::move(*params);
        if (const auto custom = json.find("custom"); custom != json.end() && custom->is_object())
            node.custom = std::move(*custom);
        const auto children = json.find("children");
        if (children == json.end() || children->is_null()) return node;
        node.children.reserve(std::min(children->size(), kMostNodes));
        std::size_t number = 0;
        for (Json& child : *children) {
            const std::string kind = child.is_object() ? textAt(child, "kind") : "";
            node.children.push_back(read(
                child, place + "/" + nacre::printable(kind.empty() ? "node" : kind) + " " + std::to_string(++number)));
        }
        return node;
    }

private:
    static std::string findFault(const Json& json) {
        if (!json.is_object()) return "it is no object";
        if (const auto kind = json.find("kind"); kind == json.end() || !kind->is_string()) return "it has no \"kind\"";
        const auto params = json.find("params"), children = json.find("children");
        if (params != json.end() && !params->is_null() && !params->is_object()) return "its \"params\" are no object";
        const bool listed = children == json.end() || children->is_null() || children->is_array();
        return listed ? "" : "its \"children\" are no list";
    }

    const std::string& name_;
    std::size_t count_ = 0;
};

void takeMetadata(const Json& json, Snapshot& snapshot) {
    const auto metadata = json.find("metadata");
    if (metadata == json.end() || !metadata->is_object()) return;
    snapshot.title = textAt(*metadata, "title");
    const bool newer = metadata->contains("duration_ms");
    snapshot.lingerSeconds = readSeconds(*metadata, newer ? "duration_ms" : "linger_duration_ms");
    snapshot.transitionSeconds = readSeconds(*metadata, "transition_duration_ms");
}

Snapshot readSnapshot(Json& json, const std::string& place, TreeReader& reader, const std::string& name) {
    const auto root = json.is_object() ? json.find("root") : json.end();
    if (!json.is_object() || root == json.end()) refuseScene(name, place + " has no \"root\"");
    Snapshot snapshot;
    takeMetadata(json, snapshot);
    snapshot.root = reader.read(*root, place.empty() ? "root" : place + "/root");
    if (!snapshot.root.fault.empty()) refuseScene(name, snapshot.root.place + ": " + snapshot.root.fault);
    if (snapshot.root.kind != "root")
        refuseScene(name, "its root is a \"" + nacre::printable(snapshot.root.kind) + "\"");
    if (const auto animation = json.find("animation"); animation != json.end() && !animation->is_null())
        snapshot.animation = reader.read(*animation, place.empty() ? "animation" : place + "/animation");
    return snapshot;
}

Json parseSceneJson(const std::string& text, const std::string& name) {
    if (text.size() > kMostSceneBytes)
        refuseScene(name, "it is larger than " + std::to_string(kMostSceneBytes >> 20) + " MiB");
    Json json = parseJson<Json>(text);
    if (json.is_discarded()) refuseScene(name, isTooDeep(text) ? "it is nested too deep" : "it is no JSON");
    return json;
}

}  // namespace

const Json* Node::param(const char* name) const {
    const auto found = params.find(name);
    return found == params.end() || found->is_null() ? nullptr : &*found;
}

bool mayBeScene(std::string_view text) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos || text[start] != '{') return false;
    const std::size_t key = text.find_first_not_of(" \t\r\n", start + 1);
    // mmJSON begins with its data block, and may be large.
    return key != std::string_view::npos && !text.substr(key).starts_with("\"data_");
}

bool looksLikeScene(std::string_view text) {
    if (!mayBeScene(text)) return false;
    const bool tree = text.find("\"root\"") != std::string_view::npos;
    return tree && (text.find("\"kind\"") != std::string_view::npos);
}

Node parseNode(const std::string& text, const std::string& name) {
    Json json = parseSceneJson(text, name);
    Node node = TreeReader(name).read(json, name);
    if (!node.fault.empty()) refuseScene(name, node.fault);
    return node;
}

SceneTree parseScene(const std::string& text, const std::string& name) {
    Json json = parseSceneJson(text, name);
    if (!json.is_object()) refuseScene(name, "it is no scene: no object");
    SceneTree tree;
    TreeReader reader(name);
    const auto snapshots = json.find("snapshots");
    if (snapshots == json.end() || !snapshots->is_array()) {
        tree.snapshots.push_back(readSnapshot(json, "", reader, name));
        return tree;
    }
    if (snapshots->empty()) refuseScene(name, "it has no snapshots");
    if (snapshots->size() > kMostSnapshots)
        refuseScene(name, "it has more than " + std::to_string(kMostSnapshots) + " snapshots");
    for (Json& each : *snapshots)
        tree.snapshots.push_back(
            readSnapshot(each, "snapshot " + std::to_string(tree.snapshots.size() + 1), reader, name));
    return tree;
}

}  // namespace nacre::app::mvs
