// Meshes of VTK's XML PolyData files (VTP): polygons and triangle strips, in text, in base64 or after the XML, also
// compressed by zlib. Colours by an array of values.
#include <zlib.h>

#include <functional>
#include <limits>
#include <optional>

#include "app/mvs/mesh_builder.h"
#include "app/mvs/value_palette.h"
#include "engine/molecule/expat_parser.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

constexpr std::size_t kMostValues = 3 * kMostMeshTriangles;  // of an array
constexpr double kLeastRange = 1e-9;

/// Attributes in Expat's form: alternating names and values.
using XmlAttributes = std::function<std::string_view(std::string_view)>;

/// A DataArray element.
struct VtpArray {
    std::optional<NumberType> type;  ///< empty: the file has no such array
    std::size_t components = 1;
    std::string format, text;
    std::size_t offset = 0;  ///< in the appended data
};

struct VtpPiece {
    std::size_t points = 0, verts = 0, lines = 0, strips = 0, polys = 0;
    VtpArray positions, corners, ends, stripCorners, stripEnds, values;
    std::size_t cells() const { return verts + lines + polys + strips; }
};

/// Bytes of an array: as they are, or in base64. Some writers pad the base64 of each part to whole groups.
class VtpBytes {
public:
    VtpBytes(std::string_view text, bool base64) : text_(text), base64_(base64) {}

    /// The next bytes; fewer at the end.
    std::string take(std::size_t count) {
        std::string bytes;
        if (!base64_) {
            bytes = text_.substr(0, count);
            text_.remove_prefix(bytes.size());
            return bytes;
        }
        while (bytes.size() < count && (!left_.empty() || decodeGroup())) {
            const std::size_t taken = std::min(left_.size(), count - bytes.size());
            bytes.append(left_, 0, taken);
            left_.erase(0, taken);
        }
        return bytes;
    }
    std::size_t most() const { return left_.size() + text_.size(); }

private:
    static int digit(char c) {
        if (c >= 'A' && c <= 'Z') return c - 'A';
        if (c >= 'a' && c <= 'z') return c - 'a' + 26;
        if (c >= '0' && c <= '9') return c - '0' + 52;
        return c == '+' ? 62 : c == '/' ? 63 : -1;
    }
    bool decodeGroup() {
        std::uint32_t bits = 0;
        std::size_t digits = 0, signs = 0;
        while (signs < 4 && !text_.empty()) {
            const char c = text_.front();
            const int value = digit(c);
            if (value < 0 && c != '=' && !isBlank(c)) return false;
            text_.remove_prefix(1);
            if (isBlank(c)) continue;
            ++signs;
            bits = bits << 6 | static_cast<std::uint32_t>(std::max(value, 0));
            if (value >= 0) ++digits;
        }
        if (signs < 4 || digits < 2) return false;
        for (std::size_t i = 0; i + 1 < digits; ++i) left_ += static_cast<char>(bits >> (16 - 8 * i) & 0xff);
        return true;
    }

    std::string_view text_;
    bool base64_;
    std::string left_;  ///< decoded bytes
};

class VtpReader {
public:
    VtpReader(const std::string& name, std::string_view bytes, const MeshColoring& coloring)
        : mesh_(name), coloring_(coloring), parser_(this) {
        XML_SetElementHandler(parser_.get(), onStart, onEnd);
        XML_SetCharacterDataHandler(parser_.get(), onText);
        XML_SetStartDoctypeDeclHandler(parser_.get(), onDoctype);
        // Appended data may be no XML: the parser skips its element.
        constexpr std::string_view kOpen = "<AppendedData", kClose = "</AppendedData>";
        const std::size_t open = bytes.find(kOpen), close = bytes.rfind(kClose);
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
            parse(bytes, true);
            return;
        }
        parse(bytes.substr(0, open), false);
        const std::string_view element = bytes.substr(open, close - open);
        const std::string_view tag = element.substr(0, element.find('>'));
        appendedBase64_ = tag.find("base64") != std::string_view::npos;
        appended_ = element.substr(std::min(tag.size() + 1, element.size()));
        appended_.remove_prefix(std::min(appended_.find('_'), appended_.size() - 1) + 1);
        parse(bytes.substr(close + kClose.size()), true);
    }

    Primitives::Mesh read() {
        if (!isPolyData_) mesh_.refuse("", "it is no VTP file: no VTKFile of type PolyData");
        for (const VtpPiece& piece : pieces_) readPiece(piece);
        if (!hasValues_) return mesh_.finish();
        return mesh_.finishBlended(colors());
    }

private:
    // -- XML

    void parse(std::string_view text, bool last) {
        if (const std::string why = parser_.parse(text, last); !why.empty())
            mesh_.refuse(line(), "it is no XML: " + why);
    }
    std::string line() const { return "line " + std::to_string(parser_.line()) + ": "; }

    template <typename Work>
    static void guarded(void* user, Work work) {
        VtpReader& reader = *static_cast<VtpReader*>(user);
        reader.parser_.guard([&] { work(reader); });
    }
    static void XMLCALL onStart(void* user, const XML_Char* name, const XML_Char** list) {
        guarded(user, [&](VtpReader& reader) {
            reader.start(name, [&](std::string_view key) -> std::string_view {
                for (const XML_Char** at = list; *at; at += 2)
                    if (key == *at) return at[1];
                return {};
            });
        });
    }
    static void XMLCALL onEnd(void* user, const XML_Char*) {
        guarded(user, [](VtpReader& reader) { reader.end(); });
    }
    static void XMLCALL onText(void* user, const XML_Char* text, int length) {
        VtpReader& reader = *static_cast<VtpReader*>(user);
        if (!reader.open_.empty() && reader.open_.back() == "DataArray" && reader.array_)
            guarded(user, [&](VtpReader&) { reader.array_->text.append(text, static_cast<std::size_t>(length)); });
    }
    static void XMLCALL onDoctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
        guarded(user, [](VtpReader& reader) { reader.mesh_.refuse(reader.line(), "it has a document type"); });
    }

    void start(std::string_view name, const XmlAttributes& attributes) {
        constexpr std::size_t kDeepest = 32, kMostPieces = 10'000;
        if (open_.size() == kDeepest) mesh_.refuse(line(), "its elements are nested too deeply");
        const std::string parent = open_.empty() ? "" : open_.back();
        open_.emplace_back(name);
        if (name == "VTKFile") readFile(attributes);
        if (name == "Piece" && parent == "PolyData") {
            if (pieces_.size() == kMostPieces) mesh_.refuse(line(), "it has too many pieces");
            const auto count = [&](const char* key) {
                const std::int64_t value = parseInteger(attributes(key)).value_or(0);
                if (value < 0 || value > static_cast<std::int64_t>(kMostMeshTriangles))
                    mesh_.refuse(line(), std::string(key) + " is not usable");
                return static_cast<std::size_t>(value);
            };
            pieces_.push_back({count("NumberOfPoints"),
                               count("NumberOfVerts"),
                               count("NumberOfLines"),
                               count("NumberOfStrips"),
                               count("NumberOfPolys"),
                               {},
                               {},
                               {},
                               {},
                               {},
                               {}});
        }
        if (name == "DataArray" && !pieces_.empty()) {
            array_ = wantedArray(parent, attributes("Name"));
            if (array_) readArray(attributes);
        }
    }
    void end() {
        if (open_.back() == "DataArray") array_ = nullptr;
        open_.pop_back();
    }

    void readFile(const XmlAttributes& attributes) {
        isPolyData_ = attributes("type") == "PolyData";
        little_ = attributes("byte_order") != "BigEndian";
        headerType_ = attributes("header_type") == "UInt64" ? NumberType::uint64 : NumberType::uint32;
        const std::string_view compressor = attributes("compressor");
        compressed_ = !compressor.empty();
        if (compressed_ && compressor != "vtkZLibDataCompressor")
            mesh_.refuse(line(), "it is compressed by " + nacre::printable(compressor, 40) + ", not by zlib");
    }

    VtpArray* wantedArray(std::string_view parent, std::string_view name) {
        VtpPiece& piece = pieces_.back();
        if (parent == "Points") return &piece.positions;
        if (parent == "Polys" && name == "connectivity") return &piece.corners;
        if (parent == "Polys" && name == "offsets") return &piece.ends;
        if (parent == "Strips" && name == "connectivity") return &piece.stripCorners;
        if (parent == "Strips" && name == "offsets") return &piece.stripEnds;
        const bool wanted = parent == (coloring_.arrayOfCells ? "CellData" : "PointData") && !name.empty();
        return wanted && name == coloring_.array ? &piece.values : nullptr;
    }

    void readArray(const XmlAttributes& attributes) {
        constexpr std::string_view kTypes[] = {"Int8",   "UInt8",   "Int16",   "UInt16", "Int32",
                                               "UInt32", "Float32", "Float64", "Int64",  "UInt64"};
        const auto type = std::ranges::find(kTypes, attributes("type"));
        if (type == std::end(kTypes)) mesh_.refuse(line(), "an array of unknown type");
        const auto integer = [&](const char* key, std::int64_t otherwise) {
            const std::string_view text = attributes(key);
            const std::int64_t value = text.empty() ? otherwise : parseInteger(text).value_or(-1);
            if (value < 0) mesh_.refuse(line(), std::string(key) + " is not usable");
            return static_cast<std::size_t>(value);
        };
        *array_ = {static_cast<NumberType>(type - std::begin(kTypes)),
                   std::clamp<std::size_t>(integer("NumberOfComponents", 1), 1, 1000),
                   std::string(attributes("format")),
                   {},
                   integer("offset", 0)};
    }

    // -- arrays

    /// The values of an array. @param count  expected; SIZE_MAX: all that are there
    std::vector<double> valuesOf(const VtpArray& array, const std::string& place, std::size_t count) const {
        if (!array.type) mesh_.refuse(place, "it is missing");
        std::vector<double> values;
        if (array.format != "appended" && array.format != "binary") {
            std::string_view rest = array.text;
            while (!(rest = trim(rest)).empty() && values.size() < count) {
                const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
                rest.remove_prefix(word.size());
                const auto value = parseNumber(word);
                if (!value) mesh_.refuse(place, "'" + nacre::printable(word, 40) + "' is no number");
                if (values.size() == kMostValues) mesh_.refuse(place, "it is too long");
                values.push_back(*value);
            }
        } else {
            const std::string bytes = bytesOf(array, place);
            const std::size_t size = sizeOf(*array.type);
            for (std::size_t at = 0; at + size <= bytes.size() && values.size() < count; at += size)
                values.push_back(numberAt(bytes.data() + at, *array.type, little_));
        }
        if (count != SIZE_MAX && values.size() < count)
            mesh_.refuse(place, "it has " + std::to_string(values.size()) + " of " + std::to_string(count) + " values");
        return values;
    }

    std::string bytesOf(const VtpArray& array, const std::string& place) const {
        const bool isAppended = array.format == "appended";
        if (isAppended && array.offset > appended_.size()) mesh_.refuse(place, "it begins after the appended data");
        VtpBytes source(isAppended ? appended_.substr(array.offset) : std::string_view(array.text),
                        !isAppended || appendedBase64_);
        const auto exactly = [&](std::size_t count) {
            std::string bytes = count <= source.most() ? source.take(count) : std::string();
            if (bytes.size() < count) mesh_.refuse(place, "its data end early");
            return bytes;
        };
        const std::size_t width = sizeOf(headerType_), most = 8 * kMostValues;
        const auto headers = [&](std::size_t count) {
            if (count > most / width) mesh_.refuse(place, "it is too long");
            const std::string bytes = exactly(count * width);
            std::vector<std::size_t> sizes;
            for (std::size_t i = 0; i < count; ++i) {
                const double size = numberAt(bytes.data() + i * width, headerType_, little_);
                if (size > static_cast<double>(most)) mesh_.refuse(place, "it is too long");
                sizes.push_back(static_cast<std::size_t>(size));
            }
            return sizes;
        };
        if (!compressed_) return exactly(headers(1)[0]);
        const std::vector<std::size_t> shape = headers(3);  // blocks, size of each, size of the last if that is smaller
        const std::vector<std::size_t> sizes = headers(shape[0]);
        std::string bytes;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            constexpr std::size_t kMostRatio = 1100;  // zlib's: 1032
            const std::size_t size = i + 1 == sizes.size() && shape[2] > 0 ? shape[2] : shape[1];
            if (size > most - bytes.size()) mesh_.refuse(place, "it is too long");
            const std::string packed = exactly(sizes[i]);
            if (size / kMostRatio > packed.size()) mesh_.refuse(place, "a block is damaged");
            const std::size_t before = bytes.size();
            bytes.resize(before + size);
            auto inflated = static_cast<uLongf>(size);
            if (uncompress(reinterpret_cast<Bytef*>(bytes.data() + before), &inflated,
                           reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size())) != Z_OK ||
                inflated != size)
                mesh_.refuse(place, "a block is damaged");
        }
        return bytes;
    }

    // -- the mesh

    void readPiece(const VtpPiece& piece) {
        const std::size_t first = mesh_.vertices();
        const std::vector<double> at = valuesOf(piece.positions, "points: ", 3 * piece.points);
        for (std::size_t i = 0; i < piece.points; ++i)
            mesh_.addVertex("point " + std::to_string(i + 1) + ": ", {at[3 * i], at[3 * i + 1], at[3 * i + 2]});
        triangleCells_.clear();
        trianglesBefore_ = mesh_.triangles().size();
        addCells(piece.corners, piece.ends, piece.polys, first, piece.verts + piece.lines, "polygon", false);
        addCells(piece.stripCorners, piece.stripEnds, piece.strips, first, piece.verts + piece.lines + piece.polys,
                 "strip", true);
        if (coloring_.source == MeshColoring::Source::array) takeValues(piece, first);
    }

    /// @param cell  number of the first cell
    void addCells(const VtpArray& corners, const VtpArray& ends, std::size_t count, std::size_t first, std::size_t cell,
                  const std::string& what, bool strips) {
        if (count == 0) return;
        const std::vector<double> stops = valuesOf(ends, what + "s, offsets: ", count),
                                  all = valuesOf(corners, what + "s, connectivity: ", SIZE_MAX);
        std::vector<std::int64_t> face;
        double start = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::string place = what + " " + std::to_string(i + 1) + ": ";
            if (!(stops[i] >= start && stops[i] <= static_cast<double>(all.size())))
                mesh_.refuse(place, "its offset is not usable");
            face.clear();
            for (auto at = static_cast<std::size_t>(start); at < static_cast<std::size_t>(stops[i]); ++at) {
                const bool usable = all[at] >= 0 && all[at] < 1e15;
                face.push_back(usable ? static_cast<std::int64_t>(all[at]) + static_cast<std::int64_t>(first) : -1);
            }
            start = stops[i];
            for (std::size_t at = 0; strips && at + 2 < face.size(); ++at)
                mesh_.addFace(place, {face[at], face[at + 1 + at % 2], face[at + 2 - at % 2]});
            if (!strips) mesh_.addFace(place, face);
            triangleCells_.resize(mesh_.triangles().size() - trianglesBefore_, cell + i);
        }
    }

    /// Values of vertices: those of points, or means of cells around; lengths of vectors.
    void takeValues(const VtpPiece& piece, std::size_t first) {
        values_.resize(mesh_.vertices(), std::numeric_limits<double>::quiet_NaN());
        if (!piece.values.type) return;
        hasValues_ = true;
        const std::size_t width = piece.values.components,
                          count = coloring_.arrayOfCells ? piece.cells() : piece.points;
        if (std::max(count, piece.points) > kMostValues / width) mesh_.refuse("values: ", "it is too long");
        std::vector<double> given = valuesOf(piece.values, "values: ", width * count);
        if (coloring_.arrayOfCells) {
            std::vector<double> sums(width * piece.points);
            std::vector<std::uint32_t> counts(piece.points);
            for (std::size_t i = 0; i < triangleCells_.size(); ++i)
                for (const std::uint32_t corner : mesh_.triangles()[trianglesBefore_ + i]) {
                    const std::size_t vertex = corner - first;
                    ++counts[vertex];
                    for (std::size_t k = 0; k < width; ++k)
                        sums[width * vertex + k] += given[width * triangleCells_[i] + k];
                }
            for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i / width];  // without cells: not a number
            given = std::move(sums);
        }
        for (std::size_t i = 0; i < piece.points; ++i) {
            double square = 0;
            for (std::size_t k = 0; k < width; ++k) square += given[width * i + k] * given[width * i + k];
            values_[first + i] = width == 1 ? given[i] : std::sqrt(square);
        }
        ofVectors_ |= width > 1;
    }

    std::vector<std::uint32_t> colors() const {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const double value : values_) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
        if (ofVectors_ && high > 0 && (high - low) / high < 0.01) low = 0;  // unit vectors, as in Mol*
        if (coloring_.domain) {
            low = (*coloring_.domain)[0];
            high = (*coloring_.domain)[1];
        }
        const std::vector<std::uint32_t>& scale = coloring_.scale;
        const double last = static_cast<double>(scale.size()) - 1;
        std::vector<std::uint32_t> colors;
        for (const double value : values_) {
            const double at = std::clamp((value - low) / std::max(high - low, kLeastRange), 0.0, 1.0) * last;
            if (!std::isfinite(at)) {
                colors.push_back(kNoMaterialColor);
                continue;
            }
            const auto from = static_cast<std::size_t>(at), to = std::min(from + 1, scale.size() - 1);
            colors.push_back(mixedColor(scale[from], scale[to], at - std::floor(at)));
        }
        return colors;
    }

    MeshBuilder mesh_;
    const MeshColoring& coloring_;
    ExpatParser parser_;
    std::vector<std::string> open_;  ///< elements
    VtpArray* array_ = nullptr;      ///< whose text is read
    std::vector<VtpPiece> pieces_;
    std::string_view appended_;
    bool appendedBase64_ = false, isPolyData_ = false, little_ = true, compressed_ = false;
    NumberType headerType_ = NumberType::uint32;
    std::vector<std::size_t> triangleCells_;  ///< of the piece
    std::size_t trianglesBefore_ = 0;         ///< the piece
    std::vector<double> values_;              ///< of vertices
    bool hasValues_ = false, ofVectors_ = false;
};

}  // namespace

Primitives::Mesh readVtp(const std::string& name, std::string_view bytes, const MeshColoring& coloring) {
    return VtpReader(name, bytes, coloring).read();
}

}  // namespace nacre::app::mvs
