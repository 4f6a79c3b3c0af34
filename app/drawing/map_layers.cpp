#include "app/drawing/map_layers.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <iterator>
#include <list>
#include <mutex>

#include "app/drawing/cell_frame.h"
#include "app/input/electrostatics.h"
#include "app/input/map_input.h"
#include "app/input/primitives_file.h"
#include "app/input/read_input.h"
#include "app/picture/option_text.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/build/map_scene.h"
#include "engine/scene/build/volume.h"
#include "engine/scene/color/colors.h"

namespace nacre::app {
namespace {

constexpr double kSigma = 1.5, kDifferenceSigma = 3, kTopPercent = 1;  // default levels
constexpr double kOpacityBesideMolecule = 0.5;
constexpr std::array<float, 4> kCrystalBlue{0.2f, 0.36f, 0.8f, 1}, kPositiveGreen{0.1f, 0.6f, 0.2f, 1},
    kNegativeRed{0.82f, 0.15f, 0.15f, 1}, kCryoGrey{0.66f, 0.7f, 0.75f, 1};

constexpr double kBoxOfFile = -1;  ///< a reach: the extent of the file itself, not of a crystal's cell

/// A map's region around some positions. It is kept, since usually only levels and colours change.
struct KeptRegion {
    std::shared_ptr<const DensityMap> map;
    std::vector<glm::dvec3> places;
    double reach = 0;
    std::shared_ptr<const MapRegion> region;
};

std::shared_ptr<const MapRegion> keptRegion(const std::shared_ptr<const DensityMap>& map,
                                            const std::vector<glm::dvec3>& places, double reach) {
    constexpr std::size_t kMostKept = 4;
    static std::mutex mutex;
    static std::list<KeptRegion> kept;
    {
        const std::lock_guard lock(mutex);
        for (auto at = kept.begin(); at != kept.end(); ++at)
            if (at->map == map && at->reach == reach && at->places == places) {
                kept.splice(kept.begin(), kept, at);
                return at->region;
            }
    }
    const auto region = !places.empty()       ? std::make_shared<const MapRegion>(*map, places, reach)
                        : reach == kBoxOfFile ? std::make_shared<const MapRegion>(*map, map->firstNode(),
                                                                                  map->firstNode() + map->boxSize - 1)
                                              : std::make_shared<const MapRegion>(*map, glm::ivec3(0), map->size - 1);
    const std::lock_guard lock(mutex);
    kept.push_front({map, places, reach, region});
    if (kept.size() > kMostKept) kept.pop_back();
    return region;
}

/// A map's entry in a list of options; the default if the list is shorter.
template <typename Value>
Value ofMap(const std::vector<Value>& list, std::size_t i) {
    return i < list.size() ? list[i] : Value{};
}

std::uint32_t packRgb(const std::array<float, 4>& color) {
    const auto channel = [&](std::size_t i) {
        return static_cast<std::uint32_t>(std::lround(static_cast<double>(color[i]) * 255)) << 8 * i;
    };
    return channel(0) | channel(1) | channel(2);
}

std::vector<glm::dvec3> finitePositions(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
    std::vector<glm::dvec3> places;
    places.reserve(atoms.size());
    for (const std::uint32_t atom : atoms) {
        const glm::dvec3 at(molecule.atoms[atom].position);
        if (std::isfinite(at.x + at.y + at.z)) places.push_back(at);
    }
    return places;
}

/// Colouring by the values of a map, which it keeps alive.
struct Values {
    std::shared_ptr<const DensityMap> map;
    ValueColoring coloring;

    Values(const ValueMap& of, std::shared_ptr<const DensityMap> from, const std::string& name)
        : map(std::move(from)), coloring{map.get(), name, of.palette, of.range} {}
    Values(const ValueMap& of, const MapLimits& limits)
        : Values(of, loadMap(of.file, limits), of.file.substr(of.file.find_last_of('/') + 1)) {}
};

/// Positions around which a map is drawn, and the distance from them; no positions: the whole map.
struct Around {
    std::vector<glm::dvec3> places;
    double reach = 0;
};

Around findSurroundings(const Molecule& molecule, const PictureDescription& d, const DensityMap& map,
                        const std::optional<glm::dvec3>& focus) {
    const MapOptions& maps = d.maps;
    if (focus) return {{*focus}, maps.reach.value_or(maps.usualReach())};
    if (!maps.around) {
        if (molecule.atoms.empty()) return {{}, kBoxOfFile};
        if (!map.periodic) return {};
        return {finitePositions(molecule, drawnAtoms(molecule, d.drawn)), kMapReachOfAll};
    }
    const std::vector<bool> chosen = selectAtoms(molecule, *maps.around);
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) atoms.push_back(i);
    Around around{finitePositions(molecule, atoms), maps.reach.value_or(maps.usualReach())};
    if (around.places.empty())
        throw Error("cannot draw map", map.name, "--map-around '" + maps.around->text + "' matches no atoms");
    return around;
}

void addGeometry(Primitives primitives, MapLayers& layers) {
    Representation own;
    own.center = layers.shown.center;
    addPrimitives(primitives, own);
    layers.frame = std::max(layers.frame, own.radius);
    for (const Primitives::Label& label : primitives.labels)
        layers.frame = std::max(layers.frame, glm::length(label.at - own.center));
    joinScenes(layers.shown, own);
    layers.notes = std::move(primitives.notes);
    layers.labels = std::move(primitives.labels);
}

/// Adds a map of a scene file.
void addVolume(const SceneVolume& volume, Representation& shown) {
    const std::shared_ptr<const MapRegion> region = keptRegion(volume.map, {}, kBoxOfFile);
    if (volume.axis >= 0) {
        ValueColoring values{volume.map.get(), volume.map->name, {}, {}, volume.color};
        values.range = ColorRange{volume.map->statistics.min, volume.map->statistics.max};
        MapSlice slice{volume.axis, volume.place, volume.opacity};
        if (volume.least) slice.least = *volume.least;
        slice.cuts = volume.cuts;
        return addSlice(*region, slice, values, shown);
    }
    MapContour contour;
    contour.level = volume.level;
    contour.above = volume.level >= 0;
    contour.color = volume.color & 0xffffffu;
    contour.opacity = volume.opacity;
    contour.width = 1;
    contour.cuts = volume.cuts;
    contour.style = MapStyle::surface;
    if (volume.faces) addContour(*region, contour, shown);
    contour.style = MapStyle::mesh;
    if (volume.wires) addContour(*region, contour, shown);
}

/// A map with a transfer function is a volume.
MapStyle pickMapStyle(const DensityMap& map, const MapOptions& maps, std::size_t i) {
    const MapStyle style = ofMap(maps.styles, i);
    const bool transfers = !ofMap(maps.transfers, i).empty();
    if (style == MapStyle::automatic)
        return transfers ? MapStyle::volume : map.periodic ? MapStyle::mesh : MapStyle::surface;
    if (transfers && style != MapStyle::volume)
        throw Error("cannot draw map", map.name,
                    "--map-transfer is for --map-style volume, not for " + mapStyleText(style));
    return style;
}

MapContour makeContour(const DensityMap& map, const MapOptions& maps, std::size_t i) {
    MapContour contour;
    contour.style = pickMapStyle(map, maps, i);
    contour.opacity = ofMap(maps.opacities, i).value_or(kOpacityBesideMolecule);
    contour.width = maps.width;
    contour.level = contourLevel(map, ofMap(maps.levels, i));
    return contour;
}

std::uint32_t contourColor(const DensityMap& map, const MapColors& colors) {
    const auto usual = map.difference ? kPositiveGreen : map.periodic ? kCrystalBlue : kCryoGrey;
    return packRgb(colors.automatic ? usual : colors.high);
}

/// The level of a difference map's negative contour: mirrored about the mean for a crystal's level in sigma, else the
/// negated level.
double negativeLevel(const DensityMap& map, double level, MapLevel::Unit unit) {
    const bool aboutMean = map.periodic && (unit == MapLevel::Unit::sigma || unit == MapLevel::Unit::automatic);
    return aboutMean ? 2 * map.statistics.mean - level : -level;
}

/// The negative contour of a difference map.
MapContour makeNegative(const DensityMap& map, const MapContour& contour, const MapOptions& maps, std::size_t i) {
    const MapColors colors = ofMap(maps.colors, i);
    MapContour other = contour;
    other.level = negativeLevel(map, contour.level, ofMap(maps.levels, i).unit);
    other.above = !contour.above;
    other.color = packRgb(colors.automatic ? kNegativeRed : colors.low);
    return other;
}

/// The transfer function of a volume without its own: from half of a contour's height above the mean, where it is
/// invisible, to twice that height, with a lighter colour. Three voxels at the contour's height have its opacity.
void addLevels(const DensityMap& map, const MapContour& contour, std::vector<VolumeLevel>& levels) {
    constexpr double kVoxels = 3, kShareAtLevel = 0.25, kWhiter = 0.6;
    const double mean = map.periodic ? map.statistics.mean : 0;
    double height = contour.level - mean;
    if (height == 0) height = map.statistics.rms > 0 ? map.statistics.rms : 1;
    const double voxel = std::cbrt(std::abs(glm::determinant(map.step)));
    const double opacity = 1 - std::pow(1 - std::min(contour.opacity, 0.999), 1 / (kVoxels * voxel));
    std::array<float, 3> color{}, light{};
    for (std::size_t i = 0; i < 3; ++i) {
        color[i] = static_cast<float>(contour.color >> 8 * i & 0xff) / 255;
        light[i] = std::lerp(color[i], 1.0f, static_cast<float>(kWhiter));
    }
    levels.push_back({mean + height / 2, color, 0});
    levels.push_back({mean + height, color, kShareAtLevel * opacity});
    levels.push_back({mean + 2 * height, light, opacity});
}

/// Adds a map as a volume. @param contour  its level, colour and opacity
void addVolume(const DensityMap& map, const MapRegion& region, const MapContour& contour, const MapOptions& maps,
               std::size_t i, Representation& shown) {
    if (contour.values)
        throw Error("cannot draw map", map.name, "--map-color-from colours contours and slices, not a volume");
    if (shown.volume) throw Error("cannot draw map", map.name, "only one map can be drawn as a volume");
    std::vector<VolumeLevel> levels;
    for (const MapTransferLevel& level : ofMap(maps.transfers, i))
        levels.push_back(
            {contourLevel(map, level.level), {level.color[0], level.color[1], level.color[2]}, level.opacity});
    if (levels.empty()) {
        addLevels(map, contour, levels);
        if (map.difference) addLevels(map, makeNegative(map, contour, maps, i), levels);
    }
    shown.volume = makeVolume(region, levels, shown.center);
    if (shown.volume) shown.radius = std::max(shown.radius, shown.volume->radius);
}

}  // namespace

double contourLevel(const DensityMap& map, const MapLevel& level) {
    const MapStatistics& s = map.statistics;
    switch (level.unit) {
        case MapLevel::Unit::value:
            return level.value;
        case MapLevel::Unit::sigma:
            return s.mean + level.value * s.rms;
        case MapLevel::Unit::top:
            return levelOfTopShare(map, level.value / 100);
        case MapLevel::Unit::automatic:
            break;
    }
    if (map.depositedLevel) return *map.depositedLevel;
    // For difference maps, twice the share, since positive and negative lobes divide it.
    if (!map.periodic) return levelOfTopShare(map, (map.difference ? 2 : 1) * kTopPercent / 100, map.difference);
    return s.mean + (map.difference ? kDifferenceSigma : kSigma) * s.rms;
}

Representation withMaps(Representation scene, const MapLayers& maps) {
    if (!maps.empty()) joinScenes(scene, maps.shown);
    return scene;
}

std::optional<Bounds> frameWithoutAtoms(const Molecule& molecule, const PictureDescription& d) {
    if (!molecule.atoms.empty() || molecule.guide) return std::nullopt;
    if (!d.primitives.empty()) return computeBounds(loadPrimitives(d.primitives, molecule));
    if (d.maps.files.empty()) return std::nullopt;
    const std::shared_ptr<const DensityMap> map = loadMap(d.maps.files.front(), mapLimits(d.input));
    const glm::dvec3 first(map->firstNode()), size(map->boxSize - 1);
    Bounds bounds{map->place(first + size / 2.0), 0};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at = first + size * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
        bounds.radius = std::max(bounds.radius, glm::distance(map->place(at), bounds.center));
    }
    return bounds;
}

bool lookIntoCrystal(const Molecule& molecule, PictureDescription& d) {
    constexpr double kMargin = 1.2;
    const MapOptions& maps = d.maps;
    if (!molecule.atoms.empty() || maps.files.empty() || d.given.contains("map-around")) return false;
    if (maps.around || maps.aroundFocus) return false;
    const std::shared_ptr<const DensityMap> map = loadMap(maps.files.front(), mapLimits(d.input));
    if (!map->periodic || ofMap(maps.slices, 0).axis >= 0 || pickMapStyle(*map, maps, 0) != MapStyle::mesh)
        return false;
    const std::optional<Bounds> whole = frameWithoutAtoms(molecule, d);
    d.maps.aroundFocus = true;
    if (whole && !d.camera.isPlaced())
        d.camera.zoom *= std::max(1.0, whole->radius / (kMargin * maps.reach.value_or(maps.usualReach())));
    return true;
}

MapLayers buildMapLayers(const Molecule& molecule, const PictureDescription& d, const glm::dvec3& center,
                         const Seen& seen) {
    MapLayers layers;
    if (d.maps.aroundFocus && !d.maps.files.empty()) layers.focus = findFocus(molecule, d, seen, center);
    Representation& shown = layers.shown;
    shown.center = center;
    for (std::size_t i = 0; i < d.maps.files.size(); ++i) {
        const std::shared_ptr<const DensityMap> map = loadMap(d.maps.files[i], mapLimits(d.input));
        const Around around = findSurroundings(molecule, d, *map, layers.focus);
        const std::shared_ptr<const MapRegion> region = keptRegion(map, around.places, around.reach);
        const auto drawn = [&] { return shown.wires.size() + shown.triangles.size() + (shown.volume ? 1u : 0u); };
        const std::size_t before = drawn();
        MapContour contour = makeContour(*map, d.maps, i);
        contour.color = contourColor(*map, ofMap(d.maps.colors, i));
        // A level below a crystal map's mean encloses lower values; for cryo-EM maps the mean is meaningless.
        contour.above = contour.level >= map->statistics.mean || !map->periodic;
        const MapStatistics& statistics = map->statistics;
        layers.sigmas.push_back(statistics.rms > 0 ? (contour.level - statistics.mean) / statistics.rms : 0);
        const MapSliceOption slice = ofMap(d.maps.slices, i);
        const ValueMap valueMap = ofMap(d.maps.values, i);
        const Values values(valueMap.file.empty() ? ValueMap{d.maps.files[i], {}, Palette::automatic} : valueMap,
                            mapLimits(d.input));
        if (!valueMap.file.empty()) contour.values = &values.coloring;
        if (slice.axis >= 0) {
            addSlice(*region, {slice.axis, slice.place, ofMap(d.maps.opacities, i).value_or(1)}, values.coloring,
                     shown);
        } else if (contour.style == MapStyle::volume) {
            addVolume(*map, *region, contour, d.maps, i, shown);
        } else {
            addContour(*region, contour, shown);
            if (map->difference) addContour(*region, makeNegative(*map, contour, d.maps, i), shown);
        }
        if (around.places.empty()) layers.frame = shown.radius;
        if (drawn() == before)
            layers.warnings.push_back(map->name + ": nothing to show" +
                                      (slice.axis >= 0                     ? " of this slice"
                                       : contour.style == MapStyle::volume ? std::string(" as a volume")
                                                                           : " at level " + numberText(contour.level)) +
                                      (layers.focus            ? " around the focus"
                                       : around.places.empty() ? ""
                                                               : " near these atoms"));
        for (const std::string& warning : map->warnings) layers.warnings.push_back(map->name + ": " + warning);
    }
    if (molecule.guide && !molecule.guide->volumes.empty()) {
        for (const SceneVolume& volume : molecule.guide->volumes) addVolume(volume, shown);
        layers.frame = std::max(layers.frame, shown.radius);
    }
    Primitives beside;
    if (!d.primitives.empty()) beside = loadPrimitives(d.primitives, molecule);
    if (molecule.guide) beside.append(molecule.guide->primitives);
    if (d.cell) {
        Primitives frame = cellFrame(molecule);
        if (frame.empty()) layers.warnings.push_back("--cell shows nothing: the file states no unit cell or box");
        beside.append(std::move(frame));
    }
    if (!beside.empty()) addGeometry(std::move(beside), layers);
    return layers;
}

std::vector<SceneVolume> sceneVolumes(const PictureDescription& picture) {
    const MapOptions& maps = picture.maps;
    std::vector<SceneVolume> volumes;
    for (std::size_t i = 0; i < maps.files.size(); ++i) {
        SceneVolume volume;
        volume.map = loadMap(maps.files[i], mapLimits(picture.input));
        const MapSliceOption slice = ofMap(maps.slices, i);
        const MapColors colors = ofMap(maps.colors, i);
        const MapContour contour = makeContour(*volume.map, maps, i);
        const auto add = [&](double level, std::uint32_t color) {
            volume.level = level;
            volume.color = 0xff000000u | color;
            volumes.push_back(volume);
        };
        volume.axis = slice.axis;
        volume.place = slice.place;
        volume.faces = contour.style == MapStyle::surface || contour.style == MapStyle::volume;
        volume.wires = !volume.faces;
        volume.opacity = slice.axis < 0 ? contour.opacity : ofMap(maps.opacities, i).value_or(1);
        if (slice.axis >= 0) {
            add(0, 0xffffffu);
            continue;
        }
        add(contour.level, contourColor(*volume.map, colors));
        if (volume.map->difference)
            add(negativeLevel(*volume.map, contour.level, ofMap(maps.levels, i).unit),
                packRgb(colors.automatic ? kNegativeRed : colors.low));
    }
    return volumes;
}

SurfaceColoring::SurfaceColoring(const ResidueFacts& facts, const PictureDescription& picture)
    : from_(picture.maps.surface), limits_(mapLimits(picture.input)) {
    if (from_.file == kElectrostatics) potential_ = electrostaticPotential(facts, picture.input);
}

void SurfaceColoring::operator()(Representation& scene) {
    if (from_.file.empty()) return;
    constexpr double kSolvent = 1.4;  // Å: radius of a water molecule, whose centre comes no nearer
    Values values = potential_ ? Values(from_, potential_, potential_->name + ", kT/e") : Values(from_, limits_);
    if (potential_) values.coloring.offset = kSolvent;
    const std::optional<ColorRange> range = colorSurfaces(values.coloring, scene);
    const char* const option = potential_ ? "--electrostatics" : "--surface-color-from";
    if (!range)
        scene.warnings.push_back(std::string(option) + " changes nothing: no surface is drawn");
    else
        from_.range = range;
    if (!potential_) return;
    for (const std::string& warning : potential_->warnings) scene.warnings.push_back(potential_->name + ": " + warning);
}

void addMapSurfaces(const Molecule& molecule, PictureDescription picture, Representation& scene) {
    colorByMap(molecule, picture, scene);
    if (!picture.drawsBeside()) return;
    picture.maps.styles.assign(picture.maps.files.size(), MapStyle::surface);
    picture.maps.transfers.clear();
    MapLayers maps = buildMapLayers(molecule, picture, scene.center, {picture.camera, scene.radius});
    scene = withMaps(std::move(scene), maps);
    std::move(maps.warnings.begin(), maps.warnings.end(), std::back_inserter(scene.warnings));
}

}  // namespace nacre::app
