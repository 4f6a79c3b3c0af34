// Representations of a component: style, colours and opacity.

#include <algorithm>
#include <stdexcept>

#include "app/mvs/molstar_radii.h"
#include "app/mvs/primitive_values.h"
#include "app/mvs/scene_parts.h"
#include "app/mvs/value_palette.h"
#include "engine/molecule/element.h"
#include "engine/molecule/text.h"
#include "engine/scene/color/colors.h"

namespace nacre::app::mvs {
namespace {

// Mol* draws balls of 0.5 Å in its scenes, for all elements, and sticks of half that radius; ours have 0.15 Å.
constexpr float kBall = 0.5f, kStickScale = 0.25f / 0.15f;
constexpr float kLargestSurface = 4;        // of a factor: a larger one would take minutes, and show a ball
constexpr float kLineScale = 2 / 1.5f;      // from our lines of 1.5 pixels to those of Mol*
constexpr float kBackboneScale = 2.0f / 3;  // from our tubes of 0.3 Å to those of 0.2 Å
constexpr std::uint32_t kDefaultColor = 0xffffffffu;

float readFactor(const Node& node, SceneWarnings& warnings) {
    const Json* value = node.param("size_factor");
    if (!value) return 1;
    const double factor = value->is_number() ? value->get<double>() : 0;
    if (factor > 0 && factor <= 100) return static_cast<float>(factor);
    warnings.add(node, "size_factor is no number between 0 and 100");
    return 1;
}

bool isOfPolymer(const Structure& structure, std::uint32_t residue) {
    const ResidueKind kind = structure.atoms->facts().kinds()[residue];
    return kind == ResidueKind::protein || kind == ResidueKind::nucleic;
}

/// @returns whether the type is supported
bool setStyle(const Node& node, std::string_view type, SceneLayer& layer, SceneWarnings& warnings) {
    const float factor = readFactor(node, warnings);
    layer.atomScale = layer.bondScale = factor;
    layer.cartoon.scale = static_cast<double>(factor) * (type == "putty" ? 1 : kCartoonScale);
    layer.cartoon.overhang = 0.5;
    layer.surface.scale = static_cast<double>(std::min(factor, kLargestSurface));
    layer.surface.radius = layer.radius = molstarRadius;
    if (type == "cartoon") {
        layer.style = Style::cartoon;
        layer.cartoon.disulfides = false;  // Mol* does not draw them
        if (flag(node, "tubular_helices", false)) layer.cartoon.helices = HelixForm::tube;
    } else if (type == "putty") {
        layer.style = Style::cartoon;
        layer.cartoon.disulfides = false;
        layer.cartoon.putty = true;
        if (nodeText(node, "size_theme") == "uncertainty") {
            layer.cartoon.tube = 0.2, layer.cartoon.tubePerTemperature = 0.1;  // as in Mol*
        } else {
            layer.cartoon.tube = static_cast<double>(factor);  // the scale multiplies it again, as in Mol*
        }
    } else if (type == "surface") {
        layer.style = Style::surface;
        if (factor > kLargestSurface) warnings.add(node, "surfaces have a size_factor of 4 at most");
        const Json* kind = node.param("surface_type");
        if (kind && *kind == "gaussian") layer.surface.kind = SurfaceKind::gaussian;
    } else if (type == "ball_and_stick") {
        layer.style = Style::ballAndStick;
        layer.ballRadius = kBall;
        layer.bondScale *= kStickScale;
    } else if (type == "spacefill") {
        layer.style = Style::spacefill;
    } else if (type == "line") {
        layer.style = Style::line;
        layer.atomScale *= kLineScale;
    } else if (type == "backbone") {
        layer.style = Style::backbone;
        layer.atomScale = layer.bondScale = factor * kBackboneScale;
    } else if (type == "carbohydrate") {
        layer.style = Style::carbohydrate;
        layer.ownColors = std::any_of(node.children.begin(), node.children.end(),
                                      [](const Node& child) { return child.kind.starts_with("color"); });
    } else {
        return false;
    }
    return true;
}

/// Colours a layer's atoms that are in a set.
void paint(const std::vector<bool>& atoms, std::uint32_t color, SceneLayer& layer) {
    for (std::size_t i = 0; i < layer.atoms.size(); ++i)
        if (atoms[layer.atoms[i]]) layer.colors[i] = color;
}

/// For a colour node without a colour.
void paintElements(const std::vector<bool>& atoms, const Structure& structure, SceneLayer& layer) {
    for (std::size_t i = 0; i < layer.atoms.size(); ++i)
        if (atoms[layer.atoms[i]]) layer.colors[i] = elementColor(structure.molecule->atoms[layer.atoms[i]].element);
}

void paintRows(const Node& node, const Structure& structure, SceneFiles& files, SceneLayer& layer,
               SceneWarnings& warnings) {
    const std::vector<AnnotationRow> rows = readRows(node, "color", structure, files);
    ColorOfValue colors = [&](const std::string& word) {
        const Json value(word);
        const auto color = readColor(&value);
        if (!color) warnings.add(node, "there is no colour '" + nacre::printable(word) + "'");
        return color;
    };
    try {
        if (const Json* palette = node.param("palette")) colors = colorsOfPalette(*palette, rows);
    } catch (const std::invalid_argument& why) {
        return warnings.add(node, why.what() + std::string(": it is left out"));
    }
    const std::vector<bool> chosen = selected(node, node.param("selector"), structure, warnings);
    std::vector<bool> atoms(structure.molecule->atoms.size());
    std::optional<std::uint32_t> last;
    const auto paintLast = [&] {
        if (!last) return;
        for (std::size_t i = 0; i < atoms.size(); ++i) atoms[i] = atoms[i] && chosen[i];
        paint(atoms, *last, layer);
        atoms.assign(atoms.size(), false);
    };
    for (const AnnotationRow& row : rows) {
        const auto color = row.value() ? colors(*row.value()) : std::nullopt;
        if (!color) continue;
        if (color != last) paintLast();  // groups rows of one colour
        last = color;
        structure.atoms->add(row.expression, atoms);
    }
    paintLast();
}

std::optional<double> readOpacity(const Node& node, SceneWarnings& warnings) {
    const Json* value = node.param("opacity");
    if (value && value->is_number() && value->get<double>() >= 0 && value->get<double>() <= 1)
        return value->get<double>();
    warnings.add(node, "its opacity is no number from 0 to 1");
    return std::nullopt;
}

void fade(const Node& node, const Structure& structure, SceneLayer& layer, SceneWarnings& warnings) {
    const auto opacity = readOpacity(node, warnings);
    if (!opacity) return;
    if (layer.style == Style::line) return warnings.add(node, "lines are drawn opaque");
    const std::vector<bool> atoms = selected(node, node.param("selector"), structure, warnings);
    if (layer.opacity.empty()) layer.opacity.assign(layer.atoms.size(), 1.0f);
    for (std::size_t i = 0; i < layer.atoms.size(); ++i)
        if (atoms[layer.atoms[i]]) layer.opacity[i] = static_cast<float>(*opacity);
}

/// Applies the colour and opacity nodes of a representation, in order.
void paintChildren(const Node& node, const Structure& structure, SceneFiles& files, SceneLayer& layer,
                   SceneWarnings& warnings) {
    for (const Node& child : node.children) {
        tellUnknown(child, node, warnings);
        if (child.kind == "color") {
            const Json* value = child.param("color");
            const auto color = readColor(value);
            if (!value || value->is_null())
                paintElements(selected(child, child.param("selector"), structure, warnings), structure, layer);
            else if (color)
                paint(selected(child, child.param("selector"), structure, warnings), *color, layer);
            else
                warnings.add(child, "it names no colour");
        } else if (child.kind == "color_from_uri" || child.kind == "color_from_source") {
            paintRows(child, structure, files, layer, warnings);
        } else if (child.kind == "opacity") {
            fade(child, structure, layer, warnings);
        }
    }
}

}  // namespace

std::optional<SceneLayer> readRepresentation(const Node& node, const std::vector<std::uint32_t>& atoms,
                                             Structure& structure, SceneFiles& files, SceneWarnings& warnings) {
    const std::string name = nodeText(node, "type");
    SceneLayer layer;
    if (!setStyle(node, name, layer, warnings)) {
        warnings.add(node, "there is no representation '" + nacre::printable(name) + "': it is left out");
        return std::nullopt;
    }
    if (const NodeRow* row = nodeRow("representation:" + name)) tellUnused(node, *row, warnings);
    const bool bare = flag(node, "ignore_hydrogens", false);
    const bool ofPolymers = layer.style == Style::cartoon || layer.style == Style::backbone;
    for (const std::uint32_t atom : atoms)
        if ((!bare || !isHydrogen(structure.molecule->atoms[atom].element)) &&
            (!ofPolymers || isOfPolymer(structure, structure.molecule->atoms[atom].residue)))
            layer.atoms.push_back(atom);
    structure.framed.push_back(layer);
    layer.colors.assign(layer.atoms.size(), kDefaultColor);
    paintChildren(node, structure, files, layer, warnings);
    // Atoms with opacity 0 are not drawn.
    if (!layer.opacity.empty())
        keepAtoms(layer, [&](std::size_t i) { return static_cast<double>(layer.opacity[i]) >= kLeastOpacity; });
    return layer;
}

void takeLook(const Node& node, std::uint32_t& color, double& opacity, SceneWarnings& warnings) {
    for (const Node& child : node.children) {
        tellUnknown(child, node, warnings);
        const auto named = child.kind == "color" ? readColor(child.param("color")) : std::nullopt;
        if (child.kind == "color" && !named) warnings.add(child, "it names no colour");
        color = named.value_or(color);
        if (child.kind == "opacity") opacity = readOpacity(child, warnings).value_or(opacity);
    }
}

std::vector<std::uint32_t> colorsOfAll(const Node& representation, const Structure& structure, SceneFiles& files) {
    SceneLayer all;
    all.atoms.resize(structure.molecule->atoms.size());
    for (std::uint32_t i = 0; i < all.atoms.size(); ++i) all.atoms[i] = i;
    all.colors.assign(all.atoms.size(), kDefaultColor);
    SceneWarnings known;  // already reported for the representation itself
    paintChildren(representation, structure, files, all, known);
    return std::move(all.colors);
}

}  // namespace nacre::app::mvs
