#include "app/annotation/shaping.h"

#include <hb.h>

#include <cstdint>
#include <memory>
#include FT_TRUETYPE_TABLES_H

#include "app/annotation/bidi.h"
#include "app/annotation/visual_text.h"
#include "app/files/code_points.h"

namespace nacre::app {
namespace {

/// A table of a font that FreeType has open.
hb_blob_t* loadTable(hb_face_t*, hb_tag_t tag, void* user) {
    const auto face = static_cast<FT_Face>(user);
    FT_ULong size = 0;
    if (FT_Load_Sfnt_Table(face, tag, 0, nullptr, &size) || size == 0) return nullptr;
    auto* const bytes = new std::vector<char>(size);
    if (FT_Load_Sfnt_Table(face, tag, 0, reinterpret_cast<FT_Byte*>(bytes->data()), &size)) {
        delete bytes;
        return nullptr;
    }
    return hb_blob_create(bytes->data(), static_cast<unsigned>(size), HB_MEMORY_MODE_READONLY, bytes,
                          [](void* data) { delete static_cast<std::vector<char>*>(data); });
}

/// Marks and joiners are drawn with the letter that they follow.
bool staysWithLetter(char32_t c) {
    const BidiClass kind = findBidiClass(c);
    return kind == BidiClass::NSM || kind == BidiClass::BN ||
           hb_unicode_general_category(hb_unicode_funcs_get_default(), c) == HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK;
}

hb_script_t findScript(char32_t c) {
    const hb_script_t script = hb_unicode_script(hb_unicode_funcs_get_default(), c);
    return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED ? HB_SCRIPT_INVALID : script;
}

/// Characters of one direction, face and script.
struct Segment {
    std::size_t first, count;
    FT_Face face;
    hb_script_t script;  ///< HB_SCRIPT_INVALID: no character has one
    bool rightToLeft;
};

std::vector<Segment> splitSegments(const std::vector<char32_t>& points, const DirectedRun& run,
                                   const std::function<FT_Face(char32_t)>& findFace) {
    std::vector<Segment> segments;
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        const bool same = !segments.empty() && staysWithLetter(points[i]);
        const FT_Face face = same ? segments.back().face : findFace(points[i]);
        const hb_script_t script = same ? HB_SCRIPT_INVALID : findScript(points[i]);
        const bool begins = segments.empty() || face != segments.back().face ||
                            (script != HB_SCRIPT_INVALID && segments.back().script != HB_SCRIPT_INVALID &&
                             script != segments.back().script);
        if (begins) segments.push_back({i, 0, face, script, run.rightToLeft});
        ++segments.back().count;
        if (segments.back().script == HB_SCRIPT_INVALID) segments.back().script = script;
    }
    return segments;
}

}  // namespace

Shaper::Shaper() = default;
Shaper::~Shaper() {
    for (const auto& [face, font] : fonts_) hb_font_destroy(font);
}

hb_font_t* Shaper::makeFont(FT_Face face) {
    hb_font_t*& font = fonts_[face];
    if (!font) {
        hb_face_t* const tables = hb_face_create_for_tables(loadTable, face, nullptr);
        hb_face_set_index(tables, static_cast<unsigned>(face->face_index));
        font = hb_font_create(tables);  // measures in the font's own units
        hb_face_destroy(tables);
    }
    return font;
}

ShapedLine Shaper::shape(const std::string& text, const std::function<FT_Face(char32_t)>& findFace) {
    const std::vector<char32_t> points = codePoints(text);
    std::vector<DirectedRun> runs{{0, points.size(), false}};
    if (mayRunFromRight(text)) runs = visualRuns(points);
    ShapedLine line;
    const std::unique_ptr<hb_buffer_t, decltype(&hb_buffer_destroy)> buffer(hb_buffer_create(), &hb_buffer_destroy);
    for (const DirectedRun& run : runs) {
        std::vector<Segment> segments = splitSegments(points, run, findFace);
        if (run.rightToLeft) segments = {segments.rbegin(), segments.rend()};
        for (const Segment& segment : segments) {
            hb_buffer_clear_contents(buffer.get());
            hb_buffer_add_utf32(buffer.get(), reinterpret_cast<const std::uint32_t*>(points.data()),
                                static_cast<int>(points.size()), static_cast<unsigned>(segment.first),
                                static_cast<int>(segment.count));
            hb_buffer_set_direction(buffer.get(), segment.rightToLeft ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
            hb_buffer_set_script(buffer.get(), segment.script == HB_SCRIPT_INVALID ? HB_SCRIPT_LATIN : segment.script);
            hb_buffer_set_language(buffer.get(), hb_language_from_string("en", -1));
            hb_shape(makeFont(segment.face), buffer.get(), nullptr, 0);
            unsigned count = 0;
            const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
            const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer.get(), &count);
            const double em = segment.face->units_per_EM;
            for (unsigned i = 0; i < count; ++i) {
                line.glyphs.push_back(
                    {segment.face, infos[i].codepoint, line.width + places[i].x_offset / em, places[i].y_offset / em});
                line.width += places[i].x_advance / em;
            }
        }
    }
    return line;
}

}  // namespace nacre::app
