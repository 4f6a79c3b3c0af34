#include "app/picture/effect_options.h"

#include <stdexcept>
#include <vector>

#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"
#include "app/picture/option_values.h"

namespace nacre::app {
namespace {

constexpr double kWidest = 64, kDeepest = 1000, kFarthest = 1e6;  // pixels, Å, Å
constexpr double kBrightest = 10, kSharpest = 2000;

/// One number, or two with a comma between them.
std::vector<double> oneOrTwo(std::string_view text) {
    const std::size_t comma = text.find(',');
    std::vector<double> numbers{parseNumber(text.substr(0, comma), -kFarthest, kFarthest)};
    if (comma != std::string_view::npos) numbers.push_back(parseNumber(text.substr(comma + 1), -kFarthest, kFarthest));
    if (numbers.size() == 2 && !(numbers[0] < numbers[1]))
        throw std::invalid_argument("expected the nearer one first, not '" + std::string(text) + "'");
    return numbers;
}

template <double Light::*member>
void setShare(std::string_view text, Effects& e) {
    e.light.*member = parseNumber(text, 0, kBrightest);
}
template <double Light::*member>
std::string shareText(const Effects& e) {
    return numberText(e.light.*member);
}

void setContours(std::string_view text, Effects& e) {
    e.contours.width = text == "off" ? 0 : parsePixels(text, 0.1, kWidest);
}
std::string contoursText(const Effects& e) { return e.contours.width > 0 ? numberText(e.contours.width) : "off"; }

void setHalos(std::string_view text, Effects& e) {
    e.halos.width = text == "off" ? 0 : parsePixels(text, 0.1, kWidest);
}
std::string halosText(const Effects& e) { return e.halos.width > 0 ? numberText(e.halos.width) : "off"; }

std::array<float, 3> parseOpaque(std::string_view text) {
    const auto [r, g, b, a] = parseColor(text);
    if (a < 1) throw std::invalid_argument("lines cannot be transparent: '" + std::string(text) + "'");
    return {r, g, b};
}
std::string opaqueText(const std::array<float, 3>& color) { return backgroundText({color[0], color[1], color[2], 1}); }

void setFog(std::string_view text, Effects& e) {
    if (text == "off" || text == "auto") {
        e.fog.range = text == "off" ? Fog::Range::off : Fog::Range::automatic;
        return;
    }
    const std::vector<double> ends = oneOrTwo(text);
    if (ends.size() != 2) throw std::invalid_argument("expected off, auto or START,END");
    e.fog.range = Fog::Range::given;
    e.fog.start = ends[0];
    e.fog.end = ends[1];
}
std::string fogText(const Effects& e) {
    if (e.fog.range == Fog::Range::off) return "off";
    return e.fog.range == Fog::Range::automatic ? "auto" : numberText(e.fog.start) + "," + numberText(e.fog.end);
}

void setClip(std::string_view text, Effects& e) {
    e.clip.near = -Clip::kNone;
    e.clip.far = Clip::kNone;
    if (text == "off") return;
    if (text.starts_with(',')) {
        e.clip.far = parseNumber(text.substr(1), -kFarthest, kFarthest);
        return;
    }
    const std::vector<double> planes = oneOrTwo(text);
    e.clip.near = planes[0];
    if (planes.size() == 2) e.clip.far = planes[1];
}
std::string clipText(const Effects& e) {
    if (!e.clip.on()) return "off";
    const std::string near = e.clip.near > -Clip::kNone ? numberText(e.clip.near) : "";
    return e.clip.far < Clip::kNone ? near + "," + numberText(e.clip.far) : near;
}

constexpr const char* kCaps[] = {"plain", "dark", "hatched"};

constexpr EffectOption kOptions[] = {
    {"contours", "PIXELS|off", "off", "Lines about what stands in front of something, 0.1 to 64 pixels wide",
     setContours, contoursText},
    {"contour-depth", "A", "1.5", "Angstroms by which depth jumps at a line",
     [](std::string_view text, Effects& e) { e.contours.depth = parseNumber(text, 0.01, kDeepest); },
     [](const Effects& e) { return numberText(e.contours.depth); }, true, "contours"},
    {"contour-weights", "1|3", "1",
     "3: all of the width between chains and about all of it, two thirds between residues more than\n6 apart in a "
     "chain, a third where depth jumps within those. Drawn as --visibility deferred on every path",
     [](std::string_view text, Effects& e) {
         e.contours.weights = parseChoice(text, {"1", "3"}) == 0 ? 1 : 3;
     },
     [](const Effects& e) { return std::to_string(e.contours.weights); }, true, "contours"},
    {"contour-color", "COLOR", "black", "An opaque colour as for --background",
     [](std::string_view text, Effects& e) { e.contours.color = parseOpaque(text); },
     [](const Effects& e) { return opaqueText(e.contours.color); }, true, "contours"},
    {"halos", "PIXELS|off", "off",
     "Soft rims about what stands in front of something, 0.1 to 64 pixels wide, denser the farther\nthat lies behind. "
     "Drawn as --visibility deferred on every path",
     setHalos, halosText},
    {"halo-depth", "A", "12", "Angstroms behind at which a halo is densest",
     [](std::string_view text, Effects& e) { e.halos.depth = parseNumber(text, 0.01, kDeepest); },
     [](const Effects& e) { return numberText(e.halos.depth); }, true, "halos"},
    {"halo-strength", "F", "0.6", "Share of a halo's colour where it is densest, 0 to 1",
     [](std::string_view text, Effects& e) { e.halos.strength = parseNumber(text, 0, 1); },
     [](const Effects& e) { return numberText(e.halos.strength); }, true, "halos"},
    {"halo-color", "COLOR", "black", "An opaque colour as for --background",
     [](std::string_view text, Effects& e) { e.halos.color = parseOpaque(text); },
     [](const Effects& e) { return opaqueText(e.halos.color); }, true, "halos"},
    {"fog", "auto|START,END|off", "off",
     "Fades into the background (white, if that is transparent) between two distances\nfrom the centre, in Angstroms "
     "away from the viewer; auto: from the centre to the far end",
     setFog, fogText},
    {"fog-strength", "F", "0.85", "Share of the background where fog ends, 0 to 1",
     [](std::string_view text, Effects& e) { e.fog.strength = parseNumber(text, 0, 1); },
     [](const Effects& e) { return numberText(e.fog.strength); }, true, "fog"},
    {"shadow", "F|off", "off",
     "Share of the direct light that what stands before it takes, 0 to 1: one depth map a frame",
     [](std::string_view text, Effects& e) { e.shadow.strength = text == "off" ? 0 : parseNumber(text, 0, 1); },
     [](const Effects& e) { return e.shadow.strength > 0 ? numberText(e.shadow.strength) : "off"; }},
    {"ambient", "F", "1", "Light from all around, 0 to 10", setShare<&Light::ambient>, shareText<&Light::ambient>},
    {"direct", "F", "1", "Light from over the left shoulder, 0 to 10", setShare<&Light::direct>,
     shareText<&Light::direct>},
    {"highlight", "F", "1", "How bright the highlight is, 0 to 10", setShare<&Light::highlight>,
     shareText<&Light::highlight>},
    {"gloss", "F", "42", "How small the highlight is, 1 to 2000",
     [](std::string_view text, Effects& e) { e.light.gloss = parseNumber(text, 1, kSharpest); },
     shareText<&Light::gloss>},
    {"occlusion-strength", "F", "1", "How much of the ambient occlusion counts, 0 to 1",
     [](std::string_view text, Effects& e) { e.light.occlusion = parseNumber(text, 0, 1); },
     shareText<&Light::occlusion>},
    {"clip", "NEAR[,FAR]|off", "off",
     "Cuts away what lies nearer than a plane, and farther than another, in Angstroms from\nthe centre, away from the "
     "viewer: 0 opens a half; ,FAR cuts behind alone",
     setClip, clipText, false},
    {"cap", "plain|dark|hatched", "plain", "How atoms and sticks look where the near plane cuts them",
     [](std::string_view text, Effects& e) { e.clip.cap = static_cast<Clip::Cap>(parseChoice(text, kCaps)); },
     [](const Effects& e) { return std::string(kCaps[static_cast<int>(e.clip.cap)]); }, true, "clip"},
};

}  // namespace

std::span<const EffectOption> effectOptions() { return kOptions; }

const EffectOption* effectOption(std::string_view name) {
    for (const EffectOption& option : kOptions)
        if (option.name == name) return &option;
    return nullptr;
}

void setSlab(std::string_view text, Effects& effects) {
    const double half = parseNumber(text, 0.01, kFarthest) / 2;
    effects.clip.near = -half;
    effects.clip.far = half;
}

}  // namespace nacre::app
