#include "app/mvs/scene_volumes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "app/mvs/clip_nodes.h"
#include "app/mvs/primitive_values.h"
#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

constexpr std::uint32_t kVolumeColor = 0xffffffffu;

std::optional<double> readValue(const Node& node, const char* name, SceneWarnings& warnings) {
    const Json* value = node.param(name);
    if (!value) return std::nullopt;
    if (value->is_number() && std::isfinite(value->get<double>())) return value->get<double>();
    warnings.add(node, std::string(name) + " is no number");
    return std::nullopt;
}

/// The map at another position; shares its values.
std::shared_ptr<const DensityMap> movedMap(const std::shared_ptr<const DensityMap>& map, const glm::dmat4x3& motion) {
    auto moved = std::make_shared<DensityMap>(*map);
    moved->origin = motion * glm::dvec4(map->origin, 1.0);
    moved->step = glm::dmat3(motion[0], motion[1], motion[2]) * map->step;
    return moved;
}

/// A ball around a box of nodes, from the axis-aligned box that contains it.
Bounds boundsOfNodes(const DensityMap& map, const glm::dvec3& low, const glm::dvec3& high) {
    Box box;
    for (int corner = 0; corner < 8; ++corner)
        box.add(map.place({corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z}));
    return {(box.low + box.high) / 2.0, glm::length(box.high - box.low) / 2};
}

Bounds boundsOfBox(const DensityMap& map) {
    const glm::dvec3 first(map.firstNode());
    return boundsOfNodes(map, first, first + glm::dvec3(map.boxSize));
}

/// The ball around a contour by Mol*'s rules: around the box of the nodes that reach its level, plus one node on each
/// side. Higher values, or lower ones for a negative level. Empty if no node reaches it.
std::optional<Bounds> boundsOfContour(const DensityMap& map, double level) {
    const glm::ivec3 first = map.firstNode(), size = map.boxSize;
    glm::ivec3 low = size, high(-1);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                glm::ivec3 node = first + glm::ivec3(x, y, z);
                if (map.periodic)
                    for (int i = 0; i < 3; ++i) node[i] = ((node[i] % map.size[i]) + map.size[i]) % map.size[i];
                const double value = static_cast<double>(map.values[map.index(node)]);
                if (!(level < 0 ? value <= level : value >= level)) continue;
                low = glm::min(low, glm::ivec3(x, y, z));
                high = glm::max(high, glm::ivec3(x, y, z));
            }
    if (high.x < 0) return std::nullopt;
    return boundsOfNodes(map, glm::dvec3(first + low - 1), glm::dvec3(first + high + 1));
}

/// One volume node while it is read.
class VolumeReader {
public:
    VolumeReader(const Node& node, const SceneFiles& files, SceneGuide& guide, CameraNodes& camera,
                 SceneWarnings& warnings)
        : node_(node), files_(files), guide_(guide), camera_(camera), warnings_(warnings) {}

    void read(const std::shared_ptr<const DensityMap>& file) {
        place(file);
        std::vector<const Node*> focuses;
        std::vector<glm::dvec4> all;
        for (const Node& child : node_.children) {
            tellUnknown(child, node_, warnings_);
            if (child.kind == "focus") focuses.push_back(&child);
            if (child.kind != "volume_representation") continue;
            const std::vector<glm::dvec4> balls = representation(child);
            all.insert(all.end(), balls.begin(), balls.end());
            for (const Node& inner : child.children)
                if (inner.kind == "focus") camera_.takeFocus(inner, balls);
        }
        for (const Node* focus : focuses) camera_.takeFocus(*focus, all);
    }

private:
    void place(const std::shared_ptr<const DensityMap>& file) {
        const std::vector<glm::dmat4x3> motions = readMotions(node_, boundsOfBox(*file).center);
        if (motions.size() > kMostVolumes)
            throw Error("cannot draw scene", node_.place,
                        "it has more than " + std::to_string(kMostVolumes) + " instances");
        for (const glm::dmat4x3& motion : motions) {
            files_.step();
            maps_.push_back(motion == glm::dmat4x3(1.0) ? file : movedMap(file, motion));
        }
    }

    /// @returns balls around what it shows
    std::vector<glm::dvec4> representation(const Node& node) {
        const std::string type = nodeText(node, "type");
        const NodeRow* row = nodeRow("volume_representation:" + type);
        if (!row) {
            warnings_.add(node, "there is no representation '" + nacre::printable(type) + "' of maps: it is left out");
            return {};
        }
        tellUnused(node, *row, warnings_);
        SceneVolume volume;
        volume.color = kVolumeColor;
        takeLook(node, volume.color, volume.opacity, warnings_);
        const bool slice = type == "grid_slice";
        if (slice ? !setSlice(node, volume) : !setContour(node, volume)) return {};
        const ClipRegions regions(node, warnings_);
        if (!regions.empty()) volume.cuts = [regions](const glm::dvec3& place) { return regions.cuts(place); };
        std::vector<glm::dvec4> balls;
        for (const auto& map : maps_) {
            files_.step();
            if (guide_.volumes.size() == kMostVolumes)
                throw Error("cannot draw scene", node.place,
                            "it has more than " + std::to_string(kMostVolumes) + " representations of maps");
            volume.map = map;
            const auto ball = slice ? boundsOfBox(*map) : boundsOfContour(*map, volume.level);
            if (!ball) {
                warnings_.add(node, "no value of the map reaches its isovalue");
                continue;
            }
            volume.ball = *ball;
            balls.emplace_back(ball->center, ball->radius);
            guide_.volumes.push_back(volume);
        }
        return balls;
    }

    /// The mean of the map, unless the node says otherwise.
    double isovalue(const Node& node) {
        const MapStatistics& statistics = maps_.front()->statistics;
        const double relative = readValue(node, "relative_isovalue", warnings_).value_or(0);
        return readValue(node, "absolute_isovalue", warnings_).value_or(statistics.mean + relative * statistics.rms);
    }

    bool setContour(const Node& node, SceneVolume& volume) {
        volume.level = isovalue(node);
        volume.wires = flag(node, "show_wireframe", false);
        volume.faces = flag(node, "show_faces", true);
        return (volume.wires || volume.faces) && volume.opacity > 0;
    }

    bool setSlice(const Node& node, SceneVolume& volume) {
        const std::string dimension = nodeText(node, "dimension");
        if (dimension != "x" && dimension != "y" && dimension != "z") {
            warnings_.add(node, "its dimension is none of x, y and z: it is left out");
            return false;
        }
        volume.axis = dimension[0] - 'x';
        const int last = std::max(maps_.front()->boxSize[volume.axis] - 1, 1);
        const auto share = readValue(node, "relative_index", warnings_);
        const auto index = readValue(node, "absolute_index", warnings_);
        const double slice = share ? std::round(*share * last) : index.value_or(0);
        volume.place = std::clamp(slice / last, 0.0, 1.0);
        volume.least = isovalue(node);
        return volume.opacity > 0;
    }

    const Node& node_;
    const SceneFiles& files_;
    SceneGuide& guide_;
    CameraNodes& camera_;
    SceneWarnings& warnings_;
    std::vector<std::shared_ptr<const DensityMap>> maps_;
};

}  // namespace

void addVolume(const Node& node, const std::string& uri, SceneFiles& files, SceneGuide& guide, CameraNodes& camera,
               SceneWarnings& warnings) {
    files.bytes(uri);  // throws, which ends the scene, if it cannot be fetched
    std::shared_ptr<const DensityMap> map;
    try {
        map = files.map(uri, nodeText(node, "channel_id"));
    } catch (const Error& error) {
        return warnings.add(node, std::string("it is left out: ") + error.what());
    }
    for (const std::string& warning : map->warnings) warnings.add(node, warning);
    VolumeReader(node, files, guide, camera, warnings).read(map);
}

}  // namespace nacre::app::mvs
