// Geometry beside the molecule.

#include "app/files/json_text.h"
#include "app/picture/rows.h"

namespace nacre::app {

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
         .parse = [](std::string_view text,
                     PictureDescription& d) { addTo(d.primitives, text, kMostPrimitiveSources, parsePrimitiveSource); },
         .print =
             [](const PictureDescription& d) {
                 return lines(d.primitives, [](const PrimitiveSource& source) { return source.text; });
             },
         .kind = Option::Kind::list,
         .save = Option::Save::differing}};
}

}  // namespace nacre::app
