#include "app/cli/options.h"

#include <algorithm>
#include <string_view>

#include "app/cli/examples.h"
#include "app/cli/option_words.h"
#include "app/cli/picture_options.h"
#include "app/drawing/complete.h"
#include "app/export/scene_files.h"
#include "app/files/output_file.h"
#include "app/picture/option_values.h"
#include "engine/graph/capability_sets.h"

namespace nacre::app {
namespace {

std::vector<std::string> capabilitySetNames() {
    std::vector<std::string> names;
    for (const graph::CapabilitySet& set : graph::capabilitySets()) names.push_back(set.plan.name);
    return names;
}

void addBench(CommandSpec& command, BenchOptions& options) {
    PictureDescription& picture = options.picture;
    picture.size = {640, 960};
    picture.supersample = 1;
    picture.meshError = 0.5;
    addInputs(command, options.paths, picture);
    addPicture(command, picture,
               kAppearance | Topic::trajectory | Topic::camera | Topic::occlusion | Topic::size | Topic::samples |
                   Topic::levels | Topic::device | Topic::path);
    command.value("--frames", "N", "20, or as many as fit into 3 seconds", "Timed frames per path, 1 to 10000",
                  [&](const std::string& text) { options.frames = static_cast<int>(parseInteger(text, 1, 10000)); });
    command.flag("--json", options.json, "As one JSON object");
}

void addPlan(CommandSpec& command, PlanOptions& options) {
    PictureDescription& picture = options.picture;
    addPicture(command, picture,
               kReading | kAppearance | Topic::look | Topic::camera | Topic::lighting | Topic::effects | Topic::size |
                   Topic::levels | Topic::device | Topic::path);
    for (OptionSpec& option : command.options)
        if (option.longName() == "--device") option.excludes = "--caps";
    const std::vector<std::string> names = capabilitySetNames();
    OptionSpec caps{"--caps", "NAME", "none", "A capability set instead of a device: " + joinWords(names),
                    [&options, names](const std::string& text) {
                        if (std::find(names.begin(), names.end(), text) == names.end())
                            refuse(text, "one of " + joinWords(names), names);
                        options.caps = text;
                    }};
    command.options.insert(command.options.begin(), caps);  // before --device, which refers to it
    command.value("--supersample", "auto|1", "1",
                  "auto: the frames of a picture, 16 samples where a pixel shows an edge",
                  [&](const std::string& text) {
                      options.edges = parseChoice(text, {"auto", "1"}) == 0;
                  });
    command.value("--merge", "on|off", "on", "Passes as subpasses of one render pass", [&](const std::string& text) {
        options.merge = parseChoice(text, {"on", "off"}) == 0;
    });
    command.flag("--headset", options.headset, "The frame of `nacre xr` instead: both eyes, each of --size");
    command.options.back().excludes = "--supersample";
    command.flag("--explain", options.explain, "Print how the frame is drawn, and why");
    command.flag("--json", options.json, "As one JSON object");
}

void addExport(CommandSpec& command, ExportCommandOptions& options) {
    PictureDescription& picture = options.picture;
    picture.occlusion.directions = 0;
    addPicture(command, picture, kReading | kAppearance);
    command.options.front().required = true;
    command
        .value("-o,--output", "FILE", "",
               "The file: .glb (glTF 2.0), .usdz (phones), .ply, .stl, .obj, or .mvsj (MolViewSpec)",
               [&](const std::string& text) {
                   std::vector<std::string> endings = sceneEndings();
                   endings.push_back(".mvsj");
                   if (!isSceneName(text) && fileExtension(text) != ".mvsj") refuseEnding(text, endings);
                   picture.output = text;
               })
        .required = true;
    command.value("--atoms", "FORM", "tessellated",
                  "Spheres and sticks: tessellated, or instanced (.glb, EXT_mesh_gpu_instancing)",
                  [&](const std::string& text) {
                      options.scene.instances = parseChoice(text, {"tessellated", "instanced"}) == 1;
                  });
    command.value("--sides", "auto|N", "auto",
                  "Vertices around a sphere or stick, even, 4 to 128; auto: 24, fewer for many",
                  [&](const std::string& text) {
                      options.scene.sides = text == "auto" ? 0 : static_cast<int>(parseInteger(text, 4, 128));
                      if (options.scene.sides % 2) throw std::invalid_argument("expected an even number");
                  });
    command.value("--scale", "F", "1", "Units of the file per Å, 0.000001 to 1000000",
                  [&](const std::string& text) { options.scale = parseNumber(text, 1e-6, 1e6); });
    command.value("--occlusion", "K|off", "off",
                  "Darken colours by ambient occlusion from K directions, 1 to 4096 (.glb, with attribute _OCCLUSION)",
                  [&](const std::string& text) { picture.occlusion.directions = parseOcclusion(text); });
    command.value("--stats", "FILE.json", "none", "Triangles, area and volume as JSON; - for standard output",
                  [&](const std::string& text) { picture.stats = fileName(text); });
}

/// @throws UsageError
void checkExport(const ExportCommandOptions& options) {
    if (options.scene.instances && fileExtension(options.picture.output) != ".glb")
        throw UsageError("--atoms instanced is for .glb");
    if (options.picture.occlusion.directions > 0 && fileExtension(options.picture.output) != ".glb")
        throw UsageError("--occlusion is for .glb");
    if (options.picture.occlusion.directions > 0 && options.scene.instances)
        throw UsageError("--occlusion needs vertices, which --atoms instanced shares: leave one of them out");
    try {
        const NamedFile files[] = {{"INPUT", options.picture.input.path},
                                   {"--output", options.picture.output, true},
                                   {"--stats", options.picture.stats, true}};
        checkApart(files);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

/// @throws UsageError
void checkInfo(const InfoOptions& options) {
    if (options.frequencies && !options.picture.look.contacts.of)
        throw UsageError("--frequencies is for --interactions");
    if (!options.picture.look.assembly.empty()) {
        if (!options.picture.look.contacts.of) throw UsageError("--assembly is for --interactions");
        if (options.frequencies) throw UsageError("--frequencies and --assembly exclude each other");
    }
    if (options.output != InfoOptions::Output::csv) return;
    if (!options.picture.look.contacts.of) throw UsageError("--csv is for --interactions");
    if (options.paths.size() > 1 && !options.together) throw UsageError("--csv is for one INPUT, or for --together");
}

void addInteractions(CommandSpec& command, InfoOptions& options) {
    addPicture(command, options.picture, static_cast<Topics>(Topic::interactions));
    command.flag("--together", options.together,
                 "The INPUTs as one scene, so that interactions between them are found; NAME=INPUT names one for "
                 "selections, /NAME");
    command.flag("--frequencies", options.frequencies,
                 "How often each interaction is there, over all models (--model all) or frames (--trajectory)");
    command.value("--assembly", "ID", "none",
                  "With interactions between the copies of an assembly or unit cell, as pictures draw them",
                  [&](const std::string& text) { options.picture.look.assembly = text; });
}

void addInfoOutputs(CommandSpec& command, InfoOptions& options) {
    const auto add = [&](const char* name, InfoOptions::Output output, const char* help) {
        command.add({name, "", "", help, [&options, output](const std::string&) {
                         if (options.output != InfoOptions::Output::text && options.output != output)
                             throw UsageError("--json, --json-lines and --csv exclude each other");
                         options.output = output;
                     }});
    };
    add("--csv", InfoOptions::Output::csv, "The interactions as a table of comma-separated values");
    add("--json", InfoOptions::Output::json, "As a JSON list, an object per INPUT; docs/json.md explains its keys");
    add("--json-lines", InfoOptions::Output::jsonLines,
        "As JSON, an object per line and INPUT, each as soon as it is read");
}

std::vector<CommandSpec> makeCommands(CommandLine& line, PictureDescription& window) {
    CommandSpec render{"render", "Draw a molecule into a picture file", kRenderExamples};
    addRender(render, line.render);
    CommandSpec movie{"movie", "Draw a movie: spin, rock, models, trajectories, saved views", kMovieExamples};
    addMovie(movie, line.movie);
    CommandSpec batch{"batch", "Draw many pictures, one per line of a job file", kBatchExamples};
    addBatch(batch, line.batch);
    CommandSpec figure{"figure", "Draw several pictures by one camera as the panels of a figure", kFigureExamples};
    addFigure(figure, line.figure);
    CommandSpec serve{"serve", "Serve pictures over HTTP, and a page to rotate molecules", kServeExamples};
    addServe(serve, line.serve);
    CommandSpec looks{"looks", "List the looks, or draw a molecule in each",
                      "Examples:\n  nacre looks\n  nacre looks sample:dna -o sheet.png\n  nacre looks --json"};
    addLooks(looks, line.looks);
    CommandSpec exported{"export", "Export the scene as triangles: glTF, USDZ, PLY, STL or OBJ", kExportExamples};
    addExport(exported, line.exported);
    CommandSpec info{"info", "Summarise a structure file",
                     "Examples:\n  nacre info 1bna.pdb 4hhb.cif.gz\n  nacre info ligands.sdf --model 3 --json"};
    addInputs(info, line.info.paths, line.info.picture);
    addPicture(info, line.info.picture, static_cast<Topics>(Topic::trajectory));
    info.flag("--residues", line.info.residues, "Each residue, with helix, strand or coil");
    addInteractions(info, line.info);
    addInfoOutputs(info, line.info);
    CommandSpec bench{"bench", "Time frames on each visibility path",
                      "Examples:\n  nacre bench 1bna.pdb\n  nacre bench 1aon.pdb.gz --frames 50 --json\n"
                      "  nacre bench 1bna.pdb 4hhb.cif.gz --visibility tiles --zoom 10"};
    addBench(bench, line.bench);
    CommandSpec plan{"plan", "Show the render passes and memory traffic of a frame on a GPU",
                     "Examples:\n"
                     "  nacre plan --caps mali --size 1170x2532\n"
                     "  nacre plan 1aon.pdb.gz --caps mali --size 1170x2532\n"
                     "  nacre plan --caps mali --look illustrative --halos 6 --shadow 0.5\n"
                     "  nacre plan --caps adreno --merge off --json\n"
                     "  nacre plan --device 0 --visibility deferred"};
    addPlan(plan, line.plan);
    CommandSpec devices{"devices", "List the Vulkan devices",
                        "Examples:\n  nacre devices\n  nacre devices --self-test --json"};
    devices.flag("--self-test", line.devices.selfTest, "Test and time every path, and keep the result for `auto`");
    devices.value("--cache", "DIR|off", "NACRE_CACHE, else ~/.cache/nacre", "Folder for results of self-tests",
                  [&](const std::string& text) { line.devices.cache = fileName(text); });
    devices.flag("--json", line.devices.json, "As a JSON array");
    CommandSpec completion{"completion", "Print completions for a shell",
                           "Examples:\n  source <(nacre completion bash)\n  nacre completion fish | source"};
    completion
        .add({"SHELL", "", "", "bash, zsh or fish",
              [&](const std::string& text) {
                  parseChoice(text, {"bash", "zsh", "fish"});
                  line.shell = text;
              }})
        .required = true;
    CommandSpec man{"man", "Print the manual page", "Examples:\n  nacre man | man -l -"};
    std::vector<CommandSpec> commands{render, movie, batch, figure,  serve,      looks, exported,
                                      info,   bench, plan,  devices, completion, man};
#ifdef NACRE_DESKTOP
    CommandSpec view{"view", "Show a molecule in a window", kViewExamples};
    addWindow(view, window);
    commands.insert(commands.begin() + 3, view);
#else
    static_cast<void>(window);
#endif
#ifdef NACRE_XR
    CommandSpec xr{"xr", "Show a molecule in a headset", kXrExamples};
    addHeadset(xr, window);
    commands.insert(commands.begin() + 4, xr);
#endif
    for (CommandSpec& command : commands)
        command.flag(
            "-q,--quiet", line.quiet,
            "No warnings, notes or progress on standard error. Errors remain, and files that a saved view opens\n"
            "outside its folder");
    for (CommandSpec& command : commands)
        if (std::any_of(command.options.begin(), command.options.end(),
                        [](const OptionSpec& option) { return option.longName() == "--offline"; }))
            command.flag("--verbose", line.verbose, "Failed downloads name every address that was tried");
    return commands;
}

Command parseCommand(const std::string& name) {
    constexpr std::pair<const char*, Command> kCommands[] = {{"render", Command::render},
                                                             {"movie", Command::movie},
                                                             {"batch", Command::batch},
                                                             {"figure", Command::figure},
                                                             {"serve", Command::serve},
                                                             {"looks", Command::looks},
                                                             {"export", Command::exporting},
                                                             {"view", Command::view},
                                                             {"info", Command::info},
                                                             {"bench", Command::bench},
                                                             {"plan", Command::plan},
                                                             {"devices", Command::devices},
                                                             {"xr", Command::xr},
                                                             {"completion", Command::help},
                                                             {"man", Command::help}};
    for (const auto& [word, command] : kCommands)
        if (name == word) return command;
    throw UsageError(
        "a command is needed: render, movie, batch, figure, serve, looks, export, view, info, bench, plan or devices, "
        "for example: nacre render sample:dna -o dna.png");
}

}  // namespace

CommandLine parseCommandLine(int argc, const char* const* argv) {
    CommandLine line;
    PictureDescription window;
    CommandSpec program{"nacre", "Nacre draws molecules.", kExamples};
    bool version = false, notices = false;
    program.flag("--version", version, "Commit, Vulkan headers, device and driver");
    program.flag("--notices", notices, "Licences of Nacre and its dependencies");
    const std::vector<CommandSpec> commands = makeCommands(line, window);
    const bool isHelp = argc > 2 && std::string_view(argv[1]) == "help";
    if (isHelp && std::none_of(commands.begin(), commands.end(), [&](const auto& c) { return c.name == argv[2]; })) {
        line.help = helpTopic(argv[2], commands);
        return line;
    }
    const ParsedCommand parsed = parseCommands(program, commands, argc, argv);
    line.help = parsed.help;
    if (isHelp && isHelpTopic(argv[2])) line.help += "\n" + helpTopic(argv[2], commands);  // also a command's name
    if (!line.help.empty()) return line;
    if ((parsed.name.empty() ? 0 : 1) + (version ? 1 : 0) + (notices ? 1 : 0) > 1)
        throw UsageError("more than one command");
    line.command = version ? Command::version : notices ? Command::notices : parseCommand(parsed.name);
    if (parsed.name == "completion") line.help = completionScript(line.shell, program, commands);
    if (parsed.name == "man") line.help = manualPage(program, commands);
    if (line.command == Command::render) completePicture(line.render);
    if (line.command == Command::movie) checkMovie(line.movie);
    if (line.command == Command::looks) checkLooks(line.looks);
    if (line.command == Command::exporting) checkExport(line.exported);
    if (line.command == Command::info) checkInfo(line.info);
    if (line.command == Command::view || line.command == Command::xr) {
        const bool named = checkWindow(window);
        if (line.command == Command::xr && !named)
            throw UsageError("INPUT is required, for example: nacre xr 1bna.pdb");
        line.view = {withWholePaths(window), !named};
    }
    return line;
}

}  // namespace nacre::app
