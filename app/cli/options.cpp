#include "app/cli/options.h"

#include <CLI/CLI.hpp>

#include "app/cli/common_options.h"
#include "app/cli/examples.h"
#include "app/cli/picture_options.h"
#include "engine/error.h"
#include "engine/graph/capability_sets.h"

namespace nacre::app {
namespace {

std::string capabilitySetNames() {
    std::string names;
    for (const graph::CapabilitySet& set : graph::capabilitySets())
        names += (names.empty() ? "" : ", ") + set.plan.name;
    return names;
}

void addBench(CLI::App& app, BenchOptions& options) {
    addContent(app, options.input, options.drawn, options.look);
    addSize(app, "640x960", options.size);
    addValue(app, "--frames", "N", "20", "Timed frames a path, 1 to 10000",
             [&](const std::string& text) { options.frames = static_cast<int>(parseInteger(text, 1, 10000)); });
    addOcclusion(app, options.occlusion);
    addDeviceName(app, options.device);
    app.add_flag("--json", options.json, "As one JSON object");
}

void addPlan(CLI::App& app, PlanOptions& options) {
    addValue(app, "--caps", "NAME", "none", "A capability set instead of a device: " + capabilitySetNames(),
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
    addOnOff(app, "--merge", options.merge, "Passes as subpasses of one render pass");
    CLI::Option* json = app.add_flag_callback(
        "--json", [&] { options.format = PlanFormat::json; }, "As one JSON object");
    app.add_flag_callback(
           "--dot", [&] { options.format = PlanFormat::dot; }, "As a Graphviz graph")
        ->excludes(json);
    app.get_option("--caps")->excludes(app.get_option("--device"));
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
    addRender(render, line.render);

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
