#include "app/mvs/build_scene.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "app/mvs/animation.h"
#include "app/mvs/camera_nodes.h"
#include "app/mvs/clip_nodes.h"
#include "app/mvs/instance_ids.h"
#include "app/mvs/scene_parts.h"
#include "app/mvs/scene_primitives.h"
#include "app/mvs/scene_shapes.h"
#include "app/mvs/scene_volumes.h"
#include "app/mvs/split_copies.h"
#include "engine/error.h"
#include "engine/molecule/displacement.h"
#include "engine/molecule/join_models.h"
#include "engine/molecule/text.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app::mvs {
namespace {

/// The extent of one list of labels by Mol*'s rules: their points, surrounded by the largest half width of a text or
/// depth of a labelled part.
class LabelBalls {
public:
    void add(const Primitives::Label& label, double depth) {
        constexpr double kWidth = 0.57;  // of a character, em
        points_.emplace_back(label.at, 0.0);
        room_ = std::max({room_, depth, label.size * kWidth / 2 * static_cast<double>(label.text.size())});
    }
    std::vector<glm::dvec4> balls() const {
        if (points_.empty()) return {};
        const Bounds sphere = extremeSphere(points_);
        if (!(sphere.radius > 0)) return {glm::dvec4(sphere.center, room_)};
        std::vector<glm::dvec4> balls;
        for (const glm::dvec3& point : movedOut(extremePoints(points_), sphere, room_)) balls.emplace_back(point, 0.0);
        return balls;
    }

private:
    std::vector<glm::dvec4> points_;
    double room_ = 0;
};

/// Whether a copy shows an atom.
bool isPlaced(const Structure& s, std::uint32_t atom) {
    return listOfCopies(s, s.molecule->atoms[atom].residue) != UINT32_MAX;
}

class SceneBuilder {
public:
    SceneBuilder(const std::string& name, const SceneSources& sources) : name_(name), files_(sources) {}

    SceneWarnings& warnings() { return warnings_; }

    Molecule build(const Snapshot& snapshot) {
        guide_ = std::make_shared<SceneGuide>();
        for (const Node& node : snapshot.root.children) findCoordinates(node);
        instanceIds_ = namedInstances(snapshot.root, files_);
        for (const Node& node : snapshot.root.children) root(node, snapshot.root);
        guide_->title = snapshot.title;
        return joined();
    }

private:
    void root(const Node& node, const Node& parent) {
        files_.step();
        tellUnknown(node, parent, warnings_);
        if (node.kind == "download") download(node);
        if (node.kind == "camera") camera_.takeCamera(node, warnings_);
        if (node.kind == "canvas") canvas(node);
        if (node.kind == "focus") camera_.focusAll(node);
        if (node.kind.starts_with("primitives")) group(node, kNoStructure);
        if (node.kind == "transition") checkTransition(node);
    }

    void checkTransition(const Node& node) {
        const CameraTransition transition = readTransition(node);
        if (!easedByName(transition.easing, 0.5))
            warnings_.add(node, "there is no easing '" + nacre::printable(transition.easing, 40) + "'");
        constexpr std::string_view kPaths[] = {"linear", "linear-relative", "leap", "leap-relative"};
        if (std::find(std::begin(kPaths), std::end(kPaths), transition.trajectory) == std::end(kPaths))
            warnings_.add(node, "there is no trajectory '" + nacre::printable(transition.trajectory, 40) + "'");
    }

    /// Structures may name coordinates that follow them.
    void findCoordinates(const Node& download) {
        for (const Node& parse : download.children)
            for (const Node& node : parse.children)
                if (node.kind == "coordinates" && !node.ref.empty())
                    files_.addCoordinates(node.ref, nodeText(download, "url"));
    }

    void group(const Node& node, std::size_t structure) {
        Group group{&node, structure, {}};
        for (const Node& child : node.children)
            if (child.kind == "focus") group.focuses.push_back(camera_.takeFocusLater(child));
        groups_.push_back(std::move(group));
    }

    void canvas(const Node& node) {
        if (!node.param("background_color")) return;
        const auto color = readColor(node.param("background_color"));
        if (!color) return warnings_.add(node, "it names no colour");
        std::array<float, 4> background{0, 0, 0, 1};
        for (std::size_t i = 0; i < 3; ++i) background[i] = static_cast<float>(*color >> (8 * i) & 0xff) / 255.0f;
        guide_->background = background;
    }

    void download(const Node& node) {
        const std::string url = nodeText(node, "url");
        if (url.empty()) throw Error("cannot draw scene", node.place, "it has no url");
        for (const Node& child : node.children) {
            tellUnknown(child, node, warnings_);
            if (child.kind == "parse") parse(child, url);
        }
    }

    void parse(const Node& node, const std::string& url) {
        for (const Node& child : node.children) {
            files_.step();
            tellUnknown(child, node, warnings_);
            if (child.kind == "structure") structure(node, child, url);
            if (child.kind == "shape") addShape(node, child, url, files_, *guide_, camera_, warnings_);
            if (child.kind == "volume") addVolume(child, url, files_, *guide_, camera_, warnings_);
        }
    }

    void structure(const Node& parse, const Node& node, const std::string& url) {
        checkCount(node);
        const std::size_t own = structures_.size();
        structures_.push_back(readStructure(parse, node, url, files_, warnings_));
        splitInstances(node, instanceIds_, structures_[own], files_);
        takeMotions(node, structures_[own], structures_[own].atoms->all());
        const std::vector<bool> all(structures_[own].molecule->atoms.size(), true);
        for (const Node& child : node.children) {
            files_.step();
            tellUnknown(child, node, warnings_);
            if (child.kind.starts_with("component")) component(child, own);
            words(child, all, own);
            if (child.kind.starts_with("primitives")) group(child, own);
        }
    }

    void checkCount(const Node& node) const {
        if (structures_.size() == kMostStructures)
            throw Error("cannot draw scene", node.place,
                        "it has more than " + std::to_string(kMostStructures) + " structures");
    }

    /// The structure of a component: one of its own if it moves by itself.
    std::size_t structureOf(const Node& node, std::size_t whole, const std::vector<std::uint32_t>& atoms) {
        const auto moves = [](const Node& child) { return child.kind == "transform" || child.kind == "instance"; };
        if (atoms.empty() || std::ranges::none_of(node.children, moves)) return whole;
        checkCount(node);
        files_.countCopied(node, structures_[whole].molecule->atoms.size());
        Structure own = structures_[whole].copied();
        own.ref = node.ref;
        foldInstances(node, own);
        takeMotions(node, own, atoms);
        structures_.push_back(std::move(own));
        return structures_.size() - 1;
    }

    /// Adds labels, tooltips and focus of some atoms of a structure.
    void words(const Node& node, const std::vector<bool>& atoms, std::size_t structure) {
        Structure& s = structures_[structure];
        if (node.kind == "label" || node.kind == "tooltip")
            addText(node, atoms, nodeText(node, "text"), s, node.kind == "label" ? s.labels : s.tooltips);
        if (node.kind.starts_with("label_from_")) addTexts(node, "label", s, s.labels);
        if (node.kind.starts_with("tooltip_from_")) addTexts(node, "tooltip", s, s.tooltips);
        if (node.kind == "focus") camera_.takeFocus(node, structure, s.atoms->selectDrawn(atoms));
    }

    void addText(const Node& node, const std::vector<bool>& atoms, const std::string& text, const Structure& s,
                 std::vector<Structure::Text>& labels, const Node* source = nullptr) {
        Structure::Text label{s.atoms->selectDrawn(atoms), text, source};
        std::erase_if(label.atoms, [&](std::uint32_t atom) { return !isPlaced(s, atom); });
        if (label.atoms.empty() || text.empty()) return;
        files_.countShown(node.place, label.atoms.size());
        labels.push_back(std::move(label));
    }

    /// Adds one text for each group of rows.
    void addTexts(const Node& node, const char* field, Structure& s, std::vector<Structure::Text>& labels) {
        for (const auto& [text, atoms] : readTextGroups(node, field, s, files_, warnings_))
            addText(node, atoms, text, s, labels, &node);
    }

    std::vector<bool> selectedBy(const Node& node, const Structure& s) {
        if (node.kind == "component") return selected(node, node.param("selector"), s, warnings_);
        const Json* wanted = node.param("field_values");
        std::vector<bool> atoms(s.molecule->atoms.size());
        for (const AnnotationRow& row : readRows(node, "component", s, files_)) {
            const bool chosen = !wanted || (row.value() && wanted->is_array() &&
                                            std::find(wanted->begin(), wanted->end(), *row.value()) != wanted->end());
            if (chosen) s.atoms->add(row.expression, atoms);
        }
        return atoms;
    }

    void component(const Node& node, std::size_t whole) {
        const std::vector<bool> atoms = selectedBy(node, structures_[whole]);
        const std::vector<std::uint32_t> drawn = structures_[whole].atoms->selectDrawn(atoms);
        if (drawn.empty()) warnings_.add(node, "it matches no atoms");
        const std::size_t structure = structureOf(node, whole, drawn);
        for (const Node& child : node.children) {
            files_.step();
            tellUnknown(child, node, warnings_);
            if (child.kind == "representation") {
                if (++layers_ > kMostLayers)
                    throw Error("cannot draw scene", child.place,
                                "it has more than " + std::to_string(kMostLayers) + " representations");
                Structure& s = structures_[structure];
                if (!s.representation) s.representation = &child;
                files_.countShown(child.place, drawn.size());
                if (auto layer = readRepresentation(child, drawn, s, files_, warnings_))
                    addLayer(child, std::move(*layer), structure);
            }
            words(child, atoms, structure);
        }
    }

    /// Cuts a layer by the clips of its node. It may get a structure of its own.
    void addLayer(const Node& node, SceneLayer layer, std::size_t structure) {
        const ClipRegions regions(node, warnings_);
        if (!regions.empty() && !hasCopies(structures_[structure])) {
            clipLayer(regions, structures_[structure], layer);
        } else if (!regions.empty()) {
            auto own = separateCut(node, regions, structures_[structure], layer, files_, warnings_);
            if (own) {
                checkCount(node);
                own->original = structure;
                structures_.push_back(std::move(*own));
                structure = structures_.size() - 1;
            }
        }
        if (!layer.atoms.empty()) structures_[structure].layers.push_back(std::move(layer));
    }

    /// Whether no structure has copies: then atoms are moved to their final positions.
    bool single() const {
        return std::all_of(structures_.begin(), structures_.end(), [](const Structure& s) {
            return s.transforms.size() + s.instances.size() <= 1 &&
                   std::ranges::find(s.listOfResidue, UINT32_MAX) == s.listOfResidue.end();
        });
    }

    static void putAtoms(Structure& s) {
        const glm::dmat4x3 motion = findFirstMotion(s);
        if (motion == glm::dmat4x3(1.0)) return;
        for (std::size_t i = 0; i < s.molecule->atoms.size(); ++i) {
            glm::vec3& position = s.molecule->atoms[i].position;
            position = glm::vec3(motion * glm::dvec4(glm::dvec3(position), 1.0));
            turnDisplacement(*s.molecule, i, glm::dmat3(motion));
        }
    }

    /// Adds the copies of a structure to those of the scene.
    void placeCopies(const Structure& s) {
        const auto add = [&](const std::vector<glm::dmat4x3>& copies) {
            std::vector<std::uint32_t> list;
            for (const glm::dmat4x3& copy : copies)
                for (const glm::dmat4x3& motion : listMotions(s, copy)) {
                    std::array<double, 12> numbers{};
                    std::copy_n(&motion[0][0], numbers.size(), numbers.begin());
                    const auto [known, isNew] =
                        transforms_.emplace(numbers, static_cast<std::uint32_t>(guide_->transforms.size()));
                    list.push_back(known->second);
                    if (isNew) guide_->transforms.push_back(motion);
                    if (guide_->transforms.size() > kMostCopies)
                        throw Error("cannot draw scene", name_,
                                    "it has more than " + std::to_string(kMostCopies) + " copies");
                }
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
            const auto [known, isNew] =
                lists_.emplace(std::move(list), static_cast<std::uint32_t>(guide_->lists.size()));
            if (isNew) guide_->lists.push_back(known->first);
            return known->second;
        };
        std::vector<std::uint32_t> places;
        if (s.transforms.empty()) places.push_back(add({glm::dmat4x3(1.0)}));
        for (const std::vector<std::uint32_t>& list : s.lists) {
            std::vector<glm::dmat4x3> copies;
            for (const std::uint32_t copy : list) copies.push_back(s.transforms[copy]);
            places.push_back(add(copies));
        }
        for (std::uint32_t i = 0; i < s.molecule->residues.size(); ++i) {
            const std::uint32_t list = listOfCopies(s, i);
            guide_->listOfResidue.push_back(list == UINT32_MAX ? UINT32_MAX : places[list]);
        }
    }

    /// Drops atoms from layers if their structure's assembly omits them.
    static void dropUnplaced(Structure& s) {
        for (SceneLayer& layer : s.layers) keepAtoms(layer, [&](std::size_t i) { return isPlaced(s, layer.atoms[i]); });
    }

    /// Makes labels primitives while structures still have their own atoms, and adds tooltips to the joined molecule.
    void takeTexts(Structure& s, std::uint32_t firstAtom) {
        std::vector<std::uint32_t> colors;
        if (!s.labels.empty() && s.representation) colors = colorsOfAll(*s.representation, s, files_);
        std::vector<std::pair<const Node*, LabelBalls>> drawn;  // each list of labels is one object for the camera
        for (const Structure::Text& label : s.labels) {
            double depth = 0;
            guide_->primitives.labels.push_back(makeLabel(
                label.text, label.atoms, s,
                colors.empty() ? std::nullopt : std::optional<std::uint32_t>(colors[label.atoms.front()]), depth));
            auto list = std::ranges::find_if(drawn, [&](const auto& d) { return d.first == label.source; });
            if (list == drawn.end()) list = drawn.insert(drawn.end(), {label.source, {}});
            list->second.add(guide_->primitives.labels.back(), depth);
        }
        for (const auto& [source, labels] : drawn) camera_.addDrawn(labels.balls());
        const Structure& told = s.original ? structures_[*s.original] : s;
        const auto times = static_cast<std::uint32_t>(s.instanceIds.size() / told.instanceIds.size());
        const auto each = static_cast<std::uint32_t>(s.molecule->atoms.size() / times);
        for (const Structure::Text& tip : told.tooltips) {
            files_.countShown(name_, tip.atoms.size() * times);
            SceneNote note{{}, tip.text};
            for (std::uint32_t group = 0; group < times; ++group)
                for (const std::uint32_t atom : tip.atoms) note.atoms.push_back(atom + firstAtom + group * each);
            guide_->tooltips.push_back(std::move(note));
        }
    }

    void takePrimitives() {
        for (const Group& group : groups_) {
            files_.step();
            const Structure* own = group.structure == kNoStructure ? nullptr : &structures_[group.structure];
            Node loaded;
            const Node* node = group.node;
            if (node->kind == "primitives_from_uri") {
                const std::string uri = nodeText(*node, "uri");
                if (uri.empty()) throw Error("cannot draw scene", node->place, "it has no uri");
                loaded = parseNode(files_.bytes(uri), nacre::printable(uri, 200));
                node = &loaded;
            }
            Primitives primitives = readPrimitives(*node, own, structures_, warnings_);
            std::vector<glm::dvec4> balls = outlinePoints(primitives);
            LabelBalls labels;
            for (const Primitives::Label& label : primitives.labels) labels.add(label, 0);
            std::ranges::copy(labels.balls(), std::back_inserter(balls));
            clipPrimitives(ClipRegions(*node, warnings_), primitives);
            if (node != group.node) clipPrimitives(ClipRegions(*group.node, warnings_), primitives);
            camera_.addDrawn(balls);
            for (const std::size_t focus : group.focuses) camera_.fillFocus(focus, balls);
            guide_->primitives.append(std::move(primitives));
        }
    }

    Molecule withoutStructures() {
        if (guide_->primitives.empty() && guide_->volumes.empty()) {
            const std::vector<std::string> faults = warnings_.take();
            throw Error("cannot draw scene", name_, "it shows nothing" + (faults.empty() ? "" : ": " + faults.front()));
        }
        Molecule none;
        none.file.format = "mvs";
        finish(none, {});
        return none;
    }

    void finish(Molecule& molecule, const std::vector<std::uint32_t>& firsts) {
        guide_->camera = camera_.camera(molecule, *guide_, firsts, warnings_);
        guide_->warnings = warnings_.take();
        molecule.guide = guide_;
    }

    /// All structures as one molecule, with its guide.
    Molecule joined() {
        takePrimitives();
        if (structures_.empty()) return withoutStructures();
        const bool once = single();
        std::vector<Molecule> molecules;
        std::vector<std::uint32_t> firsts;
        std::uint32_t atoms = 0;
        std::size_t models = 0;
        for (std::size_t i = 0; i < structures_.size(); ++i) {
            files_.step();
            Structure& s = structures_[i];
            takeTexts(s, atoms);
            once ? putAtoms(s) : placeCopies(s);
            dropUnplaced(s);
            for (std::vector<SceneLayer>* layers : {&s.layers, &s.framed})
                for (SceneLayer& layer : *layers)
                    for (std::uint32_t& atom : layer.atoms) atom += atoms;
            std::ranges::move(s.layers, std::back_inserter(guide_->layers));
            for (SceneLayer& layer : s.framed) camera_.addLayer(std::move(layer));
            firsts.push_back(atoms);
            atoms += static_cast<std::uint32_t>(s.molecule->atoms.size());
            s.atoms.reset();
            const std::size_t groups = s.instanceIds.size();
            if (structures_.size() > 1 || groups > 1)
                for (Chain& chain : s.molecule->chains)  // a number for each group of copies
                    chain.model = static_cast<int>(models + 1) + (groups > 1 ? chain.model : 0);
            models += groups;
            molecules.push_back(std::move(*s.molecule));
        }
        const std::size_t count = molecules.size();
        const FileSummary file = molecules.front().file;
        Molecule whole = count == 1 ? std::move(molecules.front())
                                    : joinModels(name_, std::move(molecules), files_.sources().reading.maxAtoms);
        if (models > 1) {
            whole.modelsAreInputs = true;
            whole.assemblies.clear();
            whole.serials.clear();
        }
        finish(whole, firsts);
        return whole;
    }

    const std::string& name_;
    SceneFiles files_;
    SceneWarnings warnings_;
    std::shared_ptr<SceneGuide> guide_;
    std::vector<Structure> structures_;
    CameraNodes camera_;
    struct Group {
        const Node* node;
        std::size_t structure;  ///< or kNoStructure
        std::vector<std::size_t> focuses;
    };
    static constexpr std::size_t kNoStructure = SIZE_MAX;
    std::vector<Group> groups_;                                   ///< of primitives
    std::set<std::string> instanceIds_;                           ///< that selectors name
    std::map<std::array<double, 12>, std::uint32_t> transforms_;  ///< those of the guide
    std::map<std::vector<std::uint32_t>, std::uint32_t> lists_;   ///< those of the guide
    std::size_t layers_ = 0;
};

}  // namespace

Molecule buildScene(const SceneTree& tree, std::size_t snapshot, const std::string& name, const SceneSources& sources,
                    std::optional<double> seconds) {
    if (snapshot >= tree.snapshots.size())
        throw Error("cannot draw scene", name,
                    "there is no snapshot " + std::to_string(snapshot + 1) + "; it has " +
                        std::to_string(tree.snapshots.size()));
    SceneBuilder builder(name, sources);
    const Snapshot& still = tree.snapshots[snapshot];
    if (!seconds || still.animation.kind != "animation") return builder.build(still);
    return builder.build(animatedAt(still, *seconds, builder.warnings()));
}

}  // namespace nacre::app::mvs
