#include "app/input/primitives_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/files/json_text.h"
#include "app/picture/color_values.h"
#include "app/picture/option_text.h"
#include "app/picture/option_values.h"
#include "app/picture/words.h"
#include "engine/error.h"
#include "engine/molecule/crystal.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/build/appearance.h"

namespace nacre::app {
namespace {

using PrimitiveJson = nlohmann::json;

constexpr std::size_t kMostFileBytes = std::size_t{256} << 20;
constexpr double kThickest = 1000;  // maximum of radii and widths, Å or pixels

/// The keys of one primitive. Keys that are never read are unknown ones.
class Keys {
public:
    Keys(const PrimitiveJson& object, const FindPlace& findPlace) : object_(object), findPlace_(findPlace) {}

    bool has(const char* key) {
        known_.emplace_back(key);
        return object_.contains(key);
    }
    const PrimitiveJson& need(const char* key) {
        if (!has(key)) throw std::invalid_argument("\"" + std::string(key) + "\" is missing");
        return object_[key];
    }

    template <typename Read>
    auto at(const char* key, const Read& read) {
        const PrimitiveJson& value = need(key);
        try {
            return read(value);
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("\"" + std::string(key) + "\": " + error.what());
        }
    }

    double number(const char* key, double otherwise, double low, double high) {
        return has(key) ? at(key, [&](const PrimitiveJson& v) { return within(v, low, high); }) : otherwise;
    }
    bool flag(const char* key, bool otherwise) {
        if (!has(key)) return otherwise;
        return at(key, [](const PrimitiveJson& v) {
            if (!v.is_boolean()) throw std::invalid_argument("expected true or false");
            return v.get<bool>();
        });
    }
    std::string text(const char* key) {
        return at(key, [](const PrimitiveJson& v) {
            if (!v.is_string()) throw std::invalid_argument("expected a text");
            return v.get<std::string>();
        });
    }
    glm::dvec3 vector(const char* key) { return at(key, threeNumbers); }
    /// Three numbers, or a selection.
    glm::dvec3 place(const char* key) {
        return at(key, [&](const PrimitiveJson& v) {
            return v.is_string() ? findPlace_(v.get<std::string>()) : threeNumbers(v);
        });
    }
    std::uint32_t color(const char* key) { return at(key, readColor); }

    std::array<glm::dvec3, 3> vectors(const char* key) {
        return at(key, [](const PrimitiveJson& v) {
            if (!v.is_array() || v.size() != 3) throw std::invalid_argument("expected three lists of three numbers");
            return std::array{threeNumbers(v[0]), threeNumbers(v[1]), threeNumbers(v[2])};
        });
    }

    void refuseUnknown() const {
        for (const auto& [key, value] : object_.items())
            if (std::find(known_.begin(), known_.end(), key) == known_.end())
                throw std::invalid_argument("there is no \"" + key + "\"" + suggestion(key, known_));
    }

    static double within(const PrimitiveJson& value, double low, double high) {
        if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high))
            throw std::invalid_argument("expected a number from " + numberText(low) + " to " + numberText(high));
        return value.get<double>();
    }
    static glm::dvec3 threeNumbers(const PrimitiveJson& v) {
        if (!v.is_array() || v.size() != 3 || !std::all_of(v.begin(), v.end(), [](const PrimitiveJson& n) {
                return n.is_number() && std::isfinite(n.get<double>());
            }))
            throw std::invalid_argument("expected three numbers");
        return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
    }
    static std::uint32_t readColor(const PrimitiveJson& v) {
        if (!v.is_string()) throw std::invalid_argument("expected a colour's name or #rrggbb");
        const std::array<float, 4> color = parseColor(v.get<std::string>());
        if (color[3] < 1) throw std::invalid_argument("expected an opaque colour (\"opacity\" makes it translucent)");
        return opaqueColor(color);
    }

private:
    const PrimitiveJson& object_;
    const FindPlace& findPlace_;
    std::vector<std::string> known_;
};

/// Lists of numbers, flat or grouped by three.
std::vector<double> flatNumbers(const PrimitiveJson& list) {
    std::vector<double> numbers;
    const auto add = [&](const PrimitiveJson& v) {
        if (!v.is_number() || !std::isfinite(v.get<double>()))
            throw std::invalid_argument("expected numbers in threes");
        numbers.push_back(v.get<double>());
    };
    if (!list.is_array()) throw std::invalid_argument("expected a list");
    for (const PrimitiveJson& v : list) {
        if (v.is_array() && v.size() == 3)
            std::for_each(v.begin(), v.end(), add);
        else
            add(v);
    }
    if (numbers.size() % 3 != 0) throw std::invalid_argument("expected numbers in threes");
    return numbers;
}

class Reader {
public:
    Reader(const FindPlace& findPlace, const FileSummary& file, Primitives& all)
        : findPlace_(findPlace), cell_(cellEdges(file)), corner_(file.boxOrigin), all_(all) {}

    void add(const PrimitiveJson& object) {
        if (!object.is_object()) throw std::invalid_argument("expected an object");
        Keys keys(object, findPlace_);
        const std::string kind = keys.text("kind");
        using Add = void (Reader::*)(Keys&);
        constexpr std::pair<const char*, Add> kKinds[] = {
            {"line", &Reader::line},   {"tube", &Reader::tube},           {"arrow", &Reader::arrow},
            {"sphere", &Reader::ball}, {"ellipsoid", &Reader::ellipsoid}, {"ellipse", &Reader::ellipse},
            {"box", &Reader::box},     {"mesh", &Reader::mesh},           {"label", &Reader::label},
            {"cell", &Reader::cell}};
        std::vector<std::string> names;
        for (const auto& [name, read] : kKinds) {
            names.emplace_back(name);
            if (kind != name) continue;
            (this->*read)(keys);
            return keys.refuseUnknown();
        }
        throw std::invalid_argument("\"kind\": expected " + joinAlternatives(names) + ", not '" + kind + "'" +
                                    suggestion(kind, names));
    }

private:
    PrimitiveLook look(Keys& keys) {
        PrimitiveLook look;
        if (keys.has("color")) look.color = keys.color("color");
        look.opacity = keys.number("opacity", 1, kLeastOpacity, 1);
        all_.notes.push_back(keys.has("note") ? keys.text("note") : "");
        look.note = static_cast<std::uint32_t>(all_.notes.size());
        return look;
    }
    PrimitiveDashes dashes(Keys& keys) {
        if (!keys.has("dash")) return {};
        return keys.at("dash", [](const PrimitiveJson& v) {
            constexpr double kLeast = 0.01;
            if (v.is_number()) return PrimitiveDashes{Keys::within(v, kLeast, kThickest), v.get<double>()};
            if (!v.is_array() || v.size() != 2) throw std::invalid_argument("expected a length, or two: dash and gap");
            return PrimitiveDashes{Keys::within(v[0], kLeast, kThickest), Keys::within(v[1], kLeast, kThickest)};
        });
    }

    void line(Keys& keys) {
        Primitives::Line line{keys.place("from"), keys.place("to"), 0, keys.number("width", 1.5, 0.5, 10)};
        line.dashes = dashes(keys);
        line.look = look(keys);
        if (line.look.opacity < 1) throw std::invalid_argument("lines are opaque (a tube may be translucent)");
        all_.lines.push_back(line);
    }
    void tube(Keys& keys) {
        Primitives::Line line{keys.place("from"), keys.place("to"), keys.number("radius", 0.1, 0.001, kThickest), 0};
        line.dashes = dashes(keys);
        line.look = look(keys);
        all_.lines.push_back(line);
    }
    void arrow(Keys& keys) {
        Primitives::Arrow arrow;
        arrow.from = keys.place("from");
        const bool direction = keys.has("direction");
        arrow.to = direction ? arrow.from + keys.vector("direction") : keys.place("to");
        arrow.radius = keys.number("radius", 0.1, 0, kThickest);
        arrow.headRadius = keys.number("head_radius", 2.4 * arrow.radius, 0, kThickest);
        arrow.headLength = keys.number("head_length", 6 * arrow.radius, 0, kThickest);
        if (keys.has("heads")) {
            const std::size_t heads = keys.at("heads", [](const PrimitiveJson& v) {
                return parseChoice(v.is_string() ? v.get<std::string>() : v.dump(), {"to", "from", "both"});
            });
            arrow.headAtTo = heads != 1, arrow.headAtFrom = heads != 0;
        }
        arrow.dashes = dashes(keys);
        arrow.look = look(keys);
        all_.arrows.push_back(arrow);
    }
    void ball(Keys& keys) {
        all_.balls.push_back({keys.place("center"), keys.number("radius", 1, 0.001, kFarthestPrimitive), look(keys)});
    }
    void ellipsoid(Keys& keys) {
        Primitives::Ellipsoid e{keys.place("center"), {}, {}};
        if (keys.has("radii")) {
            const glm::dvec3 radii = keys.vector("radii");
            for (int i = 0; i < 3; ++i) e.axes[static_cast<std::size_t>(i)][i] = radii[i];
        } else {
            e.axes = keys.vectors("axes");
        }
        e.look = look(keys);
        all_.ellipsoids.push_back(e);
    }
    void ellipse(Keys& keys) {
        constexpr double kDegree = std::numbers::pi / 180;
        Primitives::Ellipse e{keys.place("center"), keys.vector("major"), keys.vector("minor")};
        e.start = kDegree * keys.number("start", 0, -360, 360);
        e.end = kDegree * keys.number("end", e.start / kDegree + 360, -720, 720);
        e.look = look(keys);
        all_.ellipses.push_back(e);
    }
    void box(Keys& keys) {
        Primitives::Box box;
        if (keys.has("min")) {
            const glm::dvec3 low = keys.vector("min"), high = keys.vector("max");
            box.center = (low + high) / 2.0;
            for (int i = 0; i < 3; ++i) box.axes[static_cast<std::size_t>(i)][i] = (high[i] - low[i]) / 2;
        } else {
            box.center = keys.place("center");
            if (keys.has("axes")) {
                box.axes = keys.vectors("axes");
            } else {
                const glm::dvec3 size = keys.vector("size");
                for (int i = 0; i < 3; ++i) box.axes[static_cast<std::size_t>(i)][i] = size[i] / 2;
            }
        }
        box.faces = box.edges = look(keys);
        part(keys, "edges", false, box.edges);
        part(keys, "faces", true, box.faces);
        addBox(keys, box);
    }
    void addBox(Keys& keys, Primitives::Box& box) {
        if (box.edges) box.edges->opacity = 1;
        box.edgeRadius = keys.number("edge_radius", 0, 0, kThickest);
        box.edgeWidth = keys.number("edge_width", 1.5, 0.5, 10);
        all_.boxes.push_back(box);
    }
    void cell(Keys& keys) {
        if (!cell_) throw std::invalid_argument("the structure states no unit cell and no periodic box");
        Primitives::Box box;
        box.center = corner_;
        for (std::size_t i = 0; i < 3; ++i) {
            box.axes[i] = (*cell_)[i] / 2.0;
            box.center += box.axes[i];
        }
        box.faces.reset();
        box.edges = look(keys);
        addBox(keys, box);
    }
    /// A part that may be hidden or have its own colour. @returns whether it is drawn
    static bool part(Keys& keys, const char* key, bool otherwise, std::optional<PrimitiveLook>& look) {
        bool drawn = otherwise;
        if (keys.has(key))
            keys.at(key, [&](const PrimitiveJson& v) {
                drawn = !v.is_boolean() || v.get<bool>();
                if (!v.is_boolean()) look->color = Keys::readColor(v);
                return 0;
            });
        if (!drawn) look.reset();
        return drawn;
    }
    void mesh(Keys& keys) {
        Primitives::Mesh mesh;
        const std::vector<double> at = keys.at("vertices", flatNumbers);
        if (at.empty()) throw std::invalid_argument("\"vertices\": there are none");
        for (std::size_t i = 0; i < at.size(); i += 3) mesh.positions.emplace_back(at[i], at[i + 1], at[i + 2]);
        for (const std::vector<double> of = keys.at("triangles", flatNumbers); std::size_t i : steps(of.size())) {
            std::array<std::uint32_t, 3> t{};
            for (std::size_t k = 0; k < 3; ++k) {
                if (!(of[i + k] >= 0 && of[i + k] < static_cast<double>(mesh.positions.size())))
                    throw std::invalid_argument("\"triangles\": expected vertices' numbers from 0 to " +
                                                std::to_string(mesh.positions.size() - 1));
                t[k] = static_cast<std::uint32_t>(of[i + k]);
            }
            mesh.triangles.push_back(t);
        }
        const PrimitiveLook one = look(keys);
        mesh.looks = {one};
        if (keys.has("colors"))
            mesh.looks = keys.at("colors", [&](const PrimitiveJson& v) { return readLooks(v, one, mesh); });
        mesh.smooth = keys.flag("smooth", false);
        mesh.faces = keys.flag("faces", true);
        mesh.wireWidth = keys.number("wire_width", 1, 0.5, 10);
        std::optional<PrimitiveLook> wires = one;
        if (part(keys, "wires", !mesh.faces, wires)) mesh.wires = wires;
        all_.meshes.push_back(std::move(mesh));
    }
    static std::vector<std::size_t> steps(std::size_t count) {
        std::vector<std::size_t> firsts;
        for (std::size_t i = 0; i < count; i += 3) firsts.push_back(i);
        return firsts;
    }
    static std::vector<PrimitiveLook> readLooks(const PrimitiveJson& list, const PrimitiveLook& one,
                                                const Primitives::Mesh& mesh) {
        if (!list.is_array() || (list.size() != mesh.triangles.size() && list.size() != mesh.positions.size()))
            throw std::invalid_argument("expected a colour for each of " + std::to_string(mesh.triangles.size()) +
                                        " triangles or " + std::to_string(mesh.positions.size()) + " vertices");
        std::vector<PrimitiveLook> looks;
        for (const PrimitiveJson& color : list) {
            looks.push_back(one);
            looks.back().color = Keys::readColor(color);
        }
        return looks;
    }
    void label(Keys& keys) {
        Primitives::Label label{keys.place("at"), parseTitle(keys.text("text"))};
        label.size = keys.number("size", 0, 0.01, kThickest);
        if (keys.has("color")) label.color = keys.color("color");
        all_.labels.push_back(std::move(label));
    }

    const FindPlace& findPlace_;
    std::optional<std::array<glm::dvec3, 3>> cell_;
    glm::dvec3 corner_;
    Primitives& all_;
};

}  // namespace

Primitives readPrimitives(const std::string& text, const std::string& name, const FindPlace& findPlace,
                          const FileSummary& file) {
    const PrimitiveJson json = parseJsonText<PrimitiveJson>(text, "cannot read primitives", name);
    const PrimitiveJson* list = &json;
    if (json.is_object() && json.contains("primitives")) {
        if (json.size() > 1) throw Error("cannot read primitives", name, "expected \"primitives\" alone");
        list = &json["primitives"];
    }
    Primitives all;
    Reader reader(findPlace, file, all);
    const auto add = [&](const PrimitiveJson& one, std::size_t number) {
        try {
            reader.add(one);
        } catch (const std::invalid_argument& error) {
            throw Error("cannot read primitives", name, "primitive " + std::to_string(number) + ": " + error.what());
        }
    };
    if (list->is_object()) {
        add(*list, 1);
        return all;
    }
    if (!list->is_array()) throw Error("cannot read primitives", name, "expected a list of primitives");
    if (list->size() > kMostPrimitives)
        throw Error(
            "cannot read primitives", name,
            std::to_string(list->size()) + " primitives are more than the limit of " + std::to_string(kMostPrimitives));
    for (std::size_t i = 0; i < list->size(); ++i) add((*list)[i], i + 1);
    return all;
}

Primitives loadPrimitives(const std::vector<PrimitiveSource>& sources, const Molecule& molecule) {
    const FindPlace findPlace = [&](const std::string& text) {
        const std::vector<bool> chosen = selectAtoms(molecule, parseSelection(text));
        glm::dvec3 sum{};
        double count = 0;
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (chosen[i]) sum += glm::dvec3(molecule.atoms[i].position), ++count;
        if (count == 0) throw std::invalid_argument("'" + text + "' matches no atoms");
        return sum / count;
    };
    Primitives all;
    for (const PrimitiveSource& source : sources) {
        if (source.made)
            all.append(*source.made);
        else if (isJsonText(source.text))
            all.append(readPrimitives(source.text, "--primitives", findPlace, molecule.file));
        else
            all.append(readPrimitives(readTextFile("cannot read primitives", source.text, kMostFileBytes), source.text,
                                      findPlace, molecule.file));
    }
    return all;
}

}  // namespace nacre::app
