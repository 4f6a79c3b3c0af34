// The camera of the picture.

#include <cmath>
#include <glm/geometric.hpp>

#include "app/picture/rows.h"

namespace nacre::app {
namespace {

using P = PictureDescription;
using T = std::string_view;
using enum Option::Kind;
using enum Option::Save;

constexpr double kLargestLength = 1e9;  // Å

inline constexpr std::array<const char*, 2> kProjections{"ortho", "perspective"};

template <std::size_t count>
std::array<double, count> parseNumbers(T text) {
    std::array<double, count> numbers{};
    std::size_t i = 0;
    for (std::size_t from = 0; from <= text.size(); ++i) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        if (i == count) break;
        numbers[i] = parseNumber(text.substr(from, comma - from), -1e300, 1e300);
        from = comma + 1;
        if (comma == text.size()) {
            ++i;
            break;
        }
    }
    if (i != count || std::count(text.begin(), text.end(), ',') + 1 != count)
        throw std::invalid_argument("expected a list of " + std::to_string(count) + " numbers");
    return numbers;
}

void parseOrientation(T text, P& d) {
    const auto q = parseNumbers<4>(text);
    const glm::dquat orientation(q[0], q[1], q[2], q[3]);
    const double length = glm::length(orientation);
    if (!(length > 1e-6 && length < 1e6)) throw std::invalid_argument("expected a quaternion w, x, y, z");
    // An orientation of unit length keeps its exact digits.
    d.camera.orientation = std::abs(length - 1) < 1e-12 ? orientation : orientation / length;
}
std::string printOrientation(const P& d) {
    const glm::dquat& q = d.camera.orientation;
    return exactText(q.w) + "," + exactText(q.x) + "," + exactText(q.y) + "," + exactText(q.z);
}

glm::dvec2 parsePan(T text) {
    const auto pan = parseNumbers<2>(text);
    return {pan[0], pan[1]};
}
std::string panText(const glm::dvec2& pan) { return exactText(pan.x) + "," + exactText(pan.y); }
std::string dvec3Text(const glm::dvec3& v) { return exactText(v.x) + "," + exactText(v.y) + "," + exactText(v.z); }
void parseZoom(T text, P& d) {
    d.aim.fits = text == "fit";
    d.camera.zoom = d.aim.fits ? 1 : parseNumber(text, kSmallestZoom, kLargestZoom);
    if (!d.aim.fits) return;
    d.camera.scale.reset();
    d.camera.pan = {};
}

/// "60A", or pixels per Å.
void parseScale(T text, P& d) {
    constexpr double kFinest = 1e6, kWidest = 1e7;
    const bool across = text.ends_with('A');
    d.aim.fits = false;
    d.camera.scale = across ? ViewScale{ViewScale::Unit::angstromAcross,
                                        parseNumber(text.substr(0, text.size() - 1), 1 / kFinest, kWidest)}
                            : ViewScale{ViewScale::Unit::pixelsPerAngstrom, parseNumber(text, 1 / kWidest, kFinest)};
}
std::string printScale(const P& d) {
    if (!d.camera.scale) return "";
    const bool across = d.camera.scale->unit == ViewScale::Unit::angstromAcross;
    return exactText(d.camera.scale->value) + (across ? "A" : "");
}

/// Three numbers, or a selection.
void parseCenter(T text, P& d) {
    d.aim.center.reset();
    d.camera.center.reset();
    d.camera.pan = {};
    if (text.find_first_not_of("0123456789.,+-eE ") != T::npos) {
        d.aim.center = parseSelection(text);
        return;
    }
    const auto place = parseNumbers<3>(text);
    d.camera.center = {place[0], place[1], place[2]};
}
std::string printCenter(const P& d) {
    if (d.camera.center) return dvec3Text(*d.camera.center);
    return d.aim.center ? d.aim.center->text : "";
}
/// A moved camera has an explicit scale.
std::string printZoom(const P& d) {
    const bool moved = d.camera.zoom != 1 || d.camera.pan != glm::dvec2(0);
    return d.aim.fits && !moved ? "fit" : exactText(d.camera.zoom);
}
std::vector<Option> cameraRows() {
    std::vector<Option> rows{
        {.key = "projection",
         .syntax = "NAME",
         .standard = "=",
         .help = "ortho or perspective",
         .value = choiceOf<kProjections, &P::camera, &Camera::projection>(),
         .save = always,
         .control = {.label = "Perspective", .choices = {{"off", "ortho"}, {"on", "perspective"}}}},
        {.key = "stereo",
         .syntax = "MODE",
         .standard = "=",
         .help = "Two eyes in one picture: side-by-side (each with half the width), cross-eyed (the same, exchanged),\n"
                 "top-bottom, anaglyph (red and cyan glasses); or one: left, right. Always in perspective",
         .value = choiceOf<Stereo::kNames, &P::stereo, &Stereo::mode>(),
         .save = differing,
         .choices = {Stereo::kNames.begin(), Stereo::kNames.end()},
         .control = {.label = "Stereo",
                     .choices = {{"Stereo: off", "off"},
                                 {"Anaglyph", "anaglyph", "For glasses with a red left and a cyan right filter."},
                                 {"Side by side", "side-by-side", "The left eye's picture is on the left."},
                                 {"Cross-eyed", "cross-eyed", "The left eye's picture is on the right."},
                                 {"Top and bottom", "top-bottom", "The left eye's picture is on top."},
                                 {"Left eye", "left", "What the left eye sees."},
                                 {"Right eye", "right", "What the right eye sees."}}}},
        {.key = "eye-distance",
         .syntax = "A",
         .standard = "1/30 of the screen distance",
         .help = "Å between the eyes of --stereo: more gives more depth",
         .value = exactOf<&P::stereo, &Stereo::eyeDistance>(0, kLargestLength),
         .save = differing,
         .number = Option::Number::real,
         .needs = "stereo"},
        {.key = "screen-distance",
         .syntax = "A",
         .standard = "that of the picture's centre",
         .help = "Å from the eyes of --stereo to what appears at the screen; nearer parts appear in front of it",
         .value = exactOf<&P::stereo, &Stereo::screenDistance>(1e-3, kLargestLength),
         .save = differing,
         .number = Option::Number::real,
         .needs = "stereo"},
        {.key = "fov",
         .syntax = "DEGREES",
         .standard = "=",
         .help = "Perspective: field of view across the shorter side, 1 to 120",
         .value = exactOf<&P::camera, &Camera::fovDegrees>(kSmallestFov, kLargestFov),
         .save = always,
         .number = Option::Number::real},
        {.key = "zoom",
         .syntax = "F|fit",
         .standard = "=",
         .help = "fit: everything drawn fills the picture from this side; movies, models and frames share one scale.\n"
                 "F, 0.0001 to 10000: at 1 the molecule's sphere fills the picture, from any side",
         .value = {parseZoom, printZoom},
         .save = always,
         .number = Option::Number::real},
        {.key = "scale",
         .syntax = "F|LENGTH",
         .standard = "none: --zoom",
         .help = "Pixels per Å; or Å across the picture's shorter side, 60A. Unlike a zoom it does not depend on what\n"
                 "is drawn; --zoom F multiplies it",
         .value = {parseScale, printScale},
         .save = differing},
        {.key = "center",
         .syntax = "SEL|X,Y,Z",
         .standard = "of what is drawn",
         .help = "Point in the middle of the picture, about which it is rotated: the middle of a selection, or Å in\n"
                 "the file's frame",
         .facet = Facet::scene,
         .value = {parseCenter, printCenter},
         .kind = numbers,
         .save = differing},
        {.key = "camera-distance",
         .facet = Facet::view,
         .value = exactOf<&P::camera, &Camera::eyeDistance>(1e-3, kLargestLength),
         .save = differing,
         .number = Option::Number::real},
        {.key = "orientation",
         .syntax = "W,X,Y,Z",
         .standard = "=",
         .help = "A quaternion that turns the molecule, before --rotate",
         .value = {parseOrientation, printOrientation},
         .kind = numbers,
         .save = always},
        {.key = "pan",
         .syntax = "X,Y",
         .standard = "=",
         .help = "Moves the molecule in the picture, in Å to the right and up",
         .value = valueOf<&P::camera, &Camera::pan>(parsePan, panText),
         .kind = numbers,
         .save = always},
        {.key = "rotate",
         .syntax = "X,Y,Z",
         .standard = "=",
         .help = "Degrees, right-handed, about the view axes, X first",
         .value = valueOf<&P::camera, &Camera::rotationDegrees>(parseRotation, dvec3Text)},
    };
    return under(Topic::camera, Facet::view, std::move(rows));
}

void parseOrient(T text, P& d) {
    d.aim.fromSide = false;
    d.aim.orientBy.reset();
    d.aim.principal = text != "file";
    if (!d.aim.principal) d.camera.orientation = glm::dquat(1, 0, 0, 0);
    if (d.aim.principal && text != "principal") d.aim.orientBy = parseSelection(text);
}
std::string printOrient(const P& d) {
    if (!d.aim.principal) return "file";
    return d.aim.orientBy ? d.aim.orientBy->text : "principal";
}

void parseUncover(T text, P& d) {
    d.aim.uncovers = false;
    d.aim.uncover = text == "off" ? std::nullopt : std::optional(parseSelection(text));
}
/// "" is the default: uncovers the zoom target.
std::string printUncover(const P& d) { return d.aim.uncover ? d.aim.uncover->text : d.aim.uncovers ? "" : "off"; }

std::vector<Option> aimRows() {
    std::vector<Option> rows{
        {.key = "orient",
         .syntax = "principal|file|SEL",
         .standard = "file, or the saved view's",
         .help =
             "principal: longest axis across the longer side, shortest towards the viewer (of a bilayer: upwards), as "
             "large as fits;\nSEL: the principal axes of a selection; file: axes as in the file. --rotate turns it "
             "further",
         .value = {parseOrient, printOrient},
         .choices = {"principal", "file"}},
        {.key = "look-at",
         .syntax = "SEL",
         .standard = "none",
         .help = "Rotate to the side that shows most of a selection",
         .value = selectionOf<&P::aim, &Aim::lookAt>()},
        {.key = "zoom-to",
         .syntax = "SEL",
         .standard = "none: the whole molecule",
         .help = "Close-up of a selection with a margin of 3 Å; removes what hides it, unless --clip or --uncover is\n"
                 "given; --zoom scales it",
         .value = selectionOf<&P::aim, &Aim::zoomTo>()},
        {.key = "uncover",
         .syntax = "SEL|off",
         .standard = "the selection of --zoom-to",
         .help = "Remove what hides a selection in this view",
         .value = {parseUncover, printUncover},
         .save = differing},
    };
    return under(Topic::aim, Facet::view, std::move(rows));
}

}  // namespace

std::vector<Option> viewRows() { return joined({cameraRows(), aimRows()}); }

}  // namespace nacre::app
