#include "app/mvs/mesh_files.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/mvs/mesh_builder.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

/// Splits a text into lines, without their ends.
std::string_view nextLine(std::string_view& rest) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

std::optional<NumberType> plyType(std::string_view name) {
    constexpr std::string_view kNames[] = {"char", "uchar", "short", "ushort", "int",   "uint",   "float",   "double",
                                           "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
    const auto found = std::ranges::find(kNames, name);
    if (found == std::end(kNames)) return std::nullopt;
    return static_cast<NumberType>((found - std::begin(kNames)) % 8);
}

/// The values after the header.
class PlyValues {
public:
    enum class Coding { ascii, little, big };
    PlyValues(Coding coding, std::string_view rest) : coding_(coding), rest_(rest) {}

    /// Empty: the file ends, or a word is no number.
    std::optional<double> next(NumberType type) {
        if (coding_ == Coding::ascii) {
            const std::size_t start = std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size());
            const std::size_t end = std::min(rest_.find_first_of(" \t\r\n", start), rest_.size());
            const std::string_view word = rest_.substr(start, end - start);
            rest_.remove_prefix(end);
            return parseNumber(word);
        }
        const std::size_t size = sizeOf(type);
        if (rest_.size() < size) return std::nullopt;
        const double value = numberAt(rest_.data(), type, coding_ == Coding::little);
        rest_.remove_prefix(size);
        return value;
    }

private:
    Coding coding_;
    std::string_view rest_;
};

class PlyReader {
public:
    PlyReader(const std::string& name, std::string_view bytes, MeshColoring::Source source)
        : mesh_(name), rest_(bytes), source_(source) {}

    Primitives::Mesh read() {
        PlyValues values = header();
        for (const Element& element : elements_)
            for (std::size_t row = 0; row < element.count && !element.properties.empty(); ++row)
                readRow(element, row, values);
        if (source_ == MeshColoring::Source::materials && !materials_.empty()) {
            colors_.clear();
            for (const double index : materialOfVertex_) {
                const bool known = index >= 0 && index < static_cast<double>(materials_.size());
                colors_.push_back(known ? materials_[static_cast<std::size_t>(index)] : kNoMaterialColor);
            }
        }
        return colors_.empty() ? mesh_.finish() : mesh_.finishBlended(colors_);
    }

private:
    struct Property {
        std::string name;
        NumberType type = NumberType::float32;
        std::optional<NumberType> count;  ///< of a list
    };
    struct Element {
        std::string name;
        std::size_t count = 0;
        std::vector<Property> properties;
    };

    PlyValues header() {
        constexpr std::size_t kMostLines = 1000;
        auto coding = PlyValues::Coding::ascii;
        if (nextLine(rest_) != "ply") mesh_.refuse("", "it does not begin with 'ply'");
        for (std::size_t number = 2; number <= kMostLines && !rest_.empty(); ++number) {
            const std::string_view line = nextLine(rest_);
            const std::string place = "line " + std::to_string(number) + ": ";
            const Words words = splitWords(line);
            if (words[0] == "end_header") return {coding, rest_};
            if (words[0] == "format") {
                constexpr std::string_view kCodings[] = {"ascii", "binary_little_endian", "binary_big_endian"};
                const auto found = std::ranges::find(kCodings, words[1]);
                if (found == std::end(kCodings)) mesh_.refuse(place, "its format is unknown");
                coding = static_cast<PlyValues::Coding>(found - std::begin(kCodings));
            } else if (words[0] == "element") {
                const auto count = parseInteger(words[2]);
                if (!count || *count < 0) mesh_.refuse(place, "an element without a number");
                elements_.push_back({std::string(words[1]), static_cast<std::size_t>(*count), {}});
            } else if (words[0] == "property") {
                const bool list = words[1] == "list";
                const auto count = list ? plyType(words[2]) : std::nullopt, type = plyType(words[list ? 3 : 1]);
                if (elements_.empty() || !type || (list && !count)) mesh_.refuse(place, "a property of no known type");
                elements_.back().properties.push_back({std::string(words[list ? 4 : 2]), *type, count});
            }
        }
        mesh_.refuse("", "its header has no end");
    }

    void readRow(const Element& element, std::size_t row, PlyValues& values) {
        const std::string place = element.name + " " + std::to_string(row + 1) + ": ";
        const auto next = [&](NumberType type) {
            const auto value = values.next(type);
            if (!value) mesh_.refuse(place, "a number is missing");
            return *value;
        };
        glm::dvec3 at(NAN);
        std::array<double, 3> rgb{NAN, NAN, NAN};
        double material = -1;
        bool face = false;
        for (const Property& property : element.properties) {
            if (!property.count) {
                const double value = next(property.type);
                const std::size_t axis = property.name.size() == 1 ? std::string_view("xyz").find(property.name) : 3;
                if (axis < 3) at[static_cast<int>(axis)] = value;
                const auto channel = std::ranges::find(kChannels, property.name);
                const bool share = property.type == NumberType::float32 || property.type == NumberType::float64;
                if (channel != std::end(kChannels))
                    rgb[static_cast<std::size_t>(channel - std::begin(kChannels))] = share ? 255 * value : value;
                if (property.name == "material_index") material = value;
                continue;
            }
            const bool used = element.name == "face" && !face && property.name.starts_with("vertex_ind");
            corners_.clear();
            for (double left = next(*property.count); left >= 1; --left) {
                const double corner = next(property.type);
                if (used) corners_.push_back(corner >= 0 && corner < 1e15 ? static_cast<std::int64_t>(corner) : -1);
                if (corners_.size() > kMostMeshTriangles + 2) mesh_.refuse(place, "a list is too long");
            }
            if (!used) continue;
            mesh_.addFace(place, corners_);
            face = true;
        }
        const bool colored = std::ranges::none_of(rgb, [](double value) { return std::isnan(value); });
        if (element.name == "material" && source_ == MeshColoring::Source::materials) {
            if (materials_.size() == kMostMeshVertices) mesh_.refuse(place, "there are too many materials");
            materials_.push_back(colored ? byteColor(rgb) : kNoMaterialColor);
        }
        if (element.name != "vertex") return;
        mesh_.addVertex(place, at);
        if (source_ == MeshColoring::Source::vertices && colored) colors_.push_back(byteColor(rgb));
        if (source_ == MeshColoring::Source::vertices && colors_.size() != (colored ? mesh_.vertices() : 0))
            mesh_.refuse(place, "its colour is not usable");
        if (source_ == MeshColoring::Source::materials) materialOfVertex_.push_back(material);
    }

    static constexpr std::string_view kChannels[] = {"red", "green", "blue"};

    MeshBuilder mesh_;
    std::string_view rest_;
    std::vector<Element> elements_;
    std::vector<std::int64_t> corners_;
    MeshColoring::Source source_;
    std::vector<std::uint32_t> colors_, materials_;  ///< packed
    std::vector<double> materialOfVertex_;
};

}  // namespace

Primitives::Mesh readObj(const std::string& name, std::string_view text, const MeshColoring& coloring) {
    constexpr std::size_t kLongestLine = 1'000'000;
    using enum MeshColoring::Source;
    MeshBuilder mesh(name);
    std::vector<std::int64_t> corners;
    std::vector<std::uint32_t> colors;
    std::uint32_t material = kNoMaterialColor;
    bool hasColors = false;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::string_view line = nextLine(text);
        if (line.starts_with("usemtl ")) {
            const auto found = coloring.materials.find(splitWords(line)[1]);
            material = found == coloring.materials.end() ? kNoMaterialColor : found->second;
        }
        if (!line.starts_with("v ") && !line.starts_with("f ")) continue;
        const std::string place = "line " + std::to_string(number) + ": ";
        if (line.size() > kLongestLine) mesh.refuse(place, "it is too long");
        if (line[0] == 'v') {
            const Words words = splitWords(line);
            glm::dvec3 at;
            for (int i = 0; i < 3; ++i) at[i] = parseNumber(words[static_cast<std::size_t>(i + 1)]).value_or(NAN);
            mesh.addVertex(place, at);
            if (coloring.source != vertices) continue;
            std::array<double, 3> rgb{255, 255, 255};
            const bool colored = words.count >= 7;
            for (std::size_t i = 0; i < 3 && colored; ++i) rgb[i] = 255 * parseNumber(words[4 + i]).value_or(1);
            hasColors |= colored;
            colors.push_back(byteColor(rgb));
            continue;
        }
        corners.clear();
        for (const std::string_view word : splitAllWords(line.substr(2))) {
            // Counted from 1, or backwards from -1; texture and normal follow slashes.
            const std::int64_t index = parseInteger(word.substr(0, word.find('/'))).value_or(0);
            corners.push_back(index < 0 ? index + static_cast<std::int64_t>(mesh.vertices()) : index - 1);
        }
        mesh.addFace(place, corners);
        if (coloring.source == materials) colors.resize(mesh.triangles().size(), material);
    }
    if (coloring.source == materials) return mesh.finishColored(colors);
    return hasColors ? mesh.finishBlended(colors) : mesh.finish();
}

Primitives::Mesh readPly(const std::string& name, std::string_view bytes, const MeshColoring& coloring) {
    return PlyReader(name, bytes, coloring.source).read();
}

}  // namespace nacre::app::mvs
