#include "app/drawing/idle_options.h"

#include <algorithm>
#include <cmath>

#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "engine/scene/color_schemes.h"

namespace nacre::app {
namespace {

/// Whether a visible colouring uses such a palette.
bool takesPalette(const Representation& scene, Palette palette) {
    const PaletteUse use = isRamp(palette) ? PaletteUse::ramp : PaletteUse::kinds;
    return std::ranges::any_of(scene.legends, [&](const Legend& legend) {
        const auto scheme = colorSchemeFromName(legend.scheme.substr(0, legend.scheme.find(':')));
        if (!scheme) return legend.ramp != Palette::automatic && use == PaletteUse::ramp;  // of a table
        return paletteUse(*scheme) == use;
    });
}

}  // namespace

std::vector<std::string> idleOptions(const PictureDescription& options, const Representation& scene,
                                     const Effects& effects, double reach) {
    std::vector<std::string> said;
    PictureDescription drawn = options;
    drawn.effects = effects;
    for (const std::string& key : options.given) {
        const std::string needs(option(key).needs);
        if (needs.empty()) continue;
        if (const std::string on = option(needs).print(drawn); on.empty() || on == "off")
            said.push_back("--" + key + " changes nothing without --" + needs);
    }
    if (const Palette palette = options.look.palette; palette != Palette::automatic && !takesPalette(scene, palette))
        said.push_back("--palette " + std::string(paletteName(palette)) + " changes nothing: nothing is coloured by " +
                       (isRamp(palette) ? "numbers" : "categories"));
    if (options.words.seenOnly && options.words.labels.empty())
        said.push_back("--show-labels changes nothing without --label");
    if (effects.clip.near >= reach || effects.clip.far <= -reach)
        said.push_back("the clipping planes remove everything: the molecule reaches " + numberText(std::ceil(reach)) +
                       " A from its centre");
    return said;
}

}  // namespace nacre::app
