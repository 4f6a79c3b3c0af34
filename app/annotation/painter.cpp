#include "app/annotation/painter.h"

#include <ft2build.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_OUTLINE_H
#include FT_STROKER_H

#include "app/annotation/shaping.h"
#include "engine/error.h"
#include "engine/molecule/text.h"
#include "engine/srgb.h"

namespace nacre::app {
namespace {

FT_Pos fixed(double pixels) { return static_cast<FT_Pos>(std::lround(pixels * 64)); }

/// Coverage of the pixels in a band of rows. Overlapping marks keep the larger value.
class Coverage {
public:
    Coverage(std::uint32_t width, std::uint32_t first, std::uint32_t rows)
        : width_(static_cast<int>(width)), first_(static_cast<int>(first)), rows_(static_cast<int>(rows)) {}

    /// Spans of one shape, in rows of the picture.
    void add(int y, int from, int count, std::uint8_t share) {
        y -= first_;
        if (y < 0 || y >= rows_) return;
        const int to = std::min(from + count, width_);
        from = std::max(from, 0);
        if (from >= to) return;
        if (shares_.empty()) shares_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_));
        low_ = std::min(low_, y), high_ = std::max(high_, y + 1);
        std::uint8_t* row = shares_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
        for (int x = from; x < to; ++x) row[x] = std::max(row[x], share);
    }

    /// Composites a colour over the covered pixels, and clears the coverage. Mixes code values, as usual for text on
    /// screens: in linear light, dark letters would look thin.
    void pour(std::uint32_t color, double strength, float* rgba) {
        std::array<float, 3> ink{};
        for (std::size_t c = 0; c < 3; ++c) ink[c] = static_cast<float>(color >> (8 * c) & 0xff) / 255.0f;
        const std::size_t width = static_cast<std::size_t>(width_);
        for (std::size_t i = static_cast<std::size_t>(low_) * width;
             !shares_.empty() && i < static_cast<std::size_t>(high_) * width; ++i) {
            if (shares_[i] == 0) continue;
            const float share = static_cast<float>(shares_[i] / 255.0 * strength);
            float* pixel = rgba + 4 * i;
            const float before = std::clamp(pixel[3], 0.0f, 1.0f), after = share + (1 - share) * before;
            const float weight = share / after;
            for (std::size_t c = 0; c < 3; ++c) {
                const float light = before > 0 ? pixel[c] / before : 0.0f;
                const float coded = linearToSrgb(light);
                pixel[c] = srgbToLinear(coded + (ink[c] - coded) * weight) * after;
            }
            pixel[3] = after;
            shares_[i] = 0;
        }
        low_ = rows_, high_ = 0;
    }

private:
    int width_, first_, rows_;
    int low_ = 0x7fffffff, high_ = 0;
    std::vector<std::uint8_t> shares_;
};

/// Adds an outline with y pointing up from the picture's top edge, in 1/64 pixels.
void rasterize(FT_Library library, FT_Outline& outline, Coverage& coverage) {
    FT_Raster_Params parameters{};
    parameters.flags = FT_RASTER_FLAG_AA | FT_RASTER_FLAG_DIRECT;
    parameters.user = &coverage;
    parameters.gray_spans = [](int y, int count, const FT_Span* spans, void* user) {
        for (int i = 0; i < count; ++i)
            static_cast<Coverage*>(user)->add(-1 - y, spans[i].x, spans[i].len, spans[i].coverage);
    };
    FT_BBox box;
    FT_Outline_Get_CBox(&outline, &box);
    parameters.flags |= FT_RASTER_FLAG_CLIP;
    parameters.clip_box = {box.xMin / 64 - 1, box.yMin / 64 - 1, box.xMax / 64 + 2, box.yMax / 64 + 2};
    FT_Outline_Render(library, &outline, &parameters);
}

void rasterizePolygon(FT_Library library, const std::vector<glm::dvec2>& corners, Coverage& coverage) {
    std::vector<FT_Vector> points;
    for (const glm::dvec2& corner : corners) points.push_back({fixed(corner.x), fixed(-corner.y)});
    std::vector<char> tags(points.size(), FT_CURVE_TAG_ON);
    short end = static_cast<short>(points.size() - 1);
    FT_Outline outline{1, static_cast<short>(points.size()), points.data(), tags.data(), &end, FT_OUTLINE_NONE};
    rasterize(library, outline, coverage);
}

void rasterizeDisc(FT_Library library, const glm::dvec2& at, double radius, Coverage& coverage) {
    const int corners = std::clamp(static_cast<int>(radius * 4), 16, 256);
    std::vector<glm::dvec2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        points.push_back(at + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    rasterizePolygon(library, points, coverage);
}

/// Segments with round ends, which join without gaps.
void rasterizeLine(FT_Library library, const LineMark& line, double grown, Coverage& coverage) {
    const double half = line.width / 2 + grown;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const glm::dvec2 a = line.points[i - 1], b = line.points[i];
        const double length = glm::distance(a, b);
        if (length < 1e-9) continue;
        const glm::dvec2 way = (b - a) / length, side = glm::dvec2(-way.y, way.x) * half;
        // halos also extend the ends of single strokes
        const glm::dvec2 more = line.points.size() == 2 ? way * grown : way * 0.0;
        rasterizePolygon(library, {a - more + side, b + more + side, b + more - side, a - more - side}, coverage);
        if (i > 1) rasterizeDisc(library, a, half, coverage);
    }
}

/// The outline, without width.
LineMark closedOutline(const ShapeMark& shape) {
    LineMark rim{shape.corners, 0};
    rim.points.push_back(shape.corners.front());
    return rim;
}

}  // namespace

struct WordPainter::Face {
    FT_Library library = nullptr;
    std::vector<FT_Face> faces;  // the built-in font, and system fonts in use
    FT_Stroker stroker = nullptr;
    FindFont find;
    Shaper shaper;
    // characters missing in the built-in font; the built-in face if no font has them
    std::map<char32_t, FT_Face> foreign;

    ~Face() {
        FT_Stroker_Done(stroker);
        for (FT_Face face : faces) FT_Done_Face(face);
        FT_Done_FreeType(library);
    }

    FT_Face findFace(char32_t c) {
        constexpr std::size_t kMostForeign = 2000;  // each may cost a call of fc-match
        if (c < 0x80 || FT_Get_Char_Index(faces[0], c)) return faces[0];
        if (const auto it = foreign.find(c); it != foreign.end()) return it->second;
        if (foreign.size() >= kMostForeign) return faces[0];
        FT_Face& face = foreign.emplace(c, faces[0]).first->second;
        for (std::size_t i = 1; i < faces.size() && face == faces[0]; ++i)
            if (FT_Get_Char_Index(faces[i], c)) face = faces[i];
        if (face == faces[0]) face = openSystemFace(c);
        return face;
    }

    /// The opened system font with the character; the built-in one if no font has its outline.
    FT_Face openSystemFace(char32_t c) {
        const std::optional<FontFile> file = find ? find({c}) : std::nullopt;
        FT_Face face = nullptr;
        if (!file || FT_New_Face(library, file->path.c_str(), file->index, &face)) return faces[0];
        if (FT_IS_SCALABLE(face) && FT_Get_Char_Index(face, c)) return faces.emplace_back(face);
        FT_Done_Face(face);
        return faces[0];
    }

    /// Characters that no font has.
    std::vector<char32_t> missing() const {
        std::vector<char32_t> found;
        for (const auto& [character, face] : foreign)
            if (face == faces[0]) found.push_back(character);
        return found;
    }

    ShapedLine shape(const std::string& text) {
        return shaper.shape(text, [this](char32_t c) { return findFace(c); });
    }

    /// @param halo  width around the letters, pixels; 0: draw the letters
    void addText(const TextMark& mark, double halo, Coverage& coverage) {
        // Baselines on whole pixels keep all letters of a line equally sharp.
        const glm::dvec2 at(mark.at.x, std::round(mark.at.y));
        const ShapedLine line = shape(mark.text);
        for (FT_Face face : faces)
            if (FT_Set_Char_Size(face, 0, std::max<FT_F26Dot6>(fixed(mark.size), 1), 72, 72)) return;
        for (const auto& [face, index, x, y] : line.glyphs) {
            if (FT_Load_Glyph(face, index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP)) continue;
            FT_Glyph glyph = nullptr;
            if (FT_Get_Glyph(face->glyph, &glyph)) continue;
            if (halo > 0) {
                FT_Stroker_Set(stroker, fixed(halo), FT_STROKER_LINECAP_ROUND, FT_STROKER_LINEJOIN_ROUND, 0);
                FT_Glyph_Stroke(&glyph, stroker, 1);
            }
            if (glyph->format == FT_GLYPH_FORMAT_OUTLINE) {
                FT_Outline& outline = reinterpret_cast<FT_OutlineGlyph>(glyph)->outline;
                FT_Outline_Translate(&outline, fixed(at.x + x * mark.size), fixed(y * mark.size - at.y));
                rasterize(library, outline, coverage);
            }
            FT_Done_Glyph(glyph);
        }
    }
};

WordPainter::WordPainter(FindFont find) : face_(std::make_unique<Face>()) {
    const std::span<const std::byte> font = fontFile();
    face_->find = std::move(find);
    FT_Face own = nullptr;
    if (FT_Init_FreeType(&face_->library) ||
        FT_New_Memory_Face(face_->library, reinterpret_cast<const FT_Byte*>(font.data()),
                           static_cast<FT_Long>(font.size()), 0, &own))
        throw Error("cannot draw text", "", "FreeType does not read the built-in font");
    face_->faces.push_back(own);
    if (FT_Stroker_New(face_->library, &face_->stroker)) throw Error("cannot draw text", "", "FreeType has no stroker");
}
WordPainter::~WordPainter() = default;

double WordPainter::measureWidth(const std::string& text, double size) const { return face_->shape(text).width * size; }

void WordPainter::paint(const Marks& marks, float* rgba, std::uint32_t width, std::uint32_t first,
                        std::uint32_t rows) const {
    constexpr double kHaloStrength = 0.85;
    FT_Library library = face_->library;
    Coverage coverage(width, first, rows);
    const auto nearRows = [&](double y, double reach) {
        return y + reach >= first && y - reach <= static_cast<double>(first) + rows;
    };
    const auto nearLine = [&](const LineMark& line) {
        return std::any_of(line.points.begin(), line.points.end(), [&](const glm::dvec2& p) {
            return nearRows(p.y, line.width + marks.haloWidth + glm::distance(line.points.front(), line.points.back()));
        });
    };
    for (const PlateMark& plate : marks.plates) {
        bool any = false;
        for (const std::vector<glm::dvec2>& part : plate.parts) {
            const auto [top, bottom] = std::ranges::minmax(part, {}, &glm::dvec2::y);
            if (bottom.y < first || top.y > static_cast<double>(first) + rows) continue;
            rasterizePolygon(library, part, coverage);
            any = true;
        }
        if (any) coverage.pour(plate.color, PlateMark::kStrength, rgba);
    }
    for (const BackMark& back : marks.backs)
        if (back.low.y < static_cast<double>(first) + rows && back.high.y > first)
            rasterizePolygon(library, {back.low, {back.high.x, back.low.y}, back.high, {back.low.x, back.high.y}},
                             coverage);
    coverage.pour(marks.halo, BackMark::kStrength, rgba);
    for (const LineMark& line : marks.lines)
        if (nearLine(line)) rasterizeLine(library, line, marks.haloWidth * 0.8, coverage);
    for (const ShapeMark& shape : marks.shapes) {
        const LineMark rim = closedOutline(shape);
        if (nearLine(rim)) rasterizeLine(library, rim, marks.haloWidth * 0.8, coverage);
    }
    for (const DiscMark& disc : marks.discs)
        if (nearRows(disc.at.y, disc.radius + marks.haloWidth))
            rasterizeDisc(library, disc.at, disc.radius + marks.haloWidth * 0.8, coverage);
    for (const TextMark& text : marks.texts)
        if (nearRows(text.at.y, 2 * text.size)) face_->addText(text, marks.haloWidth, coverage);
    coverage.pour(marks.halo, kHaloStrength, rgba);
    for (const LineMark& line : marks.lines)
        if (nearLine(line)) rasterizeLine(library, line, 0, coverage);
    for (const DiscMark& disc : marks.discs)
        if (disc.color == 0 && nearRows(disc.at.y, disc.radius)) rasterizeDisc(library, disc.at, disc.radius, coverage);
    coverage.pour(marks.color, 1, rgba);
    for (const ShapeMark& shape : marks.shapes) {
        if (!nearLine(closedOutline(shape))) continue;
        rasterizePolygon(library, shape.corners, coverage);
        coverage.pour(shape.color, 1, rgba);
    }
    for (const DiscMark& disc : marks.discs) {
        if (disc.color == 0 || !nearRows(disc.at.y, disc.radius)) continue;
        if (disc.ring) {
            rasterizeDisc(library, disc.at, disc.radius, coverage);
            coverage.pour(disc.ring, 1, rgba);
        }
        rasterizeDisc(library, disc.at, disc.inner(), coverage);
        coverage.pour(disc.color, 1, rgba);
    }
    for (const RampMark& ramp : marks.ramps)
        for (std::size_t i = 0; i + 1 < ramp.colors.size(); ++i) {
            const auto steps = static_cast<double>(ramp.colors.size() - 1);
            // On whole pixels, to avoid seams between steps.
            const auto y = [&](std::size_t k) {
                return std::round(ramp.low.y + (ramp.high.y - ramp.low.y) * static_cast<double>(k) / steps);
            };
            if (y(i) >= static_cast<double>(first) + rows || y(i + 1) < first) continue;
            rasterizePolygon(library,
                             {{ramp.low.x, y(i)}, {ramp.high.x, y(i)}, {ramp.high.x, y(i + 1)}, {ramp.low.x, y(i + 1)}},
                             coverage);
            coverage.pour(ramp.colors[i], 1, rgba);
        }
    for (const TextMark& text : marks.texts)
        if (text.color == 0 && nearRows(text.at.y, 2 * text.size)) face_->addText(text, 0, coverage);
    coverage.pour(marks.color, 1, rgba);
    for (const TextMark& text : marks.texts) {
        if (text.color == 0 || !nearRows(text.at.y, 2 * text.size)) continue;
        face_->addText(text, 0, coverage);
        coverage.pour(text.color, 1, rgba);
    }
}

Marks WordPainter::layOut(const PlacedWords& words, const View& view, double size,
                          const std::optional<std::array<float, 3>>& color, const std::array<float, 4>& background,
                          const Clip& clip, WordMemory* memory) const {
    return app::layOut(
        words, view, size, color, background,
        [this](const std::string& text, double em) { return measureWidth(text, em); }, clip, memory);
}

View WordPainter::besideWords(const View& view, const PlacedWords& words, double size,
                              const std::vector<glm::dvec4>& balls, double zoom) const {
    return app::besideWords(view, words, size, balls, zoom,
                            [this](const std::string& text, double em) { return measureWidth(text, em); });
}

std::vector<std::string> WordPainter::listWarnings(const Marks& marks) const {
    std::vector<std::string> warnings;
    if (marks.crowded > 0)
        warnings.push_back(std::to_string(marks.crowded) + (marks.crowded == 1 ? " label does" : " labels do") +
                           " not fit into the picture (use a smaller --text-size, or fewer labels)");
    if (const std::vector<char32_t> missing = face_->missing(); !missing.empty()) {
        constexpr std::size_t kNamed = 4;
        std::string text =
            "no installed font has " + std::string(missing.size() == 1 ? "the character" : "the characters");
        for (std::size_t i = 0; i < std::min(missing.size(), kNamed); ++i)
            text += formatted(i ? ", U+%04X" : " U+%04X", static_cast<unsigned>(missing[i]));
        if (missing.size() > kNamed) text += " and " + std::to_string(missing.size() - kNamed) + " more";
        warnings.push_back(text + ": the picture shows boxes instead");
    }
    return warnings;
}

std::vector<std::string> WordPainter::paint(const PlacedWords& words, const View& view, double size,
                                            const std::optional<std::array<float, 3>>& color,
                                            const std::array<float, 4>& background, Picture& picture, const Clip& clip,
                                            WordMemory* memory) const {
    if (!words.any()) return {};
    const Marks marks = layOut(words, view, size, color, background, clip, memory);
    constexpr std::uint32_t kBand = 256;
    for (std::uint32_t row = 0; row < picture.height; row += kBand)
        paint(marks, picture.rgba.data() + std::size_t{row} * picture.width * 4, picture.width, row,
              std::min(kBand, picture.height - row));
    return listWarnings(marks);
}

}  // namespace nacre::app
