#include "app/mvs/instance_ids.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "app/mvs/split_copies.h"
#include "engine/error.h"
#include "engine/molecule/crystal.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

constexpr const char* kField = "instance_id";
constexpr std::size_t kMostInstanceIds = 1000, kLongestId = 200;

/// Collects the ids that the nodes of a scene name.
class NamedIds {
public:
    explicit NamedIds(SceneFiles& files) : files_(files) {}

    /// @param url  of the download above @throws Error if there are too many
    void add(const Node& node, const std::string& url) {
        files_.step();
        addNamed(node.params);
        if (node.kind.ends_with("_from_uri")) addFromFile(node, nodeText(node, "uri"));
        if (node.kind.ends_with("_from_source")) addFromFile(node, url);
        if (ids_.size() > kMostInstanceIds)
            throw Error("cannot draw scene", node.place,
                        "selectors name more than " + std::to_string(kMostInstanceIds) + " instances");
        for (const Node& child : node.children) add(child, node.kind == "download" ? nodeText(node, "url") : url);
    }
    std::set<std::string> take() { return std::move(ids_); }

private:
    void addId(const std::string& id) {
        if (id.size() <= kLongestId) ids_.insert(id);  // a longer one names no copy
    }
    void addNamed(const Json& value) {
        if (!value.is_structured() || ids_.size() > kMostInstanceIds) return;
        if (value.is_object())
            if (const auto id = value.find(kField); id != value.end() && id->is_string())
                addId(id->get_ref<const std::string&>());
        for (const auto& [key, inner] : value.items())
            if (key != "field_remapping") addNamed(inner);
    }
    const std::string& bytes(const std::string& uri) try { return files_.bytes(uri); } catch (const Error&) {
        failed_ = true;
        throw;
    }
    /// Adds the ids in the file that a node names. Faults are told where the node is drawn.
    void addFromFile(const Node& node, const std::string& uri) try {
        const bool primitives = node.kind == "primitives_from_uri";
        const std::string column = primitives ? kField : findColumn(node, kField);
        if (column.empty() || failed_) return;
        const auto [known, isNew] = mentions_.emplace(std::pair(uri, column), false);
        if (isNew) known->second = bytes(uri).find(column) != std::string::npos;
        if (!known->second || !read_.emplace(uri, primitives ? "" : node.params.dump()).second) return;
        if (primitives) {
            for (const Node& child : parseNode(files_.bytes(uri), uri).children) addNamed(child.params);
            return;
        }
        Structure ofFile;
        ofFile.uri = uri;
        for (const AnnotationRow& row : readRows(node, kField, ofFile, files_)) {
            if (ids_.size() > kMostInstanceIds) return;
            if (row.expression.instance) addId(*row.expression.instance);
        }
    } catch (const Error&) {
    }

    SceneFiles& files_;
    std::set<std::string> ids_;
    std::map<std::pair<std::string, std::string>, bool> mentions_;  ///< by file and column
    std::set<std::pair<std::string, std::string>> read_;            ///< files, with the nodes' parameters
    bool failed_ = false;  ///< a file cannot be read: the scene is refused where its node is drawn
};

/// The motions of these ids, "ASM-X0-5", by the operators of a file's assemblies.
std::map<std::string, glm::dmat4x3> assemblyMotions(const Molecule& molecule, const std::set<std::string>& ids) {
    std::map<std::string, glm::dmat4x3> motions;
    for (const Assembly& assembly : molecule.assemblies)
        for (const AssemblyPart& part : assembly.parts)
            for (std::size_t i = 0; i < part.operators.size(); ++i)
                if (const std::string id = "ASM-" + part.operators[i]; ids.contains(id))
                    motions.emplace(id, part.transforms[i]);
    return motions;
}

/// "3_655": an operation and its cells, each of one digit or "(-1)".
std::optional<glm::dmat4x3> motionInCrystal(std::string_view id, const Molecule& molecule) {
    const std::size_t line = id.find('_');
    const auto number = parseInteger(id.substr(0, line));
    if (line == std::string_view::npos || !number || *number < 1) return std::nullopt;
    std::string_view rest = id.substr(line + 1);
    std::array<int, 3> cells{};
    for (int& cell : cells) {
        const bool bracket = rest.starts_with("(");
        const std::size_t end = bracket ? rest.find(')') : 1;
        if (rest.empty() || end == std::string_view::npos) return std::nullopt;
        const auto digits = parseInteger(bracket ? rest.substr(1, end - 1) : rest.substr(0, 1));
        if (!digits || std::abs(*digits) > 1000) return std::nullopt;
        cell = static_cast<int>(*digits) - 5;
        rest.remove_prefix(bracket ? end + 1 : 1);
    }
    return crystalMotion(molecule, static_cast<std::size_t>(*number), cells);
}

bool isNearMotion(const glm::dmat4x3& a, const glm::dmat4x3& b) {
    constexpr double kNear = 0.01;  // Å, and of unit vectors
    for (int i = 3; i >= 0; --i)
        if (!(glm::length(a[i] - b[i]) < kNear)) return false;
    return true;
}

}  // namespace

std::set<std::string> namedInstances(const Node& root, SceneFiles& files) {
    NamedIds ids(files);
    ids.add(root, {});
    return ids.take();
}

void splitInstances(const Node& node, const std::set<std::string>& ids, Structure& s, SceneFiles& files) {
    if (ids.empty() || s.transforms.size() > kMostCopies) return;  // so many are refused when they are placed
    if (s.transforms.empty()) {
        s.instanceIds = {{"1_555"}};
        s.atoms = std::make_unique<StructureAtoms>(*s.molecule, s.instanceIds);
        return;
    }
    const bool assembly = nodeText(node, "type") == "assembly";
    std::map<std::string, glm::dmat4x3> motions;
    if (assembly) motions = assemblyMotions(*s.molecule, ids);
    Molecule empty;  // to find no middle of the atoms for each id
    empty.file = s.molecule->file;
    for (const std::string& id : ids)
        if (const auto motion = assembly ? std::nullopt : motionInCrystal(id, empty)) motions.emplace(id, *motion);
    std::vector<std::uint32_t> groups(s.transforms.size());
    std::uint32_t count = 1;
    std::vector<std::pair<const std::string*, std::vector<bool>>> found;  // ids, with their copies
    for (const auto& [id, motion] : motions) {
        files.step();
        std::vector<bool> near(groups.size());
        for (std::size_t i = 0; i < near.size(); ++i) near[i] = isNearMotion(motion, s.transforms[i]);
        if (std::ranges::find(near, true) == near.end()) continue;
        std::map<std::pair<std::uint32_t, bool>, std::uint32_t> parts;
        for (std::size_t i = 0; i < groups.size(); ++i)
            groups[i] = parts.emplace(std::pair(groups[i], bool(near[i])), static_cast<std::uint32_t>(parts.size()))
                            .first->second;
        count = static_cast<std::uint32_t>(parts.size());
        found.emplace_back(&id, std::move(near));
    }
    files.countCopied(node, (count - 1) * s.molecule->atoms.size());
    splitCopies(groups, count, s);
    std::uint32_t group = 0;  // they are in the order of their first copies
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i] != group) continue;
        for (const auto& [id, near] : found)
            if (near[i]) s.instanceIds[group].insert(*id);
        ++group;
    }
    s.atoms = std::make_unique<StructureAtoms>(*s.molecule, s.instanceIds);
}

}  // namespace nacre::app::mvs
