#include "app/mvs/mesh_files.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

/// A mesh that grows within its limits.
class MeshBuilder {
public:
    explicit MeshBuilder(const std::string& name) : name_(name) { mesh_.smooth = true; }

    [[noreturn]] void refuse(const std::string& place, const std::string& why) const {
        throw Error("cannot read mesh", name_, place + why);
    }
    void addVertex(const std::string& place, const glm::dvec3& at) {
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(at[i]) <= kFarthestPrimitive)) refuse(place, "a vertex needs three numbers within 1e6 Å");
        if (mesh_.positions.size() == kMostMeshVertices)
            refuse("", "it has more than " + std::to_string(kMostMeshVertices) + " vertices");
        mesh_.positions.push_back(at);
    }
    std::size_t vertices() const { return mesh_.positions.size(); }
    /// @param corners  from 0
    void addFace(const std::string& place, const std::vector<std::int64_t>& corners) {
        if (corners.size() < 3) refuse(place, "a face has fewer than three corners");
        for (const std::int64_t corner : corners)
            if (corner < 0 || corner >= static_cast<std::int64_t>(vertices()))
                refuse(place, "a face names a vertex that is not there");
        if (mesh_.triangles.size() + corners.size() - 2 > kMostMeshTriangles)
            refuse("", "it has more than " + std::to_string(kMostMeshTriangles) + " triangles");
        const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh_.triangles.push_back({corner(0), corner(i - 1), corner(i)});
    }
    Primitives::Mesh finish() {
        if (mesh_.triangles.empty()) refuse("", "it has no faces");
        return std::move(mesh_);
    }

private:
    const std::string& name_;
    Primitives::Mesh mesh_;
};

/// Splits a text into lines, without their ends.
std::string_view nextLine(std::string_view& rest) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<PlyType> plyType(std::string_view name) {
    constexpr std::string_view kNames[] = {"char", "uchar", "short", "ushort", "int",   "uint",   "float",   "double",
                                           "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
    const auto found = std::ranges::find(kNames, name);
    if (found == std::end(kNames)) return std::nullopt;
    return static_cast<PlyType>((found - std::begin(kNames)) % 8);
}

/// The values after the header.
class PlyValues {
public:
    enum class Coding { ascii, little, big };
    PlyValues(Coding coding, std::string_view rest) : coding_(coding), rest_(rest) {}

    /// Empty: the file ends, or a word is no number.
    std::optional<double> next(PlyType type) {
        if (coding_ == Coding::ascii) {
            const std::size_t start = std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size());
            const std::size_t end = std::min(rest_.find_first_of(" \t\r\n", start), rest_.size());
            const std::string_view word = rest_.substr(start, end - start);
            rest_.remove_prefix(end);
            return parseNumber(word);
        }
        switch (type) {
            case PlyType::int8:
                return binary<std::int8_t>();
            case PlyType::uint8:
                return binary<std::uint8_t>();
            case PlyType::int16:
                return binary<std::int16_t>();
            case PlyType::uint16:
                return binary<std::uint16_t>();
            case PlyType::int32:
                return binary<std::int32_t>();
            case PlyType::uint32:
                return binary<std::uint32_t>();
            case PlyType::float32:
                return binary<float>();
            default:
                return binary<double>();
        }
    }

private:
    template <typename Value>
    std::optional<double> binary() {
        char bytes[sizeof(Value)];
        if (rest_.size() < sizeof(Value)) return std::nullopt;
        std::memcpy(bytes, rest_.data(), sizeof(Value));
        rest_.remove_prefix(sizeof(Value));
        if ((coding_ == Coding::little) != (std::endian::native == std::endian::little))
            std::reverse(std::begin(bytes), std::end(bytes));
        Value value;
        std::memcpy(&value, bytes, sizeof(Value));
        return static_cast<double>(value);
    }

    Coding coding_;
    std::string_view rest_;
};

class PlyReader {
public:
    PlyReader(const std::string& name, std::string_view bytes) : mesh_(name), rest_(bytes) {}

    Primitives::Mesh read() {
        PlyValues values = header();
        for (const Element& element : elements_)
            for (std::size_t row = 0; row < element.count && !element.properties.empty(); ++row)
                readRow(element, row, values);
        return mesh_.finish();
    }

private:
    struct Property {
        std::string name;
        PlyType type = PlyType::float32;
        std::optional<PlyType> count;  ///< of a list
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
        const auto next = [&](PlyType type) {
            const auto value = values.next(type);
            if (!value) mesh_.refuse(place, "a number is missing");
            return *value;
        };
        glm::dvec3 at(NAN);
        bool face = false;
        for (const Property& property : element.properties) {
            if (!property.count) {
                const double value = next(property.type);
                const std::size_t axis = property.name.size() == 1 ? std::string_view("xyz").find(property.name) : 3;
                if (axis < 3) at[static_cast<int>(axis)] = value;
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
        if (element.name == "vertex") mesh_.addVertex(place, at);
    }

    MeshBuilder mesh_;
    std::string_view rest_;
    std::vector<Element> elements_;
    std::vector<std::int64_t> corners_;
};

}  // namespace

Primitives::Mesh readObj(const std::string& name, std::string_view text) {
    constexpr std::size_t kLongestLine = 1'000'000;
    MeshBuilder mesh(name);
    std::vector<std::int64_t> corners;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::string_view line = nextLine(text);
        if (!line.starts_with("v ") && !line.starts_with("f ")) continue;
        const std::string place = "line " + std::to_string(number) + ": ";
        if (line.size() > kLongestLine) mesh.refuse(place, "it is too long");
        if (line[0] == 'v') {
            const Words words = splitWords(line);
            glm::dvec3 at;
            for (int i = 0; i < 3; ++i) at[i] = parseNumber(words[static_cast<std::size_t>(i + 1)]).value_or(NAN);
            mesh.addVertex(place, at);
            continue;
        }
        corners.clear();
        for (const std::string_view word : splitAllWords(line.substr(2))) {
            // Counted from 1, or backwards from -1; texture and normal follow slashes.
            const std::int64_t index = parseInteger(word.substr(0, word.find('/'))).value_or(0);
            corners.push_back(index < 0 ? index + static_cast<std::int64_t>(mesh.vertices()) : index - 1);
        }
        mesh.addFace(place, corners);
    }
    return mesh.finish();
}

Primitives::Mesh readPly(const std::string& name, std::string_view bytes) { return PlyReader(name, bytes).read(); }

}  // namespace nacre::app::mvs
