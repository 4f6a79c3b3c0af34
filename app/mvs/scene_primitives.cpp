#include "app/mvs/scene_primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "app/mvs/node_table.h"
#include "app/mvs/primitive_values.h"
#include "app/mvs/scene_parts.h"
#include "engine/molecule/text.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app::mvs {
namespace {

constexpr std::uint32_t kWhite = 0xffffffffu;
constexpr double kPixelsOfWidth = 2;  // per line width of 1, as in Mol*

/// One group of primitives while it is read.
class PrimitiveGroup {
public:
    PrimitiveGroup(const Node& group, const Structure* own, std::span<const Structure> structures,
                   SceneWarnings& warnings)
        : group_(group), own_(own), structures_(structures), warnings_(warnings) {
        if (!own_ && !structures.empty()) own_ = &structures.front();
        color_ = readColor(group.param("color")).value_or(kWhite);
        labelColor_ = readColor(group.param("label_color")).value_or(kWhite);
        opacity_ = std::clamp(number(group, "opacity", 1), 0.0, 1.0);
        tooltip_ = nodeText(group, "tooltip");
        readPlate();
    }

    Primitives read() {
        for (const Node& node : group_.children) {
            if (node.kind != "primitive") {
                tellUnknown(node, group_, warnings_);
                continue;
            }
            try {
                one(node);
            } catch (const std::invalid_argument& why) {
                warnings_.add(node, why.what() + std::string(": it is left out"));
            }
        }
        if (opacity_ < kLeastOpacity) {
            const auto labels = std::move(all_.labels);
            all_ = {};
            all_.labels = labels;
        }
        if (number(group_, "label_opacity", 1) < kLeastOpacity) all_.labels.clear();
        return atInstances(group_, std::move(all_));
    }

private:
    void readPlate() {
        constexpr double kLongest = 100;  // sizes of a label
        if (const auto color = readColor(group_.param("label_background_color")))
            plate_ = {.color = *color, .background = true};
        else if (group_.param("label_background_color"))
            warnings_.add(group_, "its label_background_color is no colour");
        const double tether = std::clamp(number(group_, "label_tether_length", 1), 0.0, kLongest);
        if (flag(group_, "label_show_tether", false)) plate_.tether = tether / kEmOfSize;
        const std::string attachment = nodeText(group_, "label_attachment");
        const std::size_t dash = attachment.find('-');
        const auto index = [](const std::string& word, std::initializer_list<const char*> words) {
            return static_cast<int>(std::ranges::find(words, word) - words.begin()) - 1;
        };
        // The side of the label that is at the point: a label that is attached at its top lies below.
        const int up = index(attachment.substr(0, dash), {"top", "middle", "bottom"});
        const int right =
            dash == std::string::npos ? 2 : index(attachment.substr(dash + 1), {"right", "center", "left"});
        if (up <= 1 && right <= 1)
            plate_.side = {right, up};
        else if (!attachment.empty())
            warnings_.add(group_, "there is no label_attachment '" + nacre::printable(attachment, 40) + "'");
    }

    void one(const Node& node) {
        const std::string kind = nodeText(node, "kind");
        const NodeRow* row = nodeRow("primitive:" + kind);
        if (!row) return warnings_.add(node, "there is no primitive '" + nacre::printable(kind) + "': it is left out");
        tellUnused(node, *row, warnings_);
        if (kind == "tube") tube(node);
        if (kind == "arrow") arrow(node);
        if (kind == "lines") lines(node);
        if (kind == "mesh") mesh(node);
        if (kind == "label") label(node);
        if (kind == "distance_measurement") distance(node);
        if (kind == "angle_measurement") angle(node);
        if (kind == "ellipse") ellipse(node);
        if (kind == "ellipsoid") ellipsoid(node);
        if (kind == "box") box(node);
    }

    PrimitiveLook look(const Node& node, const char* colorName, const std::string& note) {
        PrimitiveLook look;
        look.color = readColor(node.param(colorName)).value_or(color_);
        look.opacity = std::max(opacity_, kLeastOpacity);
        look.note = addNote(note);
        return look;
    }
    std::uint32_t addNote(const std::string& text) {
        if (text.empty()) return 0;
        if (all_.notes.empty() || all_.notes.back() != text) all_.notes.push_back(text);
        return static_cast<std::uint32_t>(all_.notes.size());
    }
    std::string readTooltip(const Node& node) const {
        const std::string own = nodeText(node, "tooltip");
        return own.empty() ? tooltip_ : own;
    }

    /// The extent of a position; empty if its expression matches no atom.
    std::optional<PlaceBounds> place(const Node& node, const char* name) {
        const Json* value = node.param(name);
        if (!value) return std::nullopt;
        if (value->is_array()) {
            const glm::dvec3 point = vectorIn(name, *value);
            return PlaceBounds{point, point, point, 0};
        }
        if (!value->is_object()) refusePrimitive(std::string(name) + " is neither a point nor an expression");
        const Structure* structure = own_;
        const Json* expressions = value;
        if (const auto listed = value->find("expressions"); listed != value->end()) expressions = &*listed;
        if (const auto ref = value->find("structure_ref"); ref != value->end() && ref->is_string()) {
            const auto found = std::find_if(structures_.begin(), structures_.end(),
                                            [&](const Structure& s) { return s.ref == ref->get<std::string>(); });
            if (found == structures_.end())
                refusePrimitive("there is no structure '" + nacre::printable(ref->get<std::string>()) + "'");
            structure = &*found;
        }
        if (!structure) refusePrimitive(std::string(name) + " names atoms, and the scene has no structure");
        return boundsOfAtoms(node, *expressions, *structure);
    }

    std::optional<PlaceBounds> boundsOfAtoms(const Node& node, const Json& selector, const Structure& structure) {
        const std::vector<glm::dvec4> balls =
            placedBalls(structure, structure.atoms->selectDrawn(selected(node, &selector, structure, warnings_)), 1);
        if (balls.empty()) {
            warnings_.add(node, "its place matches no atoms: it is left out");
            return std::nullopt;
        }
        Box box;
        for (const glm::dvec3& point : extremePoints(balls)) box.add(point);
        const Bounds bounds = extremeSphere(balls);
        return PlaceBounds{bounds.center, box.low, box.high, bounds.radius};
    }

    /// Dashes and gaps of twice the length, as Mol* draws them.
    static PrimitiveDashes dashes(double length) {
        return length > 0 ? PrimitiveDashes{2 * length, 2 * length} : PrimitiveDashes{};
    }

    void tube(const Node& node) {
        const auto a = place(node, "start"), b = place(node, "end");
        if (!a || !b) return;
        all_.lines.push_back({a->center, b->center, number(node, "radius", 0.05), 1.5,
                              dashes(number(node, "dash_length", 0)), look(node, "color", readTooltip(node))});
    }

    static void setHead(const Node& node, const std::string& side, double radius, Primitives::Arrow& arrow) {
        arrow.headRadius = number(node, (side + "_cap_radius").c_str(), 2 * radius);
        arrow.headLength = number(node, (side + "_cap_length").c_str(), 2 * arrow.headRadius);
    }

    void arrow(const Node& node) {
        const auto a = place(node, "start");
        if (!a) return;
        glm::dvec3 end = a->center;
        if (const auto b = place(node, "end"))
            end = b->center;
        else if (const Json* direction = node.param("direction"))
            end += vectorIn("direction", *direction);
        else
            return warnings_.add(node, "it has neither end nor direction");
        if (const double length = number(node, "length", 0); length > 0 && glm::distance(end, a->center) > 1e-9)
            end = a->center + glm::normalize(end - a->center) * length;
        Primitives::Arrow arrow;
        arrow.from = a->center;
        arrow.to = end;
        const double radius = number(node, "tube_radius", 0.05);
        arrow.radius = flag(node, "show_tube", true) ? radius : 0;
        arrow.headAtFrom = flag(node, "show_start_cap", false);
        arrow.headAtTo = flag(node, "show_end_cap", false);
        arrow.dashes = dashes(number(node, "tube_dash_length", 0));
        arrow.look = look(node, "color", readTooltip(node));
        setHead(node, arrow.headAtTo || !arrow.headAtFrom ? "end" : "start", radius, arrow);
        if (Primitives::Arrow other = arrow; arrow.headAtFrom && arrow.headAtTo) {  // the other head has its own size
            setHead(node, "start", radius, other);
            other.radius = 0;
            other.headAtTo = arrow.headAtFrom = false;
            const double length = glm::distance(arrow.from, arrow.to);
            if (length > 1e-9) arrow.from += (arrow.to - arrow.from) * std::min(other.headLength / length, 0.5);
            all_.arrows.push_back(other);
        }
        all_.arrows.push_back(arrow);
    }

    /// A group's value in an object keyed by number.
    static const Json* ofGroup(const Node& node, const char* name, std::int64_t group) {
        const Json* map = node.param(name);
        if (!map || !map->is_object()) return nullptr;
        const auto found = map->find(std::to_string(group));
        return found == map->end() ? nullptr : &*found;
    }

    struct Indexed {
        std::vector<glm::dvec3> points;
        std::vector<std::uint32_t> indices;
        std::vector<std::int64_t> groups;  ///< of each line or triangle
    };
    Indexed indexed(const Node& node, std::size_t each, const char* groupsName) {
        const std::vector<double> vertices = numbers(node, "vertices"), indices = numbers(node, "indices"),
                                  groups = numbers(node, groupsName);
        if (vertices.size() % 3 != 0 || indices.size() % each != 0)
            refusePrimitive("its vertices or indices are no whole number of points or figures");
        Indexed result;
        for (std::size_t i = 0; i < vertices.size(); i += 3)
            result.points.emplace_back(vertices[i], vertices[i + 1], vertices[i + 2]);
        for (const double index : indices) {
            if (!(index >= 0 && index < static_cast<double>(result.points.size())))
                refusePrimitive("an index names a vertex that is not there");
            result.indices.push_back(static_cast<std::uint32_t>(index));
        }
        for (std::size_t i = 0; i < indices.size() / each; ++i)
            result.groups.push_back(i < groups.size() ? static_cast<std::int64_t>(groups[i])
                                                      : static_cast<std::int64_t>(i));
        return result;
    }
    PrimitiveLook lookOfGroup(const Node& node, std::int64_t group) {
        const Json* tip = ofGroup(node, "group_tooltips", group);
        PrimitiveLook own = look(node, "color", tip && tip->is_string() ? tip->get<std::string>() : readTooltip(node));
        if (const auto color = readColor(ofGroup(node, "group_colors", group))) own.color = *color;
        return own;
    }

    void lines(const Node& node) {
        const Indexed figure = indexed(node, 2, "line_groups");
        for (std::size_t i = 0; i < figure.groups.size(); ++i) {
            const Json* wide = ofGroup(node, "group_widths", figure.groups[i]);
            const double width = wide && wide->is_number() ? wide->get<double>() : number(node, "width", 1);
            all_.lines.push_back({figure.points[figure.indices[2 * i]],
                                  figure.points[figure.indices[2 * i + 1]],
                                  0,
                                  std::clamp(kPixelsOfWidth * width, 0.5, 50.0),
                                  {},
                                  lookOfGroup(node, figure.groups[i])});
        }
    }

    /// Edges of a mesh, in the colour of the first triangle that has them.
    void wiresOfTriangles(const Primitives::Mesh& mesh) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> known;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3];
                if (known.insert(std::minmax(a, b)).second)
                    all_.lines.push_back({mesh.positions[a], mesh.positions[b], 0, mesh.wireWidth, {}, mesh.looks[i]});
            }
    }

    void mesh(const Node& node) {
        Indexed figure = indexed(node, 3, "triangle_groups");
        Primitives::Mesh mesh;
        mesh.positions = std::move(figure.points);
        mesh.looks.clear();
        for (std::size_t i = 0; i < figure.groups.size(); ++i) {
            mesh.triangles.push_back({figure.indices[3 * i], figure.indices[3 * i + 1], figure.indices[3 * i + 2]});
            mesh.looks.push_back(lookOfGroup(node, figure.groups[i]));
        }
        mesh.faces = flag(node, "show_triangles", true);
        if (flag(node, "show_wireframe", false)) {
            mesh.wireWidth = std::clamp(kPixelsOfWidth * number(node, "wireframe_width", 1), 0.5, 50.0);
            if (node.param("wireframe_color") || !node.param("group_colors"))
                mesh.wires = look(node, node.param("wireframe_color") ? "wireframe_color" : "color", "");
            else
                wiresOfTriangles(mesh);
        }
        if (!mesh.triangles.empty()) all_.meshes.push_back(std::move(mesh));
    }

    void addLabel(const Node& node, const glm::dvec3& at, const std::string& text, double size) {
        all_.labels.push_back({at, withoutMarkup(text), kEmOfSize * size,
                               readColor(node.param("label_color")).value_or(labelColor_), plate_});
    }

    void label(const Node& node) {
        const auto at = place(node, "position");
        if (at && !nodeText(node, "text").empty())
            addLabel(node, at->center, nodeText(node, "text"), number(node, "label_size", 1));
    }

    std::string measured(const Node& node, std::string_view field, const std::string& value) const {
        const Json* given = node.param("label_template");
        return given && given->is_string() ? replaced(given->get<std::string>(), field, value) : value;
    }
    double labelSize(const Node& node, double length, double scale) const {
        const Json* size = node.param("label_size");
        if (size && size->is_number()) return number(node, "label_size", 1);
        return std::max(length * number(node, "label_auto_size_scale", scale), number(node, "label_auto_size_min", 0));
    }

    void distance(const Node& node) {
        const auto a = place(node, "start"), b = place(node, "end");
        if (!a || !b) return;
        const double length = glm::distance(a->center, b->center);
        const std::string text = measured(node, "{{distance}}", roundedText(length) + " Å");
        all_.lines.push_back({a->center, b->center, number(node, "radius", 0.05), 1.5,
                              dashes(number(node, "dash_length", 0)), look(node, "color", text)});
        addLabel(node, (a->center + b->center) / 2.0, text, labelSize(node, length, 0.1));
    }

    void angle(const Node& node) {
        const auto a = place(node, "a"), b = place(node, "b"), c = place(node, "c");
        if (!a || !b || !c) return;
        const glm::dvec3 ba = a->center - b->center, bc = c->center - b->center;
        const double shorter = std::min(glm::length(ba), glm::length(bc));
        if (!(shorter > 1e-6)) return;
        const glm::dvec3 u = glm::normalize(ba), v = glm::normalize(bc);
        const double turn = std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0));
        const std::string text = measured(node, "{{angle}}", roundedText(turn * 180 / std::numbers::pi) + "°");
        const double radius = number(node, "section_radius", shorter * number(node, "section_radius_scale", 0.33));
        if (flag(node, "show_vector", true)) {
            const double thick = number(node, "vector_radius", 0.05);
            for (const glm::dvec3& end : {a->center, c->center})
                all_.lines.push_back({b->center, end, thick, 1.5, dashes(thick), look(node, "vector_color", text)});
        }
        glm::dvec3 across = v - u * glm::dot(u, v);
        if (flag(node, "show_section", true) && glm::length(across) > 1e-9) {
            across = glm::normalize(across);
            all_.ellipses.push_back(
                {b->center, u * radius, across * radius, 0, turn, look(node, "section_color", text)});
        }
        const glm::dvec3 middle = glm::length(u + v) > 1e-9 ? glm::normalize(u + v) : u;
        addLabel(node, b->center + middle * radius, text, labelSize(node, radius, 0.33));
    }

    /// An axis, given by its end or as a vector.
    std::optional<glm::dvec3> axis(const Node& node, const std::string& name, const glm::dvec3& center,
                                   std::optional<glm::dvec3> otherwise) {
        if (const auto end = place(node, (name + "_endpoint").c_str())) return end->center - center;
        if (const Json* given = node.param(name.c_str())) return vectorIn(name.c_str(), *given);
        return otherwise;
    }

    /// The part of an axis that is perpendicular to another one.
    static glm::dvec3 upright(const glm::dvec3& axis, const glm::dvec3& other) {
        return axis - other * (glm::dot(axis, other) / glm::dot(other, other));
    }

    void ellipse(const Node& node) {
        const auto center = place(node, "center");
        if (!center) return;
        auto major = axis(node, "major_axis", center->center, {}), minor = axis(node, "minor_axis", center->center, {});
        const glm::dvec3 across = major && minor ? upright(*minor, *major) : glm::dvec3(0);
        if (!(glm::length(across) > 1e-9)) return warnings_.add(node, "its axes are no two directions");
        const double large = number(node, "radius_major", glm::length(*major));
        const double small = flag(node, "as_circle", false) ? large : number(node, "radius_minor", glm::length(*minor));
        all_.ellipses.push_back({center->center, glm::normalize(*major) * large, glm::normalize(across) * small,
                                 number(node, "theta_start", 0), number(node, "theta_end", 2 * std::numbers::pi),
                                 look(node, "color", readTooltip(node))});
    }

    glm::dvec3 radii(const Node& node, const char* name, double otherwise) {
        const Json* value = node.param(name);
        if (!value) return glm::dvec3(otherwise);
        return value->is_array() ? vectorIn(name, *value) : glm::dvec3(number(node, name, otherwise));
    }

    void ellipsoid(const Node& node) {
        const auto center = place(node, "center");
        if (!center) return;
        const glm::dvec3 major = axis(node, "major_axis", center->center, glm::dvec3(1, 0, 0)).value();
        const glm::dvec3 minor = axis(node, "minor_axis", center->center, glm::dvec3(0, 1, 0)).value();
        const glm::dvec3 first = upright(major, minor), third = glm::cross(first, minor);
        if (!(glm::length(third) > 1e-9)) return warnings_.add(node, "its axes are no two directions");
        const glm::dvec3 radius = radii(node, "radius", center->radius) + radii(node, "radius_extent", 0);
        all_.ellipsoids.push_back(
            {center->center,
             {glm::normalize(first) * radius.x, glm::normalize(minor) * radius.y, glm::normalize(third) * radius.z},
             look(node, "color", readTooltip(node))});
    }

    void box(const Node& node) {
        const auto center = place(node, "center");
        if (!center) return;
        glm::dvec3 half = (center->high - center->low) / 2.0;
        if (const Json* extent = node.param("extent")) half += vectorIn("extent", *extent);
        Primitives::Box box;
        if (!(half.x * half.y * half.z > 1e-4)) return warnings_.add(node, "it has no room: give its extent");
        box.center = center->center;
        box.axes = {glm::dvec3(half.x, 0, 0), glm::dvec3(0, half.y, 0), glm::dvec3(0, 0, half.z)};
        box.faces.reset();
        if (flag(node, "show_faces", true)) box.faces = look(node, "face_color", readTooltip(node));
        if (flag(node, "show_edges", false)) box.edges = look(node, "edge_color", readTooltip(node));
        box.edgeRadius = number(node, "edge_radius", 0.1);
        if (box.faces || box.edges) all_.boxes.push_back(box);
    }

    const Node& group_;
    const Structure* own_;
    std::span<const Structure> structures_;
    SceneWarnings& warnings_;
    std::uint32_t color_ = kWhite, labelColor_ = kWhite;
    Primitives::LabelPlate plate_{.color = packedColor(0x808080)};
    double opacity_ = 1;
    std::string tooltip_;
    Primitives all_;
};

}  // namespace

Primitives readPrimitives(const Node& group, const Structure* own, std::span<const Structure> structures,
                          SceneWarnings& warnings) {
    try {
        return PrimitiveGroup(group, own, structures, warnings).read();
    } catch (const std::invalid_argument& why) {
        warnings.add(group, why.what() + std::string(": it is left out"));
        return {};
    }
}

}  // namespace nacre::app::mvs
