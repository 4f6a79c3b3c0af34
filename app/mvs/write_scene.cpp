#include "app/mvs/write_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "app/files/json_text.h"
#include "app/mvs/scene_file.h"
#include "app/mvs/scene_parts.h"
#include "app/mvs/write_nodes.h"
#include "app/picture/option_text.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/text.h"
#include "engine/scene/build/scene_layers.h"
#include "engine/scene/color/palettes.h"

namespace nacre::app::mvs {
namespace {

const char* representationType(Style style) {
    const bool sticks = style == Style::ballAndStick || style == Style::licorice || style == Style::ellipsoids;
    return sticks ? "ball_and_stick" : styleName(style);
}

/// Colours of a layer: the most frequent one for all, the others for their atoms.
void addColors(const SceneLayer& layer, const Expressions& expressions, Out& children) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> byColor;
    for (std::size_t i = 0; i < layer.atoms.size(); ++i)
        byColor[layer.colors[i] | 0xff000000u].push_back(layer.atoms[i]);
    const auto most = std::max_element(byColor.begin(), byColor.end(),
                                       [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    children.push_back(makeNode("color", {{"color", colorText(most->first)}}));
    for (const auto& [color, atoms] : byColor)
        if (color != most->first)
            children.push_back(makeNode("color", {{"selector", expressions.of(atoms)}, {"color", colorText(color)}}));
}

Out makeComponent(const SceneLayer& layer, const Expressions& expressions) {
    Out children = Out::array();
    addColors(layer, expressions, children);
    if (!layer.opacity.empty() && layer.opacity.front() < 1)
        children.push_back(
            makeNode("opacity", {{"opacity", std::round(static_cast<double>(layer.opacity.front()) * 1e3) / 1e3}}));
    Out params{
        {"type", layer.cartoon.putty && layer.style == Style::cartoon ? "putty" : representationType(layer.style)}};
    if (layer.style == Style::cartoon && layer.cartoon.helices != HelixForm::ribbon) params["tubular_helices"] = true;
    if (layer.style == Style::cartoon) {
        const CartoonOptions& cartoon = layer.cartoon;
        if (cartoon.putty)
            params["size_theme"] = cartoon.tube > 0 && cartoon.tubePerTemperature == 0 ? "uniform" : "uncertainty";
        params["size_factor"] = std::round(cartoon.scale / (cartoon.putty ? 1 : kCartoonScale) * 1e3) / 1e3;
    }
    Out representation = makeNode("representation", std::move(params));
    representation["children"] = std::move(children);
    return makeNode("component", {{"selector", expressions.of(layer.atoms)}}, std::move(representation));
}

bool hasFields(const Label& label) { return label.text.find('{') != std::string::npos; }

const char* sceneFormat(const Molecule& molecule) {
    const std::string& format = molecule.file.format;
    if (format == "bcif") return "bcif";
    return format == "pdb" ? "pdb" : "mmcif";
}

/// Adds labels without fields, each for all its atoms together.
void addLabels(const ResidueFacts& facts, const PictureDescription& d, const Expressions& expressions, Out& children) {
    for (const Label& label : d.words.labels) {
        if (hasFields(label)) continue;
        const std::vector<bool> chosen = selectAtoms(facts, label.selection);
        std::vector<std::uint32_t> atoms;
        for (std::uint32_t i = 0; i < chosen.size(); ++i)
            if (chosen[i]) atoms.push_back(i);
        if (!atoms.empty())
            children.push_back(makeNode("component", {{"selector", expressions.of(atoms)}},
                                        makeNode("label", {{"text", label.text}})));
    }
}

/// Notes about options that no scene can express.
std::vector<std::string> listNotes(const PictureDescription& d) {
    std::vector<std::string> notes;
    const auto add = [&](bool there, const char* what) {
        if (there) notes.push_back("MolViewSpec cannot store " + std::string(what));
    };
    const Effects& e = d.effects;
    add(e.contours.width > 0 || e.halos.width > 0, "outlines and halos");
    add(e.fog.range != Fog::Range::off || e.shadow.strength > 0, "fog and shadows");
    add(e.clip.on(), "clipping planes");
    add(e.depthOfField.strength > 0, "depth of field and its focus");
    add(d.words.legend || d.words.axes || d.words.scaleBar != ScaleBar::off, "legends, axes and scale bars");
    add(d.look.contacts.of.has_value(), "interactions");
    add(!d.input.further.empty(), "more than one structure");
    add(!d.input.trajectory.path.empty(), "trajectories");
    add(!d.primitives.empty() || d.cell, "geometry");
    return notes;
}

std::vector<std::string> listNotes(const PictureDescription& d, const Molecule& molecule,
                                   std::span<const SceneLayer> layers, std::span<const SceneVolume> volumes,
                                   std::size_t torsions) {
    std::vector<std::string> notes = listNotes(d);
    if (std::any_of(layers.begin(), layers.end(),
                    [](const SceneLayer& layer) { return layer.style == Style::licorice; }))
        notes.push_back("MolViewSpec cannot store the thickness of sticks: viewers use their own");
    if (std::any_of(layers.begin(), layers.end(),
                    [](const SceneLayer& layer) { return layer.style == Style::ellipsoids; }))
        notes.push_back("MolViewSpec cannot store ellipsoids: they become balls");
    if (std::ranges::any_of(layers, [](const SceneLayer& layer) {
            return layer.style == Style::cartoon && layer.cartoon.putty && layer.cartoon.tube == 0;
        }))
        notes.push_back(
            "MolViewSpec cannot store the widths of --putty: they become 0.2 Å and a tenth of the B factor");
    if (std::any_of(d.words.labels.begin(), d.words.labels.end(), hasFields))
        notes.push_back("MolViewSpec cannot store labels that name each residue");
    if (std::ranges::count(d.maps.styles, MapStyle::volume) > 0 ||
        std::ranges::any_of(d.maps.transfers, [](const MapTransfer& transfer) { return !transfer.empty(); }))
        notes.push_back("MolViewSpec cannot store volumes: they become surfaces");
    if (torsions > 0) notes.push_back("MolViewSpec cannot store torsion angles");
    for (const SceneVolume& volume : volumes) {
        if (volume.map->periodic)
            notes.push_back(volume.map->name + " is shown as far as its file reaches, not around the atoms");
        if (volume.map->format == "cube" || volume.map->format == "dsn6")
            notes.push_back("other programs may not read " + volume.map->name + " from a scene");
    }
    const std::string& format = molecule.file.format;
    if (format != "pdb" && format != "mmcif" && format != "bcif")
        notes.push_back("other programs may not read " + format + " from a scene");
    return notes;
}

/// Whether nodes of this kind set a scene's camera or background.
bool isOfView(const Out& node) {
    const std::string kind = node.value("kind", "");
    return kind == "camera" || kind == "canvas" || kind == "focus";
}

void dropViews(Out& node) {
    const auto children = node.find("children");
    if (children == node.end() || !children->is_array()) return;
    std::erase_if(children->get_ref<Out::array_t&>(), isOfView);
    for (Out& child : *children) dropViews(child);
}

/// Rewrites the scene of a picture with its current camera.
WrittenScene rewriteScene(const PictureDescription& d, const SceneCamera& camera, const std::string& path) {
    const std::string name = d.input.path;
    Out scene = parseJson<Out>(sceneText(name, readSceneBytes(name)));
    if (const auto list = scene.find("snapshots"); list != scene.end() && list->is_array()) {
        const auto at = static_cast<std::size_t>(std::max(d.input.snapshot, 1)) - 1;
        if (at < list->size()) scene["root"] = (*list)[at].value("root", Out());
        scene.erase("snapshots");
    }
    Out& root = scene["root"];
    dropViews(root);
    if (!root.contains("children")) root["children"] = Out::array();
    root["children"].push_back(canvasNode(d));
    root["children"].push_back(cameraNode(camera));
    scene["kind"] = "single";
    WrittenScene written{.json = jsonText(scene), .notes = listNotes(d)};
    if (d.look.style || !d.look.rules.empty())
        written.notes.push_back("the scene keeps its own representations: styles and rules are left out");
    namespace fs = std::filesystem;
    std::error_code error;
    if (!fs::equivalent(fs::absolute(name).parent_path(), fs::absolute(path).parent_path(), error))
        written.notes.push_back("put the files that " + name + " names into the scene's folder");
    if (!d.maps.files.empty()) written.notes.push_back("maps beside the scene are left out");
    return written;
}

}  // namespace

std::string sceneAddress(const std::string& input, const std::string& path, std::vector<std::string>& outside) {
    if (input.starts_with("pdb:")) return "https://files.wwpdb.org/download/" + lowerCase(input.substr(4)) + ".cif";
    if (input.starts_with("afdb:"))
        return "https://alphafold.ebi.ac.uk/files/AF-" + upperCase(input.substr(5)) + "-F1-model_v4.cif";
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path folder = fs::weakly_canonical(fs::absolute(path).parent_path(), error);
    const fs::path name = fs::weakly_canonical(fs::absolute(input), error).lexically_relative(folder);
    if (!name.empty() && *name.begin() != "..") return name.generic_string();
    outside.push_back(input);
    return fs::path(input).filename().generic_string();
}

WrittenScene writeScene(const Molecule& molecule, const PictureDescription& d, std::span<const SceneVolume> volumes,
                        const SceneCamera& camera, const std::string& path) {
    if (molecule.guide) return rewriteScene(d, camera, path);
    const ResidueFacts facts(molecule);
    const Expressions expressions(molecule);
    const std::vector<SceneLayer> layers =
        splitLayers(makeAppearance(facts, drawnAtoms(molecule, d.drawn), d.look), d.look);
    Out structureParams{{"type", d.look.assembly.empty() ? "model" : "assembly"}};
    if (!d.look.assembly.empty()) structureParams["assembly_id"] = d.look.assembly;
    if (d.input.model > 1) structureParams["model_index"] = d.input.model - 1;
    Out structure = makeNode("structure", std::move(structureParams));
    structure["children"] = Out::array();
    for (const SceneLayer& layer : layers)
        if (!layer.atoms.empty()) structure["children"].push_back(makeComponent(layer, expressions));
    addLabels(facts, d, expressions, structure["children"]);
    std::vector<std::string> outside;
    std::size_t left = 0;
    if (Out measures = measureNode(facts, d, left); !measures.is_null())
        structure["children"].push_back(std::move(measures));
    Out parse = makeNode("parse", {{"format", sceneFormat(molecule)}}, std::move(structure));
    Out root = makeNode("root", {},
                        makeNode("download", {{"url", sceneAddress(d.input.path, path, outside)}}, std::move(parse)));
    for (const SceneVolume& volume : volumes)
        root["children"].push_back(volumeNode(volume, sceneAddress(volume.map->name, path, outside)));
    root["children"].push_back(canvasNode(d));
    root["children"].push_back(cameraNode(camera));
    Out metadata{{"version", "1.2"}};
    if (!d.words.title.empty()) metadata["title"] = d.words.title;
    WrittenScene written;
    written.json = jsonText({{"kind", "single"}, {"root", std::move(root)}, {"metadata", std::move(metadata)}});
    written.notes = listNotes(d, molecule, layers, volumes, left);
    for (const std::string& file : outside)
        written.notes.push_back("put " + file + " into the scene's folder: the scene names it there");
    return written;
}

}  // namespace nacre::app::mvs
