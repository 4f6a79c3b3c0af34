// Every screen and state of the window: how it is come to.

#include <filesystem>

#include "app/picture/appearance_values.h"
#include "tests/window_sheet/driver.h"

namespace nacre::app {
namespace {

const Size kUsual{1000, 720}, kNarrow{420, 760}, kTall{620, 1000}, kWide{1300, 420};

/// Maps and the structure they belong to, beside the protein's file.
struct Mapped {
    std::string structure, map, difference;

    explicit Mapped(const std::string& protein) {
        const std::filesystem::path folder = std::filesystem::path(protein).parent_path() / "maps";
        structure = (folder / "3nzd.cif").string();
        map = (folder / "3nzd.ccp4.gz").string();
        difference = (folder / "3nzd_diff.ccp4.gz").string();
    }
    bool any() const {
        return std::filesystem::exists(structure) && std::filesystem::exists(map) &&
               std::filesystem::exists(difference);
    }
};

}  // namespace

std::vector<State> states(const std::string& protein, const std::string& models) {
    const char *p = protein.c_str(), *several = models.empty() ? p : models.c_str();
    const auto page = [](std::string_view which) { return [which](Driver& d) { d.panel().showPage(which); }; };
    const auto light = [](Driver& d) { d.panel().setBrightness(Panel::Brightness::light); };
    const auto dark = [](Driver& d) {
        d.panel().setBrightness(Panel::Brightness::dark);
        PictureDescription look = d.viewer().view();
        look.background = parseColor("black");
        d.viewer().setLook(look, seconds());
    };
    const auto rules = [](Driver& d) {
        d.panel().showPage("Select");
        d.pause(0.2);
        d.click("Ligands");
        d.settle();
        d.click("Vermilion");
        d.settle();
        d.click("Protein");
        d.click("Hide");
        d.settle();
        d.click("Switch off: Hide protein");
        d.settle();
        d.click("ligand: Vermilion");
    };
    const auto measured = [](Driver& d) {
        PictureDescription look = d.viewer().view();
        look.look.rules.push_back(parseShow("resi 1-16 or ligand=ball-and-stick"));
        d.viewer().setLook(look, seconds());
        d.settle();  // words are about atoms that are drawn
        look = d.viewer().view();
        look.words.measures.push_back(parseMeasure("78,92"));
        look.words.labels.push_back(parseLabel("resn HEM={residue} {number}"));
        look.words.legend = true;
        look.words.scaleBar = ScaleBar::angstrom;
        look.words.title = "Haemoglobin";
        d.viewer().setLook(look, seconds());
        d.panel().showPage("Labels");
    };
    const auto sequence = [](Driver& d) {
        d.panel().showPage("Parts");
        d.pause(0.2);
        d.click("Chain A");
    };
    const auto help = [](Driver& d) { d.panel().toggleHelp(); };
    const auto save = [](Driver& d) { d.panel().showSave(); };
    const auto browse = [](Driver& d) {
        d.panel().showStart();
        d.pause(0.2);
        d.click("Open a file ...");
        d.pause(0.2);
        d.click("Current folder");
    };
    const auto record = [](Driver& d) {
        d.panel().showRecord();
        d.pause(0.2);
    };
    const auto keep = [](Driver& d) {
        d.panel().keepView(d.viewer());
        d.viewer().run(ViewerCommand::rotateLeft, seconds());
        d.viewer().run(ViewerCommand::zoomIn, seconds());
        d.panel().keepView(d.viewer());
    };
    const auto recording = [](Driver& d) {
        d.panel().showRecord();
        d.pause(0.2);
        d.click("Movie format");
        d.click("GIF");
        d.click("Record");
        for (int i = 0; i < 400 && !d.tells("frame "); ++i) d.pause(0.05);
        d.rests = false;
    };
    const auto failure = [](Driver& d) { d.viewer().reading().open("no such file.pdb", seconds()); };
    const auto interactions = [](Driver& d) {
        d.panel().showPage("Select");
        d.pause(0.2);
        d.click("Ligands");
        d.settle();
        d.click("Interactions");
        d.settle();
        d.click("Distances");
    };
    static const Mapped mapped(protein);
    const auto maps = [](Driver& d) {
        d.drop(mapped.map);
        d.drop(mapped.difference);
        d.panel().showPage("Look");
        d.pause(0.2);
        d.click("Place of maps");
        d.click("Around ligands");
        d.settle();
        d.click("Place of maps");
        d.press(SpecialKey::escape);
    };
    const auto slice = [=](Driver& d) {
        maps(d);
        d.click("Style of 3nzd.ccp4.gz");
        d.click("Slice");
        d.settle();
    };
    std::vector<State> all{
        {"start", kUsual, "", [](Driver&) {}},
        {"start, light", kUsual, "", light},
        {"start, narrow", kNarrow, "", [](Driver&) {}},
        {"start, wide", kWide, "", [](Driver&) {}},
        {"start, not found", kUsual, "", failure},
        {"open, over a molecule", kUsual, p, [](Driver& d) { d.panel().showStart(); }},
        {"commands", kUsual, p,
         [](Driver& d) {
             d.panel().showPalette();
             d.pause(0.3);
             d.type("color");
         }},
        {"actions on a residue", kUsual, p,
         [](Driver& d) {
             d.rightClick({640, 300});
         }},
        {"actions beside the molecule", kUsual, p,
         [](Driver& d) {
             d.rightClick({960, 60});
         }},
        {"dropped", kUsual, "sample:dna", [=](Driver& d) { d.offer(p); }},
        {"select, a chain", kUsual, p,
         [=](Driver& d) {
             d.viewer().picking().select("chain A");
             page("Select")(d);
             d.settle();
         }},
        {"select, not understood", kUsual, p,
         [=](Driver& d) {
             page("Select")(d);
             d.click("Selection");
             d.type("heme");
         }},
        {"preset, pocket", kUsual, p,
         [](Driver& d) {
             d.click("Style preset");
             d.click("Ligand in its pocket");
             d.settle();
             d.pause(0.6);
         }},
        {"look", kUsual, p, page("Look")},
        {"look, light", kUsual, p, light},
        {"start, dark", kUsual, "", dark},
        {"start, files of before", kUsual, p,
         [=](Driver& d) {
             d.drop(several);
             d.drop(p);
             d.panel().showStart();
         }},
        {"start, names of many scripts", kUsual, p,
         [=](Driver& d) {
             const std::filesystem::path folder = std::filesystem::temp_directory_path() / "nacre sheet";
             std::filesystem::create_directories(folder);
             for (const char* name : {"蛋白質 ヘモグロビン.pdb", "혈색소와 물.pdb", "هيموغلوبين ١.pdb", "המוגלובין.pdb",
                                      "гемоглобин β.pdb"}) {
                 const std::filesystem::path path = folder / name;
                 std::filesystem::copy_file(several, path, std::filesystem::copy_options::overwrite_existing);
                 d.drop(path.string());
             }
             d.panel().showStart();
             d.settle();
             std::filesystem::remove_all(folder);
         }},
        {"download goes on", kUsual, "sample:dna", [](Driver& d) { d.viewer().reading().open("pdb:4hhb", seconds()); }},
        {"download goes on, narrow, dark", kNarrow, "sample:dna",
         [=](Driver& d) { dark(d), d.viewer().reading().open("pdb:4hhb", seconds()); }},
        {"download is asked for", kUsual, "pdb:4hhb", [](Driver&) {}},
        {"look, dark", kUsual, p, dark},
        {"look, narrow, dark", kNarrow, p, dark},
        {"look, narrow", kNarrow, p, page("Look")},
        {"look, tall", kTall, "sample:dna", page("Look")},
        {"look, wide", kWide, "sample:dna", page("Look")},
        {"look, list open", kUsual, "sample:dna", [](Driver& d) { d.click("Colours"); }},
        {"look, sliders", kUsual, p,
         [](Driver& d) {
             d.click("Light, outlines, fog");
             for (int i = 0; i < 4; ++i) d.press(SpecialKey::tab);
         }},
        {"look, effects",
         {1000, 1000},
         "sample:dna",
         [](Driver& d) {
             PictureDescription look = d.viewer().view();
             look.effects.contours.width = 2;
             look.effects.halos.width = 6;
             look.effects.fog.range = Fog::Range::automatic;
             d.viewer().setLook(look, seconds());
             d.click("Light, outlines, fog");
             d.click("Halo colour");
         }},
        {"look, depth of field",
         {1000, 1000},
         p,
         [](Driver& d) {
             PictureDescription look = d.viewer().view();
             look.effects.depthOfField.strength = 0.5;
             look.effects.depthOfField.focus = -20;
             d.viewer().setLook(look, seconds());
             d.click("Light, outlines, fog");
             d.click("Focus on the middle of the view");
             d.click("Focus on the middle of the view");
         }},
        {"parts", kUsual, p, page("Parts")},
        {"parts, sequence", kUsual, p, sequence},
        {"parts, sequence, light, narrow", kNarrow, p, [=](Driver& d) { light(d), sequence(d); }},
        {"parts, sequence, dark", kUsual, p, [=](Driver& d) { dark(d), sequence(d); }},
        {"parts, models", kUsual, several, page("Parts")},
        {"parts, models, narrow", kNarrow, several, page("Parts")},
        {"parts, assemblies", kUsual, p,
         [](Driver& d) {
             d.panel().showPage("Parts");
             d.pause(0.2);
             d.click("Assembly");
         }},
        {"parts, colour", kUsual, p,
         [](Driver& d) {
             d.panel().showPage("Parts");
             d.pause(0.2);
             d.click("Colour of Chain B");
         }},
        {"parts, two molecules", kUsual, "sample:dna",
         [](Driver& d) {
             d.viewer().reading().add("sample:buckyball", seconds());
             d.settle();
             d.panel().showPage("Parts");
         }},
        {"open, beside", kUsual, "sample:dna",
         [](Driver& d) {
             d.panel().showStart();
             d.pause(0.2);
             d.click("Add to current scene");
         }},
        {"parts, small molecule", kUsual, "sample:glucose", page("Parts")},
        {"select, nothing", kUsual, p, page("Select")},
        {"select, rules", kUsual, p, rules},
        {"select, rules, narrow", kNarrow, p, rules},
        {"select, typed", kUsual, p,
         [](Driver& d) {
             d.panel().showPage("Select");
             d.pause(0.2);
             d.click("Selection");
             d.type("chain A and si");
         }},
        {"select, interactions", {1000, 1000}, p, interactions},
        {"select, interactions, narrow, dark", kNarrow, p, [=](Driver& d) { dark(d), interactions(d); }},
        {"labels", kUsual, p, measured},
        {"labels, light, narrow", kNarrow, p, [=](Driver& d) { light(d), measured(d); }},
        {"more, developers", kUsual, "sample:dna",
         [](Driver& d) {
             d.panel().showPage("More");
             d.pause(0.2);
             d.click("For developers");
         }},
        {"folded", kUsual, p, [](Driver& d) { d.click("Fold the panel"); }},
        {"picked and hovered", kUsual, p,
         [](Driver& d) {
             const double scale = d.viewer().frames().size().height / 720.0;
             d.clickAt(scale * glm::dvec2(600, 300));
             d.clickAt(scale * glm::dvec2(690, 400));
             d.pause(0.3);
             d.moveTo(scale * glm::dvec2(640, 450));
             d.pause(0.3);
         }},
        {"save", kUsual, "sample:dna", save},
        {"save, paper, narrow", kNarrow, "sample:dna",
         [=](Driver& d) {
             save(d);
             d.pause(0.2);
             d.click("Size");
             d.click("Print");
         }},
        {"help", kUsual, "sample:dna", help},
        {"help, dark", kUsual, "sample:dna", [=](Driver& d) { dark(d), help(d); }},
        {"help, narrow, light", kNarrow, "sample:dna", [=](Driver& d) { light(d), help(d); }},
        {"help, search", kUsual, "sample:dna",
         [=](Driver& d) {
             help(d);
             d.pause(0.2);
             d.click("Search the help");
             d.type("hydr");
         }},
        {"quit", kUsual, "sample:dna",
         [=](Driver& d) {
             measured(d), keep(d);
             d.quit();
         }},
        {"browse", kUsual, p, browse},
        {"browse, narrow, light", kNarrow, p, [=](Driver& d) { light(d), browse(d); }},
        {"measuring", kUsual, p,
         [](Driver& d) {
             const double scale = d.viewer().frames().size().height / 720.0;
             d.panel().showPage("Labels");
             d.run(ViewerCommand::measure), d.run(ViewerCommand::measure);
             d.clickAt(scale * glm::dvec2(600, 300));
             d.clickAt(scale * glm::dvec2(690, 400));
         }},
        {"error", kUsual, "sample:dna", failure},
        {"error, dark", kUsual, "sample:dna", [=](Driver& d) { dark(d), failure(d); }},
        {"legends", kUsual, p,
         [](Driver& d) {
             PictureDescription look = d.viewer().view();
             look.look.color = ColorScheme::secondaryStructure;
             look.words.legend = true;
             d.viewer().setLook(look, seconds());
             d.panel().showPage("Labels");
         }},
        {"film", kUsual, "sample:dna", record},
        {"film, kept views, narrow", kNarrow, "sample:dna",
         [=](Driver& d) {
             keep(d);
             record(d);
             d.click("Motion");
             d.click("Keyframes");
         }},
        {"film, kept views, dark", kUsual, "sample:dna",
         [=](Driver& d) {
             dark(d), keep(d), record(d);
             d.click("Motion");
             d.click("Keyframes");
         }},
        {"film, preview", kUsual, "sample:dna",
         [=](Driver& d) {
             keep(d);
             record(d);
             d.click("Motion");
             d.click("Keyframes");
             d.click("Preview");
             d.pause(0.7);
             d.rests = false;
         }},
        {"film, recording", kUsual, "sample:dna", recording},
        {"film, recording, narrow, dark", kNarrow, "sample:dna", [=](Driver& d) { dark(d), recording(d); }},
        {"motion is coarser", kUsual, p,
         [=](Driver& d) {
             d.viewer().frames().keepSharp(0.001, 0.7);
             d.viewer().run(ViewerCommand::autoRotate, seconds());
             d.pause(3);
             d.rests = false;
         }},
        {"parts, laid onto", kUsual, "sample:dna",
         [](Driver& d) {
             d.viewer().reading().open(std::vector<std::string>{"sample:dna", "sample:dna"}, seconds());
             d.settle();
             d.panel().showPage("Parts");
             d.pause(0.2);
             d.click("Superposed on dna");
         }},
        {"playing, options", kUsual, several, [](Driver& d) { d.click("Playback options"); }},
        {"playing, options, narrow, light", kNarrow, several,
         [=](Driver& d) { light(d), d.click("Playback options"); }},
        {"view is saved", kUsual, "sample:dna",
         [](Driver& d) {
             d.type("S");
             d.pause(0.3);
             d.press(SpecialKey::enter);
         }},
        {"start, 420 pixels", {210, 380}, "", [](Driver&) {}},
        {"look, 420 pixels", {210, 380}, p, page("Look")},
        {"parts, 420 pixels", {210, 380}, p, page("Parts")},
        {"help, 420 pixels", {210, 380}, "sample:dna", help},
        {"error, 420 pixels", {210, 380}, "sample:dna", failure},
        {"error, narrow, light", kNarrow, "sample:dna", [=](Driver& d) { light(d), failure(d); }},
    };
    const char* m = mapped.structure.c_str();
    if (mapped.any())
        for (const State& state :
             {State{"maps", {1000, 1000}, m, maps},
              State{"maps, narrow, dark", kNarrow, m, [=](Driver& d) { dark(d), maps(d); }},
              State{"maps, slice", {1000, 1000}, m, slice},
              State{"maps, slice, light, narrow", kNarrow, m, [=](Driver& d) { light(d), slice(d); }}})
            all.push_back(state);
    return all;
}

}  // namespace nacre::app
