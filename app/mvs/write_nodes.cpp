#include "app/mvs/write_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/scene/color/palettes.h"

namespace nacre::app::mvs {
namespace {

double rounded(double x) { return std::round(x * 1e6) / 1e6; }

constexpr const char *kEnds[] = {"start", "end"}, *kCorners[] = {"a", "b", "c"};

/// The format of a map for a parse node.
const char* sceneFormat(const DensityMap& map) {
    if (map.format == "dx") return "dx";
    return map.format == "density-server" ? "bcif" : "map";
}

}  // namespace

Out makeNode(const char* kind, Out params) {
    Out node{{"kind", kind}};
    if (!params.empty()) node["params"] = std::move(params);
    return node;
}

Out toList(const glm::dvec3& v) { return Out::array({rounded(v.x), rounded(v.y), rounded(v.z)}); }

Out makeNode(const char* kind, Out params, Out child) {
    Out node = makeNode(kind, std::move(params));
    node["children"] = Out::array({std::move(child)});
    return node;
}

Out cameraNode(const SceneCamera& camera) {
    // In Mol*, a ball of half the distance fills the picture.
    const glm::dvec3 position = camera.target - glm::normalize(camera.direction) * (2 * camera.radius);
    return makeNode("camera",
                    {{"target", toList(camera.target)}, {"position", toList(position)}, {"up", toList(camera.up)}});
}

Out canvasNode(const PictureDescription& picture) {
    std::uint32_t background = 0;
    for (std::size_t i = 0; i < 3; ++i)
        background |= static_cast<std::uint32_t>(std::lround(picture.background[i] * 255.0f)) << (8 * i);
    return makeNode("canvas", {{"background_color", colorText(background)}});
}

Out Expressions::of(const std::vector<std::uint32_t>& atoms) const {
    if (atoms.size() == molecule_.atoms.size()) return "all";
    Out list = Out::array();
    for (std::size_t i = 0; i < atoms.size();) {
        const std::uint32_t residue = molecule_.atoms[atoms[i]].residue;
        std::size_t end = i;
        while (end < atoms.size() && molecule_.atoms[atoms[end]].residue == residue) ++end;
        if (end - i == molecule_.residues[residue].atomCount)
            addResidue(molecule_.residues[residue], list);
        else
            for (; i < end; ++i) list.push_back({{"atom_index", atoms[i]}});
        i = end;
    }
    return list.size() == 1 ? list.front() : list;
}

void Expressions::addResidue(const Residue& residue, Out& list) const {
    const std::string& chain = molecule_.chains[residue.chain].name;
    if (residue.insertionCode) {
        list.push_back({{"auth_asym_id", chain},
                        {"auth_seq_id", residue.number},
                        {"pdbx_PDB_ins_code", std::string(1, residue.insertionCode)}});
        return;
    }
    if (!list.empty() && list.back().contains("end_auth_seq_id") && list.back()["auth_asym_id"] == chain) {
        const std::int64_t last = list.back()["end_auth_seq_id"].get<std::int64_t>();
        if (residue.number == last || residue.number == last + 1) {
            list.back()["end_auth_seq_id"] = residue.number;
            return;
        }
    }
    list.push_back({{"auth_asym_id", chain}, {"beg_auth_seq_id", residue.number}, {"end_auth_seq_id", residue.number}});
}

Out volumeNode(const SceneVolume& volume, const std::string& address) {
    Out params;
    if (volume.axis >= 0)
        params = {{"type", "grid_slice"},
                  {"dimension", std::string(1, static_cast<char>('x' + volume.axis))},
                  {"relative_index", rounded(volume.place)},
                  {"absolute_isovalue", volume.least.value_or(volume.map->statistics.min)}};
    else
        params = {{"type", "isosurface"},
                  {"absolute_isovalue", volume.level},
                  {"show_wireframe", volume.wires},
                  {"show_faces", volume.faces}};
    Out shown =
        makeNode("volume_representation", std::move(params), makeNode("color", {{"color", colorText(volume.color)}}));
    if (volume.opacity < 1) shown["children"].push_back(makeNode("opacity", {{"opacity", rounded(volume.opacity)}}));
    Out parse = makeNode("parse", {{"format", sceneFormat(*volume.map)}}, makeNode("volume", {}, std::move(shown)));
    return makeNode("download", {{"url", address}}, std::move(parse));
}

Out measureNode(const ResidueFacts& facts, const PictureDescription& picture, std::size_t& left) {
    Out group = makeNode("primitives", {});
    group["children"] = Out::array();
    for (const Measure& measure : picture.words.measures) {
        Out params = {{"kind", measure.points.size() == 2 ? "distance_measurement" : "angle_measurement"}};
        const std::span<const char* const> names =
            measure.points.size() == 2 ? std::span<const char* const>(kEnds) : std::span<const char* const>(kCorners);
        if (measure.points.size() > names.size()) {
            ++left;
            continue;
        }
        for (std::size_t i = 0; i < measure.points.size(); ++i) {
            const std::vector<bool> chosen = selectAtoms(facts, measure.points[i]);
            const auto atom = std::find(chosen.begin(), chosen.end(), true) - chosen.begin();
            params[names[i]] = {{"atom_index", atom}};
        }
        group["children"].push_back(makeNode("primitive", std::move(params)));
    }
    return group["children"].empty() ? Out() : group;
}

}  // namespace nacre::app::mvs
