#include "app/mvs/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <stdexcept>

#include "app/mvs/molstar_radii.h"
#include "app/mvs/node_table.h"
#include "app/mvs/primitive_values.h"
#include "app/picture/color_values.h"
#include "engine/error.h"
#include "engine/molecule/assemblies.h"
#include "engine/molecule/crystal.h"
#include "engine/molecule/element.h"
#include "engine/molecule/text.h"
#include "engine/scene/instances/copies.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app::mvs {
namespace {

[[noreturn]] void refuseNode(const Node& node, const std::string& why) {
    throw Error("cannot draw scene", node.place, why);
}

/// A number from 0; 0 if the node has none.
std::size_t readIndex(const Node& node, const char* name) {
    const Json* value = node.param(name);
    if (value && !value->is_number_integer()) refuseNode(node, std::string(name) + " is no whole number");
    return value ? static_cast<std::size_t>(std::max<std::int64_t>(value->get<std::int64_t>(), 0)) : 0;
}

std::array<int, 3> readCells(const Node& node, const char* name, int otherwise) {
    const Json* value = node.param(name);
    std::array<int, 3> cells{otherwise, otherwise, otherwise};
    if (!value) return cells;
    if (!value->is_array() || value->size() != 3)
        refuseNode(node, std::string(name) + " is no list of three whole numbers");
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(*value)[i].is_number_integer() || std::abs((*value)[i].get<double>()) > 1000)
            refuseNode(node, std::string(name) + " is no list of three whole numbers within 1000");
        cells[i] = (*value)[i].get<int>();
    }
    return cells;
}

/// Extracts the data block of that name or number from a text of CIF.
std::string findBlock(const Node& node, const std::string& text, const std::string& header, std::size_t index) {
    std::size_t found = 0, number = 0, start = std::string::npos, at = 0;
    bool inText = false;
    for (; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
        if (text[at] == ';') inText = !inText;
        if (inText || lowerCase(std::string_view(text).substr(at, 5)) != "data_") continue;
        if (start != std::string::npos) break;
        const std::size_t end = text.find_first_of(" \t\r\n", at);
        const std::string name = text.substr(at + 5, end == std::string::npos ? end : end - at - 5);
        if (header.empty() ? number == index : lowerCase(name) == lowerCase(header)) start = at;
        ++number, ++found;
    }
    if (start == std::string::npos)
        refuseNode(node, header.empty() ? "the file has " + std::to_string(found) + " data blocks, none of number " +
                                              std::to_string(index)
                                        : "the file has no data block '" + nacre::printable(header) + "'");
    return text.substr(start, at - start);
}

void addAssembly(const Node& node, Structure& s, SceneWarnings& warnings) {
    const Molecule& molecule = *s.molecule;
    std::string id = nodeText(node, "assembly_id");
    const std::size_t index = readIndex(node, "assembly_index");
    if (id.empty() && molecule.assemblies.empty()) {
        const std::string why = findLeftOutWarning(molecule);
        return warnings.add(node, (why.empty() ? "the file states no assemblies" : why) + ": its model is shown");
    }
    if (id.empty() && index >= molecule.assemblies.size())
        refuseNode(node, "there is no assembly of index " + std::to_string(index));
    if (id.empty()) id = molecule.assemblies[index].id;
    Placement placement = placeAssembly(molecule, id);
    s.transforms = std::move(placement.transforms);
    s.lists = std::move(placement.lists);
    for (const Residue& residue : molecule.residues)
        s.listOfResidue.push_back(placement.listOfSubchain[residue.subchain]);
}

void placeCopies(std::vector<glm::dmat4x3> copies, Structure& s) {
    s.transforms = std::move(copies);
    std::vector<std::uint32_t> all(s.transforms.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    s.lists = {all};
}

std::vector<double> readNumbers(const Node& node, const char* name, std::size_t count) {
    const Json* value = node.param(name);
    if (!value) return {};
    try {
        return numbersIn(name, *value, count);
    } catch (const std::invalid_argument& why) {
        refuseNode(node, why.what());
    }
}

}  // namespace

std::string nodeText(const Node& node, const char* name) {
    const Json* value = node.param(name);
    return value && value->is_string() ? value->get<std::string>() : std::string();
}

std::optional<std::uint32_t> readColor(const Json* value) {
    if (!value || !value->is_string()) return std::nullopt;
    try {
        return opaqueColor(parseColor(value->get<std::string>()));
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

namespace {

/// Moves the atoms of a structure to the positions in its coordinates node.
void placeAtoms(const Node& node, std::size_t frame, Molecule& molecule, SceneFiles& files, SceneWarnings& warnings) {
    const std::string ref = nodeText(node, "coordinates_ref");
    const bool known = !ref.empty() && files.hasCoordinates(ref);
    const std::string none = "there are no coordinates '" + nacre::printable(ref, 40) + "'";
    if (known) {
        const std::vector<glm::vec3> positions = files.positions(ref, frame, molecule.atoms.size());
        for (std::size_t i = 0; i < positions.size(); ++i) molecule.atoms[i].position = positions[i];
        molecule.lacksPositions = false;
    } else if (molecule.lacksPositions) {
        refuseNode(node, ref.empty() ? "it is a topology without positions: it needs coordinates_ref" : none);
    } else if (!ref.empty()) {
        warnings.add(node, none);
    }
}

/// The motion of a transform or instance node. @param centroid  of what it moves
/// @throws Error unless it is rigid and near
glm::dmat4x3 motionOfNode(const Node& node, const std::function<glm::dvec3()>& centroid) {
    glm::dmat4x3 motion(1.0);
    if (const std::vector<double> matrix = readNumbers(node, "matrix", 16); !matrix.empty()) {
        motion = glm::dmat4x3(glm::make_mat4(matrix.data()));
    } else {
        const std::vector<double> turn = readNumbers(node, "rotation", 9), shift = readNumbers(node, "translation", 3);
        for (std::size_t i = 0; i < turn.size(); ++i)
            motion[static_cast<int>(i / 3)][static_cast<int>(i % 3)] = turn[i];
        if (const Json* about = node.param("rotation_center")) {
            glm::dvec3 center(0);
            if (*about == "centroid") {
                center = centroid();
            } else {
                const std::vector<double> point = readNumbers(node, "rotation_center", 3);
                center = {point[0], point[1], point[2]};
            }
            motion[3] = center - glm::dmat3(motion[0], motion[1], motion[2]) * center;
        }
        for (std::size_t i = 0; i < shift.size(); ++i) motion[3][static_cast<int>(i)] += shift[i];
    }
    if (!isRigid(motion)) refuseNode(node, "its rotation stretches, skews or shrinks");
    return motion;
}

}  // namespace

Structure readStructure(const Node& parse, const Node& node, const std::string& uri, SceneFiles& files,
                        SceneWarnings& warnings) {
    Structure s;
    s.uri = uri;
    s.ref = node.ref;
    ReadOptions options = files.sources().reading;
    const auto model = static_cast<int>(std::min<std::size_t>(readIndex(node, "model_index"), 1'000'000));
    const bool placed = files.hasCoordinates(nodeText(node, "coordinates_ref"));
    options.model = placed ? 1 : model + 1;
    const std::string format = lowerCase(nodeText(parse, "format"));
    if (format == "map" || format == "dx" || format == "dxbin") refuseNode(parse, "a density map has no structure");
    const std::string header = nodeText(node, "block_header");
    const std::size_t block = readIndex(node, "block_index");
    std::string bytes = files.bytes(uri);
    const bool binary = !bytes.empty() && (static_cast<unsigned char>(bytes[0]) & 0x80) != 0;
    if ((!header.empty() || block > 0) && !binary && format != "sdf")
        bytes = findBlock(node, bytes, header, block);
    else if (format == "sdf" && block > 0)
        options.model = static_cast<int>(std::min<std::size_t>(block, 1'000'000)) + 1;
    else if (!header.empty() || block > 0)
        warnings.add(node, "of BinaryCIF the first block with atoms is read");
    s.molecule = std::make_unique<Molecule>(files.molecule(uri, std::move(bytes), options));
    placeAtoms(node, static_cast<std::size_t>(model), *s.molecule, files, warnings);
    s.atoms = std::make_unique<StructureAtoms>(*s.molecule);
    const std::string type = nodeText(node, "type");
    if (type == "assembly") {
        addAssembly(node, s, warnings);
    } else if (type == "symmetry") {
        placeCopies(crystalCopies(*s.molecule, readCells(node, "ijk_min", -1), readCells(node, "ijk_max", 1)), s);
    } else if (type == "symmetry_mates") {
        const Json* radius = node.param("radius");
        placeCopies(crystalMates(*s.molecule, radius && radius->is_number() ? radius->get<double>() : 5.0), s);
    } else if (type != "model") {
        warnings.add(node, "there is no structure type '" + nacre::printable(type) + "': its model is shown");
    }
    return s;
}

Structure Structure::copied() const {
    Structure s;
    s.uri = uri;
    s.molecule = std::make_unique<Molecule>(*molecule);
    s.molecule->assemblies.clear();
    s.atoms = std::make_unique<StructureAtoms>(*s.molecule, instanceIds);
    s.transforms = transforms, s.lists = lists, s.listOfResidue = listOfResidue, s.instanceIds = instanceIds;
    s.moved = moved, s.instances = instances;
    s.representation = representation;
    return s;
}

void takeMotions(const Node& node, Structure& s, const std::vector<std::uint32_t>& atoms) {
    std::optional<glm::dvec3> known;  // computed once for all instances: it takes time proportional to the atoms
    const auto centroid = [&] {
        if (known) return *known;
        const std::vector<glm::dvec4> points = placedBalls(s, atoms, 0);
        return *(known = points.empty() ? glm::dvec3(0) : extremeSphere(points).center);
    };
    for (const Node& child : node.children) {
        if (child.kind != "transform") continue;
        s.moved = joinedMotion(motionOfNode(child, centroid), s.moved);
        known.reset();
    }
    std::vector<glm::dmat4x3> instances;
    for (const Node& child : node.children)
        if (child.kind == "instance") instances.push_back(motionOfNode(child, centroid));
    s.instances = std::move(instances);
}

std::vector<glm::dmat4x3> readMotions(const Node& node, const glm::dvec3& center) {
    glm::dmat4x3 moved(1.0);
    const auto centroid = [&] { return glm::dvec3(moved * glm::dvec4(center, 1.0)); };
    for (const Node& child : node.children)
        if (child.kind == "transform") moved = joinedMotion(motionOfNode(child, centroid), moved);
    std::vector<glm::dmat4x3> motions;
    for (const Node& child : node.children)
        if (child.kind == "instance") motions.push_back(joinedMotion(motionOfNode(child, centroid), moved));
    return motions.empty() ? std::vector{moved} : motions;
}

glm::dmat4x3 joinedMotion(const glm::dmat4x3& first, const glm::dmat4x3& second) {
    glm::dmat4x3 both;
    for (int column = 0; column < 4; ++column)
        both[column] = first * glm::dvec4(second[column], column == 3 ? 1.0 : 0.0);
    return both;
}

std::vector<bool> selected(const Node& node, const Json* selector, const Structure& structure,
                           SceneWarnings& warnings) {
    std::vector<bool> atoms(structure.molecule->atoms.size());
    const auto add = [&](const Json& json) {
        if (!json.is_object()) return warnings.add(node, "an expression of its selector is no object");
        Expression expression;
        for (const auto& [key, value] : json.items()) {
            try {
                if (!setField(expression, key, value))
                    warnings.add(node, "there is no selector field '" + nacre::printable(key) + "'");
            } catch (const std::invalid_argument& why) {
                throw Error("cannot draw scene", node.place, nacre::printable(key) + ": " + why.what());
            }
        }
        structure.atoms->add(expression, atoms);
    };
    if (!selector) {
        atoms.assign(atoms.size(), true);
    } else if (selector->is_string()) {
        if (auto kind = structure.atoms->ofKind(selector->get<std::string>())) return *kind;
        warnings.add(node, "there is no selector '" + nacre::printable(selector->get<std::string>()) + "'");
    } else if (selector->is_array()) {
        for (const Json& each : *selector) add(each);
    } else {
        add(*selector);
    }
    return atoms;
}

std::string findColumn(const Node& node, const std::string& field) {
    const Json* columns = node.param("field_remapping");
    if (!columns || !columns->is_object() || !columns->contains(field)) return field;
    const Json& column = (*columns)[field];
    return column.is_string() ? column.get<std::string>() : "";
}

std::vector<AnnotationRow> readRows(const Node& node, const char* field, const Structure& structure, SceneFiles& files,
                                    std::vector<std::string> further) {
    const bool fromUri = node.kind.ends_with("_from_uri");
    const std::string uri = fromUri ? nodeText(node, "uri") : structure.uri;
    if (uri.empty()) refuseNode(node, "it has no uri");
    TablePlace place;
    place.block = nodeText(node, "block_header");
    place.blockIndex = readIndex(node, "block_index");
    place.category = nodeText(node, "category_name");
    const std::string named = nodeText(node, "field_name");
    AnnotationFields fields{std::move(further), {}};
    if (fields.values.size() > kMostAnnotationFields)
        refuseNode(node, "it names more than " + std::to_string(kMostAnnotationFields) + " fields");
    fields.values.insert(fields.values.begin(), named.empty() ? field : named);
    if (const Json* columns = node.param("field_remapping"); columns && columns->is_object())
        for (const auto& [standard, column] : columns->items())
            fields.columns.emplace(standard, findColumn(node, standard));
    return readAnnotations(nacre::printable(uri, 200), files.bytes(uri), place, nodeText(node, "schema"), fields);
}

void tellUnknown(const Node& node, const Node& parent, SceneWarnings& warnings) {
    if (!node.fault.empty()) return warnings.add(node, node.fault + ": it is left out");
    const NodeRow* row = nodeRow(node.kind);
    if (!row) return warnings.add(node, "nodes of this kind are not drawn");
    if (!row->isBelow(parent.kind))
        return warnings.add(node, "it is not drawn below a " + nacre::printable(parent.kind, 40) + " node");
    if (node.kind == "representation" || node.kind == "volume_representation" || node.kind == "clip" ||
        node.kind == "interpolate")
        return;  // each type has its own
    tellUnused(node, *row, warnings);
}

void tellUnused(const Node& node, const NodeRow& row, SceneWarnings& warnings) {
    for (const auto& [key, value] : node.params.items())
        if (!value.is_null() && !row.knows(key))
            warnings.add(node, "its parameter '" + nacre::printable(key) + "' is not used");
}

void keepAtoms(SceneLayer& layer, const std::function<bool(std::size_t)>& keeps) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < layer.atoms.size(); ++i) {
        if (!keeps(i)) continue;
        layer.atoms[kept] = layer.atoms[i];
        layer.colors[kept] = layer.colors[i];
        if (!layer.opacity.empty()) layer.opacity[kept] = layer.opacity[i];
        ++kept;
    }
    layer.atoms.resize(kept), layer.colors.resize(kept);
    if (!layer.opacity.empty()) layer.opacity.resize(kept);
}

std::vector<glm::dmat4x3> listMotions(const Structure& s, const glm::dmat4x3& copy) {
    const glm::dmat4x3 moved = joinedMotion(s.moved, copy);
    if (s.instances.empty()) return {moved};
    std::vector<glm::dmat4x3> motions;
    for (const glm::dmat4x3& instance : s.instances) motions.push_back(joinedMotion(instance, moved));
    return motions;
}

glm::dmat4x3 findFirstMotion(const Structure& s) {
    return listMotions(s, s.transforms.empty() ? glm::dmat4x3(1.0) : s.transforms.front()).front();
}

std::uint32_t listOfCopies(const Structure& s, std::uint32_t residue) {
    return s.listOfResidue.empty() ? 0 : s.listOfResidue[residue];
}

std::vector<glm::dvec4> placedBalls(const Structure& s, const std::vector<std::uint32_t>& atoms, double scale) {
    constexpr std::size_t kManyCopies = 14, kManyBalls = 100'000;
    const auto reduce = [](std::vector<glm::dvec4>& balls) {
        const std::vector<glm::dvec3> extreme = extremePoints(balls);
        balls.clear();
        for (const glm::dvec3& point : extreme) balls.emplace_back(point, 0.0);
    };
    std::map<std::uint32_t, std::vector<glm::dvec4>> still;  // by list of copies
    for (const std::uint32_t index : atoms) {
        const Atom& atom = s.molecule->atoms[index];
        still[listOfCopies(s, atom.residue)].emplace_back(glm::dvec3(atom.position),
                                                          scale * static_cast<double>(molstarRadius(atom.element)));
    }
    std::vector<glm::dvec4> placed;
    const auto place = [&](const std::vector<glm::dvec4>& balls, const glm::dmat4x3& copy) {
        for (const glm::dmat4x3& motion : listMotions(s, copy)) {
            if (placed.size() > kManyBalls) reduce(placed);
            for (const glm::dvec4& ball : balls)
                placed.emplace_back(motion * glm::dvec4(glm::dvec3(ball), 1.0), ball.w);
        }
    };
    for (auto& [list, balls] : still) {
        if (s.transforms.empty()) place(balls, glm::dmat4x3(1.0));
        if (s.transforms.empty() || list == UINT32_MAX) continue;
        if (s.lists[list].size() > kManyCopies) reduce(balls);
        for (const std::uint32_t copy : s.lists[list]) place(balls, s.transforms[copy]);
    }
    return placed;
}

namespace {

std::size_t countCopies(const Structure& s, std::uint32_t atom) {
    const std::uint32_t list = listOfCopies(s, s.molecule->atoms[atom].residue);
    const std::size_t placed = s.transforms.empty() ? 1 : list == UINT32_MAX ? 0 : s.lists[list].size();
    return placed * std::max<std::size_t>(s.instances.size(), 1);
}

}  // namespace

Primitives::Label makeLabel(const std::string& text, const std::vector<std::uint32_t>& atoms, const Structure& s,
                            std::optional<std::uint32_t> color, double& depth) {
    std::size_t all = 0, heavy = 0;
    for (const std::uint32_t atom : atoms) {
        const std::size_t copies = countCopies(s, atom);
        all += copies;
        if (!isHydrogen(s.molecule->atoms[atom].element)) heavy += copies;
    }
    Primitives::Label label;
    const Bounds sphere = extremeSphere(placedBalls(s, atoms, 0));
    label.at = sphere.center;
    depth = sphere.radius;
    label.text = withoutMarkup(text);
    label.size = kEmOfSize * std::cbrt(static_cast<double>(heavy > 0 ? heavy : all));
    label.color = color;
    return label;
}

std::string withoutMarkup(std::string_view text) {
    std::string plain;
    for (const char c : text) {
        if (c == '_' || c == '^' || c == '\\' || c == '{' || c == '}') plain += '\\';
        plain += c == '\n' ? ' ' : c;
    }
    return plain;
}

}  // namespace nacre::app::mvs
