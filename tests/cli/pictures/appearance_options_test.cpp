// --show, --hide, --color-by and --color: as they are parsed, and in pictures that the program draws.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "app/cli/options.h"
#include "app/picture/option_text.h"
#include "engine/molecule/read.h"
#include "engine/scene/color/palettes.h"
#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

using test::nacreDone;
using test::Outcome;
using test::TemporaryFolder;

PictureDescription parsed(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), {"nacre", "render"});
    return parseCommandLine(static_cast<int>(arguments.size()), arguments.data()).render;
}

TEST(AppearanceOptions, KeepTheOrderOfTheCommandLine) {
    const PictureDescription options =
        parsed({"--color-by", "all=chain", "--hide", "chain A", "in.pdb", "--show", "resn HEM=licorice", "--hide",
                "water", "-o", "a.png", "--color-by", "chain A=#0f8", "--show", "ion=spacefill"});
    EXPECT_EQ(options.input.path, "in.pdb");
    const std::vector<Rule>& rules = options.look.rules;
    ASSERT_EQ(rules.size(), 6u);
    const std::vector<Rule::Action> actions = {Rule::Action::color, Rule::Action::hide,  Rule::Action::show,
                                               Rule::Action::hide,  Rule::Action::color, Rule::Action::show};
    for (std::size_t i = 0; i < actions.size(); ++i) EXPECT_EQ(rules[i].action, actions[i]) << i;
    EXPECT_EQ(rules[0].coloring.scheme, ColorScheme::chain);
    EXPECT_EQ(rules[1].selection, parseSelection("chain A"));
    EXPECT_EQ(rules[2].style, Style::licorice);
    EXPECT_EQ(rules[2].selection.text, "resn HEM");
    EXPECT_EQ(rules[4].coloring.scheme, ColorScheme::uniform);
    EXPECT_EQ(rules[4].coloring.color, packedColor(0x00ff88));
    EXPECT_EQ(rules[5].selection, parseSelection("ion"));
}

/// Pixels of each atom in a file of layers.
std::map<std::uint32_t, int> pixelsOfAtoms(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw std::runtime_error(OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    const int channel = spec.channelindex("id.Y");
    std::vector<float> ids(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
    if (channel < 0 || !input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, ids.data()))
        throw std::runtime_error("no channel id");
    std::map<std::uint32_t, int> pixels;
    for (const float id : ids) ++pixels[static_cast<std::uint32_t>(id)];
    return pixels;
}

TEST(AppearanceOptions, CartoonsTakeTheColoursOfChains) {
    const auto look = [](std::vector<const char*> options) {
        options.insert(options.end(), {"x", "-o", "a.png"});
        return parsed(options).look;
    };
    EXPECT_EQ(look({"--style", "cartoon"}).color, Coloring(ColorScheme::chainCarbons));
    EXPECT_EQ(look({"--color", "element", "--style", "cartoon"}).color, Coloring(ColorScheme::element));
    EXPECT_EQ(look({"--style", "ribbons", "--helices", "tube"}).cartoon.helices, HelixForm::tube);
    EXPECT_EQ(look({"--surface", "gaussian", "--surface-resolution", "0.5"}).surface.resolution, 0.5);
    EXPECT_EQ(look({"--surface-opacity", "0.5"}).surfaceOpacity, 0.5);
    EXPECT_EQ(look({"--cartoon-opacity", "0.25"}).cartoonOpacity, 0.25);
    EXPECT_EQ(look({"--show", "all=surface:opacity=0.3"}).rules.at(0).opacity, 0.3);
    EXPECT_EQ(look({"--show", "all=licorice:opacity=0.5"}).rules.at(0).opacity, 0.5);
    EXPECT_EQ(look({"--atom-opacity", "0.25"}).atomOpacity, 0.25);
    EXPECT_EQ(look({"--show", "all=surface"}).rules.at(0).opacity, std::nullopt);
    const Rule metal = look({"--show", "resi 1:3=licorice:material=metal"}).rules.at(0);
    EXPECT_EQ(metal.material, Material::metal);
    EXPECT_EQ(metal.selection.text, "resi 1:3");
    EXPECT_EQ(ruleText(metal).second, "resi 1:3=licorice:material=metal") << "as saved views have it";
    for (const char* wrong : {"all=line:opacity=0.5", "all=surface:opacity=0", "all=surface:opacity=2",
                              "all=surface:opacity=", "all=surface:opacity=nan", "all=surface:0.5", "all:opacity=0.5",
                              "all=licorice:material=wood", "all=line:material=metal",
                              "all=surface:opacity=0.5:material=metal", "all:material=metal"})
        EXPECT_THROW(look({"--show", wrong}), UsageError) << wrong;
    EXPECT_THROW(look({"--surface-opacity", "0"}), UsageError);
    EXPECT_THROW(look({"--probe", "-1"}), UsageError);
    EXPECT_THROW(look({"--surface-resolution", "0.01"}), UsageError);
}

TEST(AppearanceOptions, ACartoonIsOfGuideAtomsAndItsParts) {
    const TemporaryFolder folder;
    const auto readAtoms = [&](const std::string& options) {
        nacreDone(folder,
                  "render sample:dna -o a.png --layers l.exr --size 128x128 --occlusion off "
                  "--style cartoon " +
                      options);
        const Molecule dna = sampleMolecule("dna");
        std::map<std::string, int> pixels;
        for (const auto& [id, count] : pixelsOfAtoms(folder / "l.exr"))
            if (id != 0) pixels[std::string(dna.atoms.at(id - 1).name.view())] += count;
        return pixels;
    };
    // The backbone is its C4's, of carbon as proteins' CA are; sticks are the C1's, plates the C4's.
    auto plates = readAtoms("");
    EXPECT_GT(plates["C4'"], 500);
    EXPECT_EQ(plates["P"], 0);
    EXPECT_GT(plates["C4"], 200);
    EXPECT_GT(plates["C1'"], 100);
    EXPECT_LE(plates.size(), 4u);
    auto ladder = readAtoms("--bases ladder --show 'chain A and name C5=licorice'");
    EXPECT_EQ(ladder["C4"], 0);
    EXPECT_GT(ladder["N1"], 50);
    EXPECT_GT(ladder["C5"], 5);
}

TEST(AppearanceOptions, HiddenAtomsAreNotInThePicture) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreDone(folder,
                                      "render sample:dna -o a.png --layers l.exr --size 128x128 --occlusion 4 "
                                      "--hide 'chain A' --show 'chain A and elem P=spacefill'");
    EXPECT_EQ(outcome.err, "");
    const Molecule dna = sampleMolecule("dna");
    int hidden = 0, phosphorus = 0, others = 0;
    for (const auto& [id, count] : pixelsOfAtoms(folder / "l.exr")) {
        if (id == 0) continue;
        const Atom& atom = dna.atoms.at(id - 1);
        const bool inA = dna.chains[dna.residues[atom.residue].chain].name == "A";
        (inA ? atom.element == 15 ? phosphorus : hidden : others) += count;
    }
    EXPECT_EQ(hidden, 0);
    EXPECT_GT(phosphorus, 20);
    EXPECT_GT(others, 500);
}

TEST(AppearanceOptions, WhatChangesNothingIsSaid) {
    const TemporaryFolder folder;
    const auto said = [&](const std::string& options) {
        const Outcome outcome =
            nacreDone(folder, "render sample:glucose -o a.png --size 16x16 --supersample 1 --occlusion off " + options);
        return outcome.err;
    };
    EXPECT_EQ(said("--cap hatched --halo-depth 3 --contours 1 --contour-depth 2"),
              "nacre: warning: --cap changes nothing without --clip\n"
              "nacre: warning: --halo-depth changes nothing without --halos\n");
    EXPECT_EQ(said("--palette viridis --show-labels seen"),
              "nacre: warning: --palette viridis changes nothing: nothing is coloured by numbers\n"
              "nacre: warning: --show-labels changes nothing without --label\n");
    EXPECT_EQ(said("--palette muted --color chain --fog auto --fog-strength 0.5 --slab 1 --cap dark"), "");
    EXPECT_EQ(said("--look illustrative --contour-color navy"), "");  // whose contours these are
    EXPECT_NE(said("--clip 500").find("the clipping planes remove everything"), std::string::npos);
}

TEST(AppearanceOptions, ColoursAndLegendReachPictureAndStats) {
    const TemporaryFolder folder;
    const Outcome outcome =
        nacreDone(folder,
                  "render sample:glucose -o a.exr --stats s.json --size 96x96 --supersample 1 --occlusion off "
                  "--lighting off --color element:red --color-by 'elem O=blue' --hide hydrogens "
                  "--show 'elem C=licorice' --color-by 'resn QQQ=chain'");
    EXPECT_EQ(outcome.err, "nacre: warning: 'resn QQQ' matches no atoms to color\n");
    const auto stats = nlohmann::json::parse(test::readContents(folder / "s.json"));
    EXPECT_EQ(stats["legend"].dump(),
              R"([{"entries":[{"color":"#ff0000","label":"C"}],"scheme":"element:#ff0000","selection":"all"},)"
              R"({"entries":[{"color":"#0000ff","label":"#0000ff"}],"scheme":"#0000ff","selection":"elem O"}])");
    EXPECT_EQ(stats["warnings"].size(), 1u);
    EXPECT_EQ(stats["atoms"]["drawn"], 12);
    const auto input = OIIO::ImageInput::open(folder / "a.exr");
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> pixels(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * channels);
    ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
    int red = 0, blue = 0, white = 0, other = 0;
    for (std::size_t i = 0; i < pixels.size(); i += channels) {
        const float r = pixels[i], g = pixels[i + 1], b = pixels[i + 2];
        if (g > 0.99f)
            ++white;
        else
            ++(g > 0.01f ? other : r > 0.99f && b < 0.01f ? red : b > 0.99f && r < 0.01f ? blue : other);
    }
    EXPECT_GT(red, 100);
    EXPECT_GT(blue, 100);
    EXPECT_EQ(other, 0);
}

}  // namespace
}  // namespace nacre::app
