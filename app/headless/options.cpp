#include "app/headless/options.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>

#include "app/headless/examples.h"
#include "app/headless/image_file.h"
#include "app/headless/saved_options.h"
#include "engine/error.h"
#include "engine/graph/capability_sets.h"

namespace nacre::app {
namespace {

using Setter = std::function<void(const std::string&)>;

/// An option with one value. Always a single string, since a CLI11 option of many values swallows the INPUT.
CLI::Option* value(CLI::App& app, const std::string& name, const std::string& type, const std::string& fallback,
                   const std::string& help, Setter set) {
    const auto parse = [name, set = std::move(set)](const std::string& text) {
        try {
            set(text);
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError(name.substr(name.find("--")), error.what());
        } catch (const Error& error) {
            throw CLI::ValidationError(name.substr(name.find("--")), error.what());
        }
    };
    return app.add_option_function<std::string>(name, parse, help)->type_name(type)->default_str(fallback);
}

void onOff(CLI::App& app, const std::string& name, bool& target, const std::string& help) {
    value(app, name, "on|off", "on", help, [&](const std::string& text) {
        target = parseChoice(text, {"on", "off"}) == 0;
    });
}

void showHide(CLI::App& app, const std::string& name, bool& target, const std::string& help) {
    value(app, name, "show|hide", target ? "show" : "hide", help, [&](const std::string& text) {
        target = parseChoice(text, {"show", "hide"}) == 0;
    });
}

constexpr std::size_t kMostRules = 1000;
constexpr std::int64_t kMostOcclusionMegabytes = 65536;

std::string capabilitySetNames() {
    std::string names;
    for (const graph::CapabilitySet& set : graph::capabilitySets())
        names += (names.empty() ? "" : ", ") + set.plan.name;
    return names;
}

std::string path(const std::string& text) {
    if (text.empty()) throw std::invalid_argument("expected a file name");
    return text;
}

CLI::Option* addInput(CLI::App& app, InputOptions& input) {
    CLI::Option* option = app.add_option(
        "INPUT", input.path,
        "A structure file (PDB, mmCIF, mmJSON, BinaryCIF, MMTF, SDF/MOL, XYZ, MOL2, PQR, GRO, PDBQT, CML;\n"
        "each also .gz), - for standard input, sample:dna, sample:glucose, sample:buckyball, or a download:\n"
        "pdb:1BNA, pubchem:CID|NAME, afdb:UNIPROT");
    option->required()->type_name("");
    value(app, "--cache", "DIR|off", "NACRE_CACHE, else ~/.cache/nacre", "Where downloads and occlusion are kept",
          [&](const std::string& text) { input.cache = path(text); });
    app.add_flag("--offline", input.offline, "Take downloads from the cache alone");
    value(app, "--memory", "MB", "half of the machine's",
          "For the molecule, 1 to 1048576; one that takes more (700 bytes an atom, two a byte of text) is refused",
          [&](const std::string& text) { input.memoryMegabytes = parseInteger(text, 1, 1 << 20); });
    value(app, "--format", "NAME", "by content", "One of " + formatNames(), [&](const std::string& text) {
        input.format = formatFromName(text);
        if (!input.format) throw std::invalid_argument("expected one of " + formatNames() + ", not '" + text + "'");
    });
    value(app, "--model", "N|all", "1", "Model, frame or record, counted from 1; all: one over the other",
          [&](const std::string& text) { input.model = parseModel(text); });
    return option;
}

void addSize(CLI::App& app, const std::string& fallback, Size& size) {
    value(app, "--size", "WxH", fallback, "Pixels, each side 1 to 16384",
          [&](const std::string& text) { size = parseSize(text); });
}

void addDeviceName(CLI::App& app, DeviceOptions& device) {
    value(app, "--device", "N|NAME", "the best there is", "Number or part of the name, as `nacre devices` lists them",
          [&](const std::string& text) {
              if (text.empty()) throw std::invalid_argument("expected a device's number or part of its name");
              device.device = text;
          });
}

/// An option that may be given many times. Each is taken as it is met, so that their common order is kept.
void rule(CLI::App& app, const std::string& name, const std::string& type, const std::string& help,
          std::vector<Rule>& rules, Rule (*parse)(std::string_view)) {
    value(app, name, type, "", help,
          [&rules, parse](const std::string& text) {
              if (rules.size() == kMostRules)
                  throw std::invalid_argument("more than " + std::to_string(kMostRules) + " rules");
              rules.push_back(parse(text));
          })
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->trigger_on_parse();
}

void addRules(CLI::App& app, std::vector<Rule>& rules) {
    rule(app, "--show", "SEL=STYLE", "Draw the atoms of a selection in a style; repeatable", rules, parseShow);
    rule(app, "--hide", "SEL", "Leave out the atoms of a selection; repeatable", rules, parseHide);
    rule(app, "--color-by", "SEL=SCHEME|COLOR",
         "Colour the atoms of a selection; repeatable. These three apply in the order they stand in", rules,
         parseColorBy);
}

/// What is drawn and how it looks: the same for every command that draws.
CLI::Option* addContent(CLI::App& app, InputOptions& input, DrawnAtomsOptions& drawn, RepresentationOptions& look) {
    CLI::Option* option = addInput(app, input);
    value(app, "--style", "NAME", "spacefill; ball-and-stick under 100 atoms with bonds",
          "spacefill, ball-and-stick or licorice", [&](const std::string& text) { look.style = parseStyle(text); });
    value(app, "--color", "SCHEME|COLOR", "element",
          "element, chain, residue, hydrophobicity, charge, secondary-structure, b-factor,\n"
          "plddt (AlphaFold's bands), rainbow (N to C), occupancy, entity; or a colour as for --background",
          [&](const std::string& text) { look.color = parseColoring(text); });
    value(app, "--assembly", "ID", "none: the file's atoms as they are",
          "Biological assembly or unit cell, of those that `nacre info` lists", [&](const std::string& text) {
              if (text.empty()) throw std::invalid_argument("expected an assembly's identifier");
              look.assembly = text;
          });
    addRules(app, look.rules);
    showHide(app, "--water", drawn.water, "Water molecules");
    showHide(app, "--hydrogens", drawn.hydrogens, "Hydrogen atoms");
    return option;
}

void addOcclusion(CLI::App& app, OcclusionSettings& occlusion) {
    value(app, "--occlusion", "K|off", "128", "Ambient occlusion from K directions, 1 to 4096",
          [&](const std::string& text) { occlusion.directions = parseOcclusion(text); });
    value(app, "--occlusion-memory", "MB", "64",
          "Device memory for it, 1 to 65536; the more, the finer (says on standard error what was chosen)",
          [&](const std::string& text) { occlusion.megabytes = parseInteger(text, 1, kMostOcclusionMegabytes); });
}

void addBench(CLI::App& app, BenchOptions& options) {
    addContent(app, options.input, options.drawn, options.look);
    addSize(app, "640x960", options.size);
    value(app, "--frames", "N", "20", "Timed frames a path, 1 to 10000",
          [&](const std::string& text) { options.frames = static_cast<int>(parseInteger(text, 1, 10000)); });
    addOcclusion(app, options.occlusion);
    addDeviceName(app, options.device);
    app.add_flag("--json", options.json, "As one JSON object");
}

void addCamera(CLI::App& app, RenderOptions& options) {
    value(app, "--rotate", "X,Y,Z", "0,0,0", "Degrees, right-handed, about the view axes, X first",
          [&](const std::string& text) { options.camera.rotationDegrees = parseRotation(text); });
    value(app, "--zoom", "F", "1", "Scales the picture, 0.0001 to 10000",
          [&](const std::string& text) { options.camera.zoom = parseNumber(text, kSmallestZoom, kLargestZoom); });
    value(app, "--projection", "NAME", "ortho", "ortho or perspective", [&](const std::string& text) {
        options.camera.projection =
            parseChoice(text, {"ortho", "perspective"}) == 0 ? Projection::orthographic : Projection::perspective;
    });
    value(app, "--fov", "DEGREES", "30", "Perspective: angle across the shorter side, 1 to 120",
          [&](const std::string& text) { options.camera.fovDegrees = parseNumber(text, kSmallestFov, kLargestFov); });
}

void addShading(CLI::App& app, RenderOptions& options) {
    addOcclusion(app, options.occlusion);
    value(app, "--background", "COLOR", "white",
          "transparent, a basic CSS name, #rgb, #rrggbb or #rrggbbaa (JPEG has no transparency: over white)",
          [&](const std::string& text) { options.background = parseColor(text); });
    onOff(app, "--lighting", options.lighting, "off: base colour times occlusion, nothing else");
}

void addPixels(CLI::App& app, RenderOptions& options) {
    addSize(app, "1024x1024", options.size);
    value(app, "--supersample", "N", "1", "N x N samples a pixel, 1 to 8", [&](const std::string& text) {
        options.supersample = static_cast<std::uint32_t>(parseInteger(text, 1, kMostSupersample));
    });
}

/// Goes before the options that it stands for, so that those prevail.
void addSavedView(CLI::App& app, RenderOptions& options) {
    value(app, "--view", "FILE", "none", "A view that `nacre view` saved: what is seen, and how; options prevail",
          [&](const std::string& text) { applySavedView(readSavedView(path(text)), options); });
}

void addFiles(CLI::App& app, RenderOptions& options) {
    value(app, "-o,--output", "FILE", "", "The picture: .png, .tif, .tiff, .jpg, .jpeg or .exr",
          [&](const std::string& text) {
              if (!isPictureName(text))
                  throw std::invalid_argument(
                      "expected a name that ends in .png, .tif, .tiff, .jpg, .jpeg or .exr, not '" + text + "'");
              options.output = text;
          })
        ->required();
    value(app, "--layers", "FILE.exr", "none", "Colour, depth, normal, atom and occlusion of every pixel",
          [&](const std::string& text) {
              if (extensionOf(text) != ".exr")
                  throw std::invalid_argument("expected a name that ends in .exr, not '" + text + "'");
              options.layers = text;
          });
    value(app, "--stats", "FILE.json", "none", "View, counts, times and memory as JSON",
          [&](const std::string& text) { options.stats = path(text); });
    value(app, "--capture", "FILE.rdc", "none",
          "The frame and its occlusion bake, for RenderDoc, which has to be installed", [&](const std::string& text) {
              if (extensionOf(text) != ".rdc")
                  throw std::invalid_argument("expected a name that ends in .rdc, not '" + text + "'");
              options.capture = text;
              options.device.capture = true;
          });
}

void addVisibility(CLI::App& app, DeviceOptions& device) {
    value(
        app, "--visibility", "PATH", "auto", "auto, encoded, fragdepth, deferred or raster-order",
        [&](const std::string& text) {
            constexpr Visibility kPaths[] = {Visibility::automatic, Visibility::encoded, Visibility::fragdepth,
                                             Visibility::deferred, Visibility::rasterOrder};
            device.visibility = kPaths[parseChoice(text, {"auto", "encoded", "fragdepth", "deferred", "raster-order"})];
        });
    value(app, "--encoded-format", "FORMAT", "auto",
          "Of encoded depth: auto, r32f, rgba16f, rg16f, a2b10g10r10 or rgba8", [&](const std::string& text) {
              constexpr EncodedDepth kRungs[] = {EncodedDepth::automatic,   EncodedDepth::r32f,
                                                 EncodedDepth::rgba16f,     EncodedDepth::rg16f,
                                                 EncodedDepth::a2b10g10r10, EncodedDepth::rgba8};
              device.encoded = kRungs[parseChoice(text, {"auto", "r32f", "rgba16f", "rg16f", "a2b10g10r10", "rgba8"})];
          });
}

void addDebug(CLI::App& app, RenderOptions& options) {
    std::string names;
    for (const char* name : debugViewNames()) names += names.empty() ? name : std::string(", ") + name;
    value(
        app, "--debug", "VIEW", "none", "What the frame works with, as the picture: " + names,
        [&](const std::string& text) { options.debug = static_cast<DebugView>(parseChoice(text, debugViewNames())); });
}

void addDevice(CLI::App& app, RenderOptions& options) {
    addDeviceName(app, options.device);
    addVisibility(app, options.device);
    onOff(app, "--prepass", options.prepass, "Opaque plates that reject hidden work; never changes the picture");
    onOff(app, "--merge", options.merge, "Passes as subpasses of one render pass; never changes the picture");
    app.add_flag("--validate", options.device.validate,
                 "Run under the Vulkan validation layer; any message is an error");
}

#ifdef NACRE_DESKTOP
void addWindow(CLI::App& app, ViewOptions& options) {
    RenderOptions& first = options.first;
    first.size = {1280, 800};
    addSavedView(app, first);
    addContent(app, first.input, first.drawn, first.look)->required(false);
    addCamera(app, first);
    addSize(app, "1280x800", first.size);
    addShading(app, first);
    addDebug(app, first);
    value(app, "--stats", "FILE", "none", "What the window drew, as JSON, when it is closed",
          [&](const std::string& text) { first.stats = path(text); });
    addDeviceName(app, first.device);
    addVisibility(app, first.device);
    app.add_flag("--validate", first.device.validate, "Run under the Vulkan validation layer; any message is an error");
    app.add_flag("--capture", first.device.capture, "Load RenderDoc, so that F12 captures a frame");
}
#endif

void addPlan(CLI::App& app, PlanOptions& options) {
    value(app, "--caps", "NAME", "none", "A capability set instead of a device: " + capabilitySetNames(),
          [&](const std::string& text) {
              try {
                  options.caps = graph::capabilitySet(text).plan.name;
              } catch (const Error& error) {
                  throw std::invalid_argument(error.what());
              }
          });
    addDeviceName(app, options.device);
    addVisibility(app, options.device);
    addSize(app, "1024x1024", options.size);
    onOff(app, "--merge", options.merge, "Passes as subpasses of one render pass");
    CLI::Option* json = app.add_flag_callback(
        "--json", [&] { options.format = PlanFormat::json; }, "As one JSON object");
    app.add_flag_callback(
           "--dot", [&] { options.format = PlanFormat::dot; }, "As a Graphviz graph")
        ->excludes(json);
    app.get_option("--caps")->excludes(app.get_option("--device"));
}

bool sameFile(const std::string& a, const std::string& b) {
    if (a.empty() || b.empty()) return false;
    std::error_code error;
    if (std::filesystem::equivalent(a, b, error)) return true;
    const auto plain = [](const std::string& name) { return std::filesystem::absolute(name).lexically_normal(); };
    return plain(a) == plain(b);
}

/// INPUT, or the one of the saved view.
bool takeInput(RenderOptions& options) {
    if (!options.input.path.empty()) return true;
    options.input.path = options.savedInput.path;
    options.input.format = options.savedInput.format;
    options.input.model = options.savedInput.model;
    return !options.input.path.empty();
}

void checkDebug(const RenderOptions& options) {
    const std::string view = debugViewNames()[static_cast<std::size_t>(options.debug)];
    if (needsOcclusion(options.debug) && options.occlusion.directions == 0)
        throw UsageError("--debug " + view + " shows nothing with --occlusion off");
    if (options.debug != DebugView::none && options.supersample > 1)
        throw UsageError("--debug " + view + " takes one sample a pixel: leave out --supersample");
}

/// What no option alone can tell.
void checkRender(RenderOptions& options) {
    if (!takeInput(options)) throw UsageError("INPUT is required");
    checkDebug(options);
    try {
        checkSamples(options.size, options.supersample);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    const std::pair<const char*, const std::string*> files[] = {{"INPUT", &options.input.path},
                                                                {"--output", &options.output},
                                                                {"--layers", &options.layers},
                                                                {"--stats", &options.stats},
                                                                {"--capture", &options.capture}};
    for (std::size_t i = 0; i < std::size(files); ++i)
        for (std::size_t j = i + 1; j < std::size(files); ++j)
            if (sameFile(*files[i].second, *files[j].second))
                throw UsageError(std::string(files[i].first) + " and " + files[j].first +
                                 " are the same file: " + *files[j].second);
}

std::string oneLine(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text;
}

}  // namespace

CommandLine parseCommandLine(int argc, const char* const* argv) {
    CommandLine line;
    CLI::App app("Nacre draws molecules.", "nacre");
    app.footer(kExamples);
    bool version = false;
    app.add_flag("--version", version, "Commit, Vulkan headers, device and driver");
    bool notices = false;
    app.add_flag("--notices", notices, "Licences of Nacre and of the parts that it is made of");

    CLI::App& render = *app.add_subcommand("render", "Draw a molecule into a picture file");
    render.footer(kRenderExamples);
    addSavedView(render, line.render);
    addContent(render, line.render.input, line.render.drawn, line.render.look)->required(false);
    addFiles(render, line.render);
    addCamera(render, line.render);
    addShading(render, line.render);
    addPixels(render, line.render);
    addDebug(render, line.render);
    addDevice(render, line.render);

#ifdef NACRE_DESKTOP
    CLI::App& view = *app.add_subcommand("view", "Show a molecule in a window");
    view.footer(kViewExamples);
    addWindow(view, line.view);
#endif

    CLI::App& info = *app.add_subcommand("info", "Say what a structure file holds");
    info.footer("Examples:\n  nacre info 1bna.pdb\n  nacre info ligands.sdf --model 3 --json");
    addInput(info, line.info.input);
    info.add_flag("--json", line.info.json, "As one JSON object");

    CLI::App& bench = *app.add_subcommand("bench", "Time frames and count shaded fragments");
    bench.footer("Examples:\n  nacre bench 1bna.pdb\n  nacre bench 1aon.pdb.gz --frames 50 --json");
    addBench(bench, line.bench);

    CLI::App& plan =
        *app.add_subcommand("plan", "Show what a frame becomes on a GPU: render passes and memory traffic");
    plan.footer(
        "Examples:\n"
        "  nacre plan --caps mali --size 1170x2532\n"
        "  nacre plan --caps adreno --merge off --json\n"
        "  nacre plan --device 0 --visibility deferred --dot | dot -Tsvg -o plan.svg");
    addPlan(plan, line.plan);

    CLI::App& devices = *app.add_subcommand("devices", "List the Vulkan devices");
    devices.footer("Examples:\n  nacre devices\n  nacre devices --json");
    devices.add_flag("--json", line.json, "As a JSON array");

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        line.help = app.help();
        return line;
    } catch (const CLI::ParseError& error) {
        throw UsageError(oneLine(error.what()));
    }
    const std::size_t commands = app.get_subcommands().size();
    if (commands + (version ? 1 : 0) + (notices ? 1 : 0) > 1) throw UsageError("more than one command");
    if (version) {
        line.command = Command::version;
    } else if (notices) {
        line.command = Command::notices;
    } else if (render.parsed()) {
        checkRender(line.render);
        line.command = Command::render;
#ifdef NACRE_DESKTOP
    } else if (view.parsed()) {
        checkDebug(line.view.first);
        line.view.restore = !takeInput(line.view.first);
        line.command = Command::view;
#endif
    } else if (info.parsed()) {
        line.command = Command::info;
    } else if (bench.parsed()) {
        line.command = Command::bench;
    } else if (plan.parsed()) {
        line.command = Command::plan;
    } else if (devices.parsed()) {
        line.command = Command::devices;
    } else {
        throw UsageError("a command is needed: render, view, info, bench, plan or devices");
    }
    return line;
}

}  // namespace nacre::app
