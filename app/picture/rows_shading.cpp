// How pixels are shaded: background, light, ambient occlusion, and effects.

#include "app/picture/appearance_values.h"
#include "app/picture/rows.h"

namespace nacre::app {
namespace {

using P = PictureDescription;
using T = std::string_view;
using E = Effects;
using enum Option::Save;

constexpr double kDeepest = 1000, kFarthest = 1e6;  // Å
constexpr double kBrightest = 10, kSharpest = 2000, kPercent = 100;
constexpr std::int64_t kMostOcclusionMegabytes = 65536;
inline constexpr std::array<const char*, 3> kCaps{"plain", "dark", "hatched"};

std::vector<Option> lightRows() {
    return {
        {.key = "background",
         .syntax = "COLOR",
         .standard = "=",
         .help = "transparent, a CSS colour name (navy, lightgray), #rgb, #rrggbb or #rrggbbaa\n"
                 "(JPEG has no transparency: over white)",
         .topic = Topic::background,
         .facet = Facet::shading,
         .value = valueOf<&P::background>(parseColor, backgroundText),
         .save = always,
         .look = true,
         .control = {.label = "Background",
                     .choices = {{"White", "white"},
                                 {"Light grey", "lightgray"},
                                 {"Grey", "gray"},
                                 {"Night blue", "#102040"},
                                 {"Black", "black"},
                                 {"Paper", "#faf4e6"}}}},
        {.key = "transparent",
         .help = "Same as --background transparent",
         .topic = Topic::background,
         .facet = Facet::shading,
         .value = {[](T, P& d) { d.background = parseColor("transparent"); }},
         .kind = Option::Kind::flag,
         .excludes = "background"},
        {.key = "lighting",
         .syntax = "on|off",
         .standard = "=",
         .help = "off: base colour times occlusion, without light or shadow",
         .topic = Topic::lighting,
         .facet = Facet::shading,
         .value = switchOf<kOnOff, &P::lighting>(),
         .save = always,
         .look = true,
         .control = {.label = "Lighting", .choices = {{"off", "off"}, {"on", "on"}}}},
        {.key = "occlusion",
         .syntax = "K|off",
         .standard = "=",
         .help = "Ambient occlusion from K directions, 1 to 4096",
         .topic = Topic::occlusion,
         .facet = Facet::occlusion,
         .value = valueOf<&P::occlusion, &OcclusionOptions::directions>(
             parseOcclusion, [](int directions) { return directions ? std::to_string(directions) : "off"; }),
         .save = always,
         .number = Option::Number::whole,
         .look = true,
         .control = {.label = "Ambient occlusion",
                     .choices = {{"off", "off"}, {"on", std::to_string(OcclusionOptions{}.directions)}}}},
        {.key = "bounce",
         .syntax = "on|off",
         .standard = "=",
         .help = "on: clefts get light in the colours of the atoms around them, found by rays once per molecule and\n"
                 "colours. Needs --occlusion, and takes twice its directions",
         .topic = Topic::occlusion,
         .facet = Facet::occlusion,
         .value = switchOf<kOnOff, &P::occlusion, &OcclusionOptions::bounce>(),
         .save = differing,
         .look = true,
         .control = {.label = "Bounced light", .choices = {{"off", "off"}, {"on", "on"}}}},
        {.key = "occlusion-memory",
         .syntax = "MB",
         .standard = "64",
         .help = "Device memory for ambient occlusion, 1 to 65536; more memory gives finer detail, which is\n"
                 "reported on standard error. The default grows for meshes of more than a million vertices",
         .topic = Topic::occlusion,
         .facet = Facet::occlusion,
         .value = integerOf<&P::occlusion, &OcclusionOptions::megabytes>(1, kMostOcclusionMegabytes)},
    };
}

/// An effect: part of a look, and saved if it differs.
Option effect(T key, const char* syntax, const char* help, Option::Access access, T needs = {},
              Option::Control control = {}) {
    return {.key = key,
            .syntax = syntax,
            .standard = "=",
            .help = help,
            .topic = Topic::effects,
            .facet = Facet::shading,
            .value = std::move(access),
            .save = differing,
            .look = true,
            .needs = needs,
            .control = control};
}

std::string offOr(double value) { return value > 0 ? numberText(value) : "off"; }

/// A width in pixels; 0 is "off". @param given  set if it is in another unit; then the width is that for a default
/// picture
void parseWidth(T text, double& width, std::optional<ScreenLength>& given) {
    constexpr double kUsualSide = 1024, kUsualScale = 10;
    given = parseScreenLength(text);
    if (text == "off") {
        width = 0;
    } else if (given && given->unit != ScreenLength::Unit::points) {
        if (!(given->value >= 0.001 && given->value <= 100))
            refuse(text, "from 0.001 to 100 % of the shorter side, or ångström");
        width = std::clamp(given->pixels(kUsualSide, kScreenDpi, kUsualScale), kThinnestRim, kWidestRim);
    } else {
        width = parsePixels(text, kThinnestRim, kWidestRim);
    }
}
template <auto given, auto... members>
Option::Access rimWidth() {
    return {[](T text, P& d) { parseWidth(text, at<members...>(d), d.*given); },
            [](const P& d) { return d.*given ? screenLengthText(*(d.*given)) : offOr(at<members...>(d)); }};
}
std::array<float, 3> parseOpaque(T text) {
    const auto [r, g, b, a] = parseColor(text);
    if (a < 1) throw std::invalid_argument("expected an opaque colour, not '" + std::string(text) + "'");
    return {r, g, b};
}

std::vector<Option> lineRows() {
    return {
        effect("contours", "WIDTH|off",
               "Outlines where depth jumps, 0.1 to 64 pixels wide: 2, 1pt at --dpi, 0.3% of the shorter side, 0.2A",
               rimWidth<&P::contourWidth, &P::effects, &E::contours, &Contours::width>(), {},
               {"Outlines", 0, 8, "Outlines: %.1f px"}),
        effect("contour-depth", "A", "Depth jump in Å from which there is an outline",
               numberOf<&P::effects, &E::contours, &Contours::depth>(0.01, kDeepest), "contours",
               {"Outline depth", 0.1, 20, "Outline depth: %.1f Å"}),
        effect("contour-weights", "1|3",
               "3: full width around chains, two thirds between residues more than 6 apart in a chain,\n"
               "one third at other depth jumps. Paths other than tiles draw it as --visibility deferred",
               valueOf<&P::effects, &E::contours, &Contours::weights>([](T text) {
                   return parseChoice(text, {"1", "3"}) == 0 ? 1 : 3;
               }),
               "contours", {.label = "Wider between chains and residues", .choices = {{"off", "1"}, {"on", "3"}}}),
        effect("contour-color", "COLOR", "An opaque colour as for --background",
               valueOf<&P::effects, &E::contours, &Contours::color>(parseOpaque, opaqueText), "contours",
               {"Outline colour"}),
        effect("halos", "WIDTH|off",
               "Soft rims around foreground shapes, as wide as --contours may be, denser the farther the background\n"
               "lies behind. Paths other than tiles draw it as --visibility deferred",
               rimWidth<&P::haloWidth, &P::effects, &E::halos, &Halos::width>(), {},
               {"Halos", 0, 24, "Halos: %.1f px"}),
        effect("halo-depth", "A", "Distance behind in Å at which a halo is densest",
               numberOf<&P::effects, &E::halos, &Halos::depth>(0.01, kDeepest), "halos",
               {"Halo depth", 0.5, 60, "Halo depth: %.1f Å"}),
        effect("halo-strength", "F", "Largest opacity of halos, 0 to 1",
               numberOf<&P::effects, &E::halos, &Halos::strength>(0, 1), "halos",
               {"Halo strength", 0, 1, "Halo strength: %.2f"}),
        effect("halo-color", "COLOR", "An opaque colour as for --background",
               valueOf<&P::effects, &E::halos, &Halos::color>(parseOpaque, opaqueText), "halos", {"Halo colour"}),
    };
}

/// One number, or two separated by a comma.
std::vector<double> oneOrTwo(T text) {
    const std::size_t comma = text.find(',');
    std::vector<double> numbers{parseNumber(text.substr(0, comma), -kFarthest, kFarthest)};
    if (comma != T::npos) numbers.push_back(parseNumber(text.substr(comma + 1), -kFarthest, kFarthest));
    if (numbers.size() == 2 && !(numbers[0] < numbers[1]))
        throw std::invalid_argument("expected the nearer one first, not '" + std::string(text) + "'");
    return numbers;
}

void parseFog(T text, P& d) {
    Fog& fog = d.effects.fog;
    if (text == "off" || text == "auto") {
        fog.range = text == "off" ? Fog::Range::off : Fog::Range::automatic;
        return;
    }
    const std::vector<double> ends = oneOrTwo(text);
    if (ends.size() != 2) throw std::invalid_argument("expected off, auto or START,END");
    fog.range = Fog::Range::given;
    fog.start = ends[0];
    fog.end = ends[1];
}
std::string printFog(const P& d) {
    const Fog& fog = d.effects.fog;
    if (fog.range == Fog::Range::off) return "off";
    return fog.range == Fog::Range::automatic ? "auto" : numberText(fog.start) + "," + numberText(fog.end);
}

template <double Light::*member>
Option light(T key, const char* help, Option::Control control = {}) {
    return effect(key, "F", help, numberOf<&P::effects, &E::light, member>(0, kBrightest), {}, control);
}

std::vector<Option> lightEffectRows() {
    return {
        effect("fog", "auto|START,END|off",
               "Fade into the background (white, if that is transparent) between two distances\nfrom the centre in Å, "
               "away from the viewer; auto: from the centre to the far end",
               {parseFog, printFog}, {}, {"Fog", 0, 1, "Fog: %.2f"}),
        effect("fog-strength", "F", "Strength of fog at its far end, 0 to 1",
               numberOf<&P::effects, &E::fog, &Fog::strength>(0, 1), "fog"),
        effect("shadow", "F|off", "Cast shadows that remove this fraction of the direct light, 0 to 1",
               valueOf<&P::effects, &E::shadow, &Shadow::strength>(
                   [](T text) { return text == "off" ? 0 : parseNumber(text, 0, 1); }, offOr),
               {}, {"Shadow", 0, 1, "Shadow: %.2f"}),
        effect("depth-of-field", "PERCENT|off",
               "Blur what lies before or behind the focus, 0.1 to 50: something 20 Å away from it looks\n"
               "wider by 20 * PERCENT / 100 Å. Windows show it at rest",
               valueOf<&P::effects, &E::depthOfField, &DepthOfField::strength>(
                   [](T text) { return text == "off" ? 0 : parseNumber(text, 0.1, 50) / kPercent; },
                   [](double strength) { return offOr(strength * kPercent); }),
               {}, {"Depth of field", 0, 20, "Depth of field: %.1f %%"}),
        effect("focus-depth", "A|auto",
               "Distance of the focus from the centre in Å, away from the viewer. auto: what the camera looks at,\n"
               "which are the atoms of --zoom-to or --uncover, else the nearest atom in the picture's middle",
               {[](T text, P& d) {
                    std::optional<double>& focus = d.effects.depthOfField.focus;
                    text == "auto" ? focus.reset() : void(focus = parseNumber(text, -kFarthest, kFarthest));
                },
                [](const P& d) {
                    const std::optional<double>& focus = d.effects.depthOfField.focus;
                    return focus ? numberText(*focus) : "auto";
                }},
               "depth-of-field"),
        effect("material", "matte|plastic|metal|glow",
               "Material of what is drawn: no highlight, a white one, a broad one in the own colour, or light of its\n"
               "own. --show SEL=STYLE:material=metal gives one to a part",
               choiceOf<kMaterialNames, &P::effects, &E::light, &Light::material>(), {},
               {.label = "Material",
                .choices = {{"Material: matte", "matte"},
                            {"Material: plastic", "plastic"},
                            {"Material: metal", "metal"},
                            {"Material: glow", "glow"}}}),
        light<&Light::ambient>("ambient", "Ambient light, 0 to 10", {"Ambient light", 0, 2, "Ambient light: %.2f"}),
        light<&Light::direct>("direct", "Direct light, from over the left shoulder, 0 to 10",
                              {"Direct light", 0, 2, "Direct light: %.2f"}),
        light<&Light::highlight>("highlight", "Brightness of the highlight, 0 to 10",
                                 {"Highlight", 0, 6, "Highlight: %.2f"}),
        effect("gloss", "F", "Sharpness of the highlight, 1 to 2000",
               numberOf<&P::effects, &E::light, &Light::gloss>(1, kSharpest)),
        effect("occlusion-strength", "F", "Strength of ambient occlusion, 0 to 1",
               numberOf<&P::effects, &E::light, &Light::occlusion>(0, 1), {},
               {"Occlusion strength", 0, 1, "Occlusion strength: %.2f"}),
    };
}

void parseClip(T text, P& d) {
    Clip& clip = d.effects.clip;
    d.aim.uncovers = false;
    d.aim.clip.reset();
    clip.near = -Clip::kNone;
    clip.far = Clip::kNone;
    if (text == "off") return;
    if (text.find_first_not_of("0123456789.,+-eE ") != T::npos) {
        d.aim.clip = parseSelection(text);
        return;
    }
    if (text.starts_with(',')) {
        clip.far = parseNumber(text.substr(1), -kFarthest, kFarthest);
        return;
    }
    const std::vector<double> planes = oneOrTwo(text);
    clip.near = planes[0];
    if (planes.size() == 2) clip.far = planes[1];
}

void parseSlab(T text, P& d) {
    const double half = parseNumber(text, 0.01, kFarthest) / 2;
    d.effects.clip.near = -half;
    d.effects.clip.far = half;
    d.aim.uncovers = false;
}

std::vector<Option> clipRows() {
    Option clip =
        effect("clip", "NEAR[,FAR]|SEL|off",
               "Clipping planes: remove everything nearer than NEAR and farther than FAR, in Å away from the\n"
               "viewer, counted from the centre, or from the middle of the --zoom-to selection; 0 removes the\n"
               "front half; ,FAR: back plane only; SEL: a plane in front of a selection",
               {parseClip, [](const P& d) { return d.aim.clip ? d.aim.clip->text : clipText(d.effects.clip); }});
    clip.look = false;
    return {clip,
            effect("cap", "plain|dark|hatched", "Style of the flat caps where the front plane cuts",
                   choiceOf<kCaps, &P::effects, &E::clip, &Clip::cap>(), "clip",
                   {.label = "Cap style",
                    .choices = {{"Cap style: plain", "plain"},
                                {"Cap style: dark", "dark"},
                                {"Cap style: hatched", "hatched"}}}),
            effect("cap-color", "COLOR", "Colour where the front plane cuts, an opaque colour as for --background",
                   valueOf<&P::effects, &E::clip, &Clip::capColor>(parseOpaque, opaqueText), "clip"),
            {.key = "clip-spare",
             .syntax = "SEL",
             .standard = "none",
             .help = "Atoms that clipping planes leave whole. Other atoms are kept or removed by their centres; only\n"
                     "sticks and meshes are cut",
             .topic = Topic::effects,
             .facet = Facet::scene,
             .value = selectionOf<&P::aim, &Aim::spares>(),
             .save = differing,
             .needs = "clip"},
            {.key = "slab",
             .syntax = "A",
             .standard = "none",
             .help = "Two clipping planes this far apart, with the centre in the middle",
             .topic = Topic::effects,
             .facet = Facet::shading,
             .value = {parseSlab},
             .excludes = "clip"}};
}

}  // namespace

std::vector<Option> shadingRows() { return joined({lightRows(), lineRows(), lightEffectRows(), clipRows()}); }

}  // namespace nacre::app
