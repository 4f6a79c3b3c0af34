#include "app/mvs/node_table.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <vector>

namespace nacre::app::mvs {
namespace {

#define NACRE_SOURCE "schema category_name field_name field_remapping block_header block_index"
#define NACRE_URI "uri format " NACRE_SOURCE

constexpr std::string_view kPalettes = "palette: categorical, discrete and continuous; elements in Nacre's colours";
constexpr std::string_view kFormats = "text_format: types s, d, f, e and %, with width, precision, sign and commas";

constexpr std::string_view kMovedParents = "structure component component_from_uri component_from_source volume shape";
constexpr std::string_view kLookParents = "component component_from_uri component_from_source";
constexpr std::string_view kTextParents = "structure component component_from_uri component_from_source";
constexpr std::string_view kFocusParents =
    "root structure component component_from_uri component_from_source primitives primitives_from_uri volume "
    "volume_representation shape";

constexpr NodeRow kRows[] = {
    {"root", "", "", "", ""},
    {"download", "root", "url", "", "files in the archive, beside the scene, of --mvs-map, or downloaded"},
    {"parse", "download", "format", "", "every format that Nacre reads; the content decides"},
    {"coordinates", "parse", "", "", "DCD, XTC, TRR, AMBER NetCDF, or the models of a structure file"},
    {"structure", "parse",
     "type assembly_id assembly_index model_index coordinates_ref block_index block_header radius ijk_min ijk_max", "",
     "block_index and block_header: of CIF and SDF; with coordinates_ref, model_index is the frame"},
    {"transform", kMovedParents, "rotation translation rotation_center matrix", "", "rigid motions"},
    {"instance", kMovedParents, "rotation translation rotation_center matrix", "", "rigid motions"},
    {"component", "structure", "selector", "", "selector: all fields; instance_id gives a copy atoms of its own"},
    {"component_from_uri", "structure", NACRE_URI " field_values", "", ""},
    {"component_from_source", "structure", NACRE_SOURCE " field_values", "", ""},
    {"representation", kLookParents, "type", "", "types: the rows below"},
    {"representation:cartoon", "", "type tubular_helices size_factor", "", ""},
    {"representation:ball_and_stick", "", "type ignore_hydrogens size_factor", "", ""},
    {"representation:spacefill", "", "type ignore_hydrogens size_factor", "", ""},
    {"representation:surface", "", "type ignore_hydrogens surface_type size_factor", "",
     "size_factor: of the atoms' radii, 4 at most"},
    {"representation:line", "", "type ignore_hydrogens size_factor", "", ""},
    {"representation:backbone", "", "type size_factor", "", ""},
    {"representation:carbohydrate", "", "type size_factor", "",
     "SNFG symbols, in their own colours without a color node"},
    {"representation:putty", "", "type size_factor size_theme", "", "size_theme: uniform or uncertainty"},
    {"color", "representation volume_representation shape", "color selector", "", ""},
    {"color_from_uri", "representation", NACRE_URI " palette selector", "", kPalettes},
    {"color_from_source", "representation", NACRE_SOURCE " palette selector", "", kPalettes},
    {"opacity", "representation volume_representation shape", "opacity selector", "",
     "not of lines; two layers are in order, and further ones blended without"},
    {"clip", "representation primitives primitives_from_uri volume_representation shape", "type", "",
     "types: the rows below; whole atoms, residues of cartoons, primitives and triangles, by their centres; each copy "
     "where it is"},
    {"clip:plane", "", "type normal point check_transform invert variant", "", "cuts where the normal points to"},
    {"clip:sphere", "", "type center radius check_transform invert variant", "", ""},
    {"clip:box", "", "type center size rotation check_transform invert variant", "", ""},
    {"label", kTextParents, "text", "", ""},
    {"label_from_uri", kTextParents, NACRE_URI " text_format group_by_fields", "", kFormats},
    {"label_from_source", kTextParents, NACRE_SOURCE " text_format group_by_fields", "", kFormats},
    {"tooltip", kTextParents, "text", "", "in a window, under the pointer"},
    {"tooltip_from_uri", kTextParents, NACRE_URI " text_format", "", "in a window, under the pointer"},
    {"tooltip_from_source", kTextParents, NACRE_SOURCE " text_format", "", "in a window, under the pointer"},
    {"focus", kFocusParents, "direction up radius radius_factor radius_extent", "", ""},
    {"camera", "root", "target position up near", "", ""},
    {"canvas", "root", "background_color", "", ""},
    {"transition", "root", "duration_ms trajectory easing", "", "in movies; leap-relative is drawn as leap"},
    {"animation", "", "duration_ms loop frame_time_ms include_camera include_canvas", "autoplay",
     "in movies; of a snapshot, beside its root"},
    {"interpolate", "animation", "kind", "", "kinds: the rows below"},
    {"interpolate:scalar", "",
     "kind target_ref property start_ms duration_ms frequency alternate_direction easing start end discrete",
     "noise_magnitude", ""},
    {"interpolate:vec3", "",
     "kind target_ref property start_ms duration_ms frequency alternate_direction easing start end spherical",
     "noise_magnitude", ""},
    {"interpolate:rotation_matrix", "",
     "kind target_ref property start_ms duration_ms frequency alternate_direction easing start end", "noise_magnitude",
     ""},
    {"interpolate:color", "",
     "kind target_ref property start_ms duration_ms frequency alternate_direction easing start end palette", "", ""},
    {"interpolate:transform_matrix", "",
     "kind target_ref property start_ms duration_ms pivot rotation_start rotation_end rotation_easing "
     "rotation_frequency rotation_alternate_direction translation_start translation_end translation_easing "
     "translation_frequency translation_alternate_direction",
     "rotation_noise_magnitude translation_noise_magnitude scale_start scale_end scale_easing scale_frequency "
     "scale_alternate_direction scale_noise_magnitude",
     "rigid motions"},
    {"volume", "parse", "channel_id", "",
     "CCP4, MRC, OpenDX and density servers' BinaryCIF, as far as the file reaches"},
    {"volume_representation", "volume", "type", "", "types: the rows below"},
    {"volume_representation:isosurface", "", "type relative_isovalue absolute_isovalue show_wireframe show_faces", "",
     ""},
    {"volume_representation:grid_slice", "",
     "type dimension absolute_index relative_index relative_isovalue absolute_isovalue", "",
     "from black to the colour; without what lies below the isovalue: the mean where the scene gives none"},
    {"shape", "parse", "", "",
     "triangles of OBJ, PLY and VTP files; colours of the file by obj_coloring, ply_coloring and vtp_attribute of "
     "custom"},
    {"primitives", "root structure",
     "color label_color tooltip opacity label_opacity label_show_tether label_tether_length label_attachment "
     "label_background_color instances",
     "snapshot_key", "its primitives: the rows below"},
    {"primitives_from_uri", "root structure", "uri format references", "", ""},
    {"primitive", "primitives", "kind", "", "kinds: the rows below"},
    {"primitive:tube", "", "kind start end radius dash_length color tooltip", "", ""},
    {"primitive:arrow", "",
     "kind start end direction length show_start_cap start_cap_length start_cap_radius show_end_cap end_cap_length "
     "end_cap_radius show_tube tube_radius tube_dash_length color tooltip",
     "", ""},
    {"primitive:lines", "",
     "kind vertices indices line_groups group_colors group_tooltips group_widths tooltip width color", "", "opaque"},
    {"primitive:mesh", "",
     "kind vertices indices triangle_groups group_colors group_tooltips tooltip color show_triangles show_wireframe "
     "wireframe_width wireframe_color",
     "", ""},
    {"primitive:label", "", "kind position text label_size label_color label_offset", "",
     "labels lie over what is drawn, whatever their label_offset"},
    {"primitive:distance_measurement", "",
     "kind start end radius dash_length color label_template label_size label_auto_size_scale label_auto_size_min "
     "label_color",
     "", ""},
    {"primitive:angle_measurement", "",
     "kind a b c label_template label_size label_auto_size_scale label_auto_size_min label_color show_vector "
     "vector_color vector_radius show_section section_color section_radius section_radius_scale",
     "start end radius dash_length color", "start to color: Mol* does not use them, either"},
    {"primitive:ellipse", "",
     "kind center as_circle major_axis minor_axis major_axis_endpoint minor_axis_endpoint radius_major radius_minor "
     "theta_start theta_end color tooltip",
     "", ""},
    {"primitive:ellipsoid", "",
     "kind center major_axis minor_axis major_axis_endpoint minor_axis_endpoint radius radius_extent color tooltip", "",
     ""},
    {"primitive:box", "", "kind center extent show_faces face_color show_edges edge_radius edge_color tooltip", "", ""},
};

/// Splits words separated by blanks.
std::vector<std::string> divided(std::string_view words) {
    std::istringstream text{std::string(words)};
    return {std::istream_iterator<std::string>(text), {}};
}

bool isAmong(std::string_view word, std::string_view words) {
    const std::vector<std::string> all = divided(words);
    return std::find(all.begin(), all.end(), word) != all.end();
}

}  // namespace

bool NodeRow::knows(std::string_view param) const { return isAmong(param, params); }

bool NodeRow::isBelow(std::string_view parent) const { return isAmong(parent, parents); }

std::span<const NodeRow> nodeRows() { return kRows; }

std::string nodeTable() {
    std::string table = "| node | parameter | drawn | remark |\n|---|---|---|---|\n";
    for (const NodeRow& row : kRows) {
        std::string kind(row.kind);
        std::replace(kind.begin(), kind.end(), ':', ' ');
        table += "| " + kind + " | | yes | " + std::string(row.remark) + " |\n";
        for (const std::string& word : divided(row.params)) table += "| " + kind + " | `" + word + "` | yes | |\n";
        for (const std::string& word : divided(row.unused)) table += "| " + kind + " | `" + word + "` | no | |\n";
    }
    return table;
}

const NodeRow* nodeRow(std::string_view kind) {
    const auto found = std::ranges::find_if(kRows, [&](const NodeRow& row) { return row.kind == kind; });
    return found == std::end(kRows) ? nullptr : &*found;
}

}  // namespace nacre::app::mvs
