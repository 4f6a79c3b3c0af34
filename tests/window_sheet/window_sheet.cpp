// Every screen and state of the window, each as a picture. Drives the window from
// within, by the names of its controls, on the display that it finds. tools/window_sheet makes one sheet of them.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>

#include "app/desktop/window_session.h"
#include "app/shared/appearance_values.h"

// X11's names are apart from ours.
namespace {

/// What the display shows from its top left, where the window stands.
void writePicture(Display* display, const std::string& path, unsigned width, unsigned height) {
    XSync(display, False);
    XImage* image = XGetImage(display, DefaultRootWindow(display), 0, 0, width, height, AllPlanes, ZPixmap);
    std::ofstream out(path, std::ios::binary);
    out << "P6\n" << width << " " << height << "\n255\n";
    for (unsigned y = 0; y < height; ++y)
        for (unsigned x = 0; x < width; ++x) {
            const unsigned long pixel = XGetPixel(image, static_cast<int>(x), static_cast<int>(y));
            for (const int shift : {16, 8, 0}) out.put(static_cast<char>(pixel >> shift & 255));
        }
    XDestroyImage(image);
}

void setScale(Display* display, double scale) {
    const std::string text = "Xft.dpi:\t" + std::to_string(std::lround(96 * scale)) + "\n";
    XChangeProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    XSync(display, False);
}

}  // namespace

namespace nacre::app {
namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

class Driver {
public:
    explicit Driver(const ViewOptions& options) : session_(options), events_(session_.events()) { settle(); }

    Viewer& viewer() { return session_.viewer(); }
    Panel& panel() { return session_.panel(); }

    /// Until nothing is due any more.
    void settle(double most = 20) {
        const double end = seconds() + most;
        int downloading = 0;
        for (int quiet = 0; quiet < 4 && seconds() < end && downloading < 40;
             downloading += viewer().loadingProgress() >= 0)
            quiet = session_.step(0.05) > 0.2 && !viewer().loading() ? quiet + 1 : 0;
    }
    void pause(double time) {
        const double end = seconds() + time;
        while (seconds() < end) session_.step(0.02);
    }
    /// The first control of a name that is seen.
    const Control* find(const std::string& name) {
        for (const Control& c : panel().controls())
            if (c.name == name && c.seen() && c.role != "text") return &c;
        return nullptr;
    }
    /// Scrolls to a control, if need be, and clicks it.
    void click(const std::string& name) {
        const Control* c = find(name);
        for (int i = 0; i < 40 && (!c || c->seenBottom - c->seenTop < 0.9f * (c->bottom - c->top)); ++i) {
            for (const Control& any : panel().controls())
                if (any.seen() && any.window == "Nacre")
                    events_.pointer({(any.seenLeft + any.seenRight) / 2, (any.seenTop + any.seenBottom) / 2});
            events_.wheel(-1);
            for (int k = 0; k < 3; ++k) session_.step(0.02);
            c = find(name);
        }
        if (!c) {
            std::cerr << "there is no \"" << name << "\"\n";
            std::exit(1);
        }
        clickAt({(c->seenLeft + c->seenRight) / 2, (c->seenTop + c->seenBottom) / 2});
    }
    void clickAt(glm::dvec2 at) {
        events_.pointer(at);
        session_.step(0.02);
        events_.button(MouseButton::left, true, {});
        session_.step(0.02);
        events_.button(MouseButton::left, false, {});
        for (int i = 0; i < 4; ++i) session_.step(0.02);
    }
    void moveTo(glm::dvec2 at) { events_.pointer(at); }
    void type(const std::string& text) {
        for (const char c : text) {
            events_.character(static_cast<char32_t>(c));
            for (int i = 0; i < 2; ++i) session_.step(0.02);
        }
    }
    void press(SpecialKey key) {
        events_.special(key, true, {});
        events_.key({keyOf(key), {}});
        session_.step(0.02);
        events_.special(key, false, {});
        session_.step(0.02);
    }
    void drop(const std::string& path) {
        events_.dropped({path});
        settle();
    }
    void press(char32_t letter, Modifiers with) { events_.key({letter, with}); }
    bool rests = true;  ///< the picture is taken once nothing moves
    void run(ViewerCommand command) { events_.key({0, {}}), viewer().run(command, seconds()); }

private:
    WindowSession session_;
    WindowEvents events_;
};

struct State {
    const char* name;
    Size size;
    const char* input;
    std::function<void(Driver&)> act;
};

const Size kUsual{1000, 720}, kNarrow{420, 760}, kTall{620, 1000}, kWide{1300, 420};

/// @param models  a file of several; empty: there is none
std::vector<State> states(const std::string& protein, const std::string& models) {
    const char *p = protein.c_str(), *several = models.empty() ? p : models.c_str();
    const auto page = [](Panel::Page which) { return [which](Driver& d) { d.panel().showPage(which); }; };
    const auto light = [](Driver& d) { d.panel().setBrightness(Panel::Brightness::light); };
    const auto dark = [](Driver& d) {
        d.panel().setBrightness(Panel::Brightness::dark);
        SavedView look = d.viewer().view();
        look.background = parseColor("black");
        d.viewer().setLook(look, seconds());
    };
    const auto rules = [](Driver& d) {
        d.panel().showPage(Panel::Page::select);
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
        SavedView look = d.viewer().view();
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
        d.panel().showPage(Panel::Page::labels);
    };
    const auto sequence = [](Driver& d) {
        d.panel().showPage(Panel::Page::parts);
        d.pause(0.2);
        d.click("Chain A");
    };
    const auto help = [](Driver& d) { d.panel().toggleHelp(); };
    const auto save = [](Driver& d) { d.panel().showSave(); };
    const auto record = [](Driver& d) {
        d.panel().showRecord();
        d.pause(0.2);
    };
    const auto keep = [](Driver& d) {
        d.panel().keepView(d.viewer(), seconds());
        d.viewer().run(ViewerCommand::rotateLeft, seconds());
        d.viewer().run(ViewerCommand::zoomIn, seconds());
        d.panel().keepView(d.viewer(), seconds());
    };
    const auto failure = [](Driver& d) { d.viewer().open("no such file.pdb", seconds()); };
    return {
        {"start", kUsual, "", [](Driver&) {}},
        {"start, light", kUsual, "", light},
        {"start, narrow", kNarrow, "", [](Driver&) {}},
        {"start, wide", kWide, "", [](Driver&) {}},
        {"start, not found", kUsual, "", failure},
        {"open, over a molecule", kUsual, p, [](Driver& d) { d.panel().showStart(); }},
        {"look", kUsual, p, page(Panel::Page::look)},
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
        {"download goes on", kUsual, "sample:dna", [](Driver& d) { d.viewer().open("pdb:4hhb", seconds()); }},
        {"download goes on, narrow, dark", kNarrow, "sample:dna",
         [=](Driver& d) { dark(d), d.viewer().open("pdb:4hhb", seconds()); }},
        {"download is asked for", kUsual, "pdb:4hhb", [](Driver&) {}},
        {"look, dark", kUsual, p, dark},
        {"look, narrow, dark", kNarrow, p, dark},
        {"look, narrow", kNarrow, p, page(Panel::Page::look)},
        {"look, tall", kTall, "sample:dna", page(Panel::Page::look)},
        {"look, wide", kWide, "sample:dna", page(Panel::Page::look)},
        {"look, list open", kUsual, "sample:dna", [](Driver& d) { d.click("Colours"); }},
        {"look, sliders", kUsual, p,
         [](Driver& d) {
             d.click("Light, lines, fog");
             for (int i = 0; i < 4; ++i) d.press(SpecialKey::tab);
         }},
        {"look, effects",
         {1000, 1000},
         "sample:dna",
         [](Driver& d) {
             SavedView look = d.viewer().view();
             look.effects.contours.width = 2;
             look.effects.halos.width = 6;
             look.effects.fog.range = Fog::Range::automatic;
             d.viewer().setLook(look, seconds());
             d.click("Light, lines, fog");
             d.click("Colour of the halos");
         }},
        {"parts", kUsual, p, page(Panel::Page::parts)},
        {"parts, sequence", kUsual, p, sequence},
        {"parts, sequence, light, narrow", kNarrow, p, [=](Driver& d) { light(d), sequence(d); }},
        {"parts, sequence, dark", kUsual, p, [=](Driver& d) { dark(d), sequence(d); }},
        {"parts, models", kUsual, several, page(Panel::Page::parts)},
        {"parts, models, narrow", kNarrow, several, page(Panel::Page::parts)},
        {"parts, assemblies", kUsual, p,
         [](Driver& d) {
             d.panel().showPage(Panel::Page::parts);
             d.pause(0.2);
             d.click("Assembly");
         }},
        {"parts, colour", kUsual, p,
         [](Driver& d) {
             d.panel().showPage(Panel::Page::parts);
             d.pause(0.2);
             d.click("Colour of Chain B");
         }},
        {"parts, two molecules", kUsual, "sample:dna",
         [](Driver& d) {
             d.viewer().add("sample:buckyball", seconds());
             d.settle();
             d.panel().showPage(Panel::Page::parts);
         }},
        {"open, beside", kUsual, "sample:dna",
         [](Driver& d) {
             d.panel().showStart();
             d.pause(0.2);
             d.click("Beside what is open");
         }},
        {"parts, small molecule", kUsual, "sample:glucose", page(Panel::Page::parts)},
        {"select, nothing", kUsual, p, page(Panel::Page::select)},
        {"select, rules", kUsual, p, rules},
        {"select, rules, narrow", kNarrow, p, rules},
        {"select, typed", kUsual, p,
         [](Driver& d) {
             d.panel().showPage(Panel::Page::select);
             d.pause(0.2);
             d.click("Selection");
             d.type("chain A and si");
         }},
        {"labels", kUsual, p, measured},
        {"labels, light, narrow", kNarrow, p, [=](Driver& d) { light(d), measured(d); }},
        {"more, developers", kUsual, "sample:dna",
         [](Driver& d) {
             d.panel().showPage(Panel::Page::more);
             d.pause(0.2);
             d.click("For developers");
         }},
        {"folded", kUsual, p, [](Driver& d) { d.click("Fold the panel"); }},
        {"picked and hovered", kUsual, p,
         [](Driver& d) {
             const double scale = d.viewer().size().height / 720.0;
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
             d.click("For paper");
         }},
        {"help", kUsual, "sample:dna", help},
        {"help, dark", kUsual, "sample:dna", [=](Driver& d) { dark(d), help(d); }},
        {"help, narrow, light", kNarrow, "sample:dna", [=](Driver& d) { light(d), help(d); }},
        {"error", kUsual, "sample:dna", failure},
        {"error, dark", kUsual, "sample:dna", [=](Driver& d) { dark(d), failure(d); }},
        {"legends", kUsual, p,
         [](Driver& d) {
             SavedView look = d.viewer().view();
             look.look.color = ColorScheme::secondaryStructure;
             look.words.legend = true;
             d.viewer().setLook(look, seconds());
             d.panel().showPage(Panel::Page::labels);
         }},
        {"film", kUsual, "sample:dna", record},
        {"film, kept views, narrow", kNarrow, "sample:dna",
         [=](Driver& d) {
             keep(d);
             record(d);
             d.click("Motion");
             d.click("Kept views");
         }},
        {"film, kept views, dark", kUsual, "sample:dna",
         [=](Driver& d) {
             dark(d), keep(d), record(d);
             d.click("Motion");
             d.click("Kept views");
         }},
        {"film, preview", kUsual, "sample:dna",
         [=](Driver& d) {
             keep(d);
             record(d);
             d.click("Motion");
             d.click("Kept views");
             d.click("Preview");
             d.pause(0.7);
             d.rests = false;
         }},
        {"motion is coarser", kUsual, p,
         [=](Driver& d) {
             d.viewer().keepSharp(0.001, 0.7);
             d.viewer().run(ViewerCommand::autoRotate, seconds());
             d.pause(3);
             d.rests = false;
         }},
        {"parts, laid onto", kUsual, "sample:dna",
         [](Driver& d) {
             d.viewer().open(std::vector<std::string>{"sample:dna", "sample:dna"}, seconds());
             d.settle();
             d.panel().showPage(Panel::Page::parts);
             d.pause(0.2);
             d.click("Laid onto dna");
         }},
        {"playing, options", kUsual, several, [](Driver& d) { d.click("How it is played"); }},
        {"playing, options, narrow, light", kNarrow, several,
         [=](Driver& d) { light(d), d.click("How it is played"); }},
        {"view is saved", kUsual, "sample:dna",
         [](Driver& d) {
             d.press('s', {true, false});
         }},
        {"start, 420 pixels", {210, 380}, "", [](Driver&) {}},
        {"look, 420 pixels", {210, 380}, p, page(Panel::Page::look)},
        {"parts, 420 pixels", {210, 380}, p, page(Panel::Page::parts)},
        {"help, 420 pixels", {210, 380}, "sample:dna", help},
        {"error, 420 pixels", {210, 380}, "sample:dna", failure},
        {"error, narrow, light", kNarrow, "sample:dna", [=](Driver& d) { light(d), failure(d); }},
    };
}

int main(int argc, char** argv) {
    const std::string folder = argv[1], protein = argv[2], models = argv[3];
    const double scale = std::atof(argv[4]);
    Display* display = XOpenDisplay(nullptr);
    if (!display) return std::cerr << "there is no display\n", 1;
    setScale(display, scale);
    for (const State& state : states(protein, models)) {
        bool wanted = argc < 6;
        for (int i = 5; i < argc; ++i) wanted |= std::string(state.name).find(argv[i]) != std::string::npos;
        if (!wanted) continue;
        ViewOptions options;
        options.size = state.size;
        options.first.input = state.input;
        options.first.occlusionDirections = 32;
        options.restore = options.first.input.empty();
        if (options.first.input.starts_with("pdb:")) {  // as a view names it
            options.input.path = options.first.input;
            options.input.namedBy = "haemoglobin.view.json";
        }
        Driver driver(options);
        state.act(driver);
        if (driver.rests) {
            driver.settle();
            driver.pause(0.2);
        }
        const PixelSize size = driver.viewer().size();
        const std::string name = std::string(state.name) + (scale == 1 ? "" : ", 200 %");
        writePicture(display, folder + "/" + name + ".ppm", size.width, size.height);
    }
    XCloseDisplay(display);
    return 0;
}

}  // namespace
}  // namespace nacre::app

int main(int argc, char** argv) {
    if (argc < 5) return std::cerr << "window_sheet FOLDER PROTEIN MODELS SCALE [STATE...]\n", 2;
    try {
        return nacre::app::main(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
