// Density maps: files, levels, and appearance.

#include "app/files/json_text.h"
#include "app/picture/rows.h"

namespace nacre::app {
namespace {

using P = PictureDescription;
using M = MapOptions;
using T = std::string_view;
using enum Option::Kind;
using enum Option::Save;

}  // namespace

std::vector<Option> mapRows() {
    const auto row = [](T key, const char* syntax, const char* standard, const char* help, Option::Access access,
                        Option::Kind kind = value) {
        return Option{.key = key,
                      .syntax = syntax,
                      .standard = standard,
                      .help = help,
                      .topic = Topic::map,
                      .facet = Facet::map,
                      .value = std::move(access),
                      .kind = kind,
                      .save = differing};
    };
    std::vector<Option> rows{
        row("map", "FILE", "",
            "Density map: CCP4 or MRC, OpenDX, Gaussian cube, DSN6, BRIX or BinaryCIF of a density server; repeatable",
            {[](T text, P& d) {
                 addTo(d.maps.files, text, kMostMaps, fileName);
                 d.mapsChanged();
             },
             [](const P& d) { return lines(d.maps.files, [](const std::string& file) { return file; }); }},
            list),
        row("map-level", "LEVEL", "1.5sigma for crystals, 3sigma for difference maps, else top1%",
            "Contour level: 1.5sigma (above the mean, RMS over the unit cell), 0.03 or top1%;\nrepeatable, in the "
            "order of --map",
            listOf<&P::maps, &M::levels>(kMostMaps, parseMapLevel, mapLevelText), list),
        row("map-style", "STYLE", "mesh for crystals, else surface",
            "mesh, surface, dots or volume (one map at most); repeatable, in the order of --map",
            listOf<&P::maps, &M::styles>(kMostMaps, parseMapStyle, mapStyleText), list),
        row("map-color", "COLOR[,COLOR]", "blue; green and red for difference maps; grey for cryo-EM maps",
            "Colour; a second one is for a difference map's negative contour;\nrepeatable, in the order of --map",
            listOf<&P::maps, &M::colors>(kMostMaps, parseMapColors, mapColorsText), list),
        row("map-color-from", "FILE", "none",
            "Colour the contour or slice by the values of a map, as local resolution; FILE:LOW..HIGH:PALETTE gives the "
            "range and\nthe palette; repeatable: the first is that of the first --map",
            listOf<&P::maps, &M::values>(kMostMaps, parseValueMap, valueMapText), list),
        row("map-slice", "AXIS", "none",
            "Draw a slice across a, b or c in place of the contour, in the colours of its values; AXIS,PLACE says "
            "where,\n0 to 1 (0.5); repeatable: the first is that of the first --map",
            listOf<&P::maps, &M::slices>(kMostMaps, parseMapSlice, mapSliceText), list),
        row("map-transfer", "LEVEL=COLOR@OPACITY,...", "by level, colour and opacity of the map",
            "Draw the map as a volume: what 2 to 8 levels look like, such as 1sigma=blue@0,4sigma=white@0.2;\nOPACITY "
            "is the share of light that 1 Å hides; repeatable: the first is that of the first --map",
            listOf<&P::maps, &M::transfers>(kMostMaps, parseMapTransfer, mapTransferText), list),
        row("map-opacity", "SHARE", "0.5 for surfaces and volumes, 1 for slices",
            "Opacity of surfaces and slices, and of three voxels of a volume, 0.01 to 1;\nrepeatable: the first is "
            "that "
            "of "
            "the first --map",
            listOf<&P::maps, &M::opacities>(kMostMaps, parseMapOpacity, mapOpacityText), list),
        row("map-width", "PIXELS", "=", "Width of map lines and dots in pixels, 0.5 to 10",
            numberOf<&P::maps, &M::width>(0.5, kWidestWire)),
        row("map-around", "SEL|focus[,RADIUS]",
            "all drawn atoms, 4 Å, for crystals, or without atoms focus; else the whole map",
            "Draw maps within RADIUS (2 Å) of the atoms of a selection only; focus: within RADIUS (10 Å) of what the "
            "camera\nlooks at",
            {[](T text, P& d) { parseMapAround(text, d.maps); }, [](const P& d) { return mapAroundText(d.maps); }}),
    };
    for (Option& option : rows)
        if (option.key != "map") option.needs = "map";
    rows.push_back(row(
        "surface-color-from", "FILE", "none",
        "Colour molecular surfaces by the values of a map, as an electrostatic potential; FILE:LOW..HIGH:PALETTE gives "
        "the\nrange and the palette",
        valueOf<&P::maps, &M::surface>(parseValueMap,
                                       [](const ValueMap& map) { return map.file.empty() ? "" : valueMapText(map); })));
    rows.back().facet = Facet::scene;
    rows.push_back(
        row("electrostatics", "on|LOW..HIGH|off", "=",
            "Colour molecular surfaces by their electrostatic potential: on (-5..5 kT/e), or a range in kT/e. The "
            "programs\n"
            "pdb2pqr and apbs calculate it",
            valueOf<&P::maps, &M::surface>(parseElectrostatics, electrostaticsText)));
    rows.back().facet = Facet::scene;
    return rows;
}

bool isJsonText(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

PrimitiveSource parsePrimitiveSource(std::string_view text) {
    if (!isJsonText(text)) return {fileName(text)};
    if (text.size() > kLongestGeometryText)
        throw std::invalid_argument("JSON in an option is at most " + std::to_string(kLongestGeometryText >> 20) +
                                    " MB long (put it in a file)");
    const auto json = parseJson<nlohmann::ordered_json>(std::string(text));
    if (json.is_discarded()) throw std::invalid_argument("it begins like JSON, but is not valid JSON");
    return {json.dump()};
}

std::vector<Option> geometryRows() {
    return {
        {.key = "primitives",
         .syntax = "FILE|JSON",
         .help = "Lines, tubes, arrows, spheres, ellipsoids, boxes, meshes and labels at points, from a JSON file\nor "
                 "the JSON itself; repeatable",
         .topic = Topic::geometry,
         .facet = Facet::map,
         .value = listOf<&P::primitives>(kMostPrimitiveSources, parsePrimitiveSource,
                                         [](const PrimitiveSource& source) { return source.text; }),
         .kind = Option::Kind::list,
         .save = Option::Save::differing},
        {.key = "cell",
         .syntax = "on|off",
         .standard = "=",
         .help = "Edges of the crystal's unit cell or the simulation's box, with a, b and c in red, green and blue",
         .topic = Topic::geometry,
         .facet = Facet::map,
         .value = switchOf<kOnOff, &PictureDescription::cell>(),
         .save = Option::Save::differing,
         .control = {.label = "Unit cell", .choices = {{"off", "off"}, {"on", "on"}}}}};
}

}  // namespace nacre::app
