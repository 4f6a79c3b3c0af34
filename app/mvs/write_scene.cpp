#include "app/mvs/write_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>

#include "app/files/json_text.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

using Out = nlohmann::ordered_json;

Out nodeOf(const char* kind, Out params) {
    Out node{{"kind", kind}};
    if (!params.empty()) node["params"] = std::move(params);
    return node;
}

std::string hexOf(std::uint32_t color) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", color & 0xff, color >> 8 & 0xff, color >> 16 & 0xff);
    return text;
}

Out listOf(const glm::dvec3& v) {
    const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6; };
    return Out::array({rounded(v.x), rounded(v.y), rounded(v.z)});
}

const char* typeOf(Style style) {
    switch (style) {
        case Style::spacefill:
            return "spacefill";
        case Style::cartoon:
            return "cartoon";
        case Style::surface:
            return "surface";
        case Style::line:
            return "line";
        case Style::backbone:
            return "backbone";
        case Style::carbohydrate:
            return "carbohydrate";
        case Style::ballAndStick:
        case Style::licorice:
            break;
    }
    return "ball_and_stick";
}

/// Expressions of atoms by the authors' names: whole residues in ranges of their numbers, other atoms by their places.
class Expressions {
public:
    Expressions(const Molecule& molecule, std::size_t atoms) : molecule_(molecule), all_(atoms) {}

    Out of(const std::vector<std::uint32_t>& atoms) const {
        if (atoms.size() == all_) return "all";
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

private:
    void addResidue(const Residue& residue, Out& list) const {
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
        list.push_back(
            {{"auth_asym_id", chain}, {"beg_auth_seq_id", residue.number}, {"end_auth_seq_id", residue.number}});
    }

    const Molecule& molecule_;
    std::size_t all_;
};

/// Colours of a layer: the most frequent one for all, the others for their atoms.
void addColors(const SceneLayer& layer, const Expressions& expressions, Out& children) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> byColor;
    for (std::size_t i = 0; i < layer.atoms.size(); ++i)
        byColor[layer.colors[i] | 0xff000000u].push_back(layer.atoms[i]);
    const auto most = std::max_element(byColor.begin(), byColor.end(),
                                       [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    children.push_back(nodeOf("color", {{"color", hexOf(most->first)}}));
    for (const auto& [color, atoms] : byColor)
        if (color != most->first)
            children.push_back(nodeOf("color", {{"selector", expressions.of(atoms)}, {"color", hexOf(color)}}));
}

Out componentOf(const SceneLayer& layer, const Expressions& expressions) {
    Out children = Out::array();
    addColors(layer, expressions, children);
    if (!layer.opacity.empty() && layer.opacity.front() < 1)
        children.push_back(
            nodeOf("opacity", {{"opacity", std::round(static_cast<double>(layer.opacity.front()) * 1e3) / 1e3}}));
    Out params{{"type", layer.cartoon.putty && layer.style == Style::cartoon ? "putty" : typeOf(layer.style)}};
    if (layer.style == Style::cartoon && layer.cartoon.helices != HelixForm::ribbon) params["tubular_helices"] = true;
    Out representation = nodeOf("representation", std::move(params));
    representation["children"] = std::move(children);
    Out component = nodeOf("component", {{"selector", expressions.of(layer.atoms)}});
    component["children"] = Out::array({std::move(representation)});
    return component;
}

const char* formatOf(const Molecule& molecule) {
    const std::string& format = molecule.file.format;
    if (format == "bcif") return "bcif";
    return format == "pdb" ? "pdb" : "mmcif";
}

std::vector<std::string> notesOf(const PictureDescription& d, const Molecule& molecule,
                                 std::span<const SceneLayer> layers) {
    std::vector<std::string> notes;
    const auto add = [&](bool there, const char* what) {
        if (there) notes.push_back(std::string(what) + " are left out: MolViewSpec has no words for them");
    };
    const Effects& e = d.effects;
    add(e.contours.width > 0 || e.halos.width > 0, "outlines and halos");
    add(e.fog.range != Fog::Range::off || e.shadow.strength > 0, "fog and shadows");
    add(e.clip.on(), "clipping planes");
    add(!d.words.measures.empty() || d.words.legend || d.words.scaleBar != ScaleBar::off,
        "measurements, legend and scale bar");
    add(d.look.contacts.of.has_value(), "interactions");
    add(!d.maps.files.empty(), "density maps");
    add(!d.input.further.empty(), "further INPUTs");
    add(!d.input.trajectory.path.empty(), "trajectories");
    add(std::any_of(layers.begin(), layers.end(),
                    [](const SceneLayer& layer) { return layer.style == Style::licorice; }),
        "the widths of licorice");
    const std::string& format = molecule.file.format;
    if (format != "pdb" && format != "mmcif" && format != "bcif")
        notes.push_back("other programs may not read " + format + " from a scene");
    return notes;
}

}  // namespace

std::string addressOf(const std::string& input) {
    if (input.starts_with("pdb:")) return "https://files.wwpdb.org/download/" + lowerCase(input.substr(4)) + ".cif";
    if (input.starts_with("afdb:"))
        return "https://alphafold.ebi.ac.uk/files/AF-" + upperCase(input.substr(5)) + "-F1-model_v4.cif";
    return std::filesystem::path(input).filename().generic_string();
}

WrittenScene writeScene(const ResidueFacts& facts, const PictureDescription& d, std::span<const SceneLayer> layers,
                        const std::optional<SceneCamera>& camera) {
    const Molecule& molecule = facts.molecule();
    const Expressions expressions(molecule, molecule.atoms.size());
    Out structureParams{{"type", d.look.assembly.empty() ? "model" : "assembly"}};
    if (!d.look.assembly.empty()) structureParams["assembly_id"] = d.look.assembly;
    if (d.input.model > 1) structureParams["model_index"] = d.input.model - 1;
    Out structure = nodeOf("structure", std::move(structureParams));
    structure["children"] = Out::array();
    for (const SceneLayer& layer : layers)
        if (!layer.atoms.empty()) structure["children"].push_back(componentOf(layer, expressions));
    for (const Label& label : d.words.labels) {
        if (label.text.find('{') != std::string::npos) continue;
        const std::vector<bool> chosen = selectAtoms(facts, label.selection);
        std::vector<std::uint32_t> atoms;
        for (std::uint32_t i = 0; i < chosen.size(); ++i)
            if (chosen[i]) atoms.push_back(i);
        Out component = nodeOf("component", {{"selector", expressions.of(atoms)}});
        component["children"] = Out::array({nodeOf("label", {{"text", label.text}})});
        if (!atoms.empty()) structure["children"].push_back(std::move(component));
    }
    Out parse = nodeOf("parse", {{"format", formatOf(molecule)}});
    parse["children"] = Out::array({std::move(structure)});
    Out download = nodeOf("download", {{"url", addressOf(d.input.path)}});
    download["children"] = Out::array({std::move(parse)});
    Out root = nodeOf("root", {});
    root["children"] = Out::array({std::move(download)});
    std::uint32_t background = 0;
    for (std::size_t i = 0; i < 3; ++i)
        background |= static_cast<std::uint32_t>(std::lround(d.background[i] * 255.0f)) << (8 * i);
    root["children"].push_back(nodeOf("canvas", {{"background_color", hexOf(background)}}));
    if (camera)
        root["children"].push_back(nodeOf(
            "camera", {{"target", listOf(camera->target)},
                       {"position", listOf(camera->target - glm::normalize(camera->direction) * (2 * camera->radius))},
                       {"up", listOf(camera->up)}}));
    Out metadata{{"version", "1.2"}};
    if (!d.words.title.empty()) metadata["title"] = d.words.title;
    WrittenScene written;
    written.json = jsonText({{"kind", "single"}, {"root", std::move(root)}, {"metadata", std::move(metadata)}});
    written.notes = notesOf(d, molecule, layers);
    if (std::any_of(d.words.labels.begin(), d.words.labels.end(),
                    [](const Label& label) { return label.text.find('{') != std::string::npos; }))
        written.notes.push_back("labels with fields are left out");
    return written;
}

}  // namespace nacre::app::mvs
