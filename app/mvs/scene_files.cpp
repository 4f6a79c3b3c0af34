// The files that a scene names, and its warnings.

#include <algorithm>

#include "app/mvs/mesh_files.h"
#include "app/mvs/scene_parts.h"
#include "engine/error.h"
#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/text.h"
#include "engine/volume/read_map.h"

namespace nacre::app::mvs {
namespace {

constexpr std::size_t kMostMapBytes = std::size_t{2} << 30;  // of the values of all maps

/// Calls `find` once. Later calls return, or throw, the same. @param known  keeps the result; empty at first
template <typename Result, typename Find>
const Result& once(std::shared_future<Result>& known, const Find& find) {
    if (!known.valid()) known = std::async(std::launch::deferred, find);
    return known.get();
}

}  // namespace

void SceneWarnings::add(const std::string& text) {
    if (!known_.insert(text).second) return;
    if (texts_.size() < kMost)
        texts_.push_back(text);
    else
        ++more_;
}

std::vector<std::string> SceneWarnings::take() {
    if (more_ > 0) texts_.push_back("and " + std::to_string(more_) + " more such things of the scene");
    return std::move(texts_);
}

const std::string& SceneFiles::bytes(const std::string& uri) {
    return once(files_[uri], [&] {
        if (files_.size() > kMostFiles)
            throw Error("cannot draw scene", "", "it names more than " + std::to_string(kMostFiles) + " files");
        std::string bytes = sources_.fetch(uri);
        if (!detectCompression(bytes).empty())
            bytes = decompress(nacre::printable(uri, 200), bytes, sources_.reading.maxBytes);
        held_ += bytes.size();
        if (held_ > sources_.reading.maxBytes)
            throw Error("cannot draw scene", nacre::printable(uri, 200), "its files together are too large");
        return bytes;
    });
}

Molecule SceneFiles::molecule(const std::string& uri, std::string text, ReadOptions options) {
    countParsed(uri, text.size());
    options.maxAtoms = sources_.reading.maxAtoms - std::min(atoms_, sources_.reading.maxAtoms);
    Molecule molecule = readMolecule(nacre::printable(uri, 200), std::move(text), options);
    atoms_ += molecule.atoms.size();
    return molecule;
}

std::shared_ptr<const DensityMap> SceneFiles::map(const std::string& uri, const std::string& channel) {
    return once(maps_[{uri, channel}], [&] {
        const std::string& text = bytes(uri);
        countParsed(uri, text.size());
        const std::size_t most = std::min(sources_.reading.maxBytes, kMostMapBytes);
        auto map = std::make_shared<const DensityMap>(
            readMap(nacre::printable(uri, 200), text, {most - std::min(mapBytes_, most), channel}));
        mapBytes_ += map->values.size() * sizeof(float);
        return map;
    });
}

Primitives::Mesh SceneFiles::mesh(const std::string& uri, const std::string& format, const MeshColoring& coloring) {
    const std::string& text = bytes(uri);
    const std::string name = nacre::printable(uri, 200);
    countParsed(uri, text.size());
    if (format == "ply") return readPly(name, text, coloring);
    if (format == "vtp") return readVtp(name, text, coloring);
    if (format != "obj") throw Error("cannot read mesh", name, "its format is not obj, ply or vtp");
    return readObj(name, text, coloring);
}

std::vector<glm::vec3> SceneFiles::positions(const std::string& ref, std::size_t frame, std::size_t atoms) {
    const std::string& uri = coordinates_.at(ref);
    const std::string name = nacre::printable(uri, 200);
    const std::string& text = bytes(uri);
    auto& trajectory = trajectories_[uri];
    if (!trajectory) trajectory = openTrajectory(name, text);
    std::vector<glm::vec3> positions;
    std::size_t found = 0;
    if (trajectory) {
        found = trajectory->atoms();
        if (found == atoms) positions = trajectory->read(frame).positions;
    } else {
        ReadOptions options = sources_.reading;
        options.model = static_cast<int>(frame) + 1;
        const Molecule models = molecule(uri, text, options);
        found = models.atoms.size();
        if (models.lacksPositions) throw Error("cannot draw scene", name, "it is a topology without positions");
        for (const Atom& atom : models.atoms) positions.push_back(atom.position);
    }
    if (found != atoms)
        throw Error("cannot draw scene", name,
                    "it has " + std::to_string(found) + " atoms, the structure " + std::to_string(atoms));
    return positions;
}

void SceneFiles::countCopied(const Node& node, std::size_t atoms) {
    atoms_ += atoms;
    if (atoms_ > sources_.reading.maxAtoms) throw tooManyAtoms(node.place, sources_.reading.maxAtoms);
}

void SceneFiles::countShown(const std::string& place, std::size_t atoms) {
    shown_ += atoms;
    if (shown_ / kMostTimes > sources_.reading.maxAtoms)
        throw Error("cannot draw scene", place,
                    "the representations, labels and tooltips have more than " +
                        std::to_string(sources_.reading.maxAtoms * kMostTimes) + " atoms together");
}

void SceneFiles::countParsed(const std::string& uri, std::size_t bytes) {
    parsed_ += bytes;
    if (parsed_ / kMostTimes > sources_.reading.maxBytes)
        throw Error("cannot draw scene", nacre::printable(uri, 200), "it is read too often");
}

}  // namespace nacre::app::mvs
